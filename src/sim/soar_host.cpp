// SPDX-License-Identifier: BSD-2-Clause
#include "sim/soar_host.h"

#include <fstream>
#include <limits>
#include <system_error>

#include "sml_Client.h"

namespace soarbox::sim {
namespace {

Diagnostic Problem(std::string message, std::string hint = {}) {
  Diagnostic diagnostic;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  return diagnostic;
}

std::string ErrorText(::sml::ClientErrors& source) {
  const char* text = source.GetLastErrorDescription();
  return text == nullptr ? "no reason given" : text;
}

/// Collects what an agent prints while its rules are loaded.
class PrintCollector {
 public:
  explicit PrintCollector(::sml::Agent& agent)
      : agent_(agent), callback_(agent.RegisterForPrintEvent(::sml::smlEVENT_PRINT, &PrintCollector::OnPrint, this)) {}
  ~PrintCollector() { agent_.UnregisterForPrintEvent(callback_); }
  PrintCollector(const PrintCollector&) = delete;
  PrintCollector& operator=(const PrintCollector&) = delete;

  const std::string& text() const { return text_; }

 private:
  static void OnPrint(::sml::smlPrintEventId, void* self, ::sml::Agent*, char const* message) {
    static_cast<PrintCollector*>(self)->text_ += message;
  }

  ::sml::Agent& agent_;
  int callback_;
  std::string text_;
};

}  // namespace

Result<std::unique_ptr<SoarHost>> SoarHost::Create(const SoarSettings& settings) {
  ::sml::Kernel* kernel = nullptr;
  if (!settings.remote_host.empty()) {
    kernel = ::sml::Kernel::CreateRemoteConnection(true, settings.remote_host.c_str(), settings.remote_port);
  } else {
    const int port = settings.port == 0 ? static_cast<int>(::sml::Kernel::kSuppressListener) : settings.port;
    kernel = ::sml::Kernel::CreateKernelInCurrentThread(true, port);
  }
  // Owned from here on, so that a failed connection is closed as well.
  std::unique_ptr<SoarHost> host(new SoarHost(kernel, settings));
  if (kernel->HadError()) {
    if (!settings.remote_host.empty()) {
      return Problem("no Soar kernel answers at " + settings.remote_host + ":" + std::to_string(settings.remote_port) + " (" +
                         ErrorText(*kernel) + ")",
                     "start one there, for example with: soarbox kernel --port " + std::to_string(settings.remote_port));
    }
    if (settings.port != 0) {
      return Problem("port " + std::to_string(settings.port) + " cannot be opened for debuggers (" + ErrorText(*kernel) + ")",
                     "another program holds it; choose another with --port N, or none with --port 0");
    }
    return Problem("the Soar kernel did not start: " + ErrorText(*kernel));
  }
  return host;
}

SoarHost::~SoarHost() {
  kernel_->Shutdown();
  delete kernel_;
}

Result<SoarHost::Loaded> SoarHost::CreateAgent(const std::string& name, const std::filesystem::path& rules) {
  const std::string file = rules.string();
  if (!std::ifstream(rules)) {
    Diagnostic problem = Problem("the rules of " + name + " cannot be read", "check the name, or add their folder with --path");
    problem.file = file;
    return problem;
  }
  Loaded loaded;
  loaded.agent = kernel_->CreateAgent(name.c_str());
  if (loaded.agent == nullptr) return Problem("the kernel refuses an agent named " + name + ": " + ErrorText(*kernel_));
  loaded.agent->ExecuteCommandLine("watch 0");
  // Each agent draws from a stream of its own, given by the run's seed and its place in the order of creation.
  const std::uint64_t seed = (settings_.seed * 1000003u + ++agents_made_) & std::numeric_limits<std::int32_t>::max();
  loaded.agent->ExecuteCommandLine(("srand " + std::to_string(seed)).c_str());

  std::error_code ignored;
  const std::filesystem::path absolute = std::filesystem::absolute(rules, ignored);
  PrintCollector printed(*loaded.agent);
  const bool ok = loaded.agent->LoadProductions(absolute.string().c_str(), false);
  loaded.problems = ParseDiagnostics(printed.text(), file);
  if (!ok) {
    std::vector<Diagnostic> more = ParseDiagnostics(ErrorText(*loaded.agent), file);
    if (loaded.problems.empty()) loaded.problems = std::move(more);
  }
  for (Diagnostic& problem : loaded.problems) {
    if (problem.file == absolute.string()) problem.file = file;
  }
  loaded.agent->SetBlinkIfNoChange(true);
  return loaded;
}

void SoarHost::ServeClients() {
  while (kernel_->CheckForIncomingCommands()) {
  }
}

bool SoarHost::IsConnected() const { return settings_.remote_host.empty() || !kernel_->IsConnectionClosed(); }

}  // namespace soarbox::sim
