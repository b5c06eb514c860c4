// SPDX-License-Identifier: BSD-2-Clause
// Recordings keep the files of a run, so that it can be continued even if the files have changed.
#include "record/kept_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "diagnostics/read_text.h"
#include "record/branch.h"
#include "record/history.h"
#include "record/recorder.h"
#include "record/run_test_support.h"
#include "record/ticks_test_support.h"
#include "sim/live_edits.h"
#include "sim/simulation.h"
#include "world/world.h"

namespace soarbox::record {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWalk = R"(sp {walk*propose
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <o> + =)
   (<o> ^name SAY)
}
sp {walk*apply
   (state <s> ^operator.name SAY ^io.output-link <out>)
-->
   (<out> ^set-speed <c>)
   (<c> ^speed 1)
}
)";

std::string Rules(const std::string& word) {
  std::string text = kWalk;
  for (std::size_t at = 0; (at = text.find("SAY", at)) != std::string::npos;) text.replace(at, 3, word);
  return text;
}

void Put(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// A world with one agent. Its file of rules sources a second file in a subfolder.
class KeptFilesTest : public testing::Test, protected NotedRun {
 protected:
  using NotedRun::Run;  // Not the one of testing::Test.

  KeptFilesTest() {
    Put(folder() / "scout.soar", "source more/walk.soar\n");
    Put(folder() / "more" / "walk.soar", Rules("amble"));
    Put(folder() / "notes.txt", "nobody's business");
    scenario = sim::FindScenario((folder() / "scout.soar").string(), Data()).value();
    settings.soar.threads = 1;
    settings.mind_detail = sim::MindDetail::kDecisions;
    simulation = std::move(sim::Simulation::Create(scenario, settings).value());
    history = std::make_unique<History>(HeaderOf(scenario, settings, 1.0 / 30, Level::kDecisions));
    Note();
  }
  Result<std::unique_ptr<Branch>> Arrive(std::uint64_t tick) {
    Result<std::unique_ptr<Branch>> branch = Branch::Begin(*history, scenario, settings, tick);
    while (branch && !(*branch)->IsThere())
      if (const Result<void> gone = (*branch)->Advance(100); !gone) return gone.error();
    return branch;
  }
  const fs::path& folder() const { return scratch_.path(); }

 private:
  ScratchFolder scratch_;
};

TEST_F(KeptFilesTest, WhatLinksLeadOutToIsNotKept) {
  const ScratchFolder outside;
  Put(outside.path() / "secret.soar", "somebody's secret");
  fs::create_symlink(outside.path() / "secret.soar", folder() / "link.soar");
  fs::create_directory_symlink(outside.path(), folder() / "linked");
  fs::create_symlink("/dev/zero", folder() / "zero.lua");
  fs::create_symlink(folder() / "more" / "walk.soar", folder() / "same.soar");
  const ScenarioFiles files = ReadScenarioFiles(scenario);
  EXPECT_EQ(files.files, (std::vector<KeptFile>{{0, "more/walk.soar", Rules("amble")},
                                                {0, "same.soar", Rules("amble")},
                                                {0, "scout.soar", "source more/walk.soar\n"}}));
}

TEST_F(KeptFilesTest, ScriptsRulesAndScenarioFilesAreKeptAndNothingElse) {
  const ScenarioFiles files = ReadScenarioFiles(scenario);
  EXPECT_EQ(files.files, (std::vector<KeptFile>{{0, "more/walk.soar", Rules("amble")},
                                                {0, "scout.soar", "source more/walk.soar\n"}}));
  EXPECT_EQ(ReadScenarioFiles(scenario).digest, files.digest);
  Put(folder() / "more" / "walk.soar", Rules("stroll"));
  EXPECT_NE(ReadScenarioFiles(scenario).digest, files.digest);
}

TEST_F(KeptFilesTest, FilesThatAreAddedChangeNothing) {
  const ScenarioFiles then = ReadScenarioFiles(scenario);
  Put(folder() / "another.soar", Rules("stroll"));
  EXPECT_FALSE(HaveChanged(scenario, then.digest, then.files));
  Put(folder() / "more" / "walk.soar", Rules("amble") + "\n");
  EXPECT_TRUE(HaveChanged(scenario, then.digest, then.files));
  Put(folder() / "more" / "walk.soar", Rules("amble"));
  EXPECT_FALSE(HaveChanged(scenario, then.digest, then.files));
  fs::remove(folder() / "more" / "walk.soar");
  EXPECT_TRUE(HaveChanged(scenario, then.digest, then.files));
}

TEST_F(KeptFilesTest, ARunIsGoneOnWithAsItWasWhateverBecameOfItsFiles) {
  Run(20);
  Put(folder() / "more" / "walk.soar", "sp {other (state <s> ^superstate nil) --> (halt)}\n");
  const Result<std::unique_ptr<Branch>> branch = Arrive(12);
  ASSERT_TRUE(branch) << Format(branch.error());
  ASSERT_EQ((*branch)->warnings().size(), 1u);
  EXPECT_NE((*branch)->warnings()[0].message.find("have changed"), std::string::npos);
  Futures futures = (*branch)->CompareFutures();
  std::unique_ptr<sim::Simulation> again = (*branch)->TakeSimulation();
  TickRecord now;
  for (int i = 0; i < 8; ++i) {
    again->Tick();
    Observe(*again, again->TakeEvents(), Level::kDecisions, now);
    futures.See(now);
  }
  EXPECT_FALSE(futures.comparison().difference);
  EXPECT_EQ(futures.comparison().last_tick, 20u);
  // Editing opens the user's own file, not the copy.
  for (const sim::WatchedFile& file : again->Files())
    EXPECT_EQ(file.file.string().find("soarbox-run-"), std::string::npos) << file.file;
}

TEST_F(KeptFilesTest, WhatWasEditedSinceComesOnTop) {
  sim::LiveEdits edits(*simulation);
  Run(10);
  Put(folder() / "more" / "walk.soar", Rules("stroll"));
  fs::last_write_time(folder() / "more" / "walk.soar", fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_FALSE(edits.Poll().empty());
  Run(10);
  // Before the edit: the old rule runs, and the edit is applied again. After it: the edit is included.
  for (const std::uint64_t tick : {5u, 15u}) {
    const Result<std::unique_ptr<Branch>> branch = Arrive(tick);
    ASSERT_TRUE(branch) << Format(branch.error());
    const std::unique_ptr<sim::Simulation> again = (*branch)->TakeSimulation();
    sim::LiveEdits later(*again, edits);
    EXPECT_EQ(later.Poll().empty(), tick == 15) << tick;
    again->Tick();
    const Result<std::string> rule = again->Command(again->Mind(0).agent, "print walk*propose");
    ASSERT_TRUE(rule) << Format(rule.error());
    EXPECT_NE(rule->find("stroll"), std::string::npos) << *rule;
    EXPECT_TRUE(later.Poll().empty());
  }
}

TEST_F(KeptFilesTest, CopiesGoWithTheLastWhoNeedsThem) {
  Result<sim::Scenario> kept = WithKeptFiles(scenario, ReadScenarioFiles(scenario).files);
  ASSERT_TRUE(kept) << Format(kept.error());
  const fs::path rules = kept->rules;
  EXPECT_NE(rules, scenario.rules);
  EXPECT_EQ(ReadText(rules), "source more/walk.soar\n");
  EXPECT_EQ(kept->Original(rules), scenario.rules);
  auto user = std::make_unique<sim::Scenario>(*kept);
  kept = sim::Scenario();
  EXPECT_TRUE(fs::exists(rules));
  user.reset();
  EXPECT_FALSE(fs::exists(rules.parent_path()));
}

TEST_F(KeptFilesTest, ARunIsGoneOnWithWhenItsScenarioIsThereNoMore) {
  // By the file, by its name without the extension, and from the folder of the run.
  for (const auto& [name, from] : {std::pair{(folder() / "scout.soar").string(), fs::path()},
                                   {(folder() / "scout").string(), fs::path()},
                                   {std::string("scout.soar"), folder()}}) {
    SCOPED_TRACE(name);
    Header header = HeaderOf(scenario, settings, 1.0 / 30, Level::kDecisions);
    header.scenario = name;
    header.folder = from.string();
    history = std::make_unique<History>(header);
    simulation = std::move(sim::Simulation::Create(scenario, settings).value());
    Note();
    Run(12);
    const fs::path away = folder().string() + "-away";
    fs::rename(folder(), away);
    Result<std::unique_ptr<Branch>> branch = Branch::Begin(*history, Data(), 10, 1);
    while (branch && !(*branch)->IsThere()) ASSERT_TRUE((*branch)->Advance(100));
    fs::rename(away, folder());
    ASSERT_TRUE(branch) << Format(branch.error());
    ASSERT_EQ((*branch)->warnings().size(), 1u);
    EXPECT_NE((*branch)->warnings()[0].message.find("no longer there"), std::string::npos);
  }
}

TEST_F(KeptFilesTest, NamesThatLeadElsewhereAreRefused) {
  for (const char* name : {"../x.soar", "/tmp/x.soar", "a/../../x.soar", "", ".", "..", "a/"}) {
    const Result<sim::Scenario> kept = WithKeptFiles(scenario, {{0, name, "x"}});
    EXPECT_FALSE(kept) << name;
  }
  EXPECT_FALSE(WithKeptFiles(scenario, {}));
}

}  // namespace
}  // namespace soarbox::record
