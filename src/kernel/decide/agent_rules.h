// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include "kernel/decide/rule_changes.h"

namespace soarbox::kernel {

struct AgentCore;

/// Adds and excises the rules of one agent. Keeps the agent's records, its directory and the data of learning
/// consistent with the match, and informs observers.
class AgentRules final : public RuleChanges {
 public:
  explicit AgentRules(AgentCore& core) : core_(core) {}

  ProductionId Find(std::string_view name) const override;
  Outcome Add(const ProductionPtr& rule) override;
  void NoteAdded(ProductionId production, const ProductionPtr& rule) override;
  void Excise(ProductionId production) override;
  void LeaveMatch(ProductionId production) override;

 private:
  AgentCore& core_;
};

}  // namespace soarbox::kernel
