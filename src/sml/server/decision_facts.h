// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/agent.h"
#include "kernel/decide/decision_trace.h"
#include "mind/decision.h"
#include "sml/server/printed_names.h"

namespace soarbox::server {

/// Turns what the decision procedure says, in handles of the kernel, into facts: the only place where that is done.
/// Keeps its memory from decision to decision.
class DecisionReader {
 public:
  /// Valid until the next call, and as long as the rules are there.
  const mind::DecisionView& Read(const kernel::Agent& agent, const kernel::DecisionReport& report);
  /// The same for an operator of the last decision that was read; null if the decision does not mention it.
  const mind::DecisionView::Operator* Find(kernel::Symbol op) const;

 private:
  std::uint32_t PlaceOf(const kernel::Agent& agent, kernel::Symbol op);
  std::string_view Keep(std::string_view text);

  mind::DecisionView decision_;
  std::vector<kernel::Symbol> operators_;  ///< By place.
  std::deque<std::string> texts_;          ///< The first used_ of them.
  std::size_t used_ = 0;
  PrintedNames names_;
};

/// What the procedure says of a state's operators now. Empty if there is no such state, or nothing speaks of operators.
mind::Decision DecisionNow(const kernel::Agent& agent, std::string_view state);

}  // namespace soarbox::server
