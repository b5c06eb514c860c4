// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "viewer/panels/text_capture.h"

namespace soarbox::viewer {

/// What a script that plays a user can see and do in a frame.
struct UiStage {
  const std::vector<ShownText>& shown;
  std::uint64_t tick = 0;
  double time_s = 0;
  bool is_idle = true;  ///< The panels have received all input so far.
  /// Returns a point of the screen where a click selects this agent; nothing if there is none.
  std::function<std::optional<ImVec2>(const std::string& agent)> place_of;
  std::string selected;  ///< The selected agent.
  std::function<Result<void>(const std::filesystem::path&)> save_picture;
  /// Finds texts that are cut or overlap (layout_audit.h).
  std::function<std::vector<std::string>()> audit;
  /// Prints the costs of the window (frame_meter.h).
  std::function<void(const std::string& name)> measure;
};

/// Plays a user. A script has lines like
///
///     click "Pause"            the place of this text on the screen; with a number after it, the n-th of these places
///     click-agent scout
///     type "print s1"
///     key Return               also Ctrl+R, F11, ...
///     expect "operator tie"    waits until the text appears; expect-not: until it disappears
///     picture docs/why.png
///     measure "at 30 s"        prints the costs of the frames since the last such line, and the used memory
///     audit "panel Why"        fails if a text is cut or windows overlap; the message contains the name
///
/// and is executed with real mouse and keyboard events, one per frame. A line that fails ends the script.
class UiScript {
 public:
  static Result<UiScript> Load(const std::filesystem::path& file);

  /// Advances the script. Call it after each frame.
  void Advance(const UiStage& stage);

  /// Skips the first `steps` steps; another window has already executed them.
  void Skip(std::size_t steps) { at_ = steps; }
  std::size_t at() const { return at_; }
  bool is_over() const { return at_ >= steps_.size() || failure_.has_value(); }
  /// The error with the script's line.
  const std::optional<Diagnostic>& failure() const { return failure_; }

 private:
  struct Step {
    int line = 0;
    std::string word;
    std::vector<std::string> arguments;
  };
  /// Returns true if the step is done, false if it must be tried again in the next frame.
  bool Do(const Step& step, const UiStage& stage);
  bool DoMouse(const Step& step, const UiStage& stage);
  /// Clicks until the agent is selected: in a moving crowd, another agent may be in front of it.
  bool ClickAgent(const std::string& agent, const UiStage& stage);
  void Fail(const Step& step, std::string message, const UiStage& stage);

  std::string file_;
  std::vector<Step> steps_;
  std::size_t at_ = 0;
  int settle_ = 0;        ///< Frames to wait.
  int waited_ = 0;        ///< Frames that the current step has waited.
  bool clicked_ = false;  ///< The current step has already clicked.
  std::chrono::steady_clock::time_point waits_since_;
  std::optional<Diagnostic> failure_;
};

}  // namespace soarbox::viewer
