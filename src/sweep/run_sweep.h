// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "sweep/rows.h"

namespace soarbox::sweep {

struct SweepSettings {
  int jobs = 0;  ///< Processes at a time; 0: one per processor.
  /// Of all missing runs, only those whose number leaves this remainder: one task of many.
  std::size_t task = 0, tasks = 1;
  bool retry = false;  ///< Runs that crashed or hung three times are tried once more.
};

/// What there is to do and what is done.
struct Progress {
  std::size_t planned = 0, there_before = 0, done = 0, failed = 0;
  std::size_t left_out = 0;           ///< Runs whose kernel is not there.
  std::vector<std::string> problems;  ///< What is wrong with variants that were left out.
};

/// Loads each variant that has no row yet, without a tick. Fails with the errors of the first variant that reports
/// some: rules that cannot be read, files that are missing, scripts that stop.
Result<void> TryVariants(const Spec& spec, const Plan& plan, const std::filesystem::path& folder, int jobs);

/// Makes the runs that no part holds yet, each in a process of its own, and adds them to a part. A run that crashes is
/// tried three times in all. It asks `goes_on` now and then.
Result<Progress> RunSweep(const Spec& spec, const Plan& plan, const std::filesystem::path& folder,
                          const SweepSettings& settings, const std::function<bool(const Progress&)>& goes_on);

/// The rows that belong to this plan, by variant and seed.
std::vector<Row> RowsOf(const Spec& spec, const Plan& plan, const std::filesystem::path& folder,
                        std::vector<Diagnostic>& problems);

}  // namespace soarbox::sweep
