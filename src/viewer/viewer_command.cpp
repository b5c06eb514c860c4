// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/viewer_command.h"

#include <SDL_scancode.h>

#include "workbench/flow_info.h"

namespace soarbox::viewer {
namespace {

using C = ViewerCommand;
using G = CommandGroup;

/// A command of the run, with the words that the page uses, too.
constexpr CommandInfo OfRun(C command, workbench::Flow flow, std::string_view keys) {
  const workbench::FlowInfo& info = workbench::InfoOf(flow);
  return {command, G::kRun, "", info.title, keys, info.meaning};
}

constexpr CommandInfo kInfos[] = {
    OfRun(C::kTogglePause, workbench::Flow::kTogglePause, "P"),
    // In a world without turns this is a tick.
    {C::kSingleStep, G::kRun, "", "Step", "N", workbench::InfoOf(workbench::Flow::kStepTurn).meaning},
    OfRun(C::kStepDecision, workbench::Flow::kStepDecision, "Shift+N"),
    OfRun(C::kStepPhase, workbench::Flow::kStepPhase, "Ctrl+N"),
    OfRun(C::kStepChange, workbench::Flow::kStepChange, "Ctrl+Shift+N"),
    OfRun(C::kFaster, workbench::Flow::kFaster, "+"),
    OfRun(C::kSlower, workbench::Flow::kSlower, "-"),
    OfRun(C::kNormalSpeed, workbench::Flow::kNormalSpeed, "Backspace"),
    OfRun(C::kUnlimited, workbench::Flow::kUnlimited, "O"),
    OfRun(C::kReset, workbench::Flow::kReset, "Ctrl+R"),
    OfRun(C::kNextSeed, workbench::Flow::kNextSeed, "Ctrl+Shift+R"),
    OfRun(C::kQuit, workbench::Flow::kQuit, "Ctrl+Q"),
    {C::kFrameSelection, G::kCamera, "", "Frame the selection", "F", "Keeps the selected agents in view"},
    {C::kFrameAll, G::kCamera, "", "Frame all", "Home", "Keeps all agents in view, and the places as far as they fit"},
    {C::kFreeCamera, G::kCamera, "free", "Free camera", "1",
     "Fly: W A S D, Q E; right drag looks, the wheel flies ahead"},
    {C::kOrbitCamera, G::kCamera, "orbit", "Orbit", "2",
     "Circle round the selected agent, or the middle of the picture"},
    {C::kFollowCamera, G::kCamera, "follow", "Follow", "3 or C", "Stay with the selected agent"},
    {C::kEyesCamera, G::kCamera, "eyes", "Agent's eyes", "4", "See what the selected agent looks at"},
    {C::kMapCamera, G::kCamera, "map", "Map", "5", "From above, north up; drag to move, the wheel zooms"},
    {C::kSelectNext, G::kSelection, "", "Next agent", "Tab", "Select the agent after this one"},
    {C::kSelectPrevious, G::kSelection, "", "Previous agent", "Shift+Tab", "Select the agent before this one"},
    {C::kSelectNone, G::kSelection, "", "Select none", "Ctrl+D", "Clear the selection"},
    {C::kScaleAuto, G::kScale, "", "Automatic", "",
     "The largest scale with thirty pictures a second; full size with a graphics card"},
    {C::kScaleFull, G::kScale, "", "100 %", "", "Every pixel of the scene is drawn"},
    {C::kScaleThreeQuarters, G::kScale, "", "75 %", "", "A little soft, for half of the work; texts stay sharp"},
    {C::kScaleHalf, G::kScale, "", "50 %", "", "Soft, for a quarter of the work; texts stay sharp"},
    {C::kMute, G::kSound, "", "Sounds off", "U", "The sounds of the world are silent"},
    {C::kLabels, G::kOverlay, "labels", "Names and states", "L", "Name, operator, health above each agent"},
    {C::kTrails, G::kOverlay, "trails", "Trails", "T", "Where each agent came from"},
    {C::kSenses, G::kOverlay, "senses", "Sensor cones", "V", "How far and how wide the agents see and hear"},
    {C::kPaths, G::kOverlay, "paths", "Planned paths", "R", "The paths that agents intend to follow"},
    {C::kTargets, G::kOverlay, "targets", "Targets", "G", "What agents aim at, go to and follow"},
    {C::kShots, G::kOverlay, "shots", "Shots and hits", "X", "Lines of fire, and a mark where they ended"},
    {C::kMessages, G::kOverlay, "messages", "Messages", "M", "What agents say, as speech bubbles"},
    {C::kForces, G::kOverlay, "forces", "Steering forces", "Y", "Velocity and the force that changes it"},
    {C::kBelief, G::kOverlay, "belief", "Belief", "B", "The others where the selected agent believes them to be"},
    {C::kNavigation, G::kOverlay, "navigation", "Navigation mesh", "J", "Where agents can walk"},
    {C::kInfluence, G::kOverlay, "influence", "Influence map", "I", "The scenario's influence map"},
    {C::kPhysics, G::kOverlay, "physics", "Physics shapes", "K", "What bodies really collide with"},
    {C::kHelp, G::kHelp, "", "Keys", "H or ?", "The list of keys"},
};

constexpr bool IsInOrder() {
  int number = 0;
  for (const CommandInfo& info : kInfos) {
    if (static_cast<int>(info.command) != number++) return false;
  }
  return number == kViewerCommands;
}
static_assert(IsInOrder());

struct Key {
  int scancode;
  bool shift, control;
  ViewerCommand command;
};

constexpr Key kKeys[] = {
    {SDL_SCANCODE_P, false, false, C::kTogglePause},
    {SDL_SCANCODE_PAUSE, false, false, C::kTogglePause},
    {SDL_SCANCODE_N, false, false, C::kSingleStep},
    {SDL_SCANCODE_PERIOD, false, false, C::kSingleStep},
    {SDL_SCANCODE_N, true, false, C::kStepDecision},
    {SDL_SCANCODE_N, false, true, C::kStepPhase},
    {SDL_SCANCODE_N, true, true, C::kStepChange},
    {SDL_SCANCODE_EQUALS, false, false, C::kFaster},
    {SDL_SCANCODE_EQUALS, true, false, C::kFaster},
    {SDL_SCANCODE_KP_PLUS, false, false, C::kFaster},
    {SDL_SCANCODE_MINUS, false, false, C::kSlower},
    {SDL_SCANCODE_KP_MINUS, false, false, C::kSlower},
    {SDL_SCANCODE_BACKSPACE, false, false, C::kNormalSpeed},
    {SDL_SCANCODE_O, false, false, C::kUnlimited},
    {SDL_SCANCODE_R, false, true, C::kReset},
    {SDL_SCANCODE_R, true, true, C::kNextSeed},
    {SDL_SCANCODE_ESCAPE, false, false, C::kQuit},
    {SDL_SCANCODE_F, false, false, C::kFrameSelection},
    {SDL_SCANCODE_HOME, false, false, C::kFrameAll},
    {SDL_SCANCODE_1, false, false, C::kFreeCamera},
    {SDL_SCANCODE_2, false, false, C::kOrbitCamera},
    {SDL_SCANCODE_3, false, false, C::kFollowCamera},
    {SDL_SCANCODE_C, false, false, C::kFollowCamera},
    {SDL_SCANCODE_4, false, false, C::kEyesCamera},
    {SDL_SCANCODE_5, false, false, C::kMapCamera},
    {SDL_SCANCODE_TAB, false, false, C::kSelectNext},
    {SDL_SCANCODE_TAB, true, false, C::kSelectPrevious},
    {SDL_SCANCODE_D, false, true, C::kSelectNone},
    {SDL_SCANCODE_U, false, false, C::kMute},
    {SDL_SCANCODE_L, false, false, C::kLabels},
    {SDL_SCANCODE_T, false, false, C::kTrails},
    {SDL_SCANCODE_V, false, false, C::kSenses},
    {SDL_SCANCODE_R, false, false, C::kPaths},
    {SDL_SCANCODE_G, false, false, C::kTargets},
    {SDL_SCANCODE_X, false, false, C::kShots},
    {SDL_SCANCODE_M, false, false, C::kMessages},
    {SDL_SCANCODE_Y, false, false, C::kForces},
    {SDL_SCANCODE_B, false, false, C::kBelief},
    {SDL_SCANCODE_J, false, false, C::kNavigation},
    {SDL_SCANCODE_I, false, false, C::kInfluence},
    {SDL_SCANCODE_K, false, false, C::kPhysics},
    {SDL_SCANCODE_H, false, false, C::kHelp},
    {SDL_SCANCODE_SLASH, true, false, C::kHelp},
    {SDL_SCANCODE_Q, false, true, C::kQuit},
};

}  // namespace

std::span<const CommandInfo> Commands() {
  return kInfos;
}

const CommandInfo& InfoOf(ViewerCommand command) {
  return kInfos[static_cast<std::size_t>(command)];
}

std::optional<ViewerCommand> CommandOfKey(int scancode, bool shift, bool control) {
  for (const Key& key : kKeys) {
    if (key.scancode == scancode && key.shift == shift && key.control == control) return key.command;
  }
  return std::nullopt;
}

}  // namespace soarbox::viewer
