// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <functional>
#include <map>
#include <sstream>

#include "diagnostics/diagnostic.h"
#include "diagnostics/number_from_chars.h"
#include "explain/mind_view.h"
#include "explain/reasons.h"
#include "explain/rule_slips.h"
#include "explain/slip_words.h"
#include "vocabulary/command_check.h"
#include "vocabulary/vocabulary.h"
#include "wording/sentences.h"

namespace soarbox::explain {
namespace {

class MeaningChecker {
 public:
  MeaningChecker(const std::vector<RuleText>& rules, const KnownWords& known) : rules_(rules), known_(known) {
    made_ = known.attributes;
    for (const RuleText& rule : rules)
      for (const RuleAttribute& action : rule.actions) made_.insert(action.attribute);
    for (const RuleText& rule : rules)
      for (const RuleAttribute& condition : rule.conditions) tested_.insert(condition.attribute);
    recalls_anything_ = known.has_database && std::ranges::any_of(rules, TestsWhatWasRecalled);
  }

  std::vector<Slip> slips;

  void CheckConditions(const RuleText& rule) {
    const PathMap& paths = rule.paths;
    std::set<std::string> inputs, states;
    for (const RuleAttribute& condition : rule.conditions) {
      if (condition.attribute == "input-link") inputs.insert(FirstWord(condition.value));
      if (condition.on_state) states.insert(condition.id);
    }
    for (const RuleAttribute& condition : rule.conditions) {
      const std::string& attribute = condition.attribute;
      if (states.contains(condition.id) && (attribute == "input-link" || attribute == "output-link")) {
        Tell(rule, attribute, true, "a state has no ^" + attribute + " of its own, as rule " + rule.name + " tests",
             "it is below ^io: ^io." + attribute);
        continue;
      }
      // An attribute on the input link is a percept, even if rules make it elsewhere.
      if (const auto path = paths.find(condition.id);
          path != paths.end() && path->second.size() > 1 && path->second[1] == "input-link") {
        CheckComparison(rule, condition);
        CheckItself(rule, condition);
      }
      if (!IsConstantAttribute(attribute) || IsMade(attribute) || recalls_anything_) continue;
      // FindSlipsOfMemory checks answers of memories.
      if (const auto path = paths.find(condition.id);
          path != paths.end() && (IsMemoryAnswer(path->second) || IsBelowScene(path->second)))
        continue;
      if (inputs.contains(condition.id) && vocabulary::IsPerceptAttribute(attribute)) CheckPlace(rule, attribute);
      if (vocabulary::IsPerceptAttribute(attribute) && !IsArchitectureAttribute(attribute)) CheckWord(rule, condition);
      if (IsArchitectureAttribute(attribute) || vocabulary::IsPerceptAttribute(attribute) || !known_.complete) continue;
      const bool is_operator =
          std::ranges::any_of(rules_, [&](const RuleText& other) { return other.proposes.contains(attribute); });
      const std::string meant = is_operator ? std::string() : Nearest(attribute);
      if (!Tell(rule, attribute, true,
                "rule " + rule.name + " tests ^" + attribute + ", which no percept and no rule makes",
                is_operator ? "an operator's name is a value: ^name " + attribute : DidYouMean(meant)))
        continue;
      slips.back().topic = Topic::kUnmade;
      slips.back().meant = meant;
    }
  }

