// SPDX-License-Identifier: BSD-2-Clause
// Slips in the use of Soar: operators, links, values that accumulate, paths to different objects.
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "diagnostics/diagnostic.h"
#include "explain/mind_view.h"
#include "explain/rule_makers.h"
#include "explain/rule_slips.h"
#include "explain/slip_words.h"

namespace soarbox::explain {
namespace {

bool IsRemoval(const RuleAttribute& action) {
  return action.removes;
}

/// The constant in a value, without bars and preference; empty if it is not a single constant.
std::string ConstantOf(const std::string& value) {
  std::string word = FirstWord(value);
  if (word.empty() || word.front() == '<' || word.front() == '{' || word.front() == '(' || word == "+") return {};
  if (word.size() > 2 && word.front() == '|' && word.back() == '|') word = word.substr(1, word.size() - 2);
  return word;
}

/// "^operator go" instead of ^operator.name go, and "(<s> ^operator <o> + best)": the constant becomes a second
/// operator.
void FindOperatorsThatAreWords(const RuleText& rule, std::vector<Slip>& slips) {
  const std::set<std::string> states = StatesOf(rule);
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.attribute != "operator" || !states.contains(condition.id)) continue;
    const std::string word = ConstantOf(condition.value);
    if (word.empty()) continue;
    slips.push_back({rule.name, word, false,
                     "rule " + rule.name + " tests that the operator is the word " + word + ", which it never is",
                     "an operator is an object with a name: ^operator.name " + word});
  }
  for (const RuleAttribute& action : rule.actions) {
    if (action.attribute != "operator" || !states.contains(action.id) || IsRemoval(action)) continue;
    const std::string word = ConstantOf(action.value);
    if (word.empty()) continue;
    const bool is_number = word.find_first_not_of("0123456789.-") == std::string::npos;
    std::string hint = "an operator is an object with a name: (<s> ^operator <o> +) (<o> ^name " + word + ")";
    if (word == "+=") hint = "put a blank between them: + =";
    if (word == "best" || word == "better" || word == "worst" || word == "worse")
      hint = "preferences are signs: > is best, < is worst, = is indifferent";
    if (is_number) hint = "a number follows an =: (<s> ^operator <o> + = " + word + ")";
    slips.push_back({rule.name, word, false,
                     "rule " + rule.name + " proposes the word " + word + " itself as an operator", std::move(hint),
                     true});
  }
}

/// The names of the operators in a set of rules, and whether their names matter.
class OperatorNames {
 public:
  explicit OperatorNames(const std::vector<RuleText>& rules) {
    bool applies = false;
    for (const RuleText& rule : rules) {
      if ((rule.applies.contains("") && DoesSomething(rule)) || rule.works_on.contains("")) is_any_applied_ = true;
      for (const auto* names : {&rule.applies, &rule.works_on}) asked_.insert(names->begin(), names->end());
      proposed_.insert(rule.proposes.begin(), rule.proposes.end());
      applies |= std::ranges::any_of(rule.applies, [](const std::string& name) { return !name.empty(); });
      const std::set<std::string> states = StatesOf(rule);
      std::set<std::string> proposals;
      for (const RuleAttribute& condition : rule.conditions) {
        if (condition.attribute == "operator") proposals.insert(FirstWord(condition.value));
        const auto path = rule.paths.find(condition.id);
        const bool is_of_state =
            states.contains(condition.id) || (path != rule.paths.end() && FromTop(path->second).empty());
        is_state_named_ |= condition.attribute == "name" && is_of_state;
      }
      for (const RuleAttribute& action : rule.actions)
        is_named_later_ |= action.attribute == "name" && proposals.contains(action.id);
    }
    matter_ = applies && !is_any_applied_ && !is_named_later_;
  }

