// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sweep/rows.h"

namespace soarbox::sweep {

/// The result of repeating runs.
struct Verification {
  std::size_t made = 0, all = 0;       ///< Number of repeated runs, and number of good rows.
  std::vector<std::string> differing;  ///< "variant 'bold', seed 7: ...".
  std::size_t unmatched = 0;           ///< Rows that match no variant and seed of the folder as it is now.
  std::string other_build;             ///< The build of the rows, if it differs from this one.
};

/// Repeats a sample of the runs of a sweep's folder with the files in the folder, and compares state hashes and
/// metrics. The sample is distributed evenly over all rows, so the same folder gives the same sample; `most` = 0: all
/// rows. Skips rows of crashed and hung runs, and of variants with a remote kernel. Calls `goes_on` periodically; if
/// that returns false, it ends.
Result<Verification> VerifySweep(const std::filesystem::path& folder, const sim::DataFolders& data, std::size_t most,
                                 int jobs, const std::function<bool()>& goes_on);

}  // namespace soarbox::sweep
