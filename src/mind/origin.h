// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mind/decision.h"
#include "mind/facts.h"

namespace soarbox::mind {

constexpr std::uint32_t kNoOrigin = 0xFFFFFFFFu;

/// An element as it was when a rule matched it.
struct OriginElementFact {
  enum class Source : std::uint8_t { kRule, kInput, kArchitecture };

  ElementFact element;
  Source source = Source::kRule;
  std::uint32_t origin = kNoOrigin;  ///< Place in OriginFacts::origins of what made it, if that is noted.
};

/// What made an element, or who proposed an operator, as the kernel noted it at that moment.
struct OriginFact {
  std::string rule;            ///< Empty for an operator.
  std::uint64_t decision = 0;  ///< In which the rule fired or the operator was selected; 0: not noted.
  bool o_supported = false;
  bool is_operator = false;
  int level = 0;
  std::string state;                       ///< That the rule matched, or that the operator was selected in.
  std::string op, op_name;                 ///< The operator that was selected then; empty if none was.
  std::uint32_t op_origin = kNoOrigin;     ///< Place of its origin.
  std::vector<OriginElementFact> matched;  ///< In the order of the rule's conditions.
  std::uint32_t left_out = 0;              ///< How many more were matched.
  std::vector<std::uint32_t> proposals;    ///< Of an operator: places of the origins of its proposals.
  std::optional<Decision> decided;         ///< Of an operator: why it was selected.
};

struct OriginFacts {
  bool noted = false;               ///< The kernel notes origins. If not, nothing can be said of the past.
  std::uint64_t timetag = 0;        ///< Of the element; 0: there is none.
  std::vector<OriginFact> origins;  ///< The element's own first; empty if it has none.
};

}  // namespace soarbox::mind
