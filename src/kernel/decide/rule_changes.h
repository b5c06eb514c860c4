// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "kernel/base/ids.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// What learning needs from an agent's rules: each new rule is registered by name, reported and counted, wherever it
/// comes from. AgentRules implements it.
class RuleChanges {
 public:
  virtual ~RuleChanges() = default;

  /// The live rule of this name, or kNone.
  virtual ProductionId Find(std::string_view name) const = 0;
  struct Outcome {
    ProductionId production = ProductionId::kNone;  ///< The rule, or the one that it duplicates.
    bool loaded = false;
  };
  /// Adds a rule that a template makes and matches it, in place of one of its name. Throws std::bad_alloc if that broke
  /// the agent down.
  virtual Outcome Add(const ProductionPtr& rule) = 0;
  /// Call it after a rule has been put into the match.
  virtual void NoteAdded(ProductionId production, const ProductionPtr& rule) = 0;
  virtual void Excise(ProductionId production) = 0;
  /// Takes a production out of the match when the elaboration is over, so that no firing loses its rule.
  virtual void LeaveMatch(ProductionId production) = 0;
};

}  // namespace soarbox::kernel
