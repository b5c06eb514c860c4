// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/agent.h"
#include "kernel/decide/decision_trace.h"
#include "mind/decision_facts.h"
#include "sml/server/printed_names.h"

namespace soarbox::server {

/// Converts the outcome of the decision procedure from handles of the kernel to values of mind/. This is the only place
/// that does so. Reuses its memory.
class DecisionReader {
 public:
  /// Valid until the next call, and only while the rules exist.
  const mind::DecisionView& Read(const kernel::Agent& agent, const kernel::DecisionReport& report);
  /// The operator in the last decision that was read; null if the decision does not contain it.
  const mind::DecisionView::Operator* Find(kernel::Symbol op) const;

 private:
  std::uint32_t PlaceOf(const kernel::Agent& agent, kernel::Symbol op);
  std::string_view Keep(std::string_view text);

  mind::DecisionView decision_;
  std::vector<kernel::Symbol> operators_;  ///< By index.
  std::deque<std::string> texts_;          ///< Only the first used_ are in use.
  std::size_t used_ = 0;
  PrintedNames names_;
};

/// The current decision on a state's operators. Empty if there is no such state, or no preference for operators.
mind::Decision DecisionNow(const kernel::Agent& agent, std::string_view state);

}  // namespace soarbox::server
