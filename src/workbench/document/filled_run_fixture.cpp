// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/document/filled_run_fixture.h"

#include <stdlib.h>

#include <fstream>

#include "debugger/agents.h"
#include "debugger/rule_edit.h"
#include "record/recorder.h"

namespace soarbox::workbench {
namespace {

const char* const kWorld = R"(
[[agent]]
name = "walker"
rules = "walker.soar"
body = "soldier"
team = "red"
[[agent]]
name = "listener-with-a-rather-long-name"
rules = "listener.soar"
body = "soldier"
team = "red"
position = [6, 0]
[[waypoint]]
name = "east"
position = [18, 0]
[[waypoint]]
name = "north"
position = [0, -18]
)";

const char* const kWalker = R"(
sp {walker*propose*seek
   (state <s> ^superstate nil ^reward-link <r> ^io.input-link.waypoint <w>)
   (<w> ^name <name> ^here no)
-->
   (<s> ^operator <o> +)
   (<r> ^reward.value 0.5)
   (<o> ^name seek ^waypoint <name>)
}
sp {walker*prefer*north
   (state <s> ^superstate nil ^operator <a> + ^operator <b> +)
   (<a> ^waypoint north)
   (<b> ^waypoint east)
-->
   (<s> ^operator <a> > <b>)
}
sp {walker*apply*seek
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name seek ^waypoint <name>)
-->
   (<out> ^seek <command> ^broadcast <call>)
   (<command> ^waypoint <name> ^within 0.8)
   (<call> ^about contact ^text |I am on my way to a waypoint, follow me as soon as you can| ^range 12)
}
sp {walker*propose*flee
   (state <s> ^superstate nil ^io.input-link.self.health < 10)
-->
   (<s> ^operator <o> +)
   (<o> ^name flee)
}
)";

const char* const kListener = R"(
sp {listener*propose*first
   (state <s> ^superstate nil)
-->
   (<s> ^operator <o> +)
   (<o> ^name first)
}
sp {listener*propose*second
   (state <s> ^superstate nil)
-->
   (<s> ^operator <o> +)
   (<o> ^name second)
}
)";

}  // namespace

FilledRun::FilledRun() {
  std::string name = (std::filesystem::temp_directory_path() / "soarbox-panels-XXXXXX").string();
  folder_ = mkdtemp(name.data());
  Write("scenario.toml", kWorld);
  Write("walker.soar", kWalker);
  Write("listener.soar", kListener);
  const std::string root = SOARBOX_SOURCE_DIR;
  const auto scenario = sim::FindScenario(folder_.string(), {root + "/scenarios", root + "/media"});
  sim::SimulationSettings settings;
  settings.mind_detail = sim::MindDetail::kAll;
  settings.soar.threads = 1;
  simulation = std::move(*sim::Simulation::Create(*scenario, settings));
  for (const char* what : {"health", "self.position.x", "decide_us", "S1.reward-link.reward.value"})
    models.plots.Plot("walker", what);
  constexpr int kTicks = 45;
  for (int i = 0; i <= kTicks; ++i) {
    if (i > 0) simulation->Tick();
    record::Observe(*simulation, simulation->TakeEvents(), record::Level::kAll, last);
    models.Add(last);
    models.plots.Sample(*simulation);
  }
}

FilledRun::~FilledRun() {
  std::filesystem::remove_all(folder_);
}

