// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mind/facts.h"

namespace soarbox::explain {

using mind::FiringFact;
using mind::LearningFacts;
using mind::LessonFact;
using mind::NumberFact;
using mind::TripleFact;

/// What inspectors of living minds also are, see Inspector.
class LearningSource {
 public:
  virtual ~LearningSource() = default;

  virtual LearningFacts Learning() = 0;
  /// How rules were learned since decisions are noted (MindDetail): the last 1,000, in their order. Of their conditions
  /// and firings, only conditions that name something; Lesson gives everything. Empty where no kernel reports it.
  virtual std::vector<LessonFact> Lessons() { return {}; }
  /// All of one of them.
  virtual std::optional<LessonFact> Lesson(std::string_view rule) {
    (void)rule;
    return std::nullopt;
  }
};

}  // namespace soarbox::explain
