// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "Export.h"
#include "mind/decision.h"

namespace sml {
class Agent;
}

namespace soarbox {

/// A working memory element.
struct InspectedElement {
  std::uint64_t timetag = 0;
  std::string id, attribute, value;
  bool acceptable = false;
  bool is_object = false;  ///< The value is an identifier.
};

/// What put an element or a preference there.
struct InspectedMaker {
  enum class Kind : std::uint8_t { kRule, kInput, kArchitecture } kind = Kind::kRule;
  std::string rule;  ///< kRule only, as are the rest.
  bool o_supported = false;
  int level = 0;                           ///< Of the state for which the rule fired.
  std::vector<InspectedElement> elements;  ///< What the rule matched; empty if that match is over.
};

/// A rule with a condition that an element reaches: it has the constants that the condition asks for.
struct InspectedTester {
  std::string rule;
  std::size_t condition = 0;  ///< Counted from 0, in the order in which the rule matches.
  bool negated = false;
  bool matches = false;  ///< The element stands in a whole match of the rule now.
};

struct InspectedState {
  int level = 1;
  std::string id;
  std::string impasse, attribute;  ///< "tie" ("operator"); "none" for the top state.
  std::string operator_id, operator_name;
};

struct InspectedPreference {
  std::string type;  ///< "acceptable", "require", "reject", "prohibit", "best", "worst", "indifferent", "numeric", ...
  std::string sign;  ///< "+", ">", ...
  std::string value, name;           ///< The operator and its ^name.
  std::string referent, other_name;  ///< Of binary preferences: the other operator; of numeric ones: the number.
  InspectedMaker maker;
};

struct InspectedCandidate {
  std::string id, name;
  double value = 0;
  double probability = 0;
};

/// The operator slot of a state.
struct InspectedOperators {
  std::string state, selected;
  std::vector<InspectedPreference> preferences;
  std::vector<InspectedCandidate> candidates;  ///< Empty if the decision would be an impasse.
  std::string impasse;                         ///< Of the state below, "none" if there is none.
  mind::Decision decision;                     ///< What the decision procedure says of these preferences now.
};

struct InspectedRule {
  std::string name, type;  ///< "user", "default", "chunk", "justification", "template".
  std::string file;        ///< Empty for typed rules.
  int line = 0;
  std::string documentation;
  std::uint64_t firings = 0;
  std::size_t matches = 0;  ///< Whole matches now.
  bool breaks = false;      ///< Stops a run when it fires.
};

struct InspectedCondition {
  std::string text;
  bool negated = false;
  std::size_t partial_matches = 0;  ///< That pass it (a negated one: are not blocked by it); 0 behind the failing one.
};

/// How far a rule matches.
struct InspectedMatch {
  std::string rule;
  std::vector<InspectedCondition> conditions;
  std::optional<std::size_t> failing;                  ///< The first condition that nothing passes.
  std::size_t complete = 0;                            ///< Whole matches.
  std::vector<std::vector<InspectedElement>> matches;  ///< Some of them, oldest first.
  std::vector<std::vector<InspectedElement>> before;   ///< Some partial matches that reach the failing condition.
  std::vector<InspectedElement> candidates;            ///< Elements that pass its constant tests but do not join.
  std::vector<InspectedElement> seen;                  ///< What stands where the condition looks, with other values.
};

struct InspectedMind {
  std::string phase;  ///< That runs next: "input", "propose", "decide", "apply", "output".
  bool within_phase = false;
  std::uint64_t decisions = 0, elaborations = 0, firings = 0;
  std::size_t elements = 0, rules = 0;
  bool halted = false;
  std::string breakdown;  ///< What used its memory up; empty if nothing did.
  std::string input_link, output_link;
};

/// What reinforcement learning made of a rule's number: the sum of what it expects at once and of what follows.
struct InspectedNumber {
  std::string rule;
  double value = 0, current = 0, future = 0;
  std::uint64_t updates = 0;
};

struct InspectedLearning {
  bool by_reward = false;  ///< Switched on.
  double last_reward = 0;  ///< Of the last decision that collected any.
  double total_reward = 0;
  std::vector<InspectedNumber> numbers;  ///< Of each rule that can learn, in the order of loading.
};

/// A condition or an action of a learned rule or of a firing behind it.
struct InspectedTriple {
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
struct InspectedFiring {
  std::uint32_t serial = 0;
  std::string rule;
  int level = 0;
  bool made_result = false;
  std::vector<InspectedTriple> conditions, actions;
};

/// How a rule was learned.
struct InspectedLesson {
  std::string rule;
  std::uint64_t decision = 0;
  int level = 0;                                  ///< Of the substate.
  std::string state, superstate;                  ///< The substate, and the state above it: "S2", "S1".
  std::string impasse, attribute, operator_name;  ///< "no-change", "operator", and the name of what was selected above.
  std::uint32_t base = 0;                         ///< The firing whose results it gives.
  std::vector<InspectedTriple> conditions, actions;
  std::vector<InspectedFiring> firings;
  bool local_negation = false, long_term_memory = false, repaired = false;
};

/// An object of semantic memory.
struct InspectedObject {
  std::uint64_t number = 0;
  std::string text;  ///< Its augmentations: "^kind ammo ^site @3".
  double activation = 0;
  std::uint64_t uses = 0;
};

/// What stood in working memory when an episode was taken: an element of an object.
struct InspectedMemory {
  std::uint32_t object = 0;  ///< 0: the top state.
  std::string attribute, value;
  bool is_object = false;
  std::uint32_t value_object = 0;
};

struct InspectedLongTerm {
  bool semantic = false, episodic = false;  ///< Switched on.
  std::size_t objects = 0, augmentations = 0;
  std::vector<InspectedObject> known;  ///< The most active first; no more than were asked for.
  std::size_t episodes = 0;
  std::vector<std::uint64_t> decisions;  ///< By episode, from 1: in which it was taken; 0: in an earlier run.
};

/// Looks into the mind of a client's agent between its runs. What Soarbox's own kernel tells besides the client API:
/// values, not texts to be taken apart. Reads only; what it returns belongs to the caller. Used on the thread that runs
/// the agent, never in the middle of its cycle. Must end before the agent does.
class EXPORT MindInspection {
 public:
  virtual ~MindInspection() = default;