  /// Checks conditions below a command for answers that no command gets.
  void CheckAnswers(const RuleText& rule) {
    const PathMap& paths = rule.paths;
    for (const RuleAttribute& condition : rule.conditions) {
      const bool is_status = condition.attribute == "status";
      if ((!is_status && condition.attribute != "reason") || condition.value.empty()) continue;
      const auto path = paths.find(condition.id);
      if (path == paths.end()) continue;
      if (const std::string place = WhereNothingIsAnswered(path->second); !place.empty()) {
        if (IsMade(condition.attribute) || recalls_anything_ || !known_.complete) continue;
        Tell(rule, condition.attribute, true,
             "rule " + rule.name + " tests ^" + condition.attribute + " of " + place + ", where nothing writes it",
             "the world answers below the command: ^io.output-link." + SaidCommandOf(rule) + "." + condition.attribute);
        continue;
      }
      if (path->second.size() != 3 || path->second[1] != "output-link") continue;
      if (vocabulary::FindCommand(path->second[2]) == nullptr)
        continue;  // Answers of scripts are defined by the
                   // scripts.
      const std::string& value = condition.value;
      if (value.find_first_of(" <>{}|") != std::string::npos || known_.scripts.contains(value)) continue;
      if (IsMadeBelowCommands(condition.attribute)) continue;
      std::vector<std::string_view> words = {"complete", "error", "interrupted"};
      if (!is_status) {
        words.clear();
        for (const vocabulary::ReasonRow& row : vocabulary::Reasons()) words.push_back(row.name);
      }
      if (std::find(words.begin(), words.end(), value) != words.end()) continue;
      const std::string_view near = Suggest(value, words);
      std::string hint = is_status ? "it is complete, error or interrupted" : "docs/commands.md lists the reasons";
      if (!near.empty()) hint = "did you mean " + std::string(near) + "?";
      if (is_status && near.empty() && IsWordForComplete(value)) hint = "did you mean complete?";
      Tell(rule, value, false,
           "rule " + rule.name + " waits for ^" + condition.attribute + " " + value +
               ", which no command is answered with",
           std::move(hint));
    }
  }

  void CheckSaid(const RuleText& rule) {
    std::map<std::string, std::string> commands;  // Their identifiers and names.
    std::set<std::string> outputs;
    for (const RuleAttribute& condition : rule.conditions)
      if (condition.attribute == "output-link" && !condition.negated) outputs.insert(FirstWord(condition.value));
    for (const RuleAttribute& action : rule.actions) {
      if (!outputs.contains(action.id) || !rule.says.contains(action.attribute)) continue;
      if (action.removes) continue;
      if (!IsConstantAttribute(action.attribute) || known_.scripts.contains(action.attribute)) continue;
      if (vocabulary::FindCommand(action.attribute) == nullptr) {
        const std::string_view near = vocabulary::NearestCommand(action.attribute);
        if (near.empty() && !known_.scripts.empty()) continue;  // Scripts may accept any command.
        Tell(rule, action.attribute, true,
             "rule " + rule.name + " gives ^" + action.attribute + ", a command that does not exist",
             near.empty() ? "docs/commands.md lists the commands" : "did you mean ^" + std::string(near) + "?");
      } else if (!IsVariable(FirstWord(action.value))) {
        vocabulary::SaidCommand said;
        said.name = action.attribute;
        said.is_object = false;
        Tell(rule, action.attribute, true, "rule " + rule.name + ": " + vocabulary::CheckCommand(said).text, {});
      } else {
        commands[FirstWord(action.value)] = action.attribute;
      }
    }
    std::map<std::string, int> parameters;
    std::map<std::pair<std::string, std::string>, const RuleAttribute*> given;
    for (const RuleAttribute& action : rule.actions) {
      const auto command = commands.find(action.id);
      if (command == commands.end() || !IsConstantAttribute(action.attribute)) continue;
      ++parameters[action.id];
      CheckParameter(rule, command->second, action);
      if (action.removes) continue;
      const auto [first, is_new] = given.try_emplace({action.id, action.attribute}, &action);
      if (!is_new) CheckTwoValues(rule, command->second, *first->second, action);
    }
    CheckParts(rule, commands);
    for (const auto& [id, name] : commands) {
      if (parameters.contains(id)) continue;
      vocabulary::SaidCommand said;
      said.name = name;
      if (IsNameIn(rule, id)) {
        const vocabulary::CommandRow& row = *vocabulary::FindCommand(name);
        const std::string parameter = row.place != vocabulary::TakesPlace::kNo ? "waypoint"
                                      : !row.parameters.empty() ? std::string(row.parameters.front().name)
                                                                : std::string();
        Tell(rule, name, true,
             "rule " + rule.name + " gives ^" + name + " the value " + id +
                 ", a name: a command is a new object, with its parameters below it",
             "(<out> ^" + name + " <command>)" +
                 (parameter.empty() ? "" : " (<command> ^" + parameter + " " + id + ")"));
        continue;
      }
      if (const vocabulary::CommandFault fault = vocabulary::CheckCommand(said); !fault.ok())
        Tell(rule, name, true, "rule " + rule.name + ": " + fault.text,
             "give it below the command: (" + id + " ^... ...)");
    }
  }

