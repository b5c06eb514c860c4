// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "sweep/rows.h"

namespace soarbox::sweep {

struct SweepSettings {
  int jobs = 0;  ///< Number of processes at a time; 0: one per processor.
  /// For one of several tasks: run only the missing runs whose number has this remainder.
  std::size_t task = 0, tasks = 1;
  bool retry = false;  ///< Try runs once more that crashed or hung three times.
};

/// Progress of a sweep.
struct Progress {
  std::size_t planned = 0, there_before = 0, done = 0, failed = 0;
  std::size_t left_out = 0;           ///< Runs whose remote kernel is not available.
  std::vector<std::string> problems;  ///< Errors of variants that were skipped.
};

/// Loads each variant that has no row yet, without running a tick. Fails with the errors of the first variant that
/// reports any: rules that cannot be read, files that are missing, scripts that stop.
Result<void> TryVariants(const Spec& spec, const Plan& plan, const std::filesystem::path& folder, int jobs);

/// Runs the missing runs, each in a separate process, and writes their rows. A run that crashes is tried three times in
/// total. Calls `goes_on` periodically; if that returns false, the sweep ends.
Result<Progress> RunSweep(const Spec& spec, const Plan& plan, const std::filesystem::path& folder,
                          const SweepSettings& settings, const std::function<bool(const Progress&)>& goes_on);

/// The rows of this plan, by variant and seed.
std::vector<Row> RowsOf(const Spec& spec, const Plan& plan, const std::filesystem::path& folder,
                        std::vector<Diagnostic>& problems);

}  // namespace soarbox::sweep
