// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "mission/child_pool.h"
#include "sweep/rows.h"

namespace soarbox::sweep {

/// Runs a variant with a seed, for a child of a ChildPool. Returns what RowOf reads: metrics, then the result of the
/// run. `recording` names the file of the recording, if the sweep asks for one; empty: none.
std::string Work(const Spec& spec, const ReadyVariant& variant, std::uint64_t seed,
                 const std::filesystem::path& recording);

/// The row of a child that has ended.
Row RowOf(const Plan& plan, std::size_t variant, std::uint64_t seed, int tries, mission::ChildEnd end,
          const mission::ChildLimits& limits);

}  // namespace soarbox::sweep