  /// Whether all rules that apply operators test their names, and no rule adds names to proposals of other rules. Rules
  /// that only remove something do not count.
  bool Matter() const { return matter_; }
  /// Whether a name on a state was meant for an operator: no rule tests such a name, and none adds it to a proposal.
  bool AreForOperatorsOnly() const { return !is_state_named_ && !is_named_later_; }
  /// The name that an operator without a name probably needs: one that rules ask for and that no rule proposes.
  std::string NameFor(const RuleText& rule) const {
    std::vector<std::string> missing;
    std::ranges::set_difference(asked_, proposed_, std::back_inserter(missing));
    std::erase(missing, "");
    for (const std::string& name : missing)
      if (rule.name.ends_with("*" + name)) return name;
    return missing.size() == 1 ? missing.front() : "go";
  }

 private:
  static bool DoesSomething(const RuleText& rule) {
    return !rule.calls.empty() || std::ranges::any_of(rule.actions, [](const RuleAttribute& action) {
      return !IsRemoval(action) && action.attribute != "operator";
    });
  }

  std::set<std::string> asked_, proposed_;
  bool is_any_applied_ = false, is_named_later_ = false, is_state_named_ = false, matter_ = false;
};

/// The name that a rule gives its state, as an action; null if it gives none.
const RuleAttribute* NameOfState(const RuleText& rule) {
  const std::set<std::string> states = StatesOf(rule);
  const auto at = std::ranges::find_if(rule.actions, [&](const RuleAttribute& action) {
    return action.attribute == "name" && states.contains(action.id) && !IsRemoval(action) &&
           !ConstantOf(action.value).empty();
  });
  return at == rule.actions.end() ? nullptr : &*at;
}

void FindNamelessOperators(const RuleText& rule, const OperatorNames& operators, std::vector<Slip>& slips) {
  std::set<std::string> bound;
  for (const RuleAttribute& condition : rule.conditions)
    for (std::string& variable : VariablesIn(condition.value)) bound.insert(std::move(variable));
  std::set<std::string> told;
  for (const RuleAttribute& proposal : rule.actions) {
    const std::string id = FirstWord(proposal.value);
    if (proposal.attribute != "operator" || proposal.value.find('+') == std::string::npos) continue;
    if (!IsVariable(id) || bound.contains(id) || !told.insert(id).second) continue;
    std::vector<std::string> names;
    bool may_have_name = false;
    for (const RuleAttribute& action : rule.actions) {
      if (action.id != id) continue;
      may_have_name |= action.attribute == "name" || IsVariable(action.attribute);
      if (action.attribute == "name" && !ConstantOf(action.value).empty()) names.push_back(ConstantOf(action.value));
    }
    const RuleAttribute* const of_state =
        !may_have_name && operators.AreForOperatorsOnly() ? NameOfState(rule) : nullptr;
    if (names.size() > 1 && names[0] != names[1]) {
      slips.push_back({rule.name, names[1], false,
                       "rule " + rule.name + " gives its operator two names, " + names[0] + " and " + names[1],
                       "write them as one word: " + names[0] + "-" + names[1], true});
    } else if (of_state != nullptr) {
      const std::string name = ConstantOf(of_state->value);
      slips.push_back({rule.name, "name", true,
                       "rule " + rule.name + " gives the ^name " + name + " to its state " + of_state->id +
                           ", and its operator " + id + " has no name",
                       "write the attributes of the operator on the operator: (" + id + " ^name " + name + ")", true});
    } else if (operators.Matter() && !may_have_name) {
      slips.push_back({rule.name, "operator", true,
                       "rule " + rule.name +
                           " proposes an operator without a ^name, and the rules that apply "
                           "operators ask for names",
                       "give it one: (" + id + " ^name " + operators.NameFor(rule) + ")", true});
    }
  }
}