  /// "(<s> ^operater <o> +)": an attribute that is made but never tested, because another name was meant.
  void CheckMade(const RuleText& rule) {
    std::set<std::string> states;
    for (const RuleAttribute& condition : rule.conditions)
      if (condition.on_state) states.insert(condition.id);
    for (const RuleAttribute& action : rule.actions) {
      const std::string& attribute = action.attribute;
      if (!states.contains(action.id) || !IsVariable(FirstWord(action.value)) || attribute == "operator") continue;
      if (tested_.contains(attribute) || known_.scripts.contains(attribute)) continue;
      if (Suggest(attribute, {"operator"}).empty()) continue;
      Tell(rule, attribute, true, "rule " + rule.name + " makes ^" + attribute + ", which no rule tests",
           "did you mean ^operator?");
    }
  }

  /// Operators that are proposed and applied under different names, or not applied.
  void CheckOperators() {
    std::set<std::string> applied, proposed;
    bool applies_any = false, proposes_any = false;
    for (const RuleText& rule : rules_) {
      applied.insert(rule.applies.begin(), rule.applies.end());
      applied.insert(rule.works_on.begin(), rule.works_on.end());
      applies_any |= rule.works_on.contains("");
      proposed.insert(rule.proposes.begin(), rule.proposes.end());
      proposes_any |= rule.proposes.contains("");
      // A rule for any operator counts as an application only if it makes something. Removing answers does not count.
      const auto makes = [](const RuleAttribute& action) {
        return !action.value.ends_with("-") && action.attribute != "operator";
      };
      if (rule.applies.contains("") && std::any_of(rule.actions.begin(), rule.actions.end(), makes)) applies_any = true;
    }
    for (const RuleText& rule : rules_) {
      for (const std::string& name : rule.proposes) {
        if (name.empty() || applies_any || applied.contains(name) || IsSecondName(rule, name)) continue;
        Tell(rule, name, false, "rule " + rule.name + " proposes the operator " + name + ", which no rule applies",
             rule.says.empty()
                 ? HowToApply(rules_, name)
                 : "it gives its command itself, while its conditions match; give it in a rule that tests "
                   "^operator.name " +
                       name);
      }
      for (const std::string& name : rule.applies) {
        if (name.empty() || proposes_any || proposed.contains(name) || proposed.empty()) continue;
        const std::string_view near = Suggest(name, {proposed.begin(), proposed.end()});
        Tell(rule, name, false, "rule " + rule.name + " waits for the operator " + name + ", which no rule proposes",
             near.empty() ? "write a rule that proposes it: (<s> ^operator <o> +) (<o> ^name " + name + ")"
                          : "did you mean " + std::string(near) + "?");
      }
      if (!proposes_any && !proposed.empty()) CheckCompared(rule, proposed);
    }
  }

 private:
  /// Two commands at once for the same part of the body: the second interrupts the first.
  void CheckParts(const RuleText& rule, const std::map<std::string, std::string>& commands) {
    std::map<vocabulary::BodyPart, std::string> first;
    // In the order of the rule's text, not of the variables.
    for (const RuleAttribute& action : rule.actions) {
      const auto command = commands.find(FirstWord(action.value));
      if (command == commands.end() || command->second != action.attribute || action.removes) continue;
      const vocabulary::BodyPart part = vocabulary::FindCommand(action.attribute)->part;
      if (part != vocabulary::BodyPart::kLegs && part != vocabulary::BodyPart::kHead &&
          part != vocabulary::BodyPart::kHands)
        continue;
      const auto [other, is_new] = first.try_emplace(part, action.attribute);
      if (is_new) continue;
      Tell(rule, action.attribute, true,
           "rule " + rule.name + " gives " + other->second + " and " + action.attribute +
               " at once, and both need the " + std::string(vocabulary::NameOf(part)) +
               ": one of them interrupts the other",
           "give one of them; the other can follow when it is complete");
    }
  }

