// SPDX-License-Identifier: BSD-2-Clause
// Every panel over a filled run: what stands in it, and that nothing of it is cut. ImGui alone, without a display.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "debugger/rule_edit.h"
#include "debugger/run_models.h"
#include "record/recorder.h"
#include "viewer/panels/draw_limit.h"
#include "viewer/panels/first_steps.h"
#include "viewer/panels/layout_audit.h"
#include "viewer/panels/terms.h"
#include "viewer/panels/text_capture.h"
#include "viewer/panels/theme.h"
#include "viewer/panels/widgets.h"
#include "viewer/panels/workspace.h"

namespace soarbox::viewer {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

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

/// A run of some seconds, and the panels drawn over it into nothing.
class PanelStage {
 public:
  PanelStage() {
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
    context_ = ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
  }
  ~PanelStage() {
    ImGui::DestroyContext(context_);
    std::filesystem::remove_all(folder_);
  }

  void SetSize(int new_width, int new_height, int new_percent) {
    width = new_width;
    height = new_height;
    percent = new_percent;
    const float scale = static_cast<float>(percent) / 100;
    ImGui::GetIO().DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    ImGui::GetIO().DeltaTime = 1.0f / 30;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    fonts_ = AddPanelFonts(scale);
    ImGui::GetIO().FontDefault = fonts_.plain;
    ApplyTheme(scale);
    unsigned char* pixels = nullptr;
    int pixels_wide = 0, pixels_high = 0;
    atlas.GetTexDataAsRGBA32(&pixels, &pixels_wide, &pixels_high);
  }

