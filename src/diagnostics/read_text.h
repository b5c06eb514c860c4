// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace soarbox {

enum class ReadFrom : std::uint8_t {
  kPlainFiles,  ///< Pipes and devices, which may never end, and files larger than 1 GB are treated as unreadable.
  kAnything,    ///< The user has named the file explicitly.
};

/// The content of a file; nothing if it cannot be read.
std::optional<std::string> ReadText(const std::filesystem::path& file, ReadFrom from = ReadFrom::kPlainFiles);

/// Whether a path is a plain file below one of the folders, after resolving links.
bool IsPlainFileBelow(const std::filesystem::path& file, std::span<const std::filesystem::path> folders);

}  // namespace soarbox
