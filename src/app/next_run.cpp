// SPDX-License-Identifier: BSD-2-Clause
#include "app/next_run.h"

#include <filesystem>
#include <utility>

#include "app/data_folders.h"
#include "record/reader.h"
#include "sim/scenario.h"

namespace soarbox::app {
namespace {

std::optional<NextRun>& Kept() {
  static std::optional<NextRun> kept;
  return kept;
}

}  // namespace

Result<NextRun> FindNextRun(const std::string& what) {
  NextRun next{what, false, 0, {}};
  std::error_code error;
  if (what.ends_with(".soarrec") ||
      (std::filesystem::is_regular_file(what, error) && record::Reader::Open(what).ok())) {
    const auto opened = record::Reader::Open(what);
    if (!opened) return opened.error();
    next.is_recording = true;
    return next;
  }
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return data.error();
  const Result<sim::Scenario> scenario = sim::FindScenario(what, *data);
  if (!scenario) return scenario.error();
  return next;
}

void KeepNextRun(NextRun next) {
  Kept() = std::move(next);
}

std::optional<NextRun> TakeNextRun() {
  return std::exchange(Kept(), std::nullopt);
}

}  // namespace soarbox::app
