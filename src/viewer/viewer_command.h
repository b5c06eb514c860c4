// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace soarbox::viewer {

/// What the user can request of the window and of the run, by a key, a menu or a button.
///
/// Commands up to kQuit concern the run, which the application owns: Viewer::TakeCommands returns them. The window
/// executes the others itself. Viewer::Do accepts both kinds.
enum class ViewerCommand : std::uint8_t {
  // The run.
  kTogglePause,
  kSingleStep,    ///< Pauses and advances by one turn; in a world without turns, by one tick.
  kStepDecision,  ///< Pauses; advances by a tick in which the selected agent makes one decision.
  kStepPhase,     ///< Pauses; advances only the selected agent's mind by a phase, not the world.
  kStepChange,    ///< Runs until the selected agent's operator, goal stack or command changes, and pauses.
  kFaster,
  kSlower,
  kNormalSpeed,
  kUnlimited,  ///< As fast as possible; again: the previous speed.
  kReset,      ///< Starts again with the same seed.
  kNextSeed,   ///< Starts again with the next seed.
  kQuit,
  // The camera.
  kFrameSelection,  ///< The selected agents fill the picture; all if none is selected.
  kFrameAll,
  kFreeCamera,
  kOrbitCamera,   ///< Around the point in the middle of the picture, or the selected agent.
  kFollowCamera,  ///< With the selected agent; again: free.
  kEyesCamera,    ///< Through the selected agent's eyes.
  kMapCamera,     ///< From above, north up.
  // The selection.
  kSelectNext,
  kSelectPrevious,
  kSelectNone,
  // The scale at which the scene is drawn before it is enlarged; one of these is on.
  kScaleAuto,
  kScaleFull,
  kScaleThreeQuarters,
  kScaleHalf,
  kMute,  ///< On: the sounds of the world are silent.
  // Overlays over the scene; each is on or off.
  kLabels,
  kTrails,
  kSenses,
  kPaths,
  kTargets,
  kShots,
  kMessages,
  kForces,
  kBelief,
  kNavigation,
  kInfluence,
  kPhysics,
  kHelp,
};

inline constexpr int kViewerCommands = static_cast<int>(ViewerCommand::kHelp) + 1;

enum class CommandGroup : std::uint8_t { kRun, kCamera, kSelection, kScale, kSound, kOverlay, kHelp };

/// The description of a command for menus and the list of keys.
struct CommandInfo {
  ViewerCommand command;
  CommandGroup group;
  std::string_view word;     ///< Name of a camera mode or an overlay on command lines: "senses"; else empty.
  std::string_view title;    ///< "Sensor cones"
  std::string_view keys;     ///< "V", "Ctrl+R"
  std::string_view meaning;  ///< A sentence without its full stop.
};

/// All commands, in the order of the enumeration.
std::span<const CommandInfo> Commands();
const CommandInfo& InfoOf(ViewerCommand command);

/// Whether the command concerns the run, not the window.
inline bool IsOfRun(ViewerCommand command) {
  return command <= ViewerCommand::kQuit;
}
/// Whether the command switches an overlay.
inline bool IsOverlay(ViewerCommand command) {
  return command >= ViewerCommand::kLabels && command <= ViewerCommand::kPhysics;
}

/// Returns the command of a key (SDL's scan code); nothing for other keys.
std::optional<ViewerCommand> CommandOfKey(int scancode, bool shift, bool control);

}  // namespace soarbox::viewer
