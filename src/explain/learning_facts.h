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

/// The part of an Inspector that reports what a living mind has learned. Inspectors of living minds also implement it.
class LearningSource {
 public:
  virtual ~LearningSource() = default;

  virtual LearningFacts Learning() = 0;
  /// How rules were learned, oldest first; at most the last 1,000. They are recorded while decisions are observed
  /// (MindDetail). Conditions and firings are reduced to the conditions that name something; LearnedRule returns
  /// everything. Empty if the kernel does not report it.
  virtual std::vector<LearnedRuleFact> LearnedRules() { return {}; }
  /// Everything about how one rule was learned.
  virtual std::optional<LearnedRuleFact> LearnedRule(std::string_view rule) {
    (void)rule;
    return std::nullopt;
  }
};

}  // namespace soarbox::explain
