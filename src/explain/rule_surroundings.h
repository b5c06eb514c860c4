// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>

namespace soarbox::explain {

/// What the other files of a folder add to what its rules may test and give.
struct Surroundings {
  std::set<std::string> lua_words;      ///< Scripts may make percepts and take commands of their own.
  std::set<std::string> made_by_rules;  ///< Attributes in actions of any rule, and those of facts (smem --add).
  std::set<std::string> made_values;    ///< "attribute value" of these, each with the word after it.
  bool has_database = false;            ///< Files name a database or a file of facts, which may hold any attribute.
};

/// Reads the scripts and rules directly in a folder; an empty path is the current one. Pipes, devices and links that
/// lead out of the `readable` folders are left alone.
Surroundings LookAround(const std::filesystem::path& folder, std::span<const std::filesystem::path> readable);

}  // namespace soarbox::explain
