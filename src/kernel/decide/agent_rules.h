// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include "kernel/decide/rule_changes.h"

namespace soarbox::kernel {

struct Engine;

/// The rules of one agent as they come and go: keeps its records, its directory and what learning keeps of rules in
/// step with the match, and tells observers.
class AgentRules final : public RuleChanges {
 public:
  explicit AgentRules(Engine& engine) : engine_(engine) {}

  ProductionId Find(std::string_view name) const override;
  Outcome Add(const ProductionPtr& rule) override;
  void NoteAdded(ProductionId production, const ProductionPtr& rule) override;
  void Excise(ProductionId production) override;
  void LeaveMatch(ProductionId production) override;

 private:
  Engine& engine_;
};

}  // namespace soarbox::kernel
