// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <system_error>

#include "diagnostics/problem.h"
#include "record/export.h"
#include "record/manifest.h"
#include "record/writer.h"

namespace soarbox::record {

Result<void> ExportRecording(Reader& recording, TickRange range, const std::filesystem::path& file) {
  const std::uint64_t first = std::max(range.first, recording.first_tick());
  const std::uint64_t last = std::min(range.last, recording.last_tick());
  if (first > last) return NotThere(recording, range.first);
  std::error_code error;
  if (std::filesystem::equivalent(recording.file(), file, error)) {
    return ProblemIn(file.string(), "a part of a recording cannot replace the entire recording", "name another file");
  }
  Result<std::vector<TickInputs>> earlier = recording.Inputs();
  if (!earlier) return earlier.error();
  std::erase_if(*earlier, [&](const TickInputs& entry) { return entry.tick >= first; });
  Result<std::unique_ptr<Writer>> writer =
      Writer::Create(file, recording.header(), {.manifest = ManifestIn(recording.file())});
  if (!writer) return writer.error();
  if (const Result<void> added = (*writer)->AddEarlierInputs(*earlier); !added) return added;
  for (std::uint64_t tick = first; tick <= last; ++tick) {
    const Result<const TickRecord*> record = recording.At(tick);
    if (!record) return record.error();
    if (const Result<void> added = (*writer)->Add(**record); !added) return added;
  }
  return (*writer)->Flush();
}

}  // namespace soarbox::record
