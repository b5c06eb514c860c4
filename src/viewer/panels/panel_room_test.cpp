// SPDX-License-Identifier: BSD-2-Clause
// Draws every panel over a filled run at many sizes of the window: nothing is cut, nothing overlaps, no limit is
// exceeded.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "viewer/panels/draw_limit.h"
#include "viewer/panels/first_steps.h"
#include "viewer/panels/layout_audit.h"
#include "viewer/panels/panel_test_support.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

struct WindowSize {
  int width, height, percent;
};
constexpr WindowSize kSizes[] = {{1280, 720, 100}, {2560, 1440, 150}, {1280, 720, 150}};

TEST_F(Panels, NothingIsCutAndNothingOverlapsWhateverIsOpen) {
  for (const WindowSize& size : kSizes) {
    stage->SetSize(size.width, size.height, size.percent);
    for (const char* agent : {"walker", "listener-with-a-rather-long-name", ""}) {
      if (*agent != 'w' && size.height != 720) continue;  // One size is enough.
      stage->Fill(agent);
      for (const workbench::PanelInfo& info : workbench::kPanelInfos) {
        stage->Draw(info.id);
        EXPECT_THAT(stage->complaints, IsEmpty()) << info.word << " of '" << agent << "' at " << size.width << "x"
                                                  << size.height << ", " << size.percent << " %";
      }
    }
  }
}

/// The audit's sentences about windows that are drawn like this.
std::string AuditOf(const std::function<void()>& draw) {
  for (int i = 0; i < 3; ++i) {  // A window has the extent of its contents one frame later.
    ImGui::NewFrame();
    draw();
    ImGui::Render();
  }
  std::string all;
  for (const std::string& complaint : AuditLayout(*ImGui::GetIO().Fonts)) all += complaint + "\n";
  return all;
}

TEST_F(Panels, AnAuditFindsWhatIsCutAndWhatOverlaps) {
  stage->SetSize(1280, 720, 100);
  const std::string all = AuditOf([] {
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
  });
  EXPECT_THAT(all, HasSubstr("first: its contents are"));
  EXPECT_THAT(all, HasSubstr("second: lies over first"));
  EXPECT_THAT(all, HasSubstr("third: leaves the window"));
  EXPECT_THAT(all, HasSubstr("third: cells of column 1 are cut"));
}

TEST_F(Panels, AnAuditFindsNamesAndFieldsThatAreTooSmallToBeOfUse) {
  stage->SetSize(1280, 720, 100);
  const auto audit = [](float width) {
    std::string text;
    return AuditOf([&] {
      ImGui::SetNextWindowPos({10, 10});
      ImGui::SetNextWindowSize({width, 120});
      ImGui::Begin("small", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings);
      CutText("blue-leader-of-the-second-team");
      SearchField("##search", "Search", text);
      ImGui::End();
    });
  };
  EXPECT_EQ(audit(200), "");
  EXPECT_THAT(audit(50), HasSubstr("is cut to"));
  EXPECT_THAT(audit(50), HasSubstr("the field 'Search' has no room to type in"));
}

TEST_F(Panels, AnAuditSeesWhatIsDrawnByHandWhereTheWindowScrolls) {
  stage->SetSize(1280, 720, 100);
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings;
  const auto audit = [](const std::function<void(ImDrawList&, ImVec2)>& draw) {
    return AuditOf([&] {
      ImGui::SetNextWindowPos({10, 10});
      ImGui::SetNextWindowSize({200, 100});
      ImGui::Begin("scrolls", nullptr, kFlags);
      draw(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos());
      ImGui::Dummy({10, 900});
      ImGui::End();
    });
  };
  const ImU32 white = IM_COL32_WHITE;
  EXPECT_EQ(audit([&](ImDrawList& out, ImVec2 at) { PutText(out, at, white, "a good one"); }), "");
  // A text that can be scrolled into view is not cut.
  EXPECT_EQ(audit([&](ImDrawList& out, ImVec2 at) { PutText(out, {at.x, at.y + 75}, white, "half of it"); }), "");
  // ImGui keeps no letter of this text.
  EXPECT_THAT(audit([&](ImDrawList& out, ImVec2 at) {
                PutText(out, {at.x + 300, at.y}, white, "far out");
              }),
              HasSubstr("scrolls: the text 'far out', drawn by PutText, is cut"));
  EXPECT_THAT(audit([&](ImDrawList& out, ImVec2 at) {
                out.PushClipRect(at, {at.x + 100, at.y + 6}, true);
                PutText(out, at, white, "narrow");
                out.PopClipRect();
              }),
              HasSubstr("'narrow', drawn by PutText, is cut"));
  EXPECT_THAT(audit([&](ImDrawList& out, ImVec2 at) {
                PutText(out, at, white, "first words");
                PutText(out, {at.x + 12, at.y + 3}, white, "second words");
              }),
              HasSubstr("lie over each other"));
}

/// A run with this many ticks; in each tick many agents decide, give commands and fire rules.
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

/// The number of vertices of the window with the most.
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
      // A short run does not need one point per pixel of a wide picture.
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
    // As in the world of the thesis: at the lower right of the window, placed for the window's size.
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
    // The scenario's panel goes to the picture's lower right corner.
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
  seen.is_paused = true;  // Long before the step that asks for it.
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
  seen.agents = 1;  // There is no other agent to click.
  steps.Note(seen);
  EXPECT_EQ(steps.at(), 1u);
}

}  // namespace
}  // namespace soarbox::viewer
