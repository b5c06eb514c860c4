// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "app/recording_commands.h"
#include "diagnostics/result.h"
#include "record/export.h"
#include "record/reader.h"

namespace soarbox::app {

/// Opens a recording. Prints a note if a killed program has left it incomplete.
Result<std::unique_ptr<record::Reader>> OpenRecording(const std::filesystem::path& file);

/// The tick at this time, in simulated seconds; 0 if the time is negative.
std::uint64_t TickAt(const record::Reader& reader, double time_s);

/// The ticks from --from to --to.
record::TickRange RangeOf(const record::Reader& reader, const RecordingOptions& options);

}  // namespace soarbox::app
