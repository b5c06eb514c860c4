// SPDX-License-Identifier: BSD-2-Clause
// The user's actions in the picture: selection, commands, overlays, the scale of the picture.
#include <algorithm>
#include <utility>

#include "viewer/picture_notes.h"
#include "viewer/viewer_impl.h"

namespace soarbox::viewer {

void Viewer::Impl::SelectBeside(int step) {
  if (scene.agents.empty()) return;
  const auto count = static_cast<int>(scene.agents.size());
  int at = step > 0 ? -1 : 0;
  for (int i = 0; i < count; ++i) {
    if (Selected() == &scene.agents[static_cast<std::size_t>(i)]) at = i;
  }
  selection = {scene.agents[static_cast<std::size_t>((at + step + count) % count)].id};
  if (camera.agent() != 0) camera.SetMode(camera.mode(), Selected());
}

std::uint32_t Viewer::Impl::AgentUnder(ScreenPoint pixel) const {
  const std::uint32_t named = labels.AgentAt(pixel);
  return named != 0 ? named : View().AgentAt(pixel, scene.agents);
}

void Viewer::Impl::Pick(const Picked& picked) {
  std::vector<std::uint32_t> found;
  if (picked.is_box) {
    found = View().AgentsIn(picked.from, picked.to, scene.agents);
  } else if (const std::uint32_t agent = AgentUnder(picked.from); agent != 0) {
    found.push_back(agent);
  }
  if (picked.is_double) {
    if (!found.empty())
      Frame(found, false);
    else
      camera.GoTo(View().RayThrough(picked.from));
    return;
  }
  if (!picked.adds) {
    // A click on the ground does not change the selection, so panels keep their agent.
    if (!found.empty()) selection = std::move(found);
    return;
  }
  for (const std::uint32_t agent : found) {
    const auto there = std::find(selection.begin(), selection.end(), agent);
    if (there == selection.end()) {
      selection.push_back(agent);
    } else if (!picked.is_box) {
      selection.erase(there);
    }
  }
}

void Viewer::Impl::TakeButtonClicks(FrameInput& in) {
  const auto under = [this](ScreenPoint at) -> const world::UiSnapshot* {
    return scene.ui.empty() ? nullptr : ButtonAt(scene, Room(), View(), at);
  };
  std::vector<InputEvent> presses;
  std::erase_if(in.events, [&](const InputEvent& event) {
    if (event.kind != InputKind::kMouseButton || event.name != "left_button") return false;
    const auto* const button = under({static_cast<float>(event.x), static_cast<float>(event.y)});
    if (event.pressed) {
      buttons.held = button != nullptr ? button->id : 0;
      return button != nullptr;
    }
    const std::uint32_t held = std::exchange(buttons.held, 0);
    if (held != 0 && button != nullptr && button->id == held)
      presses.push_back({.kind = InputKind::kPanel, .pressed = true, .name = button->button});
    return held != 0;
  });
  std::erase_if(in.picked, [&](const Picked& picked) { return under(picked.from) != nullptr; });
  in.events.insert(in.events.end(), presses.begin(), presses.end());
  if (buttons.held != 0) in.box.reset();
  const auto* const hovered_button = in.cursor ? under(*in.cursor) : nullptr;
  buttons.hovered = hovered_button != nullptr ? hovered_button->id : 0;
}

void Viewer::Impl::Do(ViewerCommand command) {
  if (IsOfRun(command)) {
    if (command == ViewerCommand::kQuit && workspace && !workspace->MayClose()) return;
    commands.push_back(command);
    return;
  }
  if (IsOverlay(command)) {
    on.flip(static_cast<std::size_t>(command));
    const bool is_on = IsOn(command);
    // Names, trails and forces are available for every scene.
    const bool needs_more =
        command != ViewerCommand::kLabels && command != ViewerCommand::kTrails && command != ViewerCommand::kForces;
    const std::string title(InfoOf(command).title);
    if (is_on && needs_more && !has_overlays) {
      Notice(title + ": not available here; recordings do not contain it");
    } else if (is_on && command == ViewerCommand::kBelief && Selected() == nullptr) {
      Notice("Belief: select an agent to see the world as it believes it to be");
    } else {
      Notice(title + (is_on ? " on" : " off"));
    }
    return;
  }
  switch (command) {
    case ViewerCommand::kFrameSelection:
    case ViewerCommand::kFrameAll:
      if (camera.mode() == CameraMode::kOrbit) camera.SetMode(CameraMode::kFree, nullptr);
      Frame(command == ViewerCommand::kFrameAll ? std::vector<std::uint32_t>{} : selection, false);
      break;
    case ViewerCommand::kFreeCamera:
      SetCamera(CameraMode::kFree);
      break;
    case ViewerCommand::kOrbitCamera:
      SetCamera(CameraMode::kOrbit);
      break;
    case ViewerCommand::kFollowCamera:
      SetCamera(CameraMode::kFollow);
      break;
    case ViewerCommand::kEyesCamera:
      SetCamera(CameraMode::kEyes);
      break;
    case ViewerCommand::kMapCamera:
      SetCamera(CameraMode::kMap);
      Frame({}, false);
      break;
    case ViewerCommand::kSelectNext:
      SelectBeside(1);
      break;
    case ViewerCommand::kSelectPrevious:
      SelectBeside(-1);
      break;
    case ViewerCommand::kSelectNone:
      selection.clear();
      break;
    case ViewerCommand::kHelp:
      if (workspace) workspace->show_help() = !workspace->show_help();
      break;
    case ViewerCommand::kMute:
      on.flip(static_cast<std::size_t>(command));
      break;
    case ViewerCommand::kScaleAuto:
    case ViewerCommand::kScaleFull:
    case ViewerCommand::kScaleThreeQuarters:
    case ViewerCommand::kScaleHalf:
      ChooseScale(command);
      break;
    default:
      break;
  }
}

void Viewer::Impl::ChooseScale(ViewerCommand command) {
  constexpr double kUsualLow = 0.75;
  for (const auto each : {ViewerCommand::kScaleAuto, ViewerCommand::kScaleFull, ViewerCommand::kScaleThreeQuarters,
                          ViewerCommand::kScaleHalf}) {
    on[static_cast<std::size_t>(each)] = each == command;
  }
  auto_scale.reset();
  if (command == ViewerCommand::kScaleAuto) {
    // A script that plays a user must get the same pictures everywhere.
    if (engine->in_software() && options.ui_script.empty()) auto_scale.emplace();
    UseScale(auto_scale ? auto_scale->scale() : engine->low_detail() && !options.hidden ? kUsualLow : 1);
  } else {
    UseScale(command == ViewerCommand::kScaleFull ? 1 : command == ViewerCommand::kScaleHalf ? 0.5 : 0.75);
  }
}

void Viewer::Impl::UseScale(double scale) {
  engine->SetScale(scale);
  shaders->scene_values().setNamedConstant("line_scale", Ogre::Vector4(static_cast<float>(scale), 0, 0, 0));
}

bool Viewer::Impl::IsOn(ViewerCommand command) const {
  switch (command) {
    case ViewerCommand::kFreeCamera:
      return camera.mode() == CameraMode::kFree;
    case ViewerCommand::kOrbitCamera:
      return camera.mode() == CameraMode::kOrbit;
    case ViewerCommand::kFollowCamera:
      return camera.mode() == CameraMode::kFollow;
    case ViewerCommand::kEyesCamera:
      return camera.mode() == CameraMode::kEyes;
    case ViewerCommand::kMapCamera:
      return camera.mode() == CameraMode::kMap;
    case ViewerCommand::kTogglePause:
      return status.paused;
    case ViewerCommand::kUnlimited:
      return std::isinf(status.speed);
    case ViewerCommand::kHelp:
      return workspace && workspace->show_help();
    default:
      return on[static_cast<std::size_t>(command)];
  }
}

}  // namespace soarbox::viewer