  /// Whether a variable of a rule is a name: the ^name of something, or an attribute of the selected operator that
  /// every rule that proposes it binds to a name.
  bool IsNameIn(const RuleText& rule, const std::string& variable) const {
    bool is_name = false;
    for (const RuleAttribute& condition : rule.conditions) {
      if (condition.id == variable) return false;
      if (condition.value != variable || condition.negated) continue;
      if (condition.attribute == "name") {
        is_name = true;
        continue;
      }
      const auto path = rule.paths.find(condition.id);
      if (path == rule.paths.end() || path->second != std::vector<std::string>{"operator"}) return false;
      for (const RuleText& other : rules_) {
        for (const RuleAttribute& action : other.actions) {
          const std::string given = FirstWord(action.value);
          if (action.attribute != condition.attribute || !IsVariable(given)) continue;
          if (other.proposes.empty() || !IsBoundToName(other, given)) return false;
          is_name = true;
        }
      }
    }
    return is_name;
  }
  static bool IsBoundToName(const RuleText& rule, const std::string& variable) {
    return std::ranges::any_of(rule.conditions,
                               [&](const RuleAttribute& condition) {
                                 return condition.value == variable && condition.attribute == "name" &&
                                        !condition.negated;
                               }) &&
           std::ranges::none_of(rule.conditions,
                                [&](const RuleAttribute& condition) { return condition.id == variable; });
  }

  /// A condition on a candidate with a name that no operator has.
  void CheckCompared(const RuleText& rule, const std::set<std::string>& proposed) {
    for (const RuleAttribute& candidate : rule.conditions) {
      if (candidate.attribute != "operator" || candidate.negated || !candidate.value.ends_with(" +")) continue;
      for (const RuleAttribute& test : rule.conditions) {
        const std::string name = FirstWord(test.value);
        if (test.id != FirstWord(candidate.value) || test.attribute != "name" || test.negated || name != test.value ||
            IsVariable(name) || name.empty() || proposed.contains(name))
          continue;
        const std::vector<std::string> names(proposed.begin(), proposed.end());
        const std::string_view near = Suggest(name, {proposed.begin(), proposed.end()});
        Tell(rule, name, false,
             "rule " + rule.name + " looks for a proposed operator with the name " + name + ", which no rule proposes",
             near.empty() ? "operators here are called " + wording::Listed(names) +
                                "; what they are about is another attribute, which the rule that proposes them makes"
                          : "did you mean " + std::string(near) + "?");
      }
    }
  }

  /// "^name go there" is reported as two names.
  static bool IsSecondName(const RuleText& rule, const std::string& name) {
    return std::ranges::any_of(rule.actions, [&](const RuleAttribute& second) {
      return second.attribute == "name" && FirstWord(second.value) == name &&
             std::ranges::any_of(rule.actions, [&](const RuleAttribute& first) {
               return first.id == second.id && first.attribute == "name" && FirstWord(first.value) != name;
             });
    });
  }

  bool IsMade(const std::string& attribute) const {
    return made_.contains(attribute) || known_.scripts.contains(attribute);
  }

  /// Returns false if the word was reported before.
  bool Tell(const RuleText& rule, const std::string& word, bool is_attribute, std::string message, std::string hint) {
    const bool is_new = told_.insert((is_attribute ? "^" : "!") + word).second;
    if (is_new) slips.push_back({rule.name, word, is_attribute, std::move(message), std::move(hint)});
    return is_new;
  }

