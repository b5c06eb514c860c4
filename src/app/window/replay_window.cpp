// SPDX-License-Identifier: BSD-2-Clause
#include "app/window/replay_window.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "app/exit_codes.h"
#include "app/next_run.h"
#include "app/refuse.h"
#include "app/run_session.h"
#include "app/window/window_desk.h"
#include "app/window/window_options.h"
#include "record/rerun.h"
#include "viewer/viewer.h"
#include "workbench/recent.h"

namespace soarbox::app {
namespace {

/// A recording in a window: the desk's panels, and a position in the recording.
class ReplayWindow {
 public:
  ReplayWindow(record::Reader& recording, record::TickRange range, const sim::DataFolders& data, viewer::Viewer& viewer,
               workbench::PanelExchange& panels, bool has_script)
      : recording_(recording),
        viewer_(viewer),
        window_desk_(viewer, panels, pace_, nullptr),
        desk_(recording, data, range, window_desk_),
        step_s_(recording.header().step_s),
        turn_ticks_(record::TurnTicks(recording.header())),
        ticks_per_second_(std::max<std::int64_t>(1, std::llround(1 / recording.header().step_s))),
        has_script_(has_script) {}

  /// Selects this agent, or by default one with a mind. False if it does not exist.
  bool Select(const std::string& wanted) {
    // If there are no agents yet, shows the next tick: a recorded client makes its agents in the first tick.
    if (desk_.PastScene()->agents.empty()) Move(1);
    const world::SceneSnapshot& scene = *desk_.PastScene();
    viewer_.Show(scene);
    for (const world::AgentSnapshot& agent : scene.agents) {
      const bool is_meant = wanted.empty() ? agent.kind.starts_with("soar") : agent.name == wanted;
      if (is_meant && viewer_.selected_agent() == 0) viewer_.SelectAgent(agent.id);
    }
    return wanted.empty() || viewer_.selected_agent() != 0;
  }

  int Run() {
    while (!WasInterrupted() && !pace_.quit()) {
      const bool is_over = desk_.past().shown_tick() >= desk_.past().last_tick();
      viewer_.SetStatus(
          {.paused = pace_.paused(),
           .speed = pace_.speed(),
           .message = "replay of " + recording_.file().filename().string() + (is_over ? ", the end" : "")});
      viewer_.Show(*desk_.PastScene());
      if (!viewer_.RenderFrame()) break;
      for (const viewer::ViewerCommand command : viewer_.TakeCommands()) Obey(command);
      for (const viewer::InputEvent& event : viewer_.TakeEvents()) Obey(event);
      Move(pace_.TicksDue(step_s_, desk_.past().shown_tick(), turn_ticks_));
      window_desk_.Serve(desk_);
      if (std::optional<NextRun> wanted = window_desk_.TakeWantedRun()) {
        wanted->script_line = viewer_.ui_script().steps_done;
        KeepNextRun(std::move(*wanted));
        break;
      }
      if (has_script_ && viewer_.ui_script().is_over) break;
    }
    return kOk;
  }

 private:
  /// Moves by a number of ticks, forwards or backwards.
  void Move(std::int64_t ticks) {
    if (ticks == 0) return;
    const auto first = static_cast<std::int64_t>(desk_.past().first_tick()),
               last = static_cast<std::int64_t>(desk_.past().last_tick());
    const auto at = static_cast<std::int64_t>(desk_.past().shown_tick()) + ticks;
    desk_.Show(static_cast<std::uint64_t>(std::clamp(at, first, last)));
  }

  void Obey(viewer::ViewerCommand command) {
    using viewer::ViewerCommand;
    if (command == ViewerCommand::kReset) {
      desk_.Show(desk_.past().first_tick());
    } else if (command == ViewerCommand::kNextSeed || command == ViewerCommand::kStepDecision ||
               command == ViewerCommand::kStepPhase || command == ViewerCommand::kStepChange) {
      viewer_.Tell(std::string(viewer::InfoOf(command).title) + ": only in a run; this is a recording of one");
    } else {
      // At the end, continuing restarts the recording.
      const bool is_at_end = desk_.past().shown_tick() >= desk_.past().last_tick();
      if (command == ViewerCommand::kTogglePause && pace_.paused() && is_at_end) desk_.Show(desk_.past().first_tick());
      if (const std::optional<workbench::Flow> flow = FlowOf(command)) pace_.Obey(*flow);
    }
  }

  /// Arrow keys move by a second, the page keys by ten seconds; comma moves back; insert and end go to the beginning
  /// and the end.
  void Obey(const viewer::InputEvent& event) {
    if (event.kind != viewer::InputKind::kKey || !event.pressed) return;
    if (event.name == "left_key") Move(-ticks_per_second_);
    if (event.name == "right_key") Move(ticks_per_second_);
    if (event.name == "page_up_key") Move(-10 * ticks_per_second_);
    if (event.name == "page_down_key") Move(10 * ticks_per_second_);
    if (event.name == "insert_key") desk_.Show(desk_.past().first_tick());
    if (event.name == "end_key") desk_.Show(desk_.past().last_tick());
    if (event.name == "comma_key") {
      pace_.Pause();
      // To the end of the previous turn.
      const auto turn = static_cast<std::uint64_t>(turn_ticks_);
      const std::uint64_t over = desk_.past().shown_tick() % turn;
      Move(-static_cast<std::int64_t>(over == 0 ? turn : over));
    }
    if (event.name == "space_key") Obey(viewer::ViewerCommand::kTogglePause);
  }

  record::Reader& recording_;
  viewer::Viewer& viewer_;
  workbench::Pace pace_{1};
  WindowDesk window_desk_;
  workbench::Desk desk_;
  double step_s_;
  int turn_ticks_;
  std::int64_t ticks_per_second_;
  bool has_script_;  ///< A script plays the user; the window closes when it ends.
};

}  // namespace

int ShowReplay(record::Reader& recording, record::TickRange range, const sim::DataFolders& data,
               const RecordingOptions& options) {
  Result<viewer::ViewerOptions> window = WindowOptionsOf(options, data, false);
  if (!window) return Refuse(window.error());
  const record::Header& header = recording.header();
  window->width = options.width_px.value_or(static_cast<int>(std::min<std::uint32_t>(header.screen_width_px, 7680)));
  window->height = options.height_px.value_or(static_cast<int>(std::min<std::uint32_t>(header.screen_height_px, 4320)));
  window->title = "Soarbox replay: " + recording.file().filename().string();
  workbench::PanelExchange panels;
  window->panels = &panels;
  Result<std::unique_ptr<viewer::Viewer>> opened = viewer::Viewer::Open(*window);
  if (!opened) return Refuse(opened.error());
  viewer::Viewer& viewer = **opened;
  ReplayWindow replay(recording, range, data, viewer, panels, !options.ui_script.empty());
  if (!replay.Select(options.select))
    return Refuse("there is no agent '" + options.select + "' to select at the beginning");
  workbench::NoteRecentRun(recording.file().string());
  return AfterWindow(viewer, options, replay.Run());
}

}  // namespace soarbox::app
