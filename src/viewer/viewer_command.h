// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace soarbox::viewer {

/// What the user can ask of the window and of the run, by a key, a menu or a button.
///
/// Those up to kQuit are the application's, which owns the run: they come out of Viewer::TakeCommands. The others the
/// window obeys itself; Viewer::Do carries out either kind.
enum class ViewerCommand : std::uint8_t {
  // The run.
  kTogglePause,
  kSingleStep,    ///< Pauses and goes on by one tick.
  kStepDecision,  ///< Pauses; goes on by a tick in which the selected agent makes one decision.
  kStepPhase,     ///< Pauses; the selected agent's mind alone goes on by a phase, its world stands still.
  kStepChange,    ///< Goes on until the selected agent's operator, goal stack or command changes, and pauses.
  kFaster,
  kSlower,
  kNormalSpeed,
  kUnlimited,  ///< As fast as it goes; again: back to the speed before.
  kReset,      ///< From the beginning with the same seed.
  kNextSeed,   ///< From the beginning with the next seed.
  kQuit,
  // The camera.
  kFrameSelection,  ///< The selected agents fill the picture; all if none is selected.
  kFrameAll,
  kFreeCamera,
  kOrbitCamera,   ///< Around what is in the middle of the picture, or the selected agent.
  kFollowCamera,  ///< With the selected agent; again: free.
  kEyesCamera,    ///< Through the selected agent's eyes.
  kMapCamera,     ///< From above, north up.
  // The selection.
  kSelectNext,
  kSelectPrevious,
  kSelectNone,
  // How large the scene is drawn before it is brought up to the picture's size; one of them is on.
  kScaleAuto,
  kScaleFull,
  kScaleThreeQuarters,
  kScaleHalf,
  // What is drawn over the scene; each is on or off.
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

enum class CommandGroup : std::uint8_t { kRun, kCamera, kSelection, kScale, kOverlay, kHelp };

/// A command as menus and the list of keys show it.
struct CommandInfo {
  ViewerCommand command;
  CommandGroup group;
  std::string_view word;     ///< Of cameras and overlays, for command lines: "senses"; else empty.
  std::string_view title;    ///< "Sensor cones"
  std::string_view keys;     ///< "V", "Ctrl+R"
  std::string_view meaning;  ///< A sentence without its full stop.
};

/// All commands, in the order of the enumeration.
std::span<const CommandInfo> Commands();
const CommandInfo& InfoOf(ViewerCommand command);

/// Whether the command is the application's, not the window's own.
inline bool IsOfRun(ViewerCommand command) {
  return command <= ViewerCommand::kQuit;
}
/// Whether it switches an overlay.
inline bool IsOverlay(ViewerCommand command) {
  return command >= ViewerCommand::kLabels && command <= ViewerCommand::kPhysics;
}

/// The command behind a key (SDL's scan code); none for other keys.
std::optional<ViewerCommand> CommandOfKey(int scancode, bool shift, bool control);

}  // namespace soarbox::viewer
