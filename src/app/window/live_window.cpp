// SPDX-License-Identifier: BSD-2-Clause
#include "app/window/live_window.h"

#include <cstdio>
#include <iostream>
#include <utility>

#include "app/exit_codes.h"
#include "app/next_run.h"
#include "app/window/run_commands.h"
#include "sim/scenario_file.h"
#include "world/world.h"

namespace soarbox::app {
namespace {

/// Submits a user event as an input of the simulation.
void SubmitEvent(const viewer::InputEvent& event, sim::Simulation& simulation) {
  const auto x = static_cast<float>(event.x), y = static_cast<float>(event.y);
  switch (event.kind) {
    case viewer::InputKind::kKey:
      simulation.Submit(sim::KeyInput{event.name, event.pressed});
      break;
    case viewer::InputKind::kMouseButton:
      simulation.Submit(sim::ButtonInput{event.name, event.pressed, x, y});
      break;
    case viewer::InputKind::kPanel:
      simulation.Submit(sim::PanelInput{event.name});
      break;
    case viewer::InputKind::kPad:
      simulation.Submit(sim::PadInput{event.pad, event.name, event.value});
      break;
    case viewer::InputKind::kMouseMove:
      if (event.wheel != 0) simulation.Submit(sim::WheelInput{static_cast<float>(event.wheel), x, y});
      if (event.dx != 0 || event.dy != 0)
        simulation.Submit(sim::PointerInput{x, y, static_cast<float>(event.dx), static_cast<float>(event.dy)});
      break;
  }
}

/// The times of a frame and of a tick, for the tooltip of the clock.
std::string CostText(const SmoothTime& frame, const SmoothTime& tick) {
  if (tick.us() == 0) return {};
  char text[64];
  std::snprintf(text, sizeof text, "frame %.1f ms, tick %.1f ms", frame.us() / 1000, tick.us() / 1000);
  return text;
}

}  // namespace

void Deliverer::Deliver(viewer::Viewer& viewer, sim::Simulation& simulation) {
  const world::World& world = std::as_const(simulation).world();
  const sim::ScreenInput screen{viewer.width(), viewer.height()};
  if (screen != screen_) simulation.Submit(screen);
  screen_ = screen;
  const world::CameraSnapshot pose = viewer.Camera();
  const sim::CameraInput camera{pose.position, pose.orientation};
  const world::CameraSnapshot& known = world.camera().state();
  if (camera != camera_ && camera != sim::CameraInput{known.position, known.orientation}) simulation.Submit(camera);
  camera_ = camera;
  for (const viewer::InputEvent& event : viewer.TakeEvents()) SubmitEvent(event, simulation);
}

LiveWindow::LiveWindow(RunSession& session, viewer::Viewer& viewer, workbench::PanelExchange& panels,
                       const WindowRun& run, const RunOptions& options)
    : session_(session),
      viewer_(viewer),
      panels_(panels),
      scenario_(run.scenario),
      settings_(run.settings),
      header_(run.header),
      turn_ticks_(sim::TurnTicks(run.scenario)),
      has_script_(!options.ui_script.empty()),
      pace_(options.speed.value_or(1)),
      lessons_(scenario_, session.lesson()),
      window_desk_(viewer, panels, pace_, &lessons_) {
  // A followed kernel's ticks are shown as soon as they are known. The first tick creates its first agents.
  if (session.simulation().sends_commands_elsewhere()) {
    pace_.Obey(workbench::Flow::kUnlimited);
    session.Tick();
  }
  MakeDesk();
  if (!options.remark.empty()) viewer.Tell(options.remark);  // The file of the recording.
  // Opens the panel of the lesson and the panel that it introduces.
  if (lessons_.HasLesson()) {
    for (const workbench::PanelInfo& info : workbench::kPanelInfos)
      if (info.title == lessons_.Panel()) viewer.ShowPanel(info.id);
    viewer.ShowPanel(workbench::PanelId::kMission);
  }
  if (session.gateway() != nullptr) viewer.OfferPanel(workbench::PanelId::kExercise);
  newest_ = previous_ = session.simulation().Snapshot();
  // By default selects an agent with a mind, so that a new user sees what the panels are for.
  for (const world::AgentSnapshot& agent : newest_.agents) {
    if (viewer.selected_agent() == 0 && session.simulation().HasMind(agent.name)) viewer.SelectAgent(agent.id);
  }
}

void LiveWindow::MakeDesk() {
  desk_.emplace(session_, header_, scenario_, settings_, window_desk_);
  desk_->scripts().SetWait([this] { WaitInTick(); });
}

void LiveWindow::Draw() {
  const double step_s = static_cast<double>(std::as_const(session_.simulation()).world().settings().step_s);
  viewer_.SetStatus({.paused = pace_.paused(), .speed = pace_.speed(), .message = CostText(frame_time_, tick_time_)});
  if (const world::SceneSnapshot* past = desk_->PastScene()) {
    viewer_.Show(*past);
  } else {
    viewer_.Show(newest_, &previous_, pace_.Blend(step_s));
  }
  const world::OverlayWants wants = viewer_.overlay_wants();
  if (!desk_->past().is_live()) {
    // Overlays belong to the newest tick.
    if (overlays_tick_ != 0) viewer_.ShowOverlays({});
    overlays_tick_ = 0;
  } else if (newest_.tick + 1 != overlays_tick_ || wants != overlay_wants_) {
    viewer_.ShowOverlays(session_.simulation().Overlays(wants));
    overlays_tick_ = newest_.tick + 1;
    overlay_wants_ = wants;
  }
}

void LiveWindow::Tick(double step_s) {
  const int due = pace_.TicksDue(step_s, session_.simulation().tick(), turn_ticks_);
  bool is_cut = false;
  int i = 0;
  for (; i < due && !is_cut && !session_.IsOver(); ++i) {
    desk_->Prepare();
    const Clock::time_point tick_start = Clock::now();
    session_.Tick();
    tick_time_.Add(Clock::now() - tick_start);
    if (const std::string change = desk_->change().Take(); !change.empty()) {
      pace_.Pause();
      viewer_.Tell(change);
      is_cut = true;
    }
    if (desk_->WasHit()) {
      pace_.Pause();
      viewer_.ShowPanel(workbench::PanelId::kBreakpoints);
      is_cut = true;
    }
    if (std::exchange(was_stopped_, false) && !is_cut) {
      is_cut = true;
      pace_.Owe(due - i - 1);
    }
    if (!is_cut && pace_.OutOfTime()) {
      is_cut = true;
      pace_.Owe(due - i - 1);
    }
    // Only the last two snapshots are drawn.
    if (i + 2 >= due && !is_cut) previous_ = std::exchange(newest_, session_.simulation().Snapshot());
  }
  if (is_cut) previous_ = newest_ = session_.simulation().Snapshot();
  if (due == 0) session_.Idle();
}

void LiveWindow::WaitInTick() {
  workbench::ScriptDesk& scripts = desk_->scripts();
  // The script may have moved what is in the picture.
  previous_ = newest_ = session_.simulation().Snapshot();
  viewer_.ShowPanel(workbench::PanelId::kEdit);
  viewer_.ShowPanel(workbench::PanelId::kScript);
  while (scripts.is_stopped() && !WasInterrupted() && !is_closed_ && !window_desk_.wants_run()) {
    viewer_.SetStatus({.paused = true, .speed = pace_.speed(), .message = "a script is stopped"});
    viewer_.Show(newest_);
    is_closed_ = !viewer_.RenderFrame();
    for (const viewer::ViewerCommand command : viewer_.TakeCommands()) {
      const std::optional<workbench::Flow> flow = FlowOf(command);
      if (flow && !scripts.ObeyInTick(*flow, pace_)) postponed_.push_back(command);
    }
    window_desk_.Serve(*desk_);
    is_closed_ |= has_script_ && viewer_.ui_script().is_over;
  }
  was_stopped_ = true;
  pace_.Skip();
}

Result<void> LiveWindow::Obey() {
  using viewer::ViewerCommand;
  RunCommands control;
  std::vector<ViewerCommand> commands = std::exchange(postponed_, {});
  for (const ViewerCommand command : viewer_.TakeCommands()) commands.push_back(command);
  for (const ViewerCommand command : commands) {
    // A user who looks at the past and lets the world or a mind advance returns to the present.
    const std::optional<workbench::Flow> flow = FlowOf(command);
    const bool advances = flow && (*flow == workbench::Flow::kTogglePause || workbench::IsStep(*flow));
    if (advances) desk_->GoOn();
    if (flow) pace_.Obey(*flow);
    if (command == ViewerCommand::kStepChange) {
      if (const std::string refusal = desk_->AwaitChange(); !refusal.empty()) {
        pace_.Pause();
        viewer_.Tell(refusal);
      }
    } else if (advances) {
      desk_->change().AwaitNothing();
    }
    if (command == ViewerCommand::kStepDecision) desk_->Prepare();  // Its tick stops at lines and breakpoints, too.
    const Result<bool> obeyed = control.Obey(command, session_, viewer_, newest_);
    was_stopped_ = false;
    if (!obeyed) return obeyed.error();
  }
  if (control.has_ticked) previous_ = newest_ = session_.simulation().Snapshot();
  if (!control.has_begun_again) return {};
  // Keeps what the user created in panels.
  workbench::Desk::Belongings belongings = desk_->TakeBelongings();
  MakeDesk();
  desk_->Bring(std::move(belongings));
  viewer_.SetGhosts({});
  panels_.contents = {};
  newest_ = previous_ = session_.simulation().Snapshot();
  overlays_tick_ = 0;
  deliverer_ = Deliverer();
  pace_.Skip();
  return {};
}

int LiveWindow::Run() {
  while (!session_.IsOver() && !pace_.quit()) {
    const double step_s = static_cast<double>(std::as_const(session_.simulation()).world().settings().step_s);
    Draw();
    if (!viewer_.RenderFrame()) break;
    frame_time_.Add(Clock::now() - std::exchange(frame_start_, Clock::now()));
    if (const Result<void> obeyed = Obey(); !obeyed) {
      std::cerr << Format(obeyed.error());
      return kCannotStart;
    }
    window_desk_.Serve(*desk_);
    if (std::optional<NextRun> wanted = window_desk_.TakeWantedRun()) {
      wanted->script_line = viewer_.ui_script().steps_done;
      KeepNextRun(std::move(*wanted));
      break;
    }
    if (desk_->past().is_live()) {
      if (!was_live_) previous_ = newest_ = session_.simulation().Snapshot();
      deliverer_.Deliver(viewer_, session_.simulation());
      Tick(step_s);
    } else {
      Deliverer::Drop(viewer_);
      pace_.Skip();
    }
    was_live_ = desk_->past().is_live();
    if (is_closed_) break;
    if (has_script_ && viewer_.ui_script().is_over) break;
  }
  return session_.Finish();
}

}  // namespace soarbox::app
