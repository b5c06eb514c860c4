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

/// The file that a line of rules sources, without quotes or braces; empty for other lines.
std::string NameSourcedBy(std::string_view line);

/// A file of rules and all files that it sources, directly or through others, in the order of loading. Reads only plain
/// files, and only below the `readable` folders, if there are any.
std::vector<std::filesystem::path> FilesOfProgram(const std::filesystem::path& rules,
                                                  std::span<const std::filesystem::path> readable = {});
/// The same as a set.
std::set<std::filesystem::path> WithSourcedFiles(const std::filesystem::path& rules,
                                                 std::span<const std::filesystem::path> readable = {});

/// The folders from which a scenario's rule files may be read; empty: all.
std::vector<std::filesystem::path> ReadableRuleFolders(const Scenario& scenario);

}  // namespace soarbox::sim
