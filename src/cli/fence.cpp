// SPDX-License-Identifier: BSD-2-Clause
#include "cli/fence.h"

#include <algorithm>
#include <system_error>

namespace soarbox::cli {
namespace {

namespace fs = std::filesystem;

/// Commands that a scenario's files have no use for: they show files, change what all agents share, write, run agents
/// or start programs.
constexpr std::string_view kRefused[] = {"alias", "debug", "ls", "run", "save", "svs", "visualize"};

bool IsBelow(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

Fence::Fence(std::vector<fs::path> folders) {
  for (const fs::path& folder : folders) {
    std::error_code error;
    fs::path canonical = fs::canonical(folder, error);
    if (!error) folders_.push_back(std::move(canonical));
  }
}

bool Fence::MayRead(const fs::path& path) const {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(path, error);
  if (error) return false;
  return std::any_of(folders_.begin(), folders_.end(),
                     [&](const fs::path& folder) { return IsBelow(canonical, folder); });
}

std::string Fence::Refusal(std::span<const Word> words) {
  const std::string& name = words.front().text;
  if (std::find(std::begin(kRefused), std::end(kRefused), name) == std::end(kRefused)) return {};
  return "The files of a scenario may not use '" + name + "'. Type it yourself, or in a debugger.";
}

}  // namespace soarbox::cli
