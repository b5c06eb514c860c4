// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/words.h"

namespace soarbox::cli {

/// What the commands in a stranger's files may reach: they read below these folders, write nothing, start nothing, and
/// change nothing that other agents or the user's own commands go by.
class Fence {
 public:
  explicit Fence(std::vector<std::filesystem::path> folders);

  /// True if the file, all links followed, lies below one of the folders.
  bool MayRead(const std::filesystem::path& path) const;
  /// Why this command may not be carried out; empty if it may. The words' aliases are expanded.
  static std::string Refusal(std::span<const Word> words);

 private:
  std::vector<std::filesystem::path> folders_;  ///< Canonical.
};

}  // namespace soarbox::cli