/// "(state <s> ^impasse tie ^item <o>) --> (<s> ^operator <o> >)": a preference in the substate for an operator that is
/// a candidate only in the state above.
void FindPreferencesBelow(const RuleText& rule, const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  const auto items_of = [](const RuleText& one) {
    std::map<std::string, std::string> items;  // By variable: their substate.
    const std::set<std::string> states = StatesOf(one);
    for (const RuleAttribute& condition : one.conditions)
      if (condition.attribute == "item" && states.contains(condition.id) && !condition.negated &&
          IsVariable(condition.value))
        items[condition.value] = condition.id;
    return items;
  };
  const std::map<std::string, std::string> items = items_of(rule);
  for (const RuleAttribute& action : rule.actions) {
    const std::string id = FirstWord(action.value);
    const auto item = items.find(id);
    if (action.attribute != "operator" || item == items.end() || item->second != action.id) continue;
    // Rules may propose the candidates again in the substate.
    const bool is_proposed = std::ranges::any_of(rules, [&](const RuleText& other) {
      const std::map<std::string, std::string> its = items_of(other);
      return std::ranges::any_of(other.actions, [&](const RuleAttribute& each) {
        return each.attribute == "operator" && each.value.find(" +") != std::string::npos &&
               its.contains(FirstWord(each.value));
      });
    });
    if (is_proposed) return;
    const std::string sign = action.value.size() > id.size() ? action.value.substr(id.size()) : " +";
    slips.push_back({rule.name, "operator", true,
                     "rule " + rule.name + " gives " + id + " a preference in the substate " + action.id +
                         ", but it is a candidate of the state above: this decides nothing there",
                     "bind the state above, ^superstate <above>, and give the preference there: (<above> ^operator " +
                         id + sign + ")",
                     true});
    return;
  }
}

/// "(<s> ^io.output-link.move-to.waypoint gate)": a path in an action creates new objects, including another ^io.
void FindSecondLinks(const RuleText& rule, std::vector<Slip>& slips) {
  const std::set<std::string> states = StatesOf(rule);
  for (const RuleAttribute& action : rule.actions) {
    if (action.attribute != "io" || !states.contains(action.id)) continue;
    const std::string made = FirstWord(action.value);
    // The rule may copy the ^io of a state above to a substate.
    if (IsBoundByConditions(rule, made)) continue;
    const bool reaches_output = std::ranges::any_of(
        rule.actions, [&](const RuleAttribute& other) { return other.id == made && other.attribute == "output-link"; });
    slips.push_back(
        {rule.name, "io", true,
         "rule " + rule.name + " makes a second ^io on its state: a path in an action makes new objects, so this " +
             (reaches_output ? "gives no command" : "does not reach the agent's own links"),
         reaches_output ? "bind the link in a condition, (state <s> ^io.output-link <out>), and write on <out>"
                        : "bind the link in a condition; only the world changes what is below ^input-link",
         true});
    return;
  }
}

/// "(<s> ^count (+ <n> 1))" without "(<s> ^count <n> -)": values accumulate.
void FindHeaps(const RuleText& rule, std::vector<Slip>& slips) {
  for (const RuleAttribute& action : rule.actions) {
    if (!action.value.starts_with('(') || IsRemoval(action)) continue;
    const std::vector<std::string> used = VariablesIn(action.value);
    for (const RuleAttribute& condition : rule.conditions) {
      if (condition.id != action.id || condition.attribute != action.attribute || condition.negated) continue;
      const std::string old = FirstWord(condition.value);
      if (!IsVariable(old) || std::ranges::find(used, old) == used.end()) continue;
      const bool removes = std::ranges::any_of(rule.actions, [&](const RuleAttribute& other) {
        return other.id == action.id && other.attribute == action.attribute && IsRemoval(other);
      });
      if (removes) continue;
      slips.push_back({rule.name, action.attribute, true,
                       "rule " + rule.name + " adds another ^" + action.attribute +
                           " and keeps the old one: it fires again for each new value, without end",
                       "remove the old value, too: (" + action.id + " ^" + action.attribute + " " + old + " -)", true});
      return;
    }
  }
}

