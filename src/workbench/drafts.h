// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::workbench {

/// Copies of unsaved text, stored in the user's folder for application state so that neither closing the window nor a
/// crash loses it. A draft is removed when its file is saved or reverted.
class Drafts {
 public:
  /// With an empty folder, nothing is stored.
  explicit Drafts(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// $XDG_STATE_HOME/soarbox/drafts, or ~/.local/state/soarbox/drafts; empty if there is no home directory.
  static std::filesystem::path Folder();

  /// Writes the draft of a file. The write is atomic.
  Result<void> Keep(const std::filesystem::path& file, const std::string& text) const;
  void Drop(const std::filesystem::path& file) const;
  /// The draft of a file; nothing if there is none.
  std::optional<std::string> Find(const std::filesystem::path& file) const;

 private:
  std::filesystem::path PlaceOf(const std::filesystem::path& file) const;

  std::filesystem::path folder_;
};

}  // namespace soarbox::workbench
