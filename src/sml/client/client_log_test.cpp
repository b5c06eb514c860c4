// SPDX-License-Identifier: BSD-2-Clause
// The acts of a client are logged. An agent for which the log is replayed makes the same decisions.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "sml_Client.h"
#include "soarbox_ClientLog.h"
#include "soarbox_Observation.h"

namespace soarbox {
namespace {

constexpr const char* kRules = R"(
sp {propose*go
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^turn <t> ^place.name <name>)
-->
   (<s> ^operator <a> + = ^operator <b> + =)
   (<a> ^name left ^turn <t>)
   (<b> ^name right ^turn <t> ^says (exec greet <name>))}

sp {apply*go
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name <name> ^turn <t>)
-->
   (<out> ^<name> <c>)
   (<c> ^turn <t>)}

sp {apply*forget
   (state <s> ^operator.name ^io.output-link <out>)
   (<out> ^<name> <c>)
   (<c> ^status complete)
-->
   (<out> ^<name> <c> -)}
)";

/// The selected operators, in order.
std::vector<std::string> OperatorsIn(const mind::MindRecord& record) {
  std::vector<std::string> names;
  record.events.ForEach([&](const mind::Event& event) {
    if (const auto* selected = std::get_if<mind::OperatorSelected>(&event)) names.emplace_back(selected->name);
  });
  return names;
}

class ClientLog : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "client-log-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
    file = (folder / "run.soarrec").string();
    rules = (folder / "rules.soar").string();
    std::ofstream(rules) << kRules;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// Lets a client drive an agent for some turns. Returns the agent's decisions.
  std::vector<std::string> Drive(int turns, const char* seed) {
    const std::unique_ptr<sml::Kernel> kernel(
        sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener));
    EXPECT_EQ(RecordClients(*kernel, file), "");
    kernel->AddRhsFunction("greet", [](sml::smlRhsEventId, sml::Agent*, char const*, char const* name) {
      return "Hello " + std::string(name);
    });
    sml::Agent* const agent = kernel->CreateAgent("walker");
    EXPECT_TRUE(agent->LoadProductions(rules.c_str()));
    if (seed != nullptr) agent->ExecuteCommandLine(seed);
    mind::MindRecord record;
    std::unique_ptr<Observation> observation = ObserveMind(*agent, record, mind::MindDetail::kDecisions);
    sml::IntElement* const turn = agent->CreateIntWME(agent->GetInputLink(), "turn", 0);
    sml::Identifier* const place = agent->CreateIdWME(agent->GetInputLink(), "place");
    sml::StringElement* const name = agent->CreateStringWME(place, "name", "gate\twith a tab");
    for (int i = 1; i <= turns; ++i) {
      agent->RunSelf(1);
      for (int c = 0; c < agent->GetNumberCommands(); ++c) agent->GetCommand(c)->AddStatusComplete();
      agent->ClearOutputLinkChanges();
      if (i == turns / 2) agent->Update(name, "hall");
      agent->Update(turn, i);
    }
    observation.reset();
    kernel->Shutdown();
    return OperatorsIn(record);
  }

  /// Replays the log for a new agent. Returns its decisions. Adds differences from the recording to `problems`.
  std::vector<std::string> Play(std::vector<std::string>& problems) {
    const std::unique_ptr<sml::Kernel> kernel(
        sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener));
    // Commands in a recording may read only files of the recording.
    kernel->FenceFiles({folder.string()});
    sml::Agent* const agent = kernel->CreateAgent("walker");
    mind::MindRecord record;
    std::unique_ptr<Observation> observation = ObserveMind(*agent, record, mind::MindDetail::kDecisions);
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      std::vector<std::string> parts = PartsOfClientAct(line);
      if (parts.front() == "soarbox-client" || parts.front() == "file") continue;
      if (parts.front() == "function") parts.insert(parts.begin() + 1, "walker");
      if (parts.front() == "agent" || parts.front() == "gone") continue;
      if (std::string problem = PlayClientAct(*agent, parts); !problem.empty()) problems.push_back(std::move(problem));
    }
    observation.reset();
    kernel->Shutdown();
    return OperatorsIn(record);
  }

  std::string Log() const {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  std::filesystem::path folder;
  std::string file, rules;
};

TEST_F(ClientLog, AnAgentThinksAgainAsItDid) {
  const std::vector<std::string> once = Drive(20, nullptr);
  ASSERT_GE(once.size(), 10u);
  std::vector<std::string> problems;
  EXPECT_EQ(Play(problems), once);
  EXPECT_EQ(problems, std::vector<std::string>());
}

TEST_F(ClientLog, ASeedOfTheClientCountsAgain) {
  const std::vector<std::string> once = Drive(20, "srand 7");
  std::vector<std::string> problems;
  EXPECT_EQ(Play(problems), once);
  EXPECT_EQ(problems, std::vector<std::string>());
  EXPECT_NE(Drive(20, "srand 8"), once);
}

TEST_F(ClientLog, HoldsFilesInputAndAnswers) {
  Drive(6, nullptr);
  const std::string log = Log();
  EXPECT_NE(log.find("\nfunction\tgreet\n"), std::string::npos);
  EXPECT_NE(log.find("\nfile\t" + std::filesystem::canonical(rules).string() + "\t"), std::string::npos);
  EXPECT_NE(log.find("\tname\tstring\tgate\\twith a tab\n"), std::string::npos);
  EXPECT_NE(log.find("\tstatus\tstring\tcomplete\n"), std::string::npos);
  EXPECT_NE(log.find("\nanswer\twalker\tgreet\t"), std::string::npos);
  EXPECT_NE(log.find("\ngone\twalker\n"), std::string::npos);
}

TEST_F(ClientLog, AnotherRuleIsNoticed) {
  Drive(12, nullptr);
  std::ofstream(rules, std::ios::app)
      << "sp {more (state <s> ^superstate nil ^io.input-link.turn > 4) --> (<s> ^late yes)}\n";
  std::vector<std::string> problems;
  Play(problems);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems.front().find("its run differs from the recording"), std::string::npos);
}

TEST_F(ClientLog, IsRefusedOnceThereAreAgents) {
  const std::unique_ptr<sml::Kernel> kernel(
      sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener));
  EXPECT_NE(RecordClients(*kernel, (folder / "no/such/folder").string()).find("cannot be written"), std::string::npos);
  kernel->CreateAgent("early");
  EXPECT_NE(RecordClients(*kernel, file).find("before you create the first agent"), std::string::npos);
}

}  // namespace
}  // namespace soarbox
