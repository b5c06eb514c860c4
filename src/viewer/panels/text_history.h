// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace soarbox::viewer {

/// The versions of an edited text. Every change can be undone and redone, also changes that were not typed (a file
/// reloaded from the disk, *Revert*).
///
/// Text that is typed without a pause is one step. Very long histories drop the oldest steps.
class TextHistory {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{16} << 20, kMostSteps = 1000;

  /// Starts with this text and an empty history.
  void Begin(std::string text);
  /// Notes a new version of the text. `goes_on`: it extends the previous step, as the next letter of a word does.
  void Note(const std::string& text, bool goes_on);

  bool CanUndo() const { return at_ > 0; }
  bool CanRedo() const { return at_ + 1 < steps_.size(); }
  /// Returns the previous or the next version; call only if there is one.
  const std::string& Undo();
  const std::string& Redo();
  /// Index into the text at which the current version differs from the previously shown one.
  std::size_t changed_at() const { return changed_at_; }

 private:
  const std::string& GoTo(std::size_t step);
  void Forget();

  std::vector<std::string> steps_;
  std::size_t at_ = 0, changed_at_ = 0;
  bool may_go_on_ = false;  ///< The last step was typed, and nothing was undone since.
};

}  // namespace soarbox::viewer
