// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "kernel/base/symbol_table.h"
#include "kernel/match/rete.h"
#include "kernel/match/wme.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// All matches of a rule, as time tags in condition order, found by backtracking over all elements. It is the reference
/// for the Rete, with which it shares no code. For tests only.
std::multiset<std::vector<std::uint64_t>> MatchNaively(const Production& rule, const SymbolTable& symbols,
                                                       const WmeTable& wmes, std::span<const WmeId> live,
                                                       const GoalView& goals);

}  // namespace soarbox::kernel
