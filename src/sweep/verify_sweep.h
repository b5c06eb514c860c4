// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sweep/rows.h"

namespace soarbox::sweep {

/// What became of runs that were made again.
struct Verification {
  std::size_t made = 0, all = 0;       ///< How many of how many good rows.
  std::vector<std::string> differing;  ///< "variant 'bold', seed 7: ...".
  std::size_t unmatched = 0;           ///< Rows that belong to no variant and seed of the folder as it is now.
  std::string other_build;             ///< The build of the rows, if it is not this one.
};

/// Makes a sample of the runs of a sweep's folder again, from the files that the folder holds, and compares state
/// hashes and metrics. The sample is spread evenly over all rows, so the same folder gives the same sample; `most` = 0:
/// all rows. Rows of crashed and hung runs, and of variants with a kernel elsewhere, are left out. It asks `goes_on`
/// now and then.
Result<Verification> VerifySweep(const std::filesystem::path& folder, const sim::DataFolders& data, std::size_t most,
                                 int jobs, const std::function<bool()>& goes_on);

}  // namespace soarbox::sweep