void FilledRun::Fill(const std::string& agent) {
  contents = {};
  Moment& at = contents.moment;
  at.last_tick = at.shown_tick = last.tick;
  at.can_go_back = true;
  contents.agent = agent;
  contents.agent_count = 2;
  contents.soar_agents = {"walker", "listener-with-a-rather-long-name"};
  contents.timeline = &models.timeline;
  contents.trace = &models.trace;
  contents.messages = &models.messages;
  contents.plots = &models.plots.series();
  contents.agents = debugger::ListAgents(*simulation, models.troubles, &models.timeline);
  Diagnostic problem;
  problem.file = "/home/somebody/scenarios/of/my/own/walker.soar";
  problem.line = 14;
  problem.column = 12;
  problem.message = "variable <t> is used on the right-hand side but no condition binds it";
  problem.excerpt = "   (<s> ^target <t>)";
  problem.excerpt_length = 3;
  problem.hint = "did you mean <target>?";
  contents.problems.push_back({problem, "walker", 12, 0.4});
  ExerciseContents& exercise = contents.exercise.emplace();
  exercise.exercise = 3;
  exercise.address = "239.1.2.3:3000";
  exercise.as = "1:7";
  exercise.sent = 120;
  exercise.dropped = {{"too short", 12}};
  exercise.entity_count = 2;
  exercise.entities = {{"7:8:9", "visitor", "visitor", "red", "soldier", "3.1.225.1.1.0.0", 0},
                       {"7:8:10", "", "far away", "blue", "walker", "1.2.225.1.1.0.0", 9}};
  contents.imagery = debugger::ReadImagery(
      "S1 node \"world\" {\"shape\":\"group\"}\n"
      "S1 node \"wall\" {\"parent\":\"world\",\"shape\":\"hull\",\"at\":[10,0,2.5],\"tags\":{\"solid\":\"yes\"}}\n"
      "S1 extract \"X7\" {\"command\":\"extract\",\"rule\":\"walker*ask\",\"filter\":\"distance\",\"count\":2,"
      "\"values\":[{\"record\":\"R5\",\"value\":\"1.4\",\"nodes\":[\"self\",\"wall\"],\"from\":[]}]}\n"
      "S1 extract \"X8\" {\"command\":\"extract\",\"problem\":\"there is no node wal\",\"hint\":\"did you mean "
      "wall?\"}\n");
  contents.imagined_record = "R5";
  contents.checks = {{"it goes north", "walker should be at north by 30 s", "", "walker", false, "true", 5, 0.2},
                     {"it rests", "walker should stand idle for at least 2 s", "it stood idle for 0 s", "walker", false,
                      "false", 9, 0.3},
                     {"a moment", "walker should see listener", "", "", true, "open", 0, 0},
                     {"later", "walker should be at east by 60 s", "", "walker", false, "true", 1'000'000, 33'333}};
  contents.moment.shown_tick = 20;
  LessonContents lesson;
  lesson.name = "01-a-rule";
  lesson.title = "1. A rule fires once for each match";
  lesson.idea = "A rule fires once for each set of elements that it matches.";
  lesson.task = "Greet each visitor by name.";
  lesson.new_panels = {"memory"};
  lesson.hints = {"Watch the panel Memory."};
  lesson.hint_count = 3;
  lesson.is_tried = true;
  lesson.grade = {"  yes  anna is greeted", "  no   once per visit"};
  lesson.next = "02-operators";
  contents.lesson = lesson;
  contents.lessons = {{"01-a-rule", "A rule", false}, {"02-operators", "Operators", true}};
  FillScript();
  const std::unique_ptr<explain::Inspector> mind = simulation->Inspect(agent);
  contents.has_mind = mind != nullptr;
  if (mind == nullptr) return;
  console_.emplace(agent);
  console_->Run(*simulation, "print s1");
  contents.console = &*console_;
  contents.stack = debugger::LookAtStack(*mind);
  contents.operators = debugger::LookAtOperators(*mind);
  for (const char* id : {"S1", "I2"}) contents.objects[id] = debugger::LookAtObject(*mind, id);
  contents.rules = debugger::ListRules(*mind);
  contents.rule = debugger::LookAtRule(*mind, agent == "walker" ? "walker*propose*flee" : "listener*propose*first");
  contents.why.question = "Why does " + agent + " do what it does?";
  contents.why.answer = debugger::WhyAgent(*simulation, agent);
  contents.io = debugger::LookAtIo(*mind);
  contents.long_term = debugger::LookAtLongTerm(*mind);
  contents.learning = debugger::LookAtLearning(*mind);
  contents.learning_curves = debugger::MostMoved(contents.learning, 6);
  contents.files = debugger::FilesOf(*simulation, agent);
  contents.edit.file = (folder_ / "walker.soar").string();
  contents.edit.text = kWalker;
  contents.edit.problems = {problem};
  contents.breakpoints = {{1, debugger::BreakKind::kFire, "walker", "walker*propose*flee", true, 2}};
  contents.hits = {{1, "walker", 30, "breakpoint 1: walker: rule walker*propose*flee fired"}};
  contents.plottable = debugger::Plottable(*mind);
}

void FilledRun::FillScript() {
  const std::string file = (folder_ / "Scout.lua").string();
  ScriptContents& script = contents.script;
  script.can_stop = true;
  script.files = {file, (folder_ / "Sandbox.lua").string()};
  script.stops = {{file, 4}, {file, 12, "speed > 2"}};
  script.watches = {"speed * 2", "nothing.x"};
  script.count = 1;
  debugger::StoppedScript& stopped = script.stopped.emplace();
  stopped.script = "scout";
  stopped.reason = "breakpoint";
  stopped.calls = {{"Hurry", file, 4}, {"Agent_Update", file, 12}};
  const debugger::ScriptRow inner{"locals/memory/place", "place", "\"gate\"", "string"};
  stopped.locals = {{"locals/speed", "speed", "3", "number"},
                    {"locals/memory", "memory", "{place = \"gate\"}", "table", true, true, {inner}},
                    {"locals/others", "others", "{...}", "table", true}};
  stopped.globals = {{"globals/Team", "Team", "\"red\"", "string"}};
  stopped.watches = {{"speed * 2", {"watches/speed * 2", "speed * 2", "6", "number"}},
                     {"nothing.x", {}, "a nil value has no fields: x is asked for"}};
  script.lines = {{3, "local function Hurry(memory)"}, {4, "  local speed = 3"}, {5, ""}};
}

void FilledRun::Write(const char* file, const char* text) const {
  std::ofstream(folder_ / file) << text;
}

}  // namespace soarbox::workbench