  /// Like SimilarAttribute, but also includes attributes of the architecture.
  std::string Nearest(const std::string& attribute) const {
    std::string similar = SimilarAttribute(attribute, made_);
    if (!similar.empty() || attribute.size() < 4) return similar;
    const std::vector<std::string_view> all = {"superstate", "operator", "input-link", "output-link", "reward-link",
                                               "impasse",    "item",     "smem",       "epmem"};
    std::string_view own = Suggest(attribute, all);
    if (own.empty()) {
      const auto longer =
          std::ranges::find_if(all, [&](std::string_view one) { return one.starts_with(attribute + "-"); });
      if (longer != all.end()) own = *longer;
    }
    return std::string(own);
  }

  /// For a condition that looks for an answer next to the command instead of below it: "an operator"; empty for other
  /// paths.
  static std::string WhereNothingIsAnswered(const std::vector<std::string>& path) {
    if (path.size() == 1 && path[0] == "operator") return "an operator";
    if (path.size() == 2 && path[0] == "io" && path[1] == "output-link") return "the output link itself";
    return {};
  }

  /// A command that rules give, as an example: of this rule's operator if that is known.
  std::string SaidCommandOf(const RuleText& rule) const {
    for (const bool same_operator : {true, false}) {
      for (const RuleText& other : rules_) {
        const bool applies_it =
            std::ranges::any_of(other.applies, [&](const std::string& name) { return rule.applies.contains(name); });
        if (other.says.empty() || (same_operator && !applies_it)) continue;
        const std::string& command = *other.says.begin();
        if (IsConstantAttribute(command)) return command;
      }
    }
    return "move-to";
  }

  /// Whether rules add such an attribute below a possible command.
  bool IsMadeBelowCommands(const std::string& attribute) const { return made_.contains(attribute); }

  static bool IsWordForComplete(const std::string& word) {
    constexpr std::string_view kWords[] = {"done", "finished", "success", "succeeded", "ok", "yes", "true", "ready"};
    return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
  }

  /// A percept that is not directly on the input link.
  void CheckPlace(const RuleText& rule, const std::string& attribute) {
    for (const vocabulary::PerceptRow& row : vocabulary::Percepts())
      if (row.path == attribute) return;
    Tell(
        rule, attribute, true,
        "rule " + rule.name + " tests ^" + attribute + " directly below the input link, where there is no such percept",
        "it is " + PlacesOfPercept(attribute));
  }

  static bool IsUnit(std::string_view word) {
    constexpr std::string_view kUnits[] = {"m", "cm", "km", "s", "ms", "deg", "degrees", "metres", "meters", "seconds"};
    return std::ranges::find(kUnits, word) != std::end(kUnits);
  }

  static bool IsAlwaysNumber(const std::string& attribute) {
    return std::all_of(vocabulary::Percepts().begin(), vocabulary::Percepts().end(),
                       [&](const vocabulary::PerceptRow& row) {
                         return row.Attribute() != attribute || row.type == vocabulary::ValueType::kNumber ||
                                row.type == vocabulary::ValueType::kInteger;
                       });
  }

  /// "^health |10|": a word instead of a number.
  void CheckQuotedNumber(const RuleText& rule, const RuleAttribute& condition, const std::string& word) {
    if (!IsNumber(word) || !IsAlwaysNumber(condition.attribute)) return;
    Tell(rule, word, false,
         "rule " + rule.name + " compares ^" + condition.attribute + ", a number, with the word " + word,
         "write the number without bars: " + word);
  }

  /// "(<w> ^name <w>)"
  void CheckItself(const RuleText& rule, const RuleAttribute& condition) {
    if (condition.value != condition.id || !IsAlwaysWord(condition.attribute)) return;
    Tell(rule, condition.attribute, true,
         "rule " + rule.name + " tests that ^" + condition.attribute + " is " + condition.id +
             ", the object that has it: that never matches",
         "give it a variable of its own: ^" + condition.attribute + " <" + condition.attribute + ">");
  }

