// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/read_text.h"

#include <fstream>
#include <system_error>

namespace soarbox {

std::optional<std::string> ReadText(const std::filesystem::path& file) {
  // A folder opens as a file does, and fails only when it is read.
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::string text;
  char part[16 * 1024];
  while (in.read(part, sizeof part) || in.gcount() > 0) text.append(part, static_cast<std::size_t>(in.gcount()));
  if (in.bad()) return std::nullopt;
  return text;
}

}  // namespace soarbox
