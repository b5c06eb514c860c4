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
  kRaw,   ///< As in a zip archive.
  kGzip,  ///< For browsers, with maximum compression.
};
/// Compresses bytes. Empty on failure.
std::string Deflate(std::string_view bytes, DeflateAs format);

/// A file in a zip archive.
struct ZipEntry {
  std::string path;  ///< With "/" as the separator.
  std::string bytes;
};

std::string WriteZip(const std::vector<ZipEntry>& entries);
/// Reads a zip archive; skips folders. The archive may come from an untrusted user: fails if it contains more files or
/// bytes than allowed. Paths are not checked.
Result<std::vector<ZipEntry>> ReadZip(std::string_view archive, std::size_t most_files, std::uintmax_t most_bytes);

}  // namespace soarbox::serve