  static bool IsAlwaysWord(const std::string& attribute) {
    return vocabulary::IsPerceptAttribute(attribute) &&
           std::ranges::all_of(vocabulary::Percepts(), [&](const vocabulary::PerceptRow& row) {
             return row.Attribute() != attribute || row.type == vocabulary::ValueType::kWord;
           });
  }

  /// "^name > 3", "^name { > 3 <n> }": words cannot be less or greater.
  void CheckComparison(const RuleText& rule, const RuleAttribute& condition) {
    std::istringstream tests(condition.value);
    std::string number;
    for (std::string before, word; tests >> word && number.empty(); before = word)
      if ((before == "<" || before == "<=" || before == ">" || before == ">=") && IsNumber(word)) number = word;
    if (number.empty() || !IsAlwaysWord(condition.attribute)) return;
    Tell(rule, condition.attribute, true,
         "rule " + rule.name + " compares ^" + condition.attribute + ", a word, with the number " + number +
             ": that never matches",
         "a word is equal, or not equal: ^" + condition.attribute + " <> ...");
  }

  /// A word that the percepts of that name never have.
  void CheckWord(const RuleText& rule, const RuleAttribute& condition) {
    const std::string& value = condition.value;
    if (value.size() > 2 && value.front() == '|' && value.back() == '|') {
      CheckQuotedNumber(rule, condition, value.substr(1, value.size() - 2));
      return;
    }
    if (value.find_first_of(" <>{}|") != std::string::npos || value.empty() || IsNumber(value)) return;
    if (value == "and" || value == "or" || value == "not") return;  // Reported as a slip of form.
    const std::vector<std::string_view> words = WordsOfPercept(condition.attribute);
    if (std::find(words.begin(), words.end(), value) != words.end()) return;
    const bool is_number = IsAlwaysNumber(condition.attribute);
    if (words.empty() && !is_number) return;
    if (words.empty()) {
      Tell(rule, value, false,
           "rule " + rule.name + " compares ^" + condition.attribute + ", a number, with the word " + value,
           IsUnit(value) ? "write the number without its unit" : "numbers are compared with < <= > >= <>");
      return;
    }
    std::string all = "it is one of:";
    for (const std::string_view word : words) all += " " + std::string(word);
    const std::string_view near = Suggest(value, words);
    Tell(rule, value, false,
         "rule " + rule.name + " waits for ^" + condition.attribute + " " + value + ", which it never is",
         near.empty() ? all : "did you mean " + std::string(near) + "?");
  }

  static vocabulary::Percept GivenBy(const RuleAttribute& action) {
    vocabulary::Percept given;
    given.attribute = action.attribute;
    const std::string word = FirstWord(action.value);
    if (IsNumber(word)) {
      double number = 0;
      NumberFromChars(word, number);
      if (word.find_first_of(".eE") == std::string::npos) {
        given.value = static_cast<std::int64_t>(number);
      } else {
        given.value = number;
      }
    } else {
      given.value = word;
    }
    return given;
  }

  /// "^speed 1 + 2" is parsed as two values, because the sign is a preference.
  void CheckTwoValues(const RuleText& rule, const std::string& command, const RuleAttribute& first,
                      const RuleAttribute& second) {
    if (const std::string value = FirstWord(first.value); value == FirstWord(second.value)) {
      if (!IsNumber(value)) return;
      Tell(rule, second.attribute, true,
           "rule " + rule.name + " gives ^" + second.attribute + " of " + command + " twice, as " + value +
               ": a + after a value is a preference, not a sum",
           "a sum is written (+ " + value + " " + value + ")");
      return;
    }
    vocabulary::SaidCommand said;
    said.name = command;
    said.parameters = {GivenBy(first), GivenBy(second)};
    const vocabulary::CommandFault fault = vocabulary::CheckCommand(said);
    if (fault.reason == "bad-value") Tell(rule, second.attribute, true, "rule " + rule.name + ": " + fault.text, {});
  }