/// A command that is created with a ^status: bodies treat it as answered and do not carry it out.
void FindAnsweredCommands(const RuleText& rule, std::vector<Slip>& slips) {
  std::set<std::string> links, commands;
  for (const RuleAttribute& condition : rule.conditions)
    if (condition.attribute == "output-link" && !condition.negated) links.insert(FirstWord(condition.value));
  for (const RuleAttribute& action : rule.actions)
    if (links.contains(action.id) && !IsRemoval(action)) commands.insert(FirstWord(action.value));
  for (const RuleAttribute& action : rule.actions) {
    if (!commands.contains(action.id) || action.attribute != "status" || IsRemoval(action)) continue;
    slips.push_back(
        {rule.name, "status", true,
         "rule " + rule.name +
             " gives a command that already has a ^status: bodies treat it as answered, and do not carry it out",
         "leave ^status out; the world adds it: complete, error or interrupted", true});
  }
}

/// "^io.input-link.waypoint.name gate ^io.input-link.waypoint.here no": the paths may lead to different waypoints.
void FindPartedPaths(const RuleText& rule, std::vector<Slip>& slips) {
  constexpr std::string_view kMany[] = {"agent", "object", "waypoint", "region", "message"};
  const PathMap& paths = rule.paths;
  // Variables that the kernel generated for the dots of a path have a * in their name.
  std::map<std::string, std::map<std::string, std::string>> tested;  // By kind: variable, attribute.
  for (const RuleAttribute& condition : rule.conditions) {
    const auto path = paths.find(condition.id);
    if (path == paths.end() || condition.negated || condition.id.find('*') == std::string::npos) continue;
    if (path->second.size() != 3 || path->second[1] != "input-link") continue;
    if (std::ranges::find(kMany, path->second[2]) == std::end(kMany)) continue;
    tested[path->second[2]].try_emplace(condition.id, condition.attribute);
  }
  for (const auto& [kind, by_variable] : tested) {
    if (by_variable.size() < 2) continue;
    const std::string& first = by_variable.begin()->second;
    const std::string& second = std::next(by_variable.begin())->second;
    const std::string variable = "<" + kind.substr(0, 1) + ">";
    slips.push_back({rule.name, kind, true,
                     "rule " + rule.name + " tests ^" + first + " and ^" + second +
                         " on two paths, which may lead to "
                         "two different " +
                         kind + "s",
                     "bind one: ^io.input-link." + kind + " " + variable + ") (" + variable + " ^" + first + " ... ^" +
                         second + " ...)"});
  }
}

/// Words that the architecture never uses on a state: "^impasse nochange".
void FindWordsOfStates(const RuleText& rule, const std::set<std::string>& made, std::vector<Slip>& slips) {
  static const std::map<std::string, std::vector<std::string_view>> kWords = {
      {"impasse", {"no-change", "tie", "conflict", "constraint-failure"}},
      {"type", {"state"}},
      {"attribute", {"operator", "state"}},
      {"choices", {"none", "multiple", "constraint-failure"}}};
  for (const RuleAttribute& condition : rule.conditions) {
    const auto words = kWords.find(condition.attribute);
    if (!condition.on_state || words == kWords.end() || made.contains(condition.attribute)) continue;
    const std::string word = ConstantOf(condition.value);
    if (word.empty() || condition.value.find(' ') != std::string::npos) continue;
    if (std::ranges::find(words->second, word) != words->second.end()) continue;
    std::string hint = "it is one of:";
    for (const std::string_view one : words->second) hint += " " + std::string(one);
    if (words->second.size() == 1) hint = "it is always " + std::string(words->second.front());
    if (const std::string_view near = Suggest(word, words->second); !near.empty())
      hint = "did you mean " + std::string(near) + "?";
    slips.push_back(
        {rule.name, word, false,
         "rule " + rule.name + " waits for ^" + condition.attribute + " " + word + " on a state, which it never is",
         std::move(hint)});
  }
}

