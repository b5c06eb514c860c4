// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mind/decision.h"

/// What you see when you look into a mind between two ticks: plain values, the same from our own kernel
/// (soarbox_Inspection.h), from the answers of any kernel to commands, and from a recording.

namespace soarbox::mind {

/// A working memory element.
struct ElementFact {
  std::uint64_t timetag = 0;
  std::string id, attribute, value;
  bool acceptable = false;
  bool is_object = false;  ///< The value is an identifier.
  friend bool operator==(const ElementFact&, const ElementFact&) = default;
};

/// What put an element or a preference there.
struct MakerFact {
  enum class Kind : std::uint8_t { kRule, kInput, kArchitecture } kind = Kind::kRule;
  std::string rule;  ///< kRule only, as are the rest.
  bool o_supported = false;
  int level = 0;                      ///< Of the state for which the rule fired.
  std::vector<ElementFact> elements;  ///< What the rule matched; empty if that match is over.
};

/// A rule with a condition that an element reaches: it has the constants that the condition asks for.
struct TesterFact {
  std::string rule;
  std::size_t condition = 0;  ///< Counted from 0, in the order in which the rule matches.
  bool negated = false;
  bool matches = false;  ///< The element is in a whole match of the rule now.
};

struct StateFact {
  int level = 1;
  std::string id;
  std::string impasse;    ///< "tie", "conflict", "constraint-failure", "no-change"; "none" for the top state.
  std::string attribute;  ///< "operator" or "state"; empty for the top state.
  std::string operator_id, operator_name;  ///< Selected in it; empty if none is.
};

struct PreferenceFact {
  std::string type;         ///< "acceptable", "require", "reject", "prohibit", "best", "worst", "better", "worse",
                            ///< "indifferent", "numeric", "equal" (indifferent to another operator).
  std::string sign;         ///< "+", "!", ">", ...
  std::string value, name;  ///< The operator and its ^name.
  std::string referent, other_name;  ///< Of binary preferences: the other operator; of numeric ones: the number.
  MakerFact maker;
};

/// A candidate among which a decision would select, with the chance that exploration gives it.
struct CandidateFact {
  std::string id, name;
  double value = 0;
  double probability = 0;  ///< 0 to 1.
};

/// The operator slot of a state.
struct OperatorFacts {
  std::string state;     ///< Empty if there is no such state.
  std::string selected;  ///< Identifier; empty if none is.
  std::vector<PreferenceFact> preferences;
  std::vector<CandidateFact> candidates;  ///< Empty if the decision would be an impasse.
  std::string impasse;                    ///< Of the state below; "none" if there is none.
  /// What the decision procedure says of these preferences now; none if that is not reported. Nobody works it out
  /// again.
  std::optional<mind::Decision> decision;
};

struct RuleFact {
  std::string name;
  std::string type;  ///< "user", "default", "chunk", "justification", "template".
  std::string file;  ///< Empty for typed rules.
  int line = 0;
  std::string documentation;
  std::uint64_t firings = 0;
  std::size_t matches = 0;  ///< Whole matches now.
  bool breaks = false;      ///< `production break` is on.
};

struct ConditionFact {
  std::string text;
  bool negated = false;
  std::size_t partial_matches = 0;  ///< How many pass it (negated: are not blocked by it); 0 after the failing one.
};

/// How far a rule matches.
struct MatchFacts {
  std::string rule;
  std::vector<ConditionFact> conditions;
  std::optional<std::size_t> failing;             ///< The first condition that nothing passes, counted from 0.
  std::size_t complete = 0;                       ///< Whole matches.
  std::vector<std::vector<ElementFact>> matches;  ///< Some of them, oldest first.
  std::vector<std::vector<ElementFact>> before;   ///< Some partial matches that reach the failing condition.
  std::vector<ElementFact> candidates;            ///< Elements that pass its constant tests but do not join.
  std::vector<ElementFact> seen;                  ///< What is where the condition looks, with other values.
};

struct MindFacts {
  std::string phase;  ///< The next one: "input", "propose", "decide", "apply", "output"; empty if not reported.
  bool within_phase = false;
  std::uint64_t decisions = 0, elaborations = 0, firings = 0;
  std::size_t elements = 0, rules = 0;
  bool halted = false;
  std::string breakdown;                ///< What used its memory up; empty if nothing did.
  std::string input_link, output_link;  ///< Identifiers; empty if there is none.
};

/// The number of a rule that learns by reward: what it expects at once (`current`) and of what follows (`future`).
struct NumberFact {
  std::string rule;
  std::string when;  ///< Constants that the rule tests: "^name move ^row 3".
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

/// An object of semantic memory.
struct KnownObjectFact {
  std::uint64_t number = 0;  ///< 12 of @12.
  std::string text;          ///< Its augmentations: "^kind ammo ^site @3".
  double activation = 0;
  std::uint64_t uses = 0;  ///< How often it was recalled.
};

/// What was in working memory when an episode was taken: an element of an object.
struct RememberedFact {
  std::uint32_t object = 0;  ///< 0: the top state.
  std::string attribute, value;
  bool is_object = false;          ///< Then `value` is empty.
  std::uint32_t value_object = 0;  ///< If so.
};

/// What an agent has in semantic and episodic memory.
struct LongTermFacts {
  bool semantic = false, episodic = false;  ///< Switched on.
  std::size_t objects = 0, augmentations = 0;
  std::vector<KnownObjectFact> known;  ///< The most active first; no more than were asked for.
  std::size_t episodes = 0;
  std::vector<std::uint64_t> decisions;  ///< By episode, from 1: in which it was taken; 0: in an earlier run.
  std::vector<std::size_t> changed;      ///< The first episode, and those that differ from the one before; ascending.
};

}  // namespace soarbox::mind
