// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace soarbox {

enum class ReadFrom : std::uint8_t {
  kPlainFiles,  ///< Pipes and devices, which may never end, count as unreadable; so does what is larger than 1 GB.
  kAnything,    ///< Somebody named it on purpose.
};

/// All that a file holds; nothing if it cannot be read.
std::optional<std::string> ReadText(const std::filesystem::path& file, ReadFrom from = ReadFrom::kPlainFiles);

/// Whether this is a plain file that lies below one of the folders, all links followed.
bool IsPlainFileBelow(const std::filesystem::path& file, std::span<const std::filesystem::path> folders);

}  // namespace soarbox
