// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "mission/child_pool.h"
#include "sweep/rows.h"

namespace soarbox::sweep {

/// Runs a variant with a seed in a child of a ChildPool. Returns the input of RowOf: metrics, then the result of the
/// run. `recording`: file for the recording if the sweep requests one; empty: none.
std::string Work(const Spec& spec, const ReadyVariant& variant, std::uint64_t seed,
                 const std::filesystem::path& recording);

/// Converts the output of a child to a row.
Row RowOf(const Plan& plan, std::size_t variant, std::uint64_t seed, int tries, mission::ChildEnd end,
          const mission::ChildLimits& limits);

}  // namespace soarbox::sweep
