// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "language/hover.h"

namespace soarbox::editors {

/// The newest recording (.soarrec) in a folder. If it contains none, the newest in the folder above it, or else in the
/// next folder above. Empty if there is none.
std::filesystem::path NewestRecording(const std::filesystem::path& folder);
/// Counts the firings of each rule in a recording, without retractions; nothing if it cannot be opened. A recording
/// below the level `all` has no firings (LastRun::has_firings). Of long recordings, only the last `kMostTicks` ticks
/// are read.
std::optional<language::LastRun> ReadFirings(const std::filesystem::path& recording);
inline constexpr std::uint64_t kMostTicks = 18'000;

}  // namespace soarbox::editors
