// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace soarbox::editors {

/// Converts "file:///home/me/a%20b.soar" to a normalized path; empty for other schemes.
std::filesystem::path PathOfUri(std::string_view uri);
std::string UriOf(const std::filesystem::path& path);

}  // namespace soarbox::editors