/// "-(<o> ^where <name>) --> (<c> ^waypoint <name>)": a negated condition binds nothing for the actions.
void FindBoundByNegation(const RuleText& rule, std::vector<Slip>& slips) {
  std::set<std::string> bound, negated, made;
  for (const RuleAttribute& condition : rule.conditions) {
    if (!condition.negated) bound.insert(condition.id);
    for (const auto* text : {&condition.attribute, &condition.value})
      for (std::string& variable : VariablesIn(*text))
        (condition.negated ? negated : bound).insert(std::move(variable));
  }
  for (const RuleAttribute& action : rule.actions) made.insert(action.id);
  for (const RuleAttribute& action : rule.actions) {
    const std::string variable = FirstWord(action.value);
    if (!IsVariable(variable) || bound.contains(variable) || !negated.contains(variable)) continue;
    if (made.contains(variable) || IsRemoval(action)) continue;
    slips.push_back({rule.name, variable, false,
                     "rule " + rule.name + " binds " + variable +
                         " in a negated condition only: there is no value, and the action makes a new identifier",
                     "bind it in a condition without -"});
    return;
  }
}

/// "(<s> ^operator <o> > other)": operators are compared with operators, not with names.
void FindComparedNames(const RuleText& rule, std::vector<Slip>& slips) {
  for (const RuleAttribute& action : rule.actions) {
    if (action.attribute != "operator") continue;
    for (const char* sign : {" > ", " < "}) {
      const std::size_t at = action.value.find(sign);
      const std::string other = at == std::string::npos ? std::string() : FirstWord(action.value.substr(at + 3));
      if (other.empty() || IsVariable(other) || IsNumber(other) || other.find_first_of("<>=+-!~,(") == 0) continue;
      slips.push_back(
          {rule.name, other, false,
           "rule " + rule.name + " compares its operator with the word " + other + ", which is not an operator",
           "bind the other operator in a condition: (<s> ^operator <p> +) (<p> ^name " + other + ")", true});
      return;
    }
  }
}

/// Conditions on two selected operators: a state has only one.
void FindTwoSelected(const RuleText& rule, std::vector<Slip>& slips) {
  std::map<std::string, std::string> selected;  // By state.
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.attribute != "operator" || condition.negated || !IsVariable(condition.value)) continue;
    const auto [first, is_new] = selected.try_emplace(condition.id, condition.value);
    if (is_new || first->second == condition.value) continue;
    const bool prefers =
        std::ranges::any_of(rule.actions, [](const RuleAttribute& action) { return action.attribute == "operator"; });
    if (!prefers) continue;
    // The order of conditions depends on the kernel, so the names are sorted.
    const auto [one, other] = std::minmax(first->second, condition.value);
    slips.push_back({rule.name, other, false,
                     "rule " + rule.name + " tests two operators as selected, " + one + " and " + other +
                         ": only one is selected at a time",
                     "to compare proposals, add a + after each: ^operator " + one + " + ^operator " + other + " +"});
    return;
  }
}

/// Tests that no state can pass together: the top state has no superstate and no impasse.
void FindTopAndBelow(const RuleText& rule, std::vector<Slip>& slips) {
  for (const RuleAttribute& top : rule.conditions) {
    if (top.attribute != "superstate" || top.value != "nil" || top.negated || !top.on_state) continue;
    for (const RuleAttribute& below : rule.conditions) {
      if (below.id != top.id || below.negated) continue;
      const bool is_impasse = below.attribute == "impasse" || below.attribute == "item";
      if (!is_impasse && (below.attribute != "superstate" || below.value == "nil")) continue;
      slips.push_back({rule.name, "nil", false,
                       "rule " + rule.name + " never matches: it tests ^superstate nil, which is the top state, and ^" +
                           below.attribute + " of a substate",
                       "leave ^superstate nil out of rules for a substate"});
      return;
    }
  }
}

