// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::workbench {

/// What was typed into files and not saved, kept on the disk beside the files of other programs' state, so that neither
/// a closed window nor a crash loses it. A draft stays until its file is saved or reverted.
class Drafts {
 public:
  /// An empty folder: nothing is kept.
  explicit Drafts(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// $XDG_STATE_HOME/soarbox/drafts, or below ~/.local/state; empty if there is no home.
  static std::filesystem::path Folder();

  /// Writes the draft of a file, whole or not at all.
  Result<void> Keep(const std::filesystem::path& file, const std::string& text) const;
  void Drop(const std::filesystem::path& file) const;
  /// The draft of a file; nothing if there is none.
  std::optional<std::string> Find(const std::filesystem::path& file) const;

 private:
  std::filesystem::path PlaceOf(const std::filesystem::path& file) const;

  std::filesystem::path folder_;
};

}  // namespace soarbox::workbench
