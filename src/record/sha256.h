// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace soarbox::record {

/// The SHA-256 (FIPS 180-4) of these bytes, as 64 hexadecimal digits.
std::string Sha256(std::string_view bytes);
/// The SHA-256 of a file's content; empty if the file cannot be read.
std::string Sha256OfFile(const std::filesystem::path& file);

}  // namespace soarbox::record
