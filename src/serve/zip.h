// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::serve {

enum class DeflateAs : std::uint8_t {
  kRaw,   ///< As a zip archive holds it.
  kGzip,  ///< As browsers take it: as small as can be.
};
/// Empty on failure.
std::string Deflate(std::string_view bytes, DeflateAs format);

/// A file in a zip archive.
struct ZipEntry {
  std::string path;  ///< With "/" between folders.
  std::string bytes;
};

std::string WriteZip(const std::vector<ZipEntry>& entries);
/// Folders are passed over. The archive may be anybody's: it ends with an error where it
/// holds more files or bytes than asked for. Paths are as they stand there.
Result<std::vector<ZipEntry>> ReadZip(std::string_view archive, std::size_t most_files, std::uintmax_t most_bytes);

}  // namespace soarbox::serve
