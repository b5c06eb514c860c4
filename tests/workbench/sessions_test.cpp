// SPDX-License-Identifier: BSD-2-Clause
// Complete sessions of a user who watches a run: requests are JSON, contents are JSON. No display.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <thread>

#include "app/event_printer.h"
#include "app/record_run.h"
#include "app/run_session.h"
#include "debugger/views.h"
#include "diagnostics/problem.h"
#include "record/reader.h"
#include "record/run_test_support.h"
#include "record/ticks_test_support.h"
#include "sim/scenario.h"
#include "workbench/contents_json.h"
#include "workbench/desk.h"
#include "workbench/flow_info.h"
#include "workbench/pace.h"
#include "workbench/requests_json.h"

namespace soarbox {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using workbench::Json;

/// The surroundings of a desk that only record the calls.
class Room final : public workbench::Surroundings {
 public:
  bool IsPaused() const override { return pace.paused(); }
  void Pause() override { pace.Pause(); }
  void GoOn() override { pace.Resume(); }
  void SetSpeed(double speed) override { pace.SetSpeed(speed); }
  void Tell(std::string remark) override { told.push_back(std::move(remark)); }

  workbench::Pace pace{1};
  std::vector<std::string> told;
};

/// A user of a desk who writes and reads JSON.
class Watcher {
 public:
  explicit Watcher(workbench::Desk& desk) : desk_(desk) {}

  void Ask(const char* request) {
    const Result<workbench::Request> read = workbench::ReadRequest(Json::parse(request));
    ASSERT_TRUE(read) << read.error().message;
    panels_.requests.push_back(*read);
  }
  /// Returns whether the contents are new, so that a page or a window is sent them.
  bool Serve() { return desk_.Serve(panels_); }
  Json See(const char* name) { return workbench::ToJson(panels_.contents, name); }
  /// Serves until nothing is being read or simulated again; this begins when seeking has ended.
  void Await() {
    for (int i = 0; i < 20'000; ++i) {
      Serve();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (See("moment")["past_note"] == "" && See("moment")["not_available"] == "") return;
    }
    ADD_FAILURE() << See("moment").dump();
  }

 private:
  workbench::Desk& desk_;
  workbench::PanelExchange panels_;
};

class Sessions : public testing::Test {
 protected:
  Sessions() { setenv("XDG_STATE_HOME", (scratch.path() / "state").c_str(), 1); }
  ~Sessions() override { unsetenv("XDG_STATE_HOME"); }

  /// A recorded run of soldiers with Soar minds.
  void Begin(record::Level level = record::Level::kDecisions, const char* name = "soar_skirmish") {
    scenario = sim::FindScenario(name, record::Data()).value();
    settings.seed = settings.soar.seed = 4;
    settings.soar.threads = 1;
    settings.mind_detail = sim::MindDetail::kDecisions;
    options.scenario = name;
    options.record = scratch.path() / "fight.soarrec";
    session.emplace(std::move(sim::Simulation::Create(scenario, settings).value()),
                    app::EventPrinter::MakeText(out, out), options);
    header = app::HeaderOfRun(options, scenario, settings, session->simulation(), level);
    recordings.emplace(options);
    static_cast<void>(recordings->Begin(*session, header));
  }
  void Tick(workbench::Desk& desk, int ticks) {
    for (int i = 0; i < ticks && !desk.WasHit(); ++i) {
      desk.Prepare();
      session->Tick();
    }
  }

