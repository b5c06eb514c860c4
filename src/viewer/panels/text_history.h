// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace soarbox::viewer {

/// The versions of a text that somebody edits, so that every change can be undone and done again, also those that did
/// not come by typing (a file taken from the disk, *Revert*).
///
/// What is typed without a pause is one step. Of very long histories the oldest steps are forgotten.
class TextHistory {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{16} << 20, kMostSteps = 1000;

  /// Begins with this text; nothing can be undone.
  void Begin(std::string text);
  /// The text has become another. `goes_on`: it belongs to the step before, as the next letter of a word does.
  void Note(const std::string& text, bool goes_on);

  bool CanUndo() const { return at_ > 0; }
  bool CanRedo() const { return at_ + 1 < steps_.size(); }
  /// The version before, or behind; only if there is one.
  const std::string& Undo();
  const std::string& Redo();
  /// Where the version that is shown now differs from the one shown before; an index into its text.
  std::size_t changed_at() const { return changed_at_; }

 private:
  const std::string& GoTo(std::size_t step);
  void Forget();

  std::vector<std::string> steps_;
  std::size_t at_ = 0, changed_at_ = 0;
  bool may_go_on_ = false;  ///< The last step came by typing, and nothing was undone since.
};

}  // namespace soarbox::viewer
