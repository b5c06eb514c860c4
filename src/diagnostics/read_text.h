// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace soarbox {

/// All that a file holds; nothing if it cannot be read.
std::optional<std::string> ReadText(const std::filesystem::path& file);

}  // namespace soarbox
