// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "mind/decision_facts.h"

namespace soarbox::mind {

/// The position of the operators' texts in the bytes of a decision. No other bytes depend on these texts.
struct PackedOperators {
  std::size_t begin = 0, end = 0;
};

/// Appends a Decision or a DecisionView as bytes. It is fast, because it runs while a mind decides.
template <typename Text>
PackedOperators Pack(const DecisionOf<Text>& decision, std::string& bytes);

/// Reads the output of Pack. Returns nothing if the bytes are invalid. All indices in the result are within bounds.
std::optional<Decision> Unpack(std::string_view bytes);

/// A copy that owns its texts.
Decision Owned(const DecisionView& decision);

}  // namespace soarbox::mind
