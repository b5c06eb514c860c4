// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "record/reader.h"

namespace soarbox::record {

/// Which ticks of a recording to export; ticks that are not in the recording are left out.
struct TickRange {
  std::uint64_t first = 0;
  std::uint64_t last = ~std::uint64_t{0};
};

/// Calls `see(record)` for each tick of the range that the recording holds.
template <typename See>
Result<void> ForEachTick(Reader& recording, TickRange range, See see) {
  const std::uint64_t last = std::min(range.last, recording.last_tick());
  for (std::uint64_t tick = std::max(range.first, recording.first_tick()); tick <= last; ++tick) {
    const Result<const TickRecord*> record = recording.At(tick);
    if (!record) return record.error();
    see(**record);
  }
  return {};
}

/// A table with a row for each agent and tick, in a form that spreadsheets and data frames read directly: a line of
/// names, then tick, time_s, agent, position, velocity, speed, heading, health, command, decision, and a column for
/// each percept that any agent has in the range, with its value in that tick (empty: none).
Result<void> ExportCsv(Reader& recording, TickRange range, std::ostream& out);

/// The same and everything else in the recording, as one JSON object per line: one for the recording, then one per
/// tick.
Result<void> ExportJson(Reader& recording, TickRange range, std::ostream& out);

/// A part of a recording as a recording of its own, with all earlier inputs, so that you can verify and resume it like
/// the whole. Fails if the file cannot be written or no tick is in the range.
Result<void> ExportRecording(Reader& recording, TickRange range, const std::filesystem::path& file);

/// What happened, for people to read: inputs, events, percepts, decisions and commands, tick by tick.
Result<void> PrintTicks(Reader& recording, TickRange range, std::ostream& out);

}  // namespace soarbox::record
