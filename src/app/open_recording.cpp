// SPDX-License-Identifier: BSD-2-Clause
#include "app/open_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/refuse.h"
#include "diagnostics/problem.h"

namespace soarbox::app {

Result<std::unique_ptr<record::Reader>> OpenRecording(const std::filesystem::path& file) {
  Result<std::unique_ptr<record::Reader>> reader = record::Reader::Open(file);
  if (reader && !(*reader)->ending().empty())
    Remark(Severity::kWarning, ProblemIn(file, (*reader)->ending(),
                                         fmt::format("the recording is used up to tick {}", (*reader)->last_tick())));
  return reader;
}

std::uint64_t TickAt(const record::Reader& reader, double time_s) {
  return static_cast<std::uint64_t>(std::llround(std::max(time_s, 0.0) / reader.header().step_s));
}

record::TickRange RangeOf(const record::Reader& reader, const RecordingOptions& options) {
  record::TickRange range;
  if (options.from_s) range.first = TickAt(reader, *options.from_s);
  if (options.to_s) range.last = TickAt(reader, *options.to_s);
  return range;
}

}  // namespace soarbox::app
