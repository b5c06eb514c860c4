// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "record/reader.h"

namespace soarbox::record {

/// Which ticks of a recording to export. Ticks that the recording does not contain are skipped.
struct TickRange {
  std::uint64_t first = 0;
  std::uint64_t last = ~std::uint64_t{0};
};

/// Calls `see(record)` for each tick of the range that the recording contains.
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

/// Writes a CSV table with a row for each agent and tick, which spreadsheets and data frames read directly. The first
/// line has the names of the columns: tick, time_s, agent, position, velocity, speed, heading, health, command,
/// decision, and a column for each percept that any agent has in the range. The cell of a percept is empty if the agent
/// does not have it.
Result<void> ExportCsv(Reader& recording, TickRange range, std::ostream& out);

/// Writes the entire recording as one JSON object per line: one for the recording, then one per tick.
Result<void> ExportJson(Reader& recording, TickRange range, std::ostream& out);

/// Writes a part of a recording as a recording of its own. It contains all earlier inputs, so that it can be verified
/// and resumed. Fails if the file cannot be written or no tick is in the range.
Result<void> ExportRecording(Reader& recording, TickRange range, const std::filesystem::path& file);

/// Prints inputs, events, percepts, decisions and commands tick by tick, for people to read.
Result<void> PrintTicks(Reader& recording, TickRange range, std::ostream& out);

}  // namespace soarbox::record