  virtual InspectedMind Mind() = 0;
  virtual std::vector<InspectedState> Stack() = 0;
  /// Elements of an identifier, by attribute; empty if there is no such identifier.
  virtual std::vector<InspectedElement> ElementsOf(std::string_view id) = 0;
  /// Elements with this text in their attribute or value or as their identifier, by time tag; no more than `most`.
  virtual std::vector<InspectedElement> Search(std::string_view text, std::size_t most) = 0;
  virtual std::optional<InspectedElement> Element(std::uint64_t timetag) = 0;
  virtual std::vector<InspectedMaker> MakersOf(std::uint64_t timetag) = 0;
  virtual std::vector<InspectedTester> TestersOf(std::uint64_t timetag) = 0;
  /// Empty texts if there is no such state.
  virtual InspectedOperators Operators(std::string_view state) = 0;
  /// In the order of loading.
  virtual std::vector<InspectedRule> Rules() = 0;
  /// As `print` shows it; empty if there is none of this name.
  virtual std::string RuleSource(std::string_view rule) = 0;
  virtual std::optional<InspectedMatch> Match(std::string_view rule) = 0;
  virtual InspectedLearning Learning() = 0;
  /// How rules were learned while somebody observed the mind (soarbox_Observation.h): the last 1,000, in their order,
  /// or that of this rule alone. `whole`: with conditions, actions and firings.
  virtual std::vector<InspectedLesson> Lessons(bool whole, std::string_view rule) = 0;
  /// Known objects with this text in their number or augmentations, no more than `most`.
  virtual InspectedLongTerm LongTerm(std::size_t most, std::string_view text) = 0;
  /// The contents of an episode, objects before what hangs on them; empty if there is no such episode.
  virtual std::vector<InspectedMemory> Episode(std::size_t number) = 0;
  /// How the word that a command line ends with may go on.
  virtual std::vector<std::string> Complete(std::string_view line) = 0;
};

/// Null if the agent's kernel is in another process: then only the client API tells what there is.
std::unique_ptr<MindInspection> EXPORT InspectMind(sml::Agent& agent);

/// What the decision procedure says of a state's operators now; also of an agent whose kernel is in another process, if
/// that is Soarbox's own. None if it is not. Empty if there is no such state, or no preference.
std::optional<mind::Decision> EXPORT AskDecision(sml::Agent& agent, std::string_view state);

}  // namespace soarbox