  record::ScratchFolder scratch;
  std::ostringstream out;
  sim::Scenario scenario;
  sim::SimulationSettings settings;
  app::RunOptions options;
  record::Header header;
  std::optional<app::RunSession> session;
  std::optional<app::RunRecordings> recordings;
  Room room;
};

TEST_F(Sessions, ALiveRunIsWatchedAskedStoppedAndSentBack) {
  Begin();
  const std::uint64_t hash_alone = [&] {
    auto alone = std::move(sim::Simulation::Create(scenario, settings).value());
    for (int i = 0; i < 40; ++i) alone->Tick();
    return alone->StateHash();
  }();
  workbench::Desk desk(*session, header, scenario, settings, room);
  Watcher user(desk);

  // A user with no panel open only gets the state of the run.
  Tick(desk, 10);
  user.Serve();
  EXPECT_EQ(user.See("moment")["agent"], "");
  EXPECT_EQ(user.See("moment")["time"]["last_tick"], 10);
  EXPECT_THAT(user.See("agents")["agents"], IsEmpty());

  // An agent's mind, and why it does what it does.
  user.Ask(R"({"request": "select", "agent": "blue-1"})");
  user.Ask(
      R"({"request": "look", "panels": ["agents", "mind", "why", "rules", "links", "memory", "trace", "timeline"]})");
  Tick(desk, 30);
  user.Serve();
  EXPECT_EQ(session->simulation().StateHash(), hash_alone) << "watching changes nothing";
  EXPECT_EQ(user.See("moment")["has_mind"], true);
  EXPECT_EQ(user.See("agents")["agents"].size(), session->simulation().soar_agents());
  const Json stack = user.See("mind")["stack"];
  EXPECT_THAT(stack.dump(), HasSubstr("S1"));
  EXPECT_THAT(user.See("why")["question"].get<std::string>(), HasSubstr("blue-1"));
  EXPECT_THAT(user.See("why")["answer"].dump(), Not(IsEmpty()));
  EXPECT_GT(user.See("rules")["rules"].size(), 5U);
  EXPECT_THAT(user.See("links")["io"].dump(), HasSubstr("input-link"));
  EXPECT_THAT(user.See("trace")["lines"].dump(), HasSubstr("blue-1"));

  // The command line prints the same JSON.
  const auto mind = session->simulation().Inspect("blue-1");
  EXPECT_EQ(stack, workbench::ToJson(
                       [&] {
                         workbench::Contents contents;
                         contents.stack = debugger::LookAtStack(*mind);
                         return contents;
                       }(),
                       "mind")["stack"]);
  debugger::RunModels models;
  record::TickRecord last;
  record::Observe(session->simulation(), {}, record::Level::kAll, last);
  for (const workbench::ContentField& field : workbench::ContentFields()) {
    if (field.view != "stack" && field.view != "operators" && field.view != "rules") continue;
    const auto shown = debugger::ShowView({&session->simulation(), &models, &last, nullptr},
                                          {std::string(field.view), "blue-1", "", 0, last.tick});
    ASSERT_TRUE(shown) << shown.error().message;
    EXPECT_EQ(Json::parse(shown->json), user.See(std::string(field.content).c_str())[std::string(field.name)])
        << field.view;
  }

  // Queries, an unfolded object, a console.
  user.Ask(R"({"request": "object", "id": "S1"})");
  user.Ask(R"({"request": "ask", "about": "not", "what": "no-such-operator"})");
  user.Ask(R"({"request": "console", "agent": "blue-1", "line": "print s1"})");
  user.Ask(R"({"request": "complete", "agent": "blue-1", "line": "pri"})");
  user.Ask(R"({"request": "look", "panels": ["memory", "why", "console"]})");
  user.Serve();
  EXPECT_THAT(user.See("memory")["objects"]["S1"].dump(), HasSubstr("superstate"));
  EXPECT_THAT(user.See("why")["question"].get<std::string>(), HasSubstr("Why not no-such-operator"));
  EXPECT_THAT(user.See("console")["lines"].dump(), HasSubstr("(S1 "));
  EXPECT_THAT(user.See("console")["completion"]["words"].dump(), HasSubstr("print"));

  // A breakpoint stops the world; an invalid one is a problem.
  user.Ask(R"({"request": "break", "kind": "command"})");
  user.Ask(R"({"request": "break", "kind": "fire", "what": ""})");
  user.Ask(R"({"request": "look", "panels": ["breakpoints", "problems"]})");
  user.Serve();
  EXPECT_EQ(user.See("breakpoints")["breakpoints"].size(), 1U);
  EXPECT_EQ(user.See("problems")["problems"].size(), 1U) << user.See("problems").dump();
  Tick(desk, 300);
  user.Serve();
  ASSERT_TRUE(desk.WasHit());
  EXPECT_THAT(user.See("breakpoints")["hits"].dump(), HasSubstr("breakpoint 1"));
  user.Ask(R"({"request": "change-break", "number": 1, "what": "clear"})");
  user.Serve();
  EXPECT_THAT(user.See("breakpoints")["breakpoints"], IsEmpty());

  // Back to a past tick, and then forward from there.
  const std::uint64_t newest = session->simulation().tick();
  user.Ask(R"({"request": "seek", "tick": 20})");
  user.Ask(R"({"request": "look", "panels": ["mind", "futures"]})");
  user.Serve();
  EXPECT_FALSE(desk.past().is_live());
  EXPECT_TRUE(room.pace.paused());
  EXPECT_EQ(user.See("moment")["time"]["shown_tick"], 20);
  user.Await();
  EXPECT_THAT(user.See("mind")["stack"].dump(), HasSubstr("S1"));
  user.Ask(R"({"request": "resume"})");
  user.Serve();
  EXPECT_TRUE(desk.past().is_live());
  EXPECT_EQ(session->simulation().tick(), 20U);
  Tick(desk, 5);
  user.Serve();
  user.Serve();
  EXPECT_EQ(user.See("moment")["time"]["branches"], 1);
  EXPECT_EQ(user.See("futures")["futures"]["branch_tick"], 20);
  EXPECT_THAT(user.See("ghosts")["ghosts"].dump(), HasSubstr("before")) << newest;
}

TEST_F(Sessions, APlotOfAPausedRunIsShownWhenItsPastHasBeenRead) {
  Begin();
  workbench::Desk desk(*session, header, scenario, settings, room);
  Watcher user(desk);
  Tick(desk, 300);
  room.Pause();
  user.Ask(R"({"request": "select", "agent": "blue-1"})");
  user.Ask(R"({"request": "look", "panels": ["plots"]})");
  user.Serve();
  user.Ask(R"({"request": "plot", "agent": "blue-1", "what": "health", "is_on": true})");
  user.Ask(R"({"request": "plot", "agent": "blue-1", "what": "speed", "is_on": true})");
  // A call reads the past for one plot at most. Only new contents are shown.
  Json shown;
  for (int i = 0; i < 200; ++i) {
    if (user.Serve()) shown = user.See("plots");
  }
  const Json points = shown["plots"].at(1)["points"];
  ASSERT_FALSE(points.empty());
  EXPECT_EQ(points.front()[0], 0);
  EXPECT_GE(points.back()[0], 299);
}

TEST_F(Sessions, OnlyFilesOfTheRunAreEditedAndDraftsOutliveTheSession) {
  Begin();
  std::string file;
  {
    workbench::Desk desk(*session, header, scenario, settings, room);
    Watcher user(desk);
    user.Ask(R"({"request": "select", "agent": "blue-1"})");
    user.Ask(R"({"request": "look", "panels": ["edit", "problems"]})");
    user.Ask(R"({"request": "edit", "file": "/etc/hostname"})");
    user.Serve();
    EXPECT_EQ(user.See("edit")["edit"]["file"], "");
    EXPECT_THAT(user.See("problems")["problems"].dump(), HasSubstr("only files of the run"));
    file = user.See("edit")["files"][0]["file"];
    ASSERT_THAT(file, HasSubstr(".soar"));
    user.Ask(Json{{"request", "edit"}, {"file", file}}.dump().c_str());
    user.Ask(R"j({"request": "edit-text", "what": "check", "text": "sp {broken (state <s>) --> (<s> ^x"})j");
    user.Serve();
    EXPECT_EQ(user.See("edit")["edit"]["is_unsaved"], true);
    EXPECT_THAT(user.See("edit")["edit"]["problems"], Not(IsEmpty()));
  }
  workbench::Desk desk(*session, header, scenario, settings, room);
  Watcher user(desk);
  user.Ask(Json{{"request", "edit"}, {"file", file}}.dump().c_str());
  user.Ask(R"({"request": "look", "panels": ["edit"]})");
  user.Serve();
  user.Serve();
  EXPECT_THAT(user.See("edit")["edit"]["text"].get<std::string>(), HasSubstr("broken")) << "the draft";
  user.Ask(R"({"request": "edit-text", "what": "revert", "text": ""})");
  user.Serve();
  EXPECT_THAT(user.See("edit")["edit"]["text"].get<std::string>(), Not(HasSubstr("broken")));
}

TEST_F(Sessions, ProblemsOfAFileAreOverWhenItIsChangedWithoutErrors) {
  Begin();
  workbench::Desk desk(*session, header, scenario, settings, room);
  Watcher user(desk);
  user.Ask(R"({"request": "select", "agent": "blue-1"})");
  user.Ask(R"({"request": "look", "panels": ["edit", "problems"]})");
  user.Serve();
  const std::string file = user.See("edit")["files"][0]["file"];
  user.Ask(Json{{"request", "edit"}, {"file", file}}.dump().c_str());
  user.Serve();
  const std::string text = user.See("edit")["edit"]["text"];
  desk.NoteProblem(ProblemIn(file, "the first problem"), {});
  desk.NoteProblem(ProblemIn("other.soar", "the second problem"), {});
  const auto problems_after = [&](const std::string& applied) {
    user.Ask(Json{{"request", "edit-text"}, {"what", "apply"}, {"text", applied}}.dump().c_str());
    user.Serve();
    return user.See("problems")["problems"].dump();
  };
  EXPECT_THAT(problems_after("sp {broken (state <s>) --> (<s> ^x"), HasSubstr("the first problem"));
  EXPECT_THAT(problems_after(text + "\n"), AllOf(HasSubstr("the second problem"), Not(HasSubstr("the first problem"))));
}

TEST_F(Sessions, ATextThatIsAppliedInThePastIsUsedByTheRunOnlyIfItContinuesFromThere) {
  Begin();
  workbench::Desk desk(*session, header, scenario, settings, room);
  Watcher user(desk);
  Tick(desk, 5);
  user.Ask(R"({"request": "select", "agent": "blue-1"})");
  user.Ask(R"({"request": "look", "panels": ["edit", "problems", "mind"]})");
  user.Serve();
  const std::string file = user.See("edit")["files"][0]["file"];
  user.Ask(Json{{"request", "edit"}, {"file", file}}.dump().c_str());
  user.Serve();
  const std::string text = user.See("edit")["edit"]["text"].get<std::string>() +
                           "\nsp {extra (state <s> ^superstate nil) --> (<s> ^extra yes)}\n";
  desk.NoteProblem(ProblemIn(file, "the problem of the file"), {});
  Tick(desk, 10);
  const auto apply = [&] {
    user.Ask(Json{{"request", "edit-text"}, {"what", "apply"}, {"text", text}}.dump().c_str());
    user.Serve();
    EXPECT_THAT(user.See("edit")["edit"]["notice"].get<std::string>(), HasSubstr("Reloaded"));
    EXPECT_EQ(user.See("edit")["edit"]["is_changed"], false);
  };
  const auto go_back = [&] {
    user.Ask(R"({"request": "seek", "tick": 8})");
    user.Await();
  };
  const auto has_extra = [&] {
    const Result<std::string> rule = session->simulation().Command("blue-1", "print extra");
    return rule && rule->find("^extra yes") != std::string::npos;
  };
  const auto has_problem = [&] {
    return user.See("problems")["problems"].dump().find("the problem of the file") != std::string::npos;
  };

  // Left again: the run keeps its rules and its problems.
  go_back();
  apply();
  EXPECT_TRUE(has_problem());
  user.Ask(R"({"request": "live"})");
  user.Serve();
  EXPECT_EQ(user.See("edit")["edit"]["is_changed"], true);
  Tick(desk, 1);
  EXPECT_FALSE(has_extra());

  // Continued: the run has the rule.
  go_back();
  apply();
  user.Ask(R"({"request": "resume"})");
  user.Serve();
  Tick(desk, 1);
  EXPECT_TRUE(has_extra());
  user.Serve();
  EXPECT_FALSE(has_problem());
  EXPECT_EQ(user.See("edit")["edit"]["is_changed"], false);
}

TEST_F(Sessions, AScriptStopsInsideATickWhileItsUserIsServed) {
  Begin(record::Level::kDecisions, "thesis");
  const std::uint64_t hash_alone = [&] {
    auto alone = std::move(sim::Simulation::Create(scenario, settings).value());
    for (int i = 0; i < 12; ++i) alone->Tick();
    return alone->StateHash();
  }();
  std::optional<workbench::Desk> desk(std::in_place, *session, header, scenario, settings, room);
  std::optional<Watcher> user(std::in_place, *desk);
  constexpr const char* kStop = R"({"request": "line-stop", "file": "SeekingLuaAgent.lua", "line": 14})";
  user->Ask(kStop);
  user->Serve();
  EXPECT_THAT(room.told.back(), HasSubstr("Scripts cannot stop here"));

  int waits = 0;
  std::function<void()> at_stop;
  const auto wait = [&] {
    ++waits;
    if (at_stop) at_stop();
    if (desk->scripts().is_stopped()) desk->scripts().GoOn();
  };
  desk->scripts().SetWait(wait);
  user->Ask(kStop);
  user->Ask(R"({"request": "look", "panels": ["script", "edit", "agents"]})");
  user->Serve();
  EXPECT_EQ(user->See("script")["stops"].size(), 1U);
  at_stop = [&] {
    if (waits > 1) return;
    for (const char* request : {R"({"request": "seek", "tick": 1})", R"({"request": "resume"})",
                                R"({"request": "console", "agent": "x", "line": "print s1"})"}) {
      room.told.clear();
      user->Ask(request);
      user->Serve();
      EXPECT_THAT(room.told, testing::ElementsAre(HasSubstr("stopped at SeekingLuaAgent.lua:14"))) << request;
    }
    EXPECT_EQ(user->See("edit")["edit"]["stopped_line"], 14) << "the editor shows the place";
    EXPECT_EQ(user->See("edit")["edit"]["stops"], Json({14}));
    EXPECT_EQ(user->See("script")["stopped"]["line"], 14);
    EXPECT_THAT(user->See("script")["variables"]["locals"].dump(), HasSubstr("deltaTimeInMillis"));
    user->Ask(R"({"request": "script-go", "how": "over"})");
    EXPECT_FALSE(user->Serve());
    EXPECT_FALSE(desk->scripts().is_stopped());
    EXPECT_TRUE(desk->scripts().is_in_tick());
  };
  Tick(*desk, 2);
  EXPECT_EQ(waits, 3) << "a stop, a step, a stop";
  at_stop = [&] { desk->scripts().Leave(); };
  Tick(*desk, 9);
  session->Tick();  // Without Prepare.
  EXPECT_EQ(waits, 12);
  EXPECT_EQ(session->simulation().StateHash(), hash_alone) << "stops change nothing";
  user->Serve();
  EXPECT_EQ(user->See("edit")["edit"]["stopped_line"], 0);
  EXPECT_TRUE(user->See("script")["stopped"].is_null());

  // The next desk has the same stops.
  workbench::Desk::Belongings belongings = desk->TakeBelongings();
  user.reset();
  desk.reset();
  session->Tick();
  desk.emplace(*session, header, scenario, settings, room);
  desk->scripts().SetWait(wait);
  desk->Bring(std::move(belongings));
  Tick(*desk, 1);
  EXPECT_EQ(waits, 13);
}

TEST_F(Sessions, EachCommandOfTheRunHasOneMeaningWhileAScriptIsStopped) {
  Begin(record::Level::kDecisions, "thesis");
  workbench::Desk desk(*session, header, scenario, settings, room);
  Watcher user(desk);
  std::vector<std::string> effects;
  desk.scripts().SetWait([&] {
    const auto flow = static_cast<workbench::Flow>(effects.size());
    workbench::Pace pace(1);
    if (flow == workbench::Flow::kTogglePause) pace.Pause();
    room.told.clear();
    std::string effect = desk.scripts().ObeyInTick(flow, pace) ? "" : "after the tick";
    if (desk.scripts().is_stopped()) effect += room.told.empty() ? "stays stopped" : "refused";
    if (pace.paused()) effect += "pauses";
    if (pace.speed() != 1) effect += ", other speed";
    effects.push_back(effect);
  });
  user.Ask(R"({"request": "line-stop", "file": "SeekingLuaAgent.lua", "line": 14})");
  user.Serve();
  Tick(desk, static_cast<int>(workbench::kFlowInfos.size()));
  EXPECT_THAT(effects, testing::ElementsAre("", "pauses", "refused", "refused", "refused", "stays stopped, other speed",
                                            "stays stopped, other speed", "stays stopped", "stays stopped, other speed",
                                            "after the tick", "after the tick", "after the tick", "pauses"));
}

TEST_F(Sessions, ARecordingIsWatchedForwardsAndBackwards) {
  Begin();
  for (int i = 0; i < 60; ++i) session->Tick();
  session->Record(nullptr);
  const auto recording = record::Reader::Open(options.record);
  ASSERT_TRUE(recording) << recording.error().message;
  workbench::Desk desk(**recording, record::Data(), {0, 60}, room);
  Watcher user(desk);
  EXPECT_FALSE(desk.past().is_live());
  user.Ask(R"({"request": "select", "agent": "red-1"})");
  user.Ask(R"({"request": "look", "panels": ["mind", "why", "agents", "timeline"]})");
  user.Ask(R"({"request": "seek", "tick": 45})");
  user.Serve();
  ASSERT_NE(desk.PastScene(), nullptr);
  EXPECT_EQ(desk.PastScene()->tick, 45U);
  EXPECT_EQ(user.See("moment")["time"]["is_recording"], true);
  EXPECT_EQ(user.See("moment")["time"]["can_resume"], false);
  user.Await();
  const Json at_45 = user.See("mind")["stack"];
  EXPECT_THAT(at_45.dump(), HasSubstr("S1"));
  EXPECT_THAT(user.See("why")["answer"].dump(), Not(HasSubstr("Not recorded")));
  // Back, and forward again: the same mind.
  user.Ask(R"({"request": "seek", "tick": 5})");
  user.Serve();
  user.Await();
  EXPECT_EQ(user.See("moment")["time"]["shown_tick"], 5);
  user.Ask(R"({"request": "seek", "tick": 45})");
  user.Serve();
  user.Await();
  EXPECT_EQ(user.See("mind")["stack"], at_45);
  // Requests that need a live run are refused with a remark or a problem.
  user.Ask(R"({"request": "break", "kind": "command"})");
  user.Ask(R"({"request": "open-run", "what": "soar_seek"})");
  user.Ask(R"({"request": "save-picture"})");
  user.Ask(R"({"request": "resume"})");
  user.Ask(R"({"request": "look", "panels": ["problems"]})");
  user.Serve();
  EXPECT_EQ(room.told.size(), 3U);
  EXPECT_THAT(room.told[0], HasSubstr("Breakpoints stop a run"));
  EXPECT_THAT(user.See("problems")["problems"].dump(), HasSubstr("cannot be opened here"));
  EXPECT_EQ(user.See("moment")["time"]["shown_tick"], 45);
}

}  // namespace
}  // namespace soarbox
