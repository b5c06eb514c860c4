// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace soarbox::debugger {

/// A position in a file that a message mentions: "scout.soar:14:23" within a longer text.
struct FilePlace {
  std::string file;
  int line = 0;
  std::size_t begin = 0, length = 0;  ///< Where the position is in the text of the message.

  friend bool operator==(const FilePlace&, const FilePlace&) = default;
};

/// Finds the first position in a file of rules, a script or a scenario that the text mentions; nothing if there is
/// none.
std::optional<FilePlace> FindFilePlace(std::string_view text);

/// Whether the panel Edit can change this file and reload it. True for rules and scripts.
bool IsEditable(std::string_view file);

}  // namespace soarbox::debugger
