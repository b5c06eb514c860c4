// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <vector>

namespace soarbox::sim {

struct Scenario;

/// A file of rules and those that it sources, with all below them. Reads the disk: plain files only, and of them only
/// those that lie below the `readable` folders, if any are named.
std::set<std::filesystem::path> WithSourcedFiles(const std::filesystem::path& rules,
                                                 std::span<const std::filesystem::path> readable = {});

/// The folders in which a scenario's rule files may be read; empty: everywhere.
std::vector<std::filesystem::path> ReadableRuleFolders(const Scenario& scenario);

}  // namespace soarbox::sim
