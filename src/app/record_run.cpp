// SPDX-License-Identifier: BSD-2-Clause
#include "app/record_run.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "world/world.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

constexpr double kUsualLimitMb = 256;

/// $XDG_STATE_HOME/soarbox/last-run.soarrec, by default below ~/.local/state; empty without a home.
fs::path UsualFile() {
  fs::path state;
  if (const char* folder = std::getenv("XDG_STATE_HOME"); folder != nullptr && *folder != '\0') {
    state = folder;
  } else if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    state = fs::path(home) / ".local" / "state";
  } else {
    return {};
  }
  std::error_code error;
  fs::create_directories(state / "soarbox", error);
  return error ? fs::path{} : state / "soarbox" / "last-run.soarrec";
}

}  // namespace

bool WantsRecording(const RunOptions& options) {
  if (!options.record.empty()) return true;
  return !options.no_record && !options.headless && options.screenshot.empty();
}

std::string RecordRun(RunSession& session, const RunOptions& options, const sim::Scenario& scenario,
                      const sim::SimulationSettings& settings, record::Level level) {
  const bool is_usual = options.record.empty();
  const fs::path file = is_usual ? UsualFile() : options.record;
  if (file.empty()) return {};
  record::Header header =
      record::HeaderOf(scenario, settings, static_cast<double>(session.simulation().world().settings().step_s), level);
  header.scenario = options.scenario;
  for (const fs::path& folder : options.extra_folders) header.extra_folders.push_back(folder.string());
  record::WriterSettings writing;
  const double limit_mb = options.record_limit_mb.value_or(is_usual ? kUsualLimitMb : 0);
  writing.limit_bytes = static_cast<std::uint64_t>(limit_mb * 1e6);
  Result<std::unique_ptr<record::Writer>> writer = record::Writer::Create(file, header, writing);
  if (!writer) {
    Diagnostic problem = writer.error();
    if (is_usual) problem.severity = Severity::kWarning;
    std::cerr << Format(problem);
    return {};
  }
  session.Record(std::make_unique<record::Recorder>(std::move(*writer), level));
  return "recording to " + file.string();
}

}  // namespace soarbox::app
