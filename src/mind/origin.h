// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mind/decision_facts.h"
#include "mind/inspection_facts.h"

namespace soarbox::mind {

constexpr std::uint32_t kNoOrigin = 0xFFFFFFFFu;

/// An element at the time when a rule matched it.
struct OriginElementFact {
  enum class Source : std::uint8_t { kRule, kInput, kArchitecture };

  ElementFact element;
  Source source = Source::kRule;
  std::uint32_t origin = kNoOrigin;  ///< Index of its own origin in OriginFacts::origins, if that was recorded.
};

/// What made an element, or which rules proposed an operator, as the kernel recorded it at that moment.
struct OriginFact {
  std::string rule;            ///< Empty for an operator.
  std::uint64_t decision = 0;  ///< The decision in which the rule fired or the operator was selected; 0 if it was not
                               ///< recorded.
  bool o_supported = false;
  bool is_operator = false;
  int level = 0;
  std::string state;                       ///< The state that the rule matched, or in which the operator was selected.
  std::string op, op_name;                 ///< The operator that was selected at that time; empty if none was.
  std::uint32_t op_origin = kNoOrigin;     ///< Index of the operator's origin.
  std::vector<OriginElementFact> matched;  ///< In the order of the rule's conditions.
  std::uint32_t left_out = 0;              ///< Number of further matched elements that are not listed.
  std::vector<std::uint32_t> proposals;    ///< For an operator: indices of the origins of its proposals.
  std::optional<Decision> decided;         ///< For an operator: why it was selected.
};

struct OriginFacts {
  bool noted = false;               ///< The kernel records origins. If not, nothing is known about the past.
  std::uint64_t timetag = 0;        ///< Time tag of the element; 0 if there is none.
  std::vector<OriginFact> origins;  ///< The origin of the element comes first; empty if it has none.
};

}  // namespace soarbox::mind
