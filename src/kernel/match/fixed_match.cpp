// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/fixed_match.h"

namespace soarbox::kernel {

std::uint32_t MakeElementTokens(TokenPool& tokens, ElementLinks& links, std::span<const WmeId> elements,
                                std::uint32_t key, std::uint32_t mark) {
  std::uint32_t first = kNil;
  for (const WmeId wme : elements) {
    const std::uint32_t token = tokens.Make(links, Token::kFixedMatchNode, kNil, Index(wme));
    tokens[token].key = key;
    tokens[token].previous_in_bucket = mark;
    tokens[token].next_in_bucket = first;
    first = token;
  }
  return first;
}

void FreeElementTokens(TokenPool& tokens, ElementLinks& links, std::uint32_t first) {
  for (std::uint32_t token = first; token != kNil;) {
    const std::uint32_t next = tokens[token].next_in_bucket;
    tokens.Unlink(links, token);
    tokens.Free(token);
    token = next;
  }
}

MatchId AddFixedMatch(TokenPool& tokens, ElementLinks& links, MatchSet& matches, std::span<const WmeId> elements,
                      Symbol goal, GoalLevel level, InstantiationId instantiation) {
  MatchSet::Arrival arrival;
  arrival.production = kNil;
  arrival.elements = elements;
  arrival.goal = goal;
  arrival.level = level;
  arrival.token = MakeElementTokens(tokens, links, elements, 0, kNil);
  const MatchId match = matches.AddFired(arrival, instantiation);
  for (std::uint32_t token = arrival.token; token != kNil; token = tokens[token].next_in_bucket) {
    tokens[token].key = Index(match);
  }
  return match;
}

}  // namespace soarbox::kernel
