// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "mind/decision.h"

namespace soarbox::mind {

/// Where the operators' texts stand in the bytes of a decision. Before and after them nothing depends on these texts.
struct PackedOperators {
  std::size_t begin = 0, end = 0;
};

/// Appends a decision as bytes, quick to make while a mind runs. Of a Decision or a DecisionView.
template <typename Text>
PackedOperators Pack(const DecisionOf<Text>& decision, std::string& bytes);

/// Reads what Pack wrote. Nothing if the bytes are anything else: every place that they name is within bounds.
std::optional<Decision> Unpack(std::string_view bytes);

/// The same with texts of its own.
Decision Owned(const DecisionView& decision);

}  // namespace soarbox::mind
