// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "language/hover.h"

namespace soarbox::editors {

/// The newest recording (.soarrec) in a folder or in one of the two folders above it; empty if there is none.
std::filesystem::path NewestRecording(const std::filesystem::path& folder);
/// Counts the firings in a recording; nothing if it cannot be read. Of long recordings, only the last `kMostTicks`
/// ticks are read.
std::optional<language::LastRun> ReadFirings(const std::filesystem::path& recording);
inline constexpr std::uint64_t kMostTicks = 18'000;

}  // namespace soarbox::editors
