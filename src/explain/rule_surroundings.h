// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>

namespace soarbox::explain {

/// What the other files of a folder add to the words that its rules may test and use.
struct Surroundings {
  std::set<std::string> lua_words;      ///< Words of scripts, which may define percepts and commands.
  std::set<std::string> made_by_rules;  ///< Attributes in actions of any rule, and attributes of facts (smem --add).
  std::set<std::string> made_values;    ///< "attribute value" for each of these attributes and the word after it.
  bool has_database = false;            ///< A file names a database or a file of facts, which may contain any
                                        ///< attribute.
};

/// Reads the scripts and rules that are directly in a folder; an empty path means the current folder. Skips pipes,
/// devices and links that lead out of the `readable` folders.
Surroundings LookAround(const std::filesystem::path& folder, std::span<const std::filesystem::path> readable);

}  // namespace soarbox::explain
