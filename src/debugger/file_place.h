// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace soarbox::debugger {

/// A place in a file that a message names: "scout.soar:14:23" within a longer text.
struct FilePlace {
  std::string file;
  int line = 0;
  std::size_t begin = 0, length = 0;  ///< Where in the text it stands.

  friend bool operator==(const FilePlace&, const FilePlace&) = default;
};

/// The first one in the text of a file of rules, a script or a scenario; nothing if there is none.
std::optional<FilePlace> FindFilePlace(std::string_view text);

/// Whether the panel Edit can change this file and reload it: rules and scripts.
bool IsEditable(std::string_view file);

}  // namespace soarbox::debugger
