// SPDX-License-Identifier: BSD-2-Clause
#include "editors/last_run.h"

#include <algorithm>

#include "record/header.h"
#include "record/reader.h"

namespace soarbox::editors {

namespace fs = std::filesystem;

fs::path NewestRecording(const fs::path& folder) {
  constexpr int kAbove = 2;
  std::error_code error;
  fs::path at = folder;
  for (int i = 0; i <= kAbove && !at.empty(); ++i, at = at.parent_path()) {
    fs::path newest;
    fs::file_time_type time{};
    for (fs::directory_iterator it(at, error), end; !error && it != end; it.increment(error)) {
      std::error_code gone;
      if (it->path().extension() != ".soarrec" || !it->is_regular_file(gone)) continue;
      const fs::file_time_type written = it->last_write_time(gone);
      if (gone || (!newest.empty() && written <= time)) continue;
      newest = it->path();
      time = written;
    }
    if (!newest.empty()) return newest;
  }
  return {};
}

std::optional<language::LastRun> ReadFirings(const fs::path& recording) {
  Result<std::unique_ptr<record::Reader>> opened = record::Reader::Open(recording);
  if (!opened) return std::nullopt;
  record::Reader& reader = **opened;
  language::LastRun run;
  run.file = recording;
  run.has_firings = reader.header().level == record::Level::kAll;
  if (!run.has_firings) return run;
  const double step_s = reader.header().step_s;
  const std::uint64_t last = reader.last_tick();
  const std::uint64_t first = std::max(reader.first_tick(), last > kMostTicks ? last - kMostTicks : 0);
  for (std::uint64_t tick = first; tick <= last; ++tick) {
    const Result<const record::TickRecord*> read = reader.At(tick);
    if (!read) break;
    for (const record::MindRecord& mind : (*read)->minds) {
      mind.events.ForEachOf<mind::RuleFired>([&](const mind::RuleFired& fired) {
        if (fired.retracts) return;
        language::LastRun::Firings& firings = run.rules[std::string(fired.rule)];
        if (firings.count++ == 0) firings.first_s = static_cast<double>(tick) * step_s;
        firings.last_s = static_cast<double>(tick) * step_s;
      });
    }
  }
  return run;
}

}  // namespace soarbox::editors
