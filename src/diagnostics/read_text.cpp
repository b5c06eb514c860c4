// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/read_text.h"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace soarbox {

constexpr std::uintmax_t kMostTextBytes = std::uintmax_t{1} << 30;

std::optional<std::string> ReadText(const std::filesystem::path& file, ReadFrom from) {
  // A folder can be opened like a file and fails only when it is read. Opening a pipe without a writer blocks.
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return std::nullopt;
  if (from == ReadFrom::kPlainFiles) {
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    if (std::filesystem::file_size(file, error) > kMostTextBytes || error) return std::nullopt;
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::string text;
  char part[16 * 1024];
  while (in.read(part, sizeof part) || in.gcount() > 0) text.append(part, static_cast<std::size_t>(in.gcount()));
  if (in.bad()) return std::nullopt;
  return text;
}

bool IsPlainFileBelow(const std::filesystem::path& file, std::span<const std::filesystem::path> folders) {
  std::error_code error;
  const std::filesystem::path found = std::filesystem::canonical(file, error);
  if (error || !std::filesystem::is_regular_file(found, error)) return false;
  return std::ranges::any_of(folders, [&](const std::filesystem::path& folder) {
    const std::filesystem::path root = std::filesystem::canonical(folder, error);
    return !error && std::ranges::mismatch(root, found).in1 == root.end();
  });
}

}  // namespace soarbox
