// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::sim {

struct Scenario;

/// The name of the file that a line of rules sources, without its quotes or braces; empty for other lines.
std::string NameSourcedBy(std::string_view line);

/// A file of rules and those that it sources, with all below them, in the order of loading. Reads the disk: only plain
/// files, and only those below the `readable` folders, if any are named.
std::vector<std::filesystem::path> FilesOfProgram(const std::filesystem::path& rules,
                                                  std::span<const std::filesystem::path> readable = {});
/// The same as a set.
std::set<std::filesystem::path> WithSourcedFiles(const std::filesystem::path& rules,
                                                 std::span<const std::filesystem::path> readable = {});

/// The folders in which a scenario's rule files may be read; empty: everywhere.
std::vector<std::filesystem::path> ReadableRuleFolders(const Scenario& scenario);

}  // namespace soarbox::sim