  void CheckParameter(const RuleText& rule, const std::string& command, const RuleAttribute& action) {
    vocabulary::SaidCommand said;
    said.name = command;
    said.parameters.push_back(GivenBy(action));
    const std::string word = FirstWord(action.value);
    const bool is_constant = !word.empty() && word.find_first_of("<>()|") == std::string::npos;
    const vocabulary::CommandFault fault = vocabulary::CheckCommand(said);
    if (fault.reason == "unknown-parameter" || (fault.reason == "bad-value" && is_constant))
      Tell(rule, action.attribute, true, "rule " + rule.name + ": " + fault.text, {});
  }

  const std::vector<RuleText>& rules_;
  const KnownWords& known_;
  std::set<std::string> made_, tested_;
  std::set<std::string> told_;
  bool recalls_anything_ = false;  ///< For example from a database, whose facts may have any attribute.
};

}  // namespace

std::string HowToApply(const std::vector<RuleText>& rules, const std::string& name) {
  std::set<std::string> applied;
  for (const RuleText& rule : rules) applied.insert(rule.applies.begin(), rule.applies.end());
  // A rule that should apply it may test the proposal instead.
  for (const RuleText& rule : rules) {
    std::set<std::string> proposals;
    for (const RuleAttribute& condition : rule.conditions)
      if (condition.attribute == "operator" && condition.value.ends_with("+"))
        proposals.insert(FirstWord(condition.value));
    const bool names_it =
        std::any_of(rule.conditions.begin(), rule.conditions.end(), [&](const RuleAttribute& condition) {
          return proposals.contains(condition.id) && condition.attribute == "name" && condition.value == name;
        });
    const bool acts = !rule.says.empty() || rule.calls.contains("write") || rule.calls.contains("halt") ||
                      std::ranges::any_of(rule.actions, [&](const RuleAttribute& action) {
                        return action.attribute != "operator" && !proposals.contains(action.id);
                      });
    if (names_it && acts)
      return "rule " + rule.name + " tests ^operator " + *proposals.begin() +
             " +, a proposal: without the + it tests the operator that is selected";
  }
  if (name.empty())
    return "it has no ^name: give it one where it is proposed, and write a rule that tests ^operator.name";
  const std::string_view near = Suggest(name, {applied.begin(), applied.end()});
  for (const RuleText& rule : rules)
    if (!near.empty() && rule.applies.contains(std::string(near)))
      return "rule " + rule.name + " applies " + std::string(near) + ": did you mean that?";
  return "write a rule that tests ^operator.name " + name + " and gives a command or changes something";
}

std::string PlacesOfPercept(const std::string& attribute) {
  constexpr int kMostShown = 4;
  std::string places;
  int count = 0;
  for (const vocabulary::PerceptRow& row : vocabulary::Percepts()) {
    if (row.Attribute() != attribute || ++count > kMostShown) continue;
    places += (places.empty() ? "^io.input-link." : ", ^io.input-link.") + std::string(row.path);
  }
  return count > kMostShown ? places + ", ..." : places;
}

std::vector<std::string_view> WordsOfPercept(const std::string& attribute) {
  std::vector<std::string_view> words;
  for (const vocabulary::PerceptRow& row : vocabulary::Percepts()) {
    if (row.Attribute() != attribute || row.type != vocabulary::ValueType::kWord) continue;
    if (row.words.empty()) return {};
    for (std::string_view rest = row.words; !rest.empty();) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      // Several percepts of this name may share words.
      if (std::ranges::find(words, rest.substr(0, end)) == words.end()) words.push_back(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return words;
}

std::vector<Slip> FindSlipsOfMeaning(const std::vector<RuleText>& rules, const KnownWords& known) {
  MeaningChecker checker(rules, known);
  for (const RuleText& rule : rules) {
    if (known.own_world) break;
    checker.CheckConditions(rule);
    checker.CheckAnswers(rule);
    const std::size_t before = checker.slips.size();
    checker.CheckMade(rule);
    checker.CheckSaid(rule);
    for (std::size_t i = before; i < checker.slips.size(); ++i) checker.slips[i].in_actions = true;
  }
  if (known.complete) checker.CheckOperators();
  return std::move(checker.slips);
}

}  // namespace soarbox::explain
