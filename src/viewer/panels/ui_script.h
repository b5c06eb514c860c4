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

/// What a script that plays the user can see and do in a frame.
struct UiStage {
  const std::vector<ShownText>& shown;
  std::uint64_t tick = 0;
  double time_s = 0;
  bool is_idle = true;  ///< All input so far has reached the panels.
  /// Where on the screen a click selects this agent; none if nothing of it can be clicked.
  std::function<std::optional<ImVec2>(const std::string& agent)> place_of;
  std::string selected;  ///< The agent that is.
  std::function<Result<void>(const std::filesystem::path&)> save_picture;
  /// What is cut or lies over something else (layout_audit.h).
  std::function<std::vector<std::string>()> audit;
  /// Prints what the window costs (frame_meter.h).
  std::function<void(const std::string& name)> measure;
};

/// Plays a user: reads lines like
///
///     click "Pause"            the place where this stands on the screen; a number behind it: the n-th of them
///     click-agent scout
///     type "print s1"
///     key Return               also Ctrl+R, F11, ...
///     expect "operator tie"    waits until it stands there; expect-not: until it does not
///     picture docs/why.png
///     measure "at 30 s"        prints what frames cost since the last such line, and the memory that is taken
///     audit "panel Why"        fails if a text is cut or windows overlap; the name is for the message
///
/// and does them through real events of mouse and keyboard, one a frame. A line that fails ends the script.
class UiScript {
 public:
  static Result<UiScript> Load(const std::filesystem::path& file);

  /// Goes on; after each frame.
  void Advance(const UiStage& stage);

  /// Begins behind so many steps: another window has done those.
  void Skip(std::size_t steps) { at_ = steps; }
  std::size_t at() const { return at_; }
  bool is_over() const { return at_ >= steps_.size() || failure_.has_value(); }
  /// What went wrong, with the script's line.
  const std::optional<Diagnostic>& failure() const { return failure_; }

 private:
  struct Step {
    int line = 0;
    std::string word;
    std::vector<std::string> arguments;
  };
  /// True if the step is done; false: again in the next frame.
  bool Do(const Step& step, const UiStage& stage);
  bool DoMouse(const Step& step, const UiStage& stage);
  /// Clicks until the agent is selected: in a crowd that moves, another one may come before it.
  bool ClickAgent(const std::string& agent, const UiStage& stage);
  void Fail(const Step& step, std::string message, const UiStage& stage);

  std::string file_;
  std::vector<Step> steps_;
  std::size_t at_ = 0;
  int settle_ = 0;        ///< Frames to let pass.
  int waited_ = 0;        ///< Frames that the present step has waited.
  bool clicked_ = false;  ///< The present step has clicked already.
  std::chrono::steady_clock::time_point waits_since_;
  std::optional<Diagnostic> failure_;
};

}  // namespace soarbox::viewer
