// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>

#include "kernel/match/element_links.h"
#include "kernel/match/match_set.h"
#include "kernel/match/token_pool.h"

namespace soarbox::kernel {

/// Creates the tokens of a match without nodes: one per element. Returns the last token, which is the head of a list
/// that is linked through `next_in_bucket`. `key` and `mark` are stored in each token (`mark` in previous_in_bucket).
std::uint32_t MakeElementTokens(TokenPool& tokens, ElementLinks& links, std::span<const WmeId> elements,
                                std::uint32_t key, std::uint32_t mark);
/// Frees such a list.
void FreeElementTokens(TokenPool& tokens, ElementLinks& links, std::uint32_t first);

/// See Rete::AddFixedMatch.
MatchId AddFixedMatch(TokenPool& tokens, ElementLinks& links, MatchSet& matches, std::span<const WmeId> elements,
                      Symbol goal, GoalLevel level, InstantiationId instantiation);

}  // namespace soarbox::kernel