/// "(state <s> ^operator <o>) --> (<s> ^operator <o> = 6)": a number for an operator that is selected already.
void FindNumbersForSelected(const RuleText& rule, std::vector<Slip>& slips) {
  for (const RuleAttribute& action : rule.actions) {
    const std::string id = FirstWord(action.value);
    const std::size_t sign = action.value.find(" = ");
    if (action.attribute != "operator" || !IsVariable(id) || sign == std::string::npos) continue;
    if (!IsNumber(FirstWord(action.value.substr(sign + 3)))) continue;
    bool is_selected = false, is_candidate = false;
    for (const RuleAttribute& condition : rule.conditions) {
      if (condition.attribute != "operator" || condition.negated || condition.id != action.id) continue;
      is_selected |= condition.value == id;
      is_candidate |= condition.value == id + " +";
    }
    if (!is_selected || is_candidate) continue;
    slips.push_back({rule.name, "operator", true,
                     "rule " + rule.name + " gives a number to the operator that is selected already: numbers count " +
                         "only for proposed operators",
                     "test the proposal, with a + after it: ^operator " + id + " +"});
    return;
  }
}

/// "(state <s> ^operator.name mow) --> (<s> ^operator <o> +) (<o> ^name mow)": a rule proposes only the operator that
/// is already selected, so the operator is never selected.
void FindProposalsThatWaitForThemselves(const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  for (const RuleText& rule : rules) {
    for (const std::string& name : rule.proposes) {
      if (name.empty() || !rule.applies.contains(name)) continue;
      const bool has_other = std::ranges::any_of(rules, [&](const RuleText& other) {
        return &other != &rule && (other.proposes.contains(name) || other.proposes.contains(""));
      });
      if (has_other) continue;
      slips.push_back({rule.name, name, false,
                       "rule " + rule.name + " proposes " + name + " only while " + name +
                           " is selected, and no other rule proposes it: it is never selected",
                       "a proposal does not test its own operator; the rule that applies it does"});
    }
  }
}

/// "^at <here> --> (<s> ^at <there>)" when an operator is applied and <here> has no other use: the old value stays.
void FindKeptValues(const RuleText& rule, std::vector<Slip>& slips) {
  if (IsElaboration(rule)) return;
  std::map<std::string, int> uses;
  for (const auto* side : {&rule.conditions, &rule.actions}) {
    std::set<std::string> ids;
    for (const RuleAttribute& one : *side) {
      if (ids.insert(one.id).second) ++uses[one.id];
      for (const std::string& variable : VariablesIn(one.attribute + " " + one.value)) ++uses[variable];
    }
  }
  for (const RuleCall& call : rule.all_calls)
    for (const std::string& argument : call.arguments)
      if (IsVariable(argument)) ++uses[argument];
  for (const RuleAttribute& condition : rule.conditions) {
    const std::string& old = condition.value;
    if (condition.negated || !IsVariable(old) || IsMadeUpVariable(old) || uses[old] != 1) continue;
    if (condition.attribute == "operator" || !IsConstantAttribute(condition.attribute)) continue;
    for (const RuleAttribute& action : rule.actions) {
      if (action.id != condition.id || action.attribute != condition.attribute || action.removes) continue;
      if (!IsVariable(FirstWord(action.value)) || !IsBoundByConditions(rule, FirstWord(action.value))) continue;
      slips.push_back({rule.name, old, false,
                       "rule " + rule.name + " adds another ^" + action.attribute + " and keeps the old one, " + old +
                           ": there are two values then",
                       "remove the old one, too: (" + action.id + " ^" + action.attribute + " " + old + " -)"});
      return;
    }
  }
}

bool IsOnlyForTheTop(const RuleText& rule) {
  return std::ranges::any_of(rule.conditions, [](const RuleAttribute& condition) {
    return condition.on_state && condition.attribute == "superstate" && condition.value == "nil";
  });
}

bool TestsStateAbove(const RuleText& rule) {
  return std::ranges::any_of(rule.conditions, [](const RuleAttribute& condition) {
    return condition.attribute == "superstate" && !condition.negated && IsVariable(condition.value);
  });
}

