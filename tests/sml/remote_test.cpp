// SPDX-License-Identifier: BSD-2-Clause
// The client API with a kernel on a socket: the same programs, the same results.
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "sml_Client.h"
#include "sml_test_files.h"

namespace {

using namespace sml;

/// The state of an agent as a program sees it: texts, commands, names and tags.
std::vector<std::string> Play(Kernel& kernel, const std::string& rules) {
  std::vector<std::string> seen;
  Agent* agent = kernel.CreateAgent("player");
  agent->RegisterForPrintEvent(
      smlEVENT_PRINT,
      [](smlPrintEventId, void* data, Agent*, char const* text) {
        auto& lines = *static_cast<std::vector<std::string>*>(data);
        if (lines.empty() || lines.back().substr(0, 6) != "trace:") lines.push_back("trace:");
        lines.back() += text;
      },
      &seen);
  seen.push_back(agent->LoadProductions(rules.c_str()) ? "loaded" : agent->GetLastErrorDescription());
  FloatElement* distance = agent->CreateFloatWME(agent->GetInputLink(), "distance", 10.0);
  agent->CreateIdWME(agent->GetInputLink(), "plane")->CreateStringWME("type", "F-18 <\"'&>");
  for (const double value : {10.0, 2.5, 2.5, 7.0}) {
    agent->Update(distance, value);
    seen.push_back(agent->RunSelfTilOutput());
    for (int i = 0; i < agent->GetNumberCommands(); ++i) {
      Identifier* command = agent->GetCommand(i);
      seen.push_back(std::string(command->GetCommandName()) + " " + command->GetValueAsString() + " " +
                     command->GetParameterValue("speed") + " " + std::to_string(command->GetTimeTag()));
      command->AddStatusComplete();
    }
  }
  for (const char* line :
       {"print --depth 3 i1", "print s1", "bogus", "run 1", "print --stack", "init-soar", "print --depth 2 i2"}) {
    seen.push_back(agent->ExecuteCommandLine(line));
    seen.push_back(agent->GetLastCommandLineResult() ? "ok" : "failed");
  }
  agent->RunSelf(2);
  seen.push_back(agent->ExecuteCommandLine("print --depth 2 i2"));
  return seen;
}

TEST(Remote, AProgramSeesTheSameInProcessAndOverASocket) {
  const RuleFile rules("sml_remote_test", kMoverRules);
  const std::unique_ptr<Kernel> local(Kernel::CreateKernelInNewThread(Kernel::kSuppressListener));
  const std::unique_ptr<Kernel> server(Kernel::CreateKernelInNewThread(Kernel::kUseAnyPort));
  const std::unique_ptr<Kernel> remote(Kernel::CreateRemoteConnection(true, "127.0.0.1", server->GetListenerPort()));
  ASSERT_FALSE(remote->HadError()) << remote->GetLastErrorDescription();
  EXPECT_TRUE(remote->IsRemoteConnection());
  EXPECT_EQ(Play(*remote, rules.path()), Play(*local, rules.path()));
  EXPECT_FALSE(remote->HadError());
}

TEST(Remote, CommandsOfAClientAreOverheardAndWaitWhileTheyAreHeld) {
  using namespace std::chrono_literals;
  const std::unique_ptr<Kernel> server(Kernel::CreateKernelInCurrentThread(false, Kernel::kUseAnyPort));
  Agent* agent = server->CreateAgent("a");
  std::vector<std::string> heard;
  server->OverhearCommands(
      [&](char const* name, char const* line) { heard.push_back(std::string(name) + ": " + line); });
  const auto serve_until = [&](auto& done) {
    while (done.wait_for(1ms) != std::future_status::ready) server->CheckForIncomingCommands();
  };
  const int port = server->GetListenerPort();
  auto connecting = std::async(std::launch::async, [port] {
    return std::unique_ptr<Kernel>(Kernel::CreateRemoteConnection(true, "127.0.0.1", port));
  });
  serve_until(connecting);
  const std::unique_ptr<Kernel> client = connecting.get();
  ASSERT_FALSE(client->HadError());

  for (const bool held : {true, false}) {
    heard.clear();
    server->HoldIncomingCommands(held);
    auto asking =
        std::async(std::launch::async, [&] { return std::string(client->ExecuteCommandLine("print s1", "a")); });
    for (int i = 0; i < (held ? 20 : 5000) && heard.empty(); ++i) {
      agent->RunSelf(5);
      std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(heard.empty(), held);
    serve_until(asking);
    EXPECT_EQ(heard, std::vector<std::string>{"a: print s1"});
  }
  server->ExecuteCommandLine("print s1", "a");
  EXPECT_EQ(heard.size(), 1u) << "the program's own lines are not overheard";
}

TEST(Remote, NobodyAtThePortIsAnErrorThatNamesIt) {
  const std::unique_ptr<Kernel> gone(Kernel::CreateKernelInNewThread(Kernel::kUseAnyPort));
  const int port = gone->GetListenerPort();
  gone->Shutdown();
  const std::unique_ptr<Kernel> remote(Kernel::CreateRemoteConnection(true, nullptr, port));
  EXPECT_TRUE(remote->HadError());
  EXPECT_NE(std::string(remote->GetLastErrorDescription()).find(std::to_string(port)), std::string::npos);
  EXPECT_EQ(remote->CreateAgent("a"), nullptr);
  EXPECT_STREQ(remote->RunAllAgents(1), remote->GetLastErrorDescription());
}

TEST(Remote, EventsFunctionsAndMessagesReachTheClient) {
  const std::unique_ptr<Kernel> server(Kernel::CreateKernelInNewThread(Kernel::kUseAnyPort));
  const std::unique_ptr<Kernel> remote(Kernel::CreateRemoteConnection(true, "127.0.0.1", server->GetListenerPort()));
  std::vector<std::string> made;
  remote->RegisterForAgentEvent(
      smlEVENT_AFTER_AGENT_CREATED,
      [](smlAgentEventId, void* data, Agent* agent) {
        static_cast<std::vector<std::string>*>(data)->push_back(agent->GetAgentName());
      },
      &made);
  Agent* agent = remote->CreateAgent("mine");
  ASSERT_NE(agent, nullptr);
  server->CreateAgent("theirs");
  remote->UpdateAgentList();
  EXPECT_EQ(made, (std::vector<std::string>{"mine", "theirs"}));
  EXPECT_EQ(remote->GetNumberAgents(), 2);

  remote->AddRhsFunction("twice", [](smlRhsEventId, Agent* caller, char const*, char const* argument) {
    // A call from within a call.
    return std::string(argument) + argument + (caller->IsProductionLoaded("call*twice") ? "!" : "?");
  });
  agent->ExecuteCommandLine("sp {call*twice (state <s> ^superstate nil) --> (<s> ^answer (exec twice ab))}");
  agent->RunSelf(1);
  EXPECT_NE(std::string(agent->ExecuteCommandLine("print s1")).find("abab!"), std::string::npos);

  server->RegisterForClientMessageEvent(
      "host", [](smlRhsEventId, Agent*, char const*, char const* message) { return "got " + std::string(message); });
  EXPECT_EQ(remote->SendClientMessage(agent, "host", "it"), "got it");

  agent->RegisterForRunEvent(
      smlEVENT_BEFORE_INPUT_PHASE,
      [](smlRunEventId, void*, Agent* runs, smlPhase) {
        if (runs->GetInputLink()->GetNumberChildren() == 0) runs->CreateIntWME(runs->GetInputLink(), "seen", 1);
      },
      nullptr);
  agent->InitSoar();
  agent->RunSelf(1, sml_PHASE);
  EXPECT_NE(std::string(agent->ExecuteCommandLine("print i2")).find("^seen 1"), std::string::npos);

  EXPECT_TRUE(remote->GetAllConnectionInfo());
  EXPECT_EQ(remote->GetNumberConnections(), 2);
  EXPECT_TRUE(server->DestroyAgent(server->GetAgent("theirs")));
}

TEST(Remote, AKernelThatGoesAwayIsAnErrorAndNotAHang) {
  std::unique_ptr<Kernel> server(Kernel::CreateKernelInNewThread(Kernel::kUseAnyPort));
  const std::unique_ptr<Kernel> remote(Kernel::CreateRemoteConnection(true, "127.0.0.1", server->GetListenerPort()));
  Agent* agent = remote->CreateAgent("a");
  ASSERT_NE(agent, nullptr);
  server.reset();
  agent->RunSelf(1);
  EXPECT_FALSE(remote->GetLastCommandLineResult());
  agent->CreateIntWME(agent->GetInputLink(), "x", 1);
  EXPECT_TRUE(remote->HadError() || agent->HadError());
}

TEST(Remote, AKernelThatIsSilentForLongerThanTheLimitCountsAsGone) {
  const std::unique_ptr<Kernel> server(Kernel::CreateKernelInNewThread(Kernel::kUseAnyPort));
  std::promise<void> go_on;
  server->AddRhsFunction("hang",
                         [&, wait = go_on.get_future().share()](smlRhsEventId, Agent*, char const*, char const*) {
                           wait.wait();
                           return std::string("over");
                         });
  const std::unique_ptr<Kernel> remote(Kernel::CreateRemoteConnection(true, "127.0.0.1", server->GetListenerPort()));
  Agent* agent = remote->CreateAgent("a");
  agent->ExecuteCommandLine("sp {hang (state <s> ^superstate nil) --> (<s> ^answer (exec hang))}");
  remote->SetAnswerLimit(200);
  const auto begun = std::chrono::steady_clock::now();
  agent->RunSelf(1);
  EXPECT_FALSE(remote->GetLastCommandLineResult());
  EXPECT_TRUE(remote->IsConnectionClosed());
  for (int i = 0; i < 1000; ++i) agent->RunSelfTilOutput();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(10));
  go_on.set_value();
}

TEST(Remote, ARunCanBeStoppedFromAnotherThread) {
  const std::unique_ptr<Kernel> server(Kernel::CreateKernelInNewThread(Kernel::kUseAnyPort));
  const std::unique_ptr<Kernel> remote(Kernel::CreateRemoteConnection(true, "127.0.0.1", server->GetListenerPort()));
  Agent* agent = remote->CreateAgent("a");
  agent->ExecuteCommandLine("watch 0");
  agent->ExecuteCommandLine(kCounterRules);
  std::thread stopper([&] {
    while (!server->IsSoarRunning()) std::this_thread::yield();
    agent->StopSelf();
  });
  agent->RunSelfForever();
  stopper.join();
  EXPECT_EQ(agent->GetRunState(), sml_RUNSTATE_INTERRUPTED);
}

}  // namespace
