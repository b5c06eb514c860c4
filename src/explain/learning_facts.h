// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mind/inspection_facts.h"

namespace soarbox::explain {

using mind::FiringFact;
using mind::LearnedRuleFact;
using mind::LearningFacts;
using mind::NumberFact;
using mind::TripleFact;

/// Reports what a mind has learned. Inspectors of running agents also implement this class, those of recorded minds do
/// not. Callers get it from an Inspector by dynamic_cast.
class LearningSource {
 public:
  virtual ~LearningSource() = default;

  virtual LearningFacts Learning() = 0;
  /// Returns how rules were learned, oldest first; at most the last 1,000. They are recorded while decisions are
  /// observed (MindDetail). Of each rule's conditions, only those on ^name are returned; its firings are left out.
  /// LearnedRule returns everything. Empty if the kernel does not report it.
  virtual std::vector<LearnedRuleFact> LearnedRules() { return {}; }
  /// Returns everything about how one rule was learned; nothing if there is no such rule, or if the kernel does not
  /// report it.
  virtual std::optional<LearnedRuleFact> LearnedRule(std::string_view rule) {
    (void)rule;
    return std::nullopt;
  }
};

}  // namespace soarbox::explain