/// "^superstate.operator.thing <t> ^io.input-link <in>": a substate has no ^io.
void FindLinksBelow(const RuleText& rule, const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  for (const RuleAttribute& link : rule.conditions) {
    if (link.attribute != "io" || link.negated || !link.on_state) continue;
    const bool is_below = std::ranges::any_of(rule.conditions, [&](const RuleAttribute& condition) {
      return condition.attribute == "superstate" && condition.id == link.id && !condition.negated &&
             IsVariable(condition.value) && std::ranges::any_of(rule.conditions, [&](const RuleAttribute& above) {
               return above.id == condition.value && !above.negated;
             });
    });
    if (!is_below) continue;
    // Programs often keep the top state as an attribute of each state: ^top.io.
    std::string way = "superstate";
    for (const RuleText& other : rules)
      for (const auto& [variable, path] : other.paths)
        if (path.size() == 2 && path[1] == "io" && path[0] != "superstate") way = path[0];
    slips.push_back(
        {rule.name, "io", true,
         "rule " + rule.name +
             " never matches: it tests ^superstate and ^io of the same state, and only the top state has ^io",
         "reach it through the top state: ^" + way + ".io"});
    return;
  }
}

/// "(state <s> ^operator.name walk ^io.output-link <out>)" when walk is proposed only in substates, which have no ^io.
void FindLinksOfSubstates(const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  for (const RuleText& rule : rules)
    for (const RuleAttribute& action : rule.actions)
      if (!action.removes && (action.attribute == "io" || IsVariable(action.attribute))) return;  // They may get one.
  for (const RuleText& rule : rules) {
    const std::size_t before = slips.size();
    FindLinksBelow(rule, rules, slips);
    if (slips.size() > before) continue;
    if (rule.applies.empty() || rule.applies.contains("") || IsOnlyForTheTop(rule)) continue;
    const std::set<std::string> states = StatesOf(rule);
    const bool tests_io = std::ranges::any_of(rule.conditions, [&](const RuleAttribute& condition) {
      return condition.attribute == "io" && !condition.negated && condition.on_state && states.contains(condition.id);
    });
    if (!tests_io) continue;
    bool is_proposed = false, may_be_at_top = false;
    for (const RuleText& other : rules) {
      const bool proposes =
          std::ranges::any_of(rule.applies, [&](const std::string& name) { return other.proposes.contains(name); });
      is_proposed |= proposes;
      may_be_at_top |= other.proposes.contains("") || (proposes && !TestsStateAbove(other));
    }
    if (!is_proposed || may_be_at_top) continue;
    slips.push_back({rule.name, "io", true,
                     "rule " + rule.name + " tests ^io of the state where " + *rule.applies.begin() +
                         " is selected: that is a substate, which has no ^io",
                     "reach it through the state above: ^superstate.io"});
  }
}

}  // namespace

std::vector<Slip> FindSlipsOfUse(const std::vector<RuleText>& rules) {
  std::set<std::string> made;
  for (const RuleText& rule : rules)
    for (const RuleAttribute& action : rule.actions) made.insert(action.attribute);
  const OperatorNames operators(rules);
  std::vector<Slip> slips;
  for (const RuleText& rule : rules) {
    FindOperatorsThatAreWords(rule, slips);
    FindNamelessOperators(rule, operators, slips);
    FindPreferencesBelow(rule, rules, slips);
    FindSecondLinks(rule, slips);
    FindHeaps(rule, slips);
    FindAnsweredCommands(rule, slips);
    FindPartedPaths(rule, slips);
    FindWordsOfStates(rule, made, slips);
    FindBoundByNegation(rule, slips);
    FindComparedNames(rule, slips);
    FindTwoSelected(rule, slips);
    FindTopAndBelow(rule, slips);
    FindNumbersForSelected(rule, slips);
    FindKeptValues(rule, slips);
  }
  FindProposalsThatWaitForThemselves(rules, slips);
  FindLinksOfSubstates(rules, slips);
  return slips;
}

}  // namespace soarbox::explain