  /// What a selected agent's panels show.
  void Fill(const std::string& agent) {
    contents = {};
    workbench::Moment& at = contents.moment;
    at.last_tick = at.shown_tick = last.tick;
    at.can_go_back = true;
    contents.agent = agent;
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
    workbench::ExerciseContents& exercise = contents.exercise.emplace();
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
                       {"it rests", "walker should stand idle for at least 2 s", "it stood idle for 0 s", "walker",
                        false, "false", 9, 0.3},
                       {"a moment", "walker should see listener", "", "", true, "open", 0, 0},
                       {"later", "walker should be at east by 60 s", "", "walker", false, "true", 1'000'000, 33'333}};
    contents.moment.shown_tick = 20;
    workbench::LessonContents lesson;
    lesson.name = "01-a-rule";
    lesson.title = "1. A rule fires once for each match";
    lesson.idea = "A rule fires once for each set of elements that it matches.";
    lesson.task = "Greet each visitor by name.";
    lesson.new_panels = {"memory"};
    lesson.hints = {"Watch the panel Memory."};
    lesson.hint_count = 3;
    lesson.grade = {"  yes  anna is greeted", "  no   once per visit"};
    lesson.next = "02-operators";
    contents.lesson = lesson;
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
    contents.files = debugger::FilesOf(*simulation, agent);
    contents.edit.file = (folder_ / "walker.soar").string();
    contents.edit.text = kWalker;
    contents.edit.problems = {problem};
    contents.breakpoints = {{1, debugger::BreakKind::kFire, "walker", "walker*propose*flee", true, 2}};
    contents.hits = {{1, "walker", 30, "breakpoint 1: walker: rule walker*propose*flee fired"}};
    contents.plottable = debugger::Plottable(*mind);
  }

  /// Draws some frames with this panel open, as a user would find it, and reads the last one back.
  void Draw(const Layout& arranged, const std::function<void(Workspace&)>& in_the_last = {}) {
    Workspace workspace(arranged);
    workspace.layout.SetText(percent);
    world::SceneSnapshot scene = simulation->Snapshot();
    scene.ui = script_ui;
    const RunStatus status;
    std::uint32_t selected = 0;
    for (const world::AgentSnapshot& agent : scene.agents)
      if (agent.name == contents.agent) selected = agent.id;
    constexpr int kFrames = 3;  // Tables and windows know after the first how large they are.
    for (int i = 0; i < kFrames; ++i) {
      std::vector<workbench::Request> requests;
      std::vector<ViewerCommand> commands;
      if (i + 1 == kFrames && in_the_last) in_the_last(workspace);
      ImGui::NewFrame();
      PanelFrame frame{contents,
                       scene,
                       status,
                       fonts_,
                       static_cast<float>(percent) / 100,
                       workspace.layout,
                       selected,
                       requests,
                       commands,
                       workspace.shown_object,
                       [](ViewerCommand) { return false; }};
      workspace.Draw(frame, width, height, 60);
      ImGui::EndFrame();
      overfull = CutOverfullWindows();  // As the window does: it would end otherwise.
      ImGui::Render();
    }
    cover = workspace.cover();
    shown.clear();
    for (const ShownText& text : CaptureText(*ImGui::GetDrawData(), *ImGui::GetIO().Fonts)) shown += text.text + "\n";
    complaints = AuditLayout(*ImGui::GetIO().Fonts);
  }

  void Draw(workbench::PanelId panel, const std::function<void(Workspace&, workbench::PanelId)>& in_the_last = {}) {
    Layout layout = DefaultLayout();
    layout.Show(panel);
    Draw(layout, [&](Workspace& workspace) {
      if (in_the_last) in_the_last(workspace, panel);
    });
  }

  std::unique_ptr<sim::Simulation> simulation;
  debugger::RunModels models;
  record::TickRecord last;
  workbench::Contents contents;
  int width = 1280, height = 720, percent = 100;
  std::vector<world::UiSnapshot> script_ui;  ///< Panels of the scenario's own.
  PictureRect cover;                         ///< What lay over the picture.
  std::string shown;
  std::vector<std::string> complaints;
  std::vector<std::string> overfull;  ///< Windows that held more than can be drawn.

 private:
  void Write(const char* file, const char* text) const { std::ofstream(folder_ / file) << text; }

  std::filesystem::path folder_;
  ImGuiContext* context_ = nullptr;
  PanelFonts fonts_;
  std::optional<debugger::Console> console_;
};

class Panels : public testing::Test {
 protected:
  static void SetUpTestSuite() { stage = std::make_unique<PanelStage>(); }
  static void TearDownTestSuite() { stage.reset(); }
  static std::unique_ptr<PanelStage> stage;
};
std::unique_ptr<PanelStage> Panels::stage;

struct WindowSize {
  int width, height, percent;
};
constexpr WindowSize kSizes[] = {{1280, 720, 100}, {2560, 1440, 150}, {1280, 720, 150}};

TEST_F(Panels, NothingIsCutAndNothingOverlapsWhateverIsOpen) {
  for (const WindowSize& size : kSizes) {
    stage->SetSize(size.width, size.height, size.percent);
    for (const char* agent : {"walker", "listener-with-a-rather-long-name", ""}) {
      if (*agent != 'w' && size.height != 720) continue;  // Once is enough.
      stage->Fill(agent);
      for (const workbench::PanelInfo& info : workbench::kPanelInfos) {
        stage->Draw(info.id);
        EXPECT_THAT(stage->complaints, IsEmpty()) << info.word << " of '" << agent << "' at " << size.width << "x"
                                                  << size.height << ", " << size.percent << " %";
      }
    }
  }
}

TEST_F(Panels, AnAuditFindsWhatIsCutAndWhatOverlaps) {
  stage->SetSize(1280, 720, 100);
  for (int i = 0; i < 3; ++i) {  // How far its contents reach a window knows one frame later.
    ImGui::NewFrame();
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings;
    for (const char* name : {"first", "second"}) {
      ImGui::SetNextWindowPos({10, 10});
      ImGui::SetNextWindowSize({80, 60});
      ImGui::Begin(name, nullptr, kFlags);
      ImGui::TextUnformatted("a text that has no room in so small a window");
      ImGui::End();
    }
    ImGui::SetNextWindowPos({1250, 300});
    ImGui::SetNextWindowSize({80, 120});
    ImGui::Begin("third", nullptr, kFlags);
    if (ImGui::BeginTable("cells", 2, ImGuiTableFlags_SizingFixedFit)) {
      ImGui::TableSetupColumn("narrow", ImGuiTableColumnFlags_WidthFixed, 20);
      ImGui::TableSetupColumn("wide", ImGuiTableColumnFlags_WidthFixed, 20);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted("wwwwww");
      ImGui::EndTable();
    }
    ImGui::End();
    ImGui::Render();
  }
  std::string all;
  for (const std::string& complaint : AuditLayout(*ImGui::GetIO().Fonts)) all += complaint + "\n";
  EXPECT_THAT(all, HasSubstr("first: what stands in it is"));
  EXPECT_THAT(all, HasSubstr("second: lies over first"));
  EXPECT_THAT(all, HasSubstr("third: leaves the window"));
  EXPECT_THAT(all, HasSubstr("third: cells of column 1 are cut"));
}

TEST_F(Panels, AnAuditFindsNamesAndFieldsThatAreTooSmallToBeOfUse) {
  stage->SetSize(1280, 720, 100);
  const auto audit = [](float width) {
    std::string text;
    for (int i = 0; i < 3; ++i) {
      ImGui::NewFrame();
      ImGui::SetNextWindowPos({10, 10});
      ImGui::SetNextWindowSize({width, 120});
      ImGui::Begin("small", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings);
      CutText("blue-leader-of-the-second-team");
      SearchField("##search", "Search", text);
      ImGui::End();
      ImGui::Render();
    }
    std::string all;
    for (const std::string& complaint : AuditLayout(*ImGui::GetIO().Fonts)) all += complaint + "\n";
    return all;
  };
  EXPECT_EQ(audit(200), "");
  EXPECT_THAT(audit(50), HasSubstr("is cut to"));
  EXPECT_THAT(audit(50), HasSubstr("the field 'Search' has no room to type in"));
}

TEST_F(Panels, AnAuditSeesWhatIsDrawnByHandWhereTheWindowScrolls) {
  stage->SetSize(1280, 720, 100);
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings;
  const auto audit = [](const std::function<void(ImDrawList&, ImVec2)>& draw) {
    for (int i = 0; i < 3; ++i) {
      ImGui::NewFrame();
      ImGui::SetNextWindowPos({10, 10});
      ImGui::SetNextWindowSize({200, 100});
      ImGui::Begin("scrolls", nullptr, kFlags);
      draw(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos());
      ImGui::Dummy({10, 900});
      ImGui::End();
      ImGui::Render();
    }
    std::string all;
    for (const std::string& complaint : AuditLayout(*ImGui::GetIO().Fonts)) all += complaint + "\n";
    return all;
  };
  const ImU32 white = IM_COL32_WHITE;
  EXPECT_EQ(audit([&](ImDrawList& out, ImVec2 at) { PutText(out, at, white, "a good one"); }), "");
  // What can be scrolled to is not cut.
  EXPECT_EQ(audit([&](ImDrawList& out, ImVec2 at) { PutText(out, {at.x, at.y + 75}, white, "half of it"); }), "");
  // ImGui keeps no letter of this one.
  EXPECT_THAT(audit([&](ImDrawList& out, ImVec2 at) {
                PutText(out, {at.x + 300, at.y}, white, "far out");
              }),
              HasSubstr("scrolls: the text 'far out', drawn by hand, is cut"));
  EXPECT_THAT(audit([&](ImDrawList& out, ImVec2 at) {
                out.PushClipRect(at, {at.x + 100, at.y + 6}, true);
                PutText(out, at, white, "narrow");
                out.PopClipRect();
              }),
              HasSubstr("'narrow', drawn by hand, is cut"));
  EXPECT_THAT(audit([&](ImDrawList& out, ImVec2 at) {
                PutText(out, at, white, "first words");
                PutText(out, {at.x + 12, at.y + 3}, white, "second words");
              }),
              HasSubstr("lie over each other"));
}

/// A run of this many ticks in which many agents decide, command and fire rules in each tick.
debugger::RunModels BusyRun(std::uint64_t ticks, int agents) {
  debugger::RunModels models;
  record::TickRecord tick;
  for (int i = 0; i < agents; ++i) tick.minds.emplace_back().agent = i == 0 ? "walker" : "agent-" + std::to_string(i);
  models.plots.Plot("walker", "decisions");
  for (tick.tick = 0; tick.tick <= ticks; ++tick.tick) {
    tick.scene.time_s = static_cast<double>(tick.tick) / 30;
    for (record::MindRecord& mind : tick.minds) {
      const std::string number = std::to_string(tick.tick);
      const std::string op = "O" + number, state = "S" + number;
      mind.events.Clear();
      mind.events.Add(mind::OperatorSelected{1, op, "seek", {}});
      mind.events.Add(mind::RuleFired{"walker*propose*seek", false});
      mind.events.Add(mind::StateMade{1, state, mind::StateReason::kNoChange, true, {}});
      mind.events.Add(mind::OperatorSelected{2, "O1", "think", {}});
      mind.events.Add(mind::CommandSaid{0, "seek", {}, {{0, false, "waypoint", std::string_view("north")}}});
      mind.events.Add(mind::CommandEnded{"seek", mind::CommandStatus::kComplete, {}});
    }
    models.Add(tick);
  }
  return models;
}

/// The corners of the window that has most.
int MostCorners() {
  int most = 0;
  const ImDrawData& drawn = *ImGui::GetDrawData();
  for (int i = 0; i < drawn.CmdListsCount; ++i) most = std::max(most, drawn.CmdLists[i]->VtxBuffer.Size);
  return most;
}

TEST_F(Panels, DrawWhatCanBeSeenHoweverLongTheRunAndHoweverManyTheAgents) {
  const debugger::RunModels runs[] = {BusyRun(1'000, 40), BusyRun(4'000, 40)};
  for (const auto& [width, height] : {std::pair{1280, 720}, std::pair{3840, 2160}}) {
    stage->SetSize(width, height, 100);
    for (const workbench::PanelId panel :
         {workbench::PanelId::kTimeline, workbench::PanelId::kPlots, workbench::PanelId::kTrace}) {
      int corners[2] = {};
      for (const std::size_t run : {0, 1}) {
        const debugger::RunModels& models = runs[run];
        stage->Fill("walker");
        stage->contents.timeline = &models.timeline;
        stage->contents.trace = &models.trace;
        stage->contents.plots = &models.plots.series();
        stage->contents.moment.last_tick = stage->contents.moment.shown_tick = models.timeline.last_tick();
        stage->Draw(panel,
                    [](Workspace& workspace, workbench::PanelId) { workspace.layout.at(Area::kBottom).size = 1400; });
        corners[run] = MostCorners();
        EXPECT_THAT(stage->overfull, testing::IsEmpty()) << InfoOf(panel).word << " at " << width;
        EXPECT_LT(corners[run], 1 << 16) << InfoOf(panel).word << " at " << width;
      }
      // A short run does not fill a wide picture with a point per pixel.
      EXPECT_LT(corners[1], std::max(corners[0] * 1.5, width * 4.0)) << InfoOf(panel).word << " at " << width;
    }
  }
}

TEST_F(Panels, AWindowThatHoldsTooMuchIsCutAndEndsNothing) {
  stage->SetSize(1280, 720, 100);
  for (const bool cut : {false, true}) {
    ImGui::NewFrame();
    ImGui::Begin("overfull");
    for (int i = 0; i < (cut ? 40'000 : 10'000); ++i)
      ImGui::GetWindowDrawList()->AddRectFilled({10, 10}, {20, 20}, 0xFFFFFFFF);
    ImGui::End();
    ImGui::EndFrame();
    EXPECT_EQ(CutOverfullWindows().size(), cut ? 1u : 0u);
    ImGui::Render();
    const ImDrawData& drawn = *ImGui::GetDrawData();
    for (int i = 0; i < drawn.CmdListsCount; ++i) {
      const ImDrawList& list = *drawn.CmdLists[i];
      unsigned elements = 0;
      for (const ImDrawCmd& command : list.CmdBuffer) elements += command.ElemCount;
      EXPECT_EQ(static_cast<int>(elements), list.IdxBuffer.Size);
      for (const ImDrawIdx index : list.IdxBuffer) ASSERT_LT(index, list.VtxBuffer.Size);
    }
  }
}

TEST_F(Panels, CanBeCopied) {
  stage->SetSize(1280, 720, 100);
  stage->Fill("walker");
  const std::vector<std::pair<workbench::PanelId, const char*>> wanted = {
      {workbench::PanelId::kAgents, "walker"},
      {workbench::PanelId::kMind, "S1"},
      {workbench::PanelId::kMemory, "superstate"},
      {workbench::PanelId::kRules, "sp {walker*propose*flee"},
      {workbench::PanelId::kWhy, "Why does walker"},
      {workbench::PanelId::kLinks, "seek"},
      {workbench::PanelId::kMessages, "I am on my way"},
      {workbench::PanelId::kTimeline, "seek"},
      {workbench::PanelId::kTrace, "seek"},
      {workbench::PanelId::kPlots, "health"},
      {workbench::PanelId::kConsole, "superstate"},
      {workbench::PanelId::kEdit, "walker*propose*seek"},
      {workbench::PanelId::kBreakpoints, "flee"},
      {workbench::PanelId::kProblems, "did you mean"},
      {workbench::PanelId::kMission, "it stood idle for 0 s"},
      {workbench::PanelId::kLongTerm, "no long-term memory is switched on"},
      {workbench::PanelId::kLearning, "nothing has been learned"},
      {workbench::PanelId::kExercise, "7:8:9"},
      {workbench::PanelId::kImagery, "wall"},
  };
  for (const auto& [panel, text] : wanted) {
    ImGui::SetClipboardText("");
    stage->Draw(panel, [](Workspace& workspace, workbench::PanelId opened) {
      workspace.Open(opened);
      workspace.CopyPanel();
    });
    EXPECT_THAT(ImGui::GetClipboardText(), HasSubstr(text)) << InfoOf(panel).word;
  }
}

TEST_F(Panels, LeadSomebodyNewThroughTheWindow) {
  stage->SetSize(1280, 720, 100);
  stage->Fill("walker");
  Layout layout = DefaultLayout();
  layout.first_steps = true;
  stage->Draw(layout);
  for (const char* text : {"First steps", "1 of 5", "Click an agent", "Skip", "Close"})
    EXPECT_THAT(stage->shown, HasSubstr(text));
  EXPECT_THAT(stage->complaints, IsEmpty());
  layout.first_steps = false;
  stage->Draw(layout);
  EXPECT_THAT(stage->shown, testing::Not(HasSubstr("First steps")));
}

TEST_F(Panels, TheFirstStepsStandBesideWhatAScenarioShows) {
  for (const WindowSize& size : {WindowSize{1280, 720, 100}, WindowSize{1766, 993, 100}, WindowSize{1766, 993, 125}}) {
    stage->SetSize(size.width, size.height, size.percent);
    stage->Fill("walker");
    // As the world of the thesis has it: at the lower right of the window, as large as that is.
    world::UiSnapshot help;
    help.id = 1;
    help.width = 320;
    help.height = 190;
    help.x = static_cast<float>(size.width) - help.width - 20;
    help.y = static_cast<float>(size.height) - help.height - 35;
    help.text = "F2: show or hide this panel";
    stage->script_ui = {help};
    Layout layout = DefaultLayout();
    layout.first_steps = true;
    stage->Draw(layout);
    stage->script_ui.clear();
    layout.SetText(size.percent);
    const PictureRect picture = Workspace(layout).PictureIn(size.width, size.height);
    const PictureRect& cover = stage->cover;
    EXPECT_GT(cover.height, 0);
    // The picture's lower right corner is where the scenario's panel goes.
    const int left = picture.x + picture.width - 12 - 320, top = picture.y + picture.height - 12 - 190;
    EXPECT_TRUE(cover.x + cover.width <= left || cover.y + cover.height <= top)
        << size.width << "x" << size.height << ": " << cover.x << ", " << cover.y;
  }
}

TEST(FirstSteps, CoverNoPanelOfAScenario) {
  const ScreenBox area{300, 60, 980, 560};
  const auto height_of = [](float width) { return 560 * 80 / width; };
  const auto place = [&](const std::vector<ScreenBox>& taken) { return PlaceOfStrip(area, 560, height_of, taken); };
  EXPECT_EQ(place({}), (ScreenBox{360, 480, 920, 560}));
  const ScreenBox at_the_right{900, 400, 980, 560}, wide{660, 370, 980, 560}, at_the_left{300, 400, 600, 560};
  EXPECT_EQ(place({at_the_right}).left, 300);
  EXPECT_EQ(place({at_the_right}).width(), 560);
  const ScreenBox narrow = place({wide});
  EXPECT_EQ(narrow.bottom, 560) << "narrower rather than over what is above";
  EXPECT_LT(narrow.right, 660);
  EXPECT_EQ(place({wide, at_the_left}).top, 60);
  for (const std::vector<ScreenBox>& taken :
       {std::vector{at_the_right}, std::vector{wide}, std::vector{wide, at_the_left}}) {
    EXPECT_TRUE(Holds(area, place(taken)));
    for (const ScreenBox& box : taken) EXPECT_FALSE(Meet(place(taken), box));
  }
}

TEST(FirstSteps, GoOnWhenTheyAreDoneOneAtATime) {
  FirstSteps steps;
  FirstSteps::Seen seen;
  seen.agents = 3;
  seen.selected = 1;
  seen.is_paused = true;  // Long before it is asked for.
  steps.Note(seen);
  EXPECT_EQ(steps.at(), 0u);
  seen.selected = 2;
  steps.Note(seen);
  EXPECT_EQ(steps.at(), 1u);
  seen.shows_why = seen.has_asked = true;
  steps.Note(seen);
  EXPECT_EQ(steps.at(), 2u);
  steps.Note(seen);
  steps.Note(seen);
  EXPECT_EQ(steps.at(), 4u);
  steps.Note(seen);
  EXPECT_EQ(steps.at(), 4u) << "nobody has gone back yet";
  seen.is_in_past = true;
  steps.Note(seen);
  EXPECT_EQ(steps.at(), FirstSteps::kSteps);
  EXPECT_THAT(std::string(steps.text()), HasSubstr("That is how you find out why"));
  steps.Note(seen);
  EXPECT_EQ(steps.at(), FirstSteps::kSteps);
  steps.Begin();
  EXPECT_EQ(steps.at(), 0u);
  seen.agents = 1;  // There is no other one to click.
  steps.Note(seen);
  EXPECT_EQ(steps.at(), 1u);
}

TEST_F(Panels, EachShowsWhatTheRunHolds) {
  stage->SetSize(1280, 720, 100);
  stage->Fill("walker");
  const std::vector<std::pair<workbench::PanelId, std::vector<const char*>>> wanted = {
      {workbench::PanelId::kAgents, {"walker", "listener", "seek", "operator", "100"}},
      {workbench::PanelId::kMind, {"Goal stack", "propose", "seek", "Standing", "better than"}},
      {workbench::PanelId::kMemory, {"S1", "^superstate", "nil", "^operator"}},
      {workbench::PanelId::kRules, {"walker*apply*seek", "Fired", "Break when it fires", "health"}},
      {workbench::PanelId::kWhy, {"Why does walker do what it does?", "command", "walker*propose*seek", "north"}},
      {workbench::PanelId::kLinks,
       {"Commands (output link)", "seek", "broadcast", "^waypoint north", "Percepts (input link)",
        "Filter by attribute"}},
      {workbench::PanelId::kMessages, {"From", "walker", "team red", "I am on my way"}},
      {workbench::PanelId::kTimeline, {"walker", "seek"}},
      {workbench::PanelId::kTrace, {"seek", "walker"}},
      {workbench::PanelId::kPlots, {"Plot a number of walker", "health", "self.position.x (m)"}},
      {workbench::PanelId::kConsole, {"print s1", "superstate nil"}},
      {workbench::PanelId::kEdit, {"Apply", "walker*propose*seek", "line 14", "variable <t>"}},
      {workbench::PanelId::kBreakpoints, {"stopped", "walker*propose*flee", "Hits"}},
      {workbench::PanelId::kFutures, {"There is only one future so far."}},
      {workbench::PanelId::kProblems, {"error", "variable <t>", "did you mean", "walker.soar:14", "Open in editor"}},
      {workbench::PanelId::kWatch, {"Nothing is watched yet.", "Add agent"}},
      {workbench::PanelId::kMinds, {"No mind is looked at.", "Add agent"}},
      {workbench::PanelId::kMission,
       {"1. A rule fires once", "Greet each visitor", "New in the window: Memory (Alt+E)", "Hint 2 of 3",
        "1. Watch the panel", "Check my rules", "Next lesson", "1 of 3 checks, 1 failed", "it goes north", "0:00.20",
        "it stood idle for 0 s", "a moment that others refer to", "walker should be at east by 60 s",
        "once per visit"}},
      {workbench::PanelId::kLongTerm, {"Known 0", "Recalled 0", "Episodes 0", "no long-term memory is switched on"}},
      {workbench::PanelId::kLearning, {"Rules 0", "Episodes 0", "No rule has been learned yet."}},
      {workbench::PanelId::kExercise,
       {"Exercise 3", "239.1.2.3:3000", "machine only", "1:7", "120", "12 too short", "visitor", "2 entities"}},
      {workbench::PanelId::kImagery,
       {"made up", "all of S1", "distance", "X7", "walker*ask", "1.4", "self, wall", "1 more"}},
  };
  ASSERT_EQ(wanted.size(), workbench::kPanelCount);
  for (const auto& [panel, texts] : wanted) {
    stage->Draw(panel);
    for (const char* text : texts) EXPECT_THAT(stage->shown, HasSubstr(text)) << InfoOf(panel).word;
  }
  // Where there is room, a whole scene stands there, and so do all plots.
  Layout scene = DefaultLayout();
  scene.Move(workbench::PanelId::kImagery, Area::kRight);
  stage->Draw(scene);
  for (const char* text : {"there is no node", "2 nodes", "10.00", "^solid yes"})
    EXPECT_THAT(stage->shown, HasSubstr(text));
  Layout tall = DefaultLayout();
  tall.Move(workbench::PanelId::kPlots, Area::kRight);
  stage->Draw(tall);
  for (const char* text : {"decision time (\xc2\xb5s)", "reward", "0.5"}) EXPECT_THAT(stage->shown, HasSubstr(text));
}

TEST_F(Panels, TellWhatIsKnownTheMostActiveFirstAndHowMuchMoreThereIs) {
  stage->Fill("walker");
  debugger::RecallLog recalls;
  record::MindRecord mind;
  mind.events.Add(mind::Recalled{1, false, 12, "^kind ammo", "^kind ammo ^site @3", "the only one that fits"});
  recalls.Add(5, mind);
  workbench::Contents& contents = stage->contents;
  contents.recalls = &recalls;
  explain::LongTermFacts& facts = contents.long_term.facts;
  contents.long_term.note.clear();
  facts.semantic = facts.episodic = true;
  facts.objects = 5000;
  facts.known = {{12, "^kind ammo ^site @3", 1.25, 3}, {3, "^name barn ^east-of |the old mill|", -0.5, 0}};
  facts.episodes = 40;
  for (const auto& [width, height] : {std::pair{1280, 800}, std::pair{1920, 1080}}) {
    stage->SetSize(width, height, 100);
    stage->Draw(workbench::PanelId::kLongTerm);
    for (const char* text : {"Known 5000", "Recalled 1", "Episodes 40", "The 2 most active.", "@12", "1.250", "@3",
                             "-0.500", "^kind ammo ^site @3"})
      EXPECT_THAT(stage->shown, HasSubstr(text)) << width;
    EXPECT_THAT(stage->complaints, IsEmpty()) << width;
  }
  stage->Draw(workbench::PanelId::kLongTerm, [](Workspace& workspace, workbench::PanelId opened) {
    workspace.Open(opened);
    workspace.CopyPanel();
  });
  for (const char* text : {"5000 objects", "@12 (^kind ammo ^site @3) for ^kind ammo: the only one that fits"})
    EXPECT_THAT(ImGui::GetClipboardText(), HasSubstr(text));
  facts.known.clear();
  facts.objects = 0;
  stage->Draw(workbench::PanelId::kLongTerm);
  EXPECT_THAT(stage->shown, HasSubstr("Nothing is known yet."));
}

TEST_F(Panels, ShowLearnedRulesWithTheirReasonsAndDrawOnlyVisibleRows) {
  stage->Fill("walker");
  debugger::LearningLog log;
  record::MindRecord mind;
  mind.events.Add(mind::RuleLearned{1, "chunk*walker*turn*t4-1", {}, {}, mind::StateReason::kTie, true});
  mind.events.Add(mind::ValueUpdated{"rl*walker*1", 0.5});
  mind.events.Add(mind::RewardReceived{2});
  mind.events.Add(mind::EpisodeEnded{});
  log.Add(5, mind);
  mind.events.Clear();
  mind.events.Add(mind::RuleFired{"chunk*walker*turn*t4-1", false});
  mind.events.Add(mind::ValueUpdated{"rl*walker*1", 1.5});
  mind.events.Add(mind::RewardReceived{-1});
  mind.events.Add(mind::EpisodeEnded{});
  log.Add(20, mind);
  workbench::Contents& contents = stage->contents;
  contents.learning_log = &log;
  debugger::LearningView& view = contents.learning;
  view = {};
  view.learners = 1;
  view.numbers = {{"rl*walker*1", 1.5, 0, 1.5, 2}};
  debugger::LearnedRuleRow row;
  row.name = "chunk*walker*turn*t4-1";
  row.tick = 5;
  row.firings = 1;
  row.purpose = "proposes turn";
  row.source = "S2: operator tie in S1";
  view.rules.push_back(row);
  for (int n = 0; n < 20'000; ++n) {
    row.name = "chunk*many*" + std::to_string(n);
    view.rules.push_back(row);
  }
  for (const auto& [width, height] : {std::pair{1280, 800}, std::pair{1920, 1080}}) {
    stage->SetSize(width, height, 100);
    stage->Draw(workbench::PanelId::kLearning);
    for (const char* text : {"Rules 20001", "Values 1", "Episodes 2", "chunk*walker*turn*t4-1", "proposes turn",
                             "S2: operator tie in S1", "0:00.17"})
      EXPECT_THAT(stage->shown, HasSubstr(text)) << width;
    EXPECT_THAT(stage->shown, testing::Not(HasSubstr("chunk*many*100"))) << "only rows that can be seen are drawn";
    EXPECT_THAT(stage->complaints, IsEmpty()) << width;
  }
  debugger::LearnedRuleView& chosen = contents.learned_rule;
  chosen.name = "chunk*walker*turn*t4-1";
  chosen.why = {"learned in the substate S2", "learned", chosen.name, {}};
  chosen.why.below.push_back({"why each condition is there", "reason", "", {}});
  chosen.why.below[0].below.push_back({"(<s> ^operator <o>)", "condition", "", {}});
  chosen.fired = {20};
  stage->Draw(workbench::PanelId::kLearning);
  for (const char* text : {"Fired since:", "0:00.67", "learned in the substate S2", "(<s> ^operator <o>)", "Close"})
    EXPECT_THAT(stage->shown, HasSubstr(text));
  EXPECT_THAT(stage->complaints, IsEmpty());
  view.rules.clear();
  view.note = "reinforcement learning is off: rl --set learning on";
  chosen = {};
  stage->Draw(workbench::PanelId::kLearning);
  EXPECT_THAT(stage->shown, HasSubstr("rl*walker*1")) << "values, where no rule was learned";
  view.learners = 0;
  view.numbers.clear();
  stage->Draw(workbench::PanelId::kLearning);
  EXPECT_THAT(stage->shown, HasSubstr("No rule has been learned yet."));
}

TEST_F(Panels, OfARecordingSayWhatIsNotRecordedAndOfferNothingThatCannotBe) {
  stage->SetSize(1280, 720, 100);
  stage->Fill("walker");
  debugger::RecordedMinds minds(record::Level::kDecisions);
  record::TickRecord tick = stage->last;
  tick.tick = 0;
  for (record::MindRecord& mind : tick.minds) {
    mind.events.Clear();
    mind.events.Add(mind::StateMade{1, "S1", mind::StateReason::kTop, false, {}});
    mind.events.Add(mind::OperatorSelected{1, "O3", "seek", {}});
    mind.events.Add(mind::Remark{"better than the other"});
  }
  ASSERT_FALSE(tick.minds.empty());
  minds.Add(tick);
  const std::unique_ptr<explain::Inspector> mind = minds.Inspect("walker");
  ASSERT_NE(mind, nullptr);
  workbench::Contents& contents = stage->contents;
  contents.moment.is_recording = true;
  contents.moment.is_live = false;
  contents.past_note = "The mind at this moment cannot be rebuilt: the scenario has gone";
  contents.not_recorded = debugger::MemoryAbsence(*mind);
  contents.stack = debugger::LookAtStack(*mind);
  contents.operators = debugger::LookAtOperators(*mind);
  contents.objects = {{"S1", debugger::LookAtObject(*mind, "S1")}};
  contents.rules = debugger::ListRules(*mind);
  contents.long_term = debugger::LookAtLongTerm(*mind);
  contents.learning = debugger::LookAtLearning(*mind);
  contents.rule.reset();
  contents.story.reset();
  const std::vector<std::pair<workbench::PanelId, std::vector<const char*>>> wanted = {
      {workbench::PanelId::kMind,
       {"as recorded", "seek (O3) was selected: as recorded: better than the", "preferences: not recorded"}},
      {workbench::PanelId::kMemory, {"Not recorded at this level"}},
      {workbench::PanelId::kRules, {"Not recorded at this level"}},
      {workbench::PanelId::kBreakpoints, {"Nothing stops a recording."}},
      {workbench::PanelId::kFutures, {"A recording has one future."}},
      {workbench::PanelId::kLongTerm, {"what it knows and remembers: not recorded"}},
      {workbench::PanelId::kLearning, {"what it has learned: not recorded"}},
  };
  for (const auto& [panel, texts] : wanted) {
    stage->Draw(panel);
    for (const char* text : texts) EXPECT_THAT(stage->shown, HasSubstr(text)) << InfoOf(panel).word;
    EXPECT_THAT(stage->shown, testing::Not(HasSubstr("Resume here")));
    EXPECT_THAT(stage->complaints, IsEmpty()) << InfoOf(panel).word;
  }
}

TEST(Terms, EveryPhaseAndEveryImpasseIsExplained) {
  for (const std::string& phase : debugger::Phases()) EXPECT_FALSE(MeaningOf(phase).empty()) << phase;
  for (const char* term : {"operator tie", "operator conflict", "operator constraint-failure", "operator no-change",
                           "state no-change", "i-support", "o-support", "operator", "better", "numeric"})
    EXPECT_FALSE(MeaningOf(term).empty()) << term;
  EXPECT_TRUE(MeaningOf("no term of Soar").empty());
}

}  // namespace
}  // namespace soarbox::viewer
