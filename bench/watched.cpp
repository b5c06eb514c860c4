// SPDX-License-Identifier: BSD-2-Clause
//
// Cost of watching an agent: decisions per second of an agent that applies one operator after the other, without a
// client and with one client on a socket that receives the trace at level 1, as text and as XML.
//
//   watched [DECISIONS]     default 100000, at least 10
//
// Prints one line of JSON. Both runs have the trace at level 1; `kept` is the remaining fraction of the speed.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "sml_Client.h"

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kRules[] = {
    "sp {propose*begin (state <s> ^superstate nil -^count <c>) --> (<s> ^operator <o> +) (<o> ^name begin)}",
    "sp {apply*begin (state <s> ^operator.name begin) --> (<s> ^count 0)}",
    "sp {propose*step (state <s> ^superstate nil ^count <c>) --> (<s> ^operator <o> +) (<o> ^name step)}",
    "sp {apply*step (state <s> ^operator.name step ^count <c>) --> (<s> ^count <c> - (+ <c> 1))}",
};

std::atomic<long> g_texts{0};
std::atomic<long> g_documents{0};

void OnText(sml::smlPrintEventId, void*, sml::Agent*, char const*) {
  ++g_texts;
}
void OnDocument(sml::smlXMLEventId, void*, sml::Agent*, sml::ClientXML*) {
  ++g_documents;
}

/// The best of ten parts, to reduce the influence of other programs.
double DecisionsPerSecond(sml::Agent& agent, int decisions) {
  constexpr int kParts = 10;
  double best = 0;
  for (int i = 0; i < kParts; ++i) {
    const Clock::time_point start = Clock::now();
    agent.RunSelf(decisions / kParts);
    best = std::max(best, decisions / kParts / std::chrono::duration<double>(Clock::now() - start).count());
  }
  return best;
}

/// A client in a separate thread: connects, subscribes, and receives events until it is stopped.
void Watch(int port, std::atomic<bool>& watching, std::atomic<bool>& failed, const std::atomic<bool>& leave) {
  sml::Kernel* kernel = sml::Kernel::CreateRemoteConnection(true, "127.0.0.1", port);
  sml::Agent* agent = kernel->HadError() ? nullptr : kernel->GetAgent("watched");
  if (agent == nullptr) {
    failed = true;
  } else {
    agent->RegisterForPrintEvent(sml::smlEVENT_PRINT, OnText, nullptr);
    agent->RegisterForXMLEvent(sml::smlEVENT_XML_TRACE_OUTPUT, OnDocument, nullptr);
    watching = true;
    while (!leave) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kernel->Shutdown();
  delete kernel;
}

}  // namespace

int main(int argc, char** argv) {
  const int decisions = argc > 1 ? std::atoi(argv[1]) : 100000;
  if (decisions < 10) {
    std::fputs("usage: watched [DECISIONS]\n", stderr);
    return 2;
  }
  sml::Kernel* kernel = sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kUseAnyPort);
  if (kernel->HadError()) {
    std::fprintf(stderr, "watched: %s\n", kernel->GetLastErrorDescription());
    return 1;
  }
  sml::Agent* agent = kernel->CreateAgent("watched");
  for (const char* rule : kRules) agent->ExecuteCommandLine(rule);
  agent->ExecuteCommandLine("watch 1");
  agent->RunSelf(1000);
  const double alone = DecisionsPerSecond(*agent, decisions);

  std::atomic<bool> watching{false}, failed{false}, leave{false};
  std::thread watcher(Watch, kernel->GetListenerPort(), std::ref(watching), std::ref(failed), std::cref(leave));
  while (!watching && !failed) kernel->CheckForIncomingCommands();
  while (kernel->CheckForIncomingCommands()) {
  }
  const double watched = failed ? 0 : DecisionsPerSecond(*agent, decisions);
  const long texts = g_texts, documents = g_documents;
  leave = true;
  watcher.join();
  kernel->Shutdown();
  delete kernel;
  if (failed) {
    std::fputs("watched: the client could not attach\n", stderr);
    return 1;
  }
  std::printf(
      "{\"benchmark\": \"watched\", \"decisions\": %d, \"alone_per_second\": %.0f, \"watched_per_second\": %.0f, "
      "\"kept\": %.3f, \"texts_taken\": %ld, \"documents_taken\": %ld}\n",
      decisions, alone, watched, watched / alone, texts, documents);
  return 0;
}
