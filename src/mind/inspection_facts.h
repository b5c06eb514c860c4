// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mind/decision_facts.h"

/// What an inspection of a mind between two ticks returns. The types are the same for our own kernel
/// (soarbox_Inspection.h), for the answers of any kernel to commands, and for recordings.

namespace soarbox::mind {

/// A working memory element.
struct ElementFact {
  std::uint64_t timetag = 0;
  std::string id, attribute, value;
  bool acceptable = false;
  bool is_object = false;  ///< The value is an identifier.
  friend bool operator==(const ElementFact&, const ElementFact&) = default;
};

/// What made an element or a preference.
struct MakerFact {
  enum class Kind : std::uint8_t { kRule, kInput, kArchitecture } kind = Kind::kRule;
  std::string rule;  ///< For kRule, as all following members.
  bool o_supported = false;
  int level = 0;                      ///< Level of the state for which the rule fired.
  std::vector<ElementFact> elements;  ///< The elements that the rule matched; empty if it no longer matches.
};

/// A rule with a condition whose constants an element satisfies.
struct TesterFact {
  std::string rule;
  std::size_t condition = 0;  ///< Index in the order in which the rule matches, from 0.
  bool negated = false;
  bool matches = false;  ///< The element is part of a complete match of the rule now.
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
  std::string referent, other_name;  ///< For binary preferences: the other operator; for numeric ones: the number.
  MakerFact maker;
};

/// A candidate among which a decision would select, with its probability.
struct CandidateFact {
  std::string id, name;
  double value = 0;
  double probability = 0;  ///< 0 to 1.
};

/// The operators of a state and their preferences.
struct OperatorFacts {
  std::string state;     ///< Empty if there is no such state.
  std::string selected;  ///< Its identifier; empty if none is selected.
  std::vector<PreferenceFact> preferences;
  std::vector<CandidateFact> candidates;  ///< Empty if the decision would lead to an impasse.
  std::string impasse;                    ///< The impasse to which this state led; "none" if there is none.
  /// The recorded decision about these preferences; nothing if the kernel does not report it. It is never recomputed.
  std::optional<mind::Decision> decision;
};

struct RuleFact {
  std::string name;
  std::string type;  ///< "user", "default", "chunk", "justification", "template".
  std::string file;  ///< Empty for rules that were typed.
  int line = 0;
  std::string documentation;
  std::uint64_t firings = 0;
  std::size_t matches = 0;  ///< Number of complete matches now.
  bool breaks = false;      ///< `production break` is on.
};

struct ConditionFact {
  std::string text;
  bool negated = false;
  std::size_t partial_matches = 0;  ///< Number of partial matches up to this condition (negated: that it does not
                                    ///< block); 0 after the failing one.
};

/// How many conditions of a rule match.
struct MatchFacts {
  std::string rule;
  std::vector<ConditionFact> conditions;
  std::optional<std::size_t> failing;             ///< Index of the first condition without a partial match, from 0.
  std::size_t complete = 0;                       ///< Number of complete matches.
  std::vector<std::vector<ElementFact>> matches;  ///< Some of the complete matches, oldest first.
  std::vector<std::vector<ElementFact>> before;   ///< Some partial matches that end before the failing condition.
  std::vector<ElementFact> candidates;            ///< Elements that pass its constant tests but do not join with these
                                                  ///< matches.
  std::vector<ElementFact> seen;                  ///< Elements with the condition's identifier and attribute, but other
                                                  ///< values.
};

struct MindFacts {
  std::string phase;  ///< The next phase: "input", "propose", "decide", "apply", "output"; empty if it is not reported.
  bool within_phase = false;
  std::uint64_t decisions = 0, elaborations = 0, firings = 0;
  std::size_t elements = 0, rules = 0;
  bool halted = false;
  std::string breakdown;                ///< If the mind ran out of memory: what used it.
  std::string input_link, output_link;  ///< Identifiers; empty if there is none.
};

/// The value of a rule that learns by reward: the expected immediate reward (`current`) and the expected later reward
/// (`future`).
struct NumberFact {
  std::string rule;
  std::string when;  ///< Constants that the rule tests: "^name move ^row 3".
  double value = 0, current = 0, future = 0;
  std::uint64_t updates = 0;
};

struct LearningFacts {
  bool by_reward = false;  ///< Reinforcement learning is on.
  double last_reward = 0;  ///< Reward of the last decision that collected any.
  double total_reward = 0;
  std::vector<NumberFact> numbers;  ///< One for each rule that can learn, in the order of loading.
};

/// A condition or an action of a learned rule or of a firing that led to it.
struct TripleFact {
  std::string id, attribute, value;  ///< As written in the rule: <s>, operator, { <n> > 5 }.
  std::string referent;              ///< For actions: the other operator, or the number.
  std::string sign;                  ///< For operator preferences: "+", ">", "="; for conditions: "+" if acceptable.
  std::string met;                   ///< The matched element: "S1 ^operator O3"; empty for negated conditions.
  bool negated = false;              ///< For a condition that is negated: `id` contains its entire text.
  bool above = false;                ///< For a condition of a firing: it tested an element of a higher state.
  std::uint32_t creator = 0;         ///< For a condition of a firing: the firing that made the tested element; 0 if
                                     ///< none of these did.
  std::vector<std::uint32_t> path;   ///< For a condition of the learned rule: firings from the one that tested it to
                                     ///< one that made a result.
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
struct LearnedRuleFact {
  std::string rule;
  std::uint64_t decision = 0;
  int level = 0;                                  ///< Level of the substate.
  std::string state, superstate;                  ///< The substate, and the state above it: "S2", "S1".
  std::string impasse, attribute, operator_name;  ///< "no-change", "operator", and the operator that was selected in
                                                  ///< the superstate.
  std::uint32_t base = 0;                         ///< The firing whose results the rule produces.
  std::vector<TripleFact> conditions, actions;
  std::vector<FiringFact> firings;
  bool local_negation = false, long_term_memory = false, repaired = false;
};

/// An object of semantic memory.
struct KnownObjectFact {
  std::uint64_t number = 0;  ///< 12 of @12.
  std::string text;          ///< Its augmentations: "^kind ammo ^site @3".
  double activation = 0;
  std::uint64_t uses = 0;  ///< Number of recalls.
};

/// An element of working memory as it is stored in an episode.
struct RememberedFact {
  std::uint32_t object = 0;  ///< Number of its object; 0: the top state.
  std::string attribute, value;
  bool is_object = false;          ///< `value` is then empty.
  std::uint32_t value_object = 0;  ///< The object that is the value, if is_object.
};

/// The contents of an agent's semantic and episodic memory.
struct LongTermFacts {
  bool semantic = false, episodic = false;  ///< Whether these memories are on.
  std::size_t objects = 0, augmentations = 0;
  std::vector<KnownObjectFact> known;  ///< The most active first; at most the requested number.
  std::size_t episodes = 0;
  std::vector<std::uint64_t> decisions;  ///< By episode, from 1: in which it was taken; 0: in an earlier run.
  std::vector<std::size_t> changed;      ///< The first episode, and those that differ from the one before; ascending.
};

}  // namespace soarbox::mind
