// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::explain {

/// The number of a rule that learns by reward: what it expects at once (`current`) and of what follows (`future`).
struct NumberFact {
  std::string rule;
  double value = 0, current = 0, future = 0;
  std::uint64_t updates = 0;
};

struct LearningFacts {
  bool by_reward = false;  ///< Switched on.
  double last_reward = 0;  ///< Of the last decision that collected any.
  double total_reward = 0;
  std::vector<NumberFact> numbers;  ///< Of each rule that can learn, in the order of loading.
};

/// A condition or an action of a learned rule or of a firing behind it.
struct TripleFact {
  std::string id, attribute, value;  ///< As the rule has them: <s>, operator, { <n> > 5 }.
  std::string referent;              ///< Of actions: the other operator, or the number.
  std::string sign;                  ///< Of preferences for operators: "+", ">", "="; of conditions "+" if acceptable.
  std::string met;                   ///< What it was: "S1 ^operator O3"; empty for negated conditions.
  bool negated = false;              ///< A condition: `id` is all of it.
  bool above = false;                ///< A firing's condition: it tested something of a higher state.
  std::uint32_t creator = 0;         ///< A firing's condition: the firing that made what it tested; 0: none of these.
  std::vector<std::uint32_t> path;   ///< A learned condition: firings from the one that tested it to one with a result.
};

/// A rule that fired in the substate from which a rule was learned.
struct FiringFact {
  std::uint32_t serial = 0;
  std::string rule;
  int level = 0;
  bool made_result = false;
  std::vector<TripleFact> conditions, actions;
};

/// How a rule was learned.
struct LessonFact {
  std::string rule;
  std::uint64_t decision = 0;
  int level = 0;                                  ///< Of the substate.
  std::string state, superstate;                  ///< The substate, and the state above it: "S2", "S1".
  std::string impasse, attribute, operator_name;  ///< "no-change", "operator", and what was selected above.
  std::uint32_t base = 0;                         ///< The firing whose results it gives.
  std::vector<TripleFact> conditions, actions;
  std::vector<FiringFact> firings;
  bool local_negation = false, long_term_memory = false, repaired = false;
};

/// What inspectors of living minds are besides, see Inspector.
class LearningSource {
 public:
  virtual ~LearningSource() = default;

  virtual LearningFacts Learning() = 0;
  /// How rules were learned since decisions are noted (MindDetail): the last 1,000, in their order. Of their conditions
  /// and firings only conditions that name something; Lesson tells all. Empty where no kernel tells.
  virtual std::vector<LessonFact> Lessons() { return {}; }
  /// All of one of them.
  virtual std::optional<LessonFact> Lesson(std::string_view rule) {
    (void)rule;
    return std::nullopt;
  }
};

}  // namespace soarbox::explain
