// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mind/decision.h"

namespace sml {
class Agent;
}

namespace soarbox::explain {

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
  bool matches = false;  ///< The element stands in a whole match of the rule now.
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

/// A candidate that a decision would choose among, with the chance that exploration gives it.
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
  /// What the decision procedure says of these preferences now; none where that is not told. Nobody works it out again.
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
  std::size_t partial_matches = 0;  ///< That pass it (a negated one: are not blocked by it); 0 behind the failing one.
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
  std::vector<ElementFact> seen;                  ///< What stands where the condition looks, with other values.
};

struct MindFacts {
  std::string phase;  ///< That runs next: "input", "propose", "decide", "apply", "output"; empty if it is not told.
  bool within_phase = false;
  std::uint64_t decisions = 0, elaborations = 0, firings = 0;
  std::size_t elements = 0, rules = 0;
  bool halted = false;
  std::string breakdown;                ///< What used its memory up; empty if nothing did.
  std::string input_link, output_link;  ///< Identifiers; empty if there is none.
};

/// Looks into one agent's mind between two ticks: facts as plain values that belong to the caller. Reads only: no run
/// is different because somebody looked. Made by Simulation::Inspect; valid until the simulation's next tick.
///
/// Our own kernel in this process tells all. Others are asked in the Soar command language: what that does not tell
/// stays empty (TellsAll).
class Inspector {
 public:
  virtual ~Inspector() = default;

  virtual bool TellsAll() const = 0;
  virtual MindFacts Mind() = 0;
  /// From the top state down.
  virtual std::vector<StateFact> Stack() = 0;
  /// Elements of an identifier, by attribute; empty if there is no such identifier.
  virtual std::vector<ElementFact> ElementsOf(std::string_view id) = 0;
  /// Elements with this text in their attribute or value or as their identifier, by time tag; no more than `most`.
  virtual std::vector<ElementFact> Search(std::string_view text, std::size_t most) = 0;
  virtual std::optional<ElementFact> Element(std::uint64_t timetag) = 0;
  virtual std::vector<MakerFact> MakersOf(std::uint64_t timetag) = 0;
  virtual std::vector<TesterFact> TestersOf(std::uint64_t timetag) = 0;
  virtual OperatorFacts Operators(std::string_view state) = 0;
  /// In the order of loading.
  virtual std::vector<RuleFact> Rules() = 0;
  /// As `print` shows it; empty if there is none of this name.
  virtual std::string RuleSource(std::string_view rule) = 0;
  virtual std::optional<MatchFacts> Match(std::string_view rule) = 0;
  /// How the word that a command line ends with may go on.
  virtual std::vector<std::string> Complete(std::string_view line) = 0;
};

/// For an agent of any kernel; it must live longer.
std::unique_ptr<Inspector> MakeInspector(sml::Agent& agent);

}  // namespace soarbox::explain
