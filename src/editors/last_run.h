// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "language/hover.h"

namespace soarbox::editors {

/// The newest recording (.soarrec) in a folder or in one of the two above; empty if there is none.
std::filesystem::path NewestRecording(const std::filesystem::path& folder);
/// Counts the firings in a recording; nothing if it cannot be read. Long recordings are read for their last
/// `kMostTicks` ticks.
std::optional<language::LastRun> ReadFirings(const std::filesystem::path& recording);
inline constexpr std::uint64_t kMostTicks = 18'000;

}  // namespace soarbox::editors
