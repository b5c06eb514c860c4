// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "kernel/base/ids.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// The interface through which learning adds and excises rules. Every new rule is registered by name, reported and
/// counted, wherever it comes from. AgentRules implements it.
class RuleChanges {
 public:
  virtual ~RuleChanges() = default;

  /// The live rule of this name, or kNone.
  virtual ProductionId Find(std::string_view name) const = 0;
  struct Outcome {
    ProductionId production = ProductionId::kNone;  ///< The new rule, or the one that it duplicates.
    bool loaded = false;
  };
  /// Adds and matches a rule that a template generated; replaces a rule of the same name. Throws std::bad_alloc if the
  /// agent broke down.
  virtual Outcome Add(const ProductionPtr& rule) = 0;
  /// Must be called after a rule has been added to the match.
  virtual void NoteAdded(ProductionId production, const ProductionPtr& rule) = 0;
  virtual void Excise(ProductionId production) = 0;
  /// Removes a production from the match at the end of the elaboration, so that no firing loses its rule.
  virtual void LeaveMatch(ProductionId production) = 0;
};

}  // namespace soarbox::kernel
