// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>
#include <utility>

#include "diagnostics/diagnostic.h"
#include "diagnostics/number_from_chars.h"
#include "explain/former_soar.h"
#include "explain/rule_slips.h"
#include "explain/slip_words.h"
#include "rule_reading/nearest_function.h"

namespace soarbox::explain {
namespace {

constexpr std::size_t kNone = std::string::npos;

bool HasState(const RuleText& rule) {
  return std::any_of(rule.conditions.begin(), rule.conditions.end(),
                     [](const RuleAttribute& condition) { return condition.on_state; });
}

bool IsSameButForCase(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char one, unsigned char other) { return std::tolower(one) == std::tolower(other); });
}

void FindUnlinked(const RuleText& rule, std::vector<Slip>& slips) {
  if (!HasState(rule)) {
    slips.push_back({rule.name,
                     {},
                     false,
                     "no condition of rule " + rule.name + " begins with (state <s>",
                     "begin the first condition with it: (state <s> ^superstate nil ...)"});
    return;
  }
  std::set<std::string> linked;
  for (const RuleAttribute& condition : rule.conditions)
    if (condition.on_state) linked.insert(condition.id);
  for (bool grows = true; grows;) {
    grows = false;
    for (const RuleAttribute& condition : rule.conditions) {
      if (!linked.contains(condition.id)) continue;
      for (const auto* part : {&condition.attribute, &condition.value})
        for (std::string& variable : VariablesIn(*part)) grows |= linked.insert(std::move(variable)).second;
    }
  }
  std::set<std::string> told;
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.id.empty() || linked.contains(condition.id) || !told.insert(condition.id).second) continue;
    const std::vector<std::string_view> others(linked.begin(), linked.end());
    // All one-letter names are equally similar, but <O> is probably a mistyped <o>.
    const auto same_letters =
        std::ranges::find_if(others, [&](std::string_view other) { return IsSameButForCase(other, condition.id); });
    const std::string_view near = same_letters != others.end() ? *same_letters
                                  : condition.id.size() > 3    ? Suggest(condition.id, others)
                                                               : std::string_view();
    slips.push_back({rule.name, condition.id, false,
                     "nothing in rule " + rule.name + " leads from the state to " + condition.id,
                     near.empty() ? "link it: give another condition " + condition.id + " as its value"
                                  : "did you mean " + std::string(near) + "?"});
  }
}

/// "<name" or "name>", but not a relation or a bracket of << a b >>.
bool IsHalfVariable(const std::string& word) {
  if (word.size() < 2 || word.find_first_not_of("<>=") == std::string::npos) return false;
  if (word.starts_with("<<") || word.ends_with(">>")) return false;
  return (word.front() == '<') != (word.back() == '>');
}

/// The constants of a value that may be slips: those in bars, without the bars, and half variables.
std::vector<std::string> ConstantsIn(const std::string& value) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < value.size();) {
    if (value[at] == ' ') {
      ++at;
      continue;
    }
    const bool is_quoted = value[at] == '|';
    const std::size_t end = std::min(is_quoted ? value.find('|', at + 1) : value.find(' ', at), value.size());
    if (is_quoted) {
      words.push_back(value.substr(at + 1, end - at - 1));
    } else if (const std::string word = value.substr(at, end - at); IsHalfVariable(word)) {
      words.push_back(word);
    }
    at = end + 1;
  }
  return words;
}

/// "$place": a variable of other languages. Kernels print it unchanged or in bars.
bool IsOtherLanguagesVariable(const std::string& word) {
  return word.size() > 1 && word.front() == '$' && (std::isalpha(static_cast<unsigned char>(word[1])) != 0);
}

/// Splits the tests of a value: "{ > 2m <x> }" into "> 2m" and "<x>". Words in bars keep the bars.
std::vector<std::pair<std::string, std::string>> TestsIn(const std::string& value) {
  std::vector<std::pair<std::string, std::string>> tests;
  std::string relation;
  for (std::size_t at = value.find_first_not_of(' '); at < value.size(); at = value.find_first_not_of(' ', at)) {
    const std::size_t end =
        std::min(value[at] == '|' ? value.find('|', at + 1) + 1 : value.find(' ', at), value.size());
    std::string word = value.substr(at, end - at);
    at = end;
    if (word == "{" || word == "}") continue;
    if (word.find_first_not_of("<>=") == std::string::npos && word != "<<" && word != ">>") {
      relation = std::move(word);
    } else {
      tests.emplace_back(std::exchange(relation, {}), std::move(word));
    }
  }
  return tests;
}

/// "?place": a variable of older rule languages.
bool IsQuestion(const std::string& word) {
  return word.size() > 1 && word.front() == '?' && (std::isalpha(static_cast<unsigned char>(word[1])) != 0);
}

/// "<<ready" and "empty>>": brackets of a disjunction without a blank next to them.
bool IsTightChoice(const std::string& word) {
  return word.size() > 2 && word.find_first_not_of("<>=") != std::string::npos &&
         (word.starts_with("<<") || word.ends_with(">>"));
}

bool IsSignOfOtherLanguages(const std::string& word) {
  return word == "++" || word == "+=" || word == "-=" || word == "*=" || word == "/=";
}

/// Half a variable contains a letter; the word --> does not.
bool HasLetter(const std::string& word) {
  return std::ranges::any_of(word, [](unsigned char c) { return std::isalnum(c) != 0; });
}

/// Finds constants that look like something else. Kernels print them in bars, whether their author used bars or not.
/// Returns whether one of them is probably meant as a variable.
bool FindOddWords(const RuleText& rule, std::vector<Slip>& slips) {
  bool has_variable = false;
  std::set<std::string> told;
  for (const auto* side : {&rule.conditions, &rule.actions}) {
    for (const RuleAttribute& clause : *side) {
      for (const auto& test : TestsIn(clause.value)) {
        std::string word = test.second;
        if (word.size() > 2 && word.front() == '|' && word.back() == '|') word = word.substr(1, word.size() - 2);
        if (IsOtherLanguagesVariable(test.second) || IsQuestion(word)) {
          has_variable = true;
          slips.push_back({rule.name, word, false,
                           word + " in rule " + rule.name + " is read as a word, not as a variable",
                           "write a variable between < and >: <" + word.substr(1) + ">"});
        } else if (IsTightChoice(word) && told.insert(clause.id + clause.attribute).second) {
          slips.push_back({rule.name, word, false,
                           word + " in rule " + rule.name + " is read as a word, not as a choice",
                           "write blanks inside the brackets: << a b >>"});
        } else if (IsSignOfOtherLanguages(word) && clause.attribute != "operator") {
          slips.push_back({rule.name, word, false, word + " in rule " + rule.name + " is read as a word",
                           "to count, add the sum and remove the old value: (<s> ^" + clause.attribute +
                               " (+ <n> 1)) (<s> ^" + clause.attribute + " <n> -)"});
        }
      }
      for (const std::string& word : ConstantsIn(clause.value)) {
        if (word.size() < 2 || word.find(' ') != std::string::npos) continue;
        if (word.find_first_not_of("<>=!") == std::string::npos) {
          slips.push_back({rule.name, word, false, word + " in rule " + rule.name + " is read as a word",
                           "the relations are < <= > >= <> (not equal) <=> (of the same type); leave = out"});
        } else if (const std::size_t number = word.find_first_not_of("<>=");
                   word.front() == '<' && IsNumber(word.substr(number))) {
          slips.push_back({rule.name, word, false, word + " in rule " + rule.name + " is read as a word",
                           "put a blank between them: " + word.substr(0, number) + " " + word.substr(number)});
        } else if ((word.front() == '<' || word.back() == '>') && HasLetter(word)) {
          has_variable = true;
          slips.push_back({rule.name, word, false,
                           word + " in rule " + rule.name + " is read as a word, not as a variable",
                           "write a variable between < and >, without blanks"});
        }
      }
    }
  }
  return has_variable;
}

/// "2m" and "50%": returns the number that was meant; empty if there is none.
std::string LeadingNumber(const std::string& word) {
  const std::size_t end = word.find_first_not_of("0123456789.-");
  const std::string number = word.substr(0, end);
  return IsNumber(number) ? number : std::string();
}

/// Finds words that are compared by < or >. Only numbers can be less or greater, so the test always fails.
void FindComparedWords(const RuleText& rule, std::vector<Slip>& slips) {
  for (const RuleAttribute& condition : rule.conditions) {
    for (const auto& [relation, text] : TestsIn(condition.value)) {
      const bool compares = relation == "<" || relation == "<=" || relation == ">" || relation == ">=";
      const bool is_quoted = text.size() > 1 && text.front() == '|' && text.back() == '|';
      const std::string word = is_quoted ? text.substr(1, text.size() - 2) : text;
      if (!compares || word.empty() || IsVariable(word) || (!is_quoted && IsNumber(word))) continue;
      if (IsHalfVariable(word) || word.find_first_not_of("<>=!") == std::string::npos)
        continue;  // Reported as half a variable.
      const std::string number = LeadingNumber(word);
      slips.push_back({rule.name, word, false,
                       "rule " + rule.name + " tests ^" + condition.attribute + " " + relation + " " +
                           (IsNumber(word) ? text : word) + ", which is a word and no number: that never matches",
                       number.empty()   ? "< <= > >= compare numbers; a word is equal, or not equal: <>"
                       : number == word ? "write the number without bars: " + number
                                        : "write the number alone: " + number});
    }
  }
}

/// "^color red and ^size big": the words that join tests in other languages are values here.
void FindJoiningWords(const RuleText& rule, std::vector<Slip>& slips) {
  for (const RuleAttribute& condition : rule.conditions) {
    const std::string& word = condition.value;
    if (word != "and" && word != "or" && word != "not" && word != "&&") continue;
    const bool joins = std::ranges::any_of(rule.conditions, [&](const RuleAttribute& other) {
      return &other != &condition && other.id == condition.id && other.attribute == condition.attribute;
    });
    if (!joins) continue;
    slips.push_back(
        {rule.name, word, false, "rule " + rule.name + " tests that ^" + condition.attribute + " is the word " + word,
         word == "or" ? "a choice is written << a b >>"
         : word == "not"
             ? "not equal is written <>, and that an element is absent -^attribute value"
             : "conditions need no " + word + " between them; write two tests of one value in braces: { > 10 < 20 }"});
  }
}

/// "{ > 2 and < 20 }": the word is an additional test, which requires the number to be that word.
void FindJoinedTests(const RuleText& rule, std::vector<Slip>& slips) {
  for (const RuleAttribute& condition : rule.conditions) {
    if (!condition.value.starts_with('{')) continue;
    for (const auto& [relation, word] : TestsIn(condition.value)) {
      if (!relation.empty() || (word != "and" && word != "or" && word != "not" && word != "&&")) continue;
      slips.push_back(
          {rule.name, word, false, "rule " + rule.name + " tests that ^" + condition.attribute + " is the word " + word,
           word == "or" ? "a choice is written << a b >>" : "write tests in braces one after another: { > 10 < 20 }"});
      break;
    }
  }
}

/// Finds operators that a rule creates but never makes acceptable, so that they are not candidates.
void FindUnproposed(const RuleText& rule, std::vector<Slip>& slips) {
  std::set<std::string> known, proposed;
  for (const RuleAttribute& condition : rule.conditions)
    for (std::string& variable : VariablesIn(condition.value)) known.insert(std::move(variable));
  for (const RuleAttribute& action : rule.actions) {
    if (action.attribute != "operator") {
      known.insert(FirstWord(action.value));  // Another rule may find it there and propose it.
    } else if (action.value.ends_with(" +") || action.value.ends_with(" !") || action.value.find(' ') == kNone) {
      proposed.insert(FirstWord(action.value));
    }
  }
  std::set<std::string> told;
  for (const RuleAttribute& action : rule.actions) {
    const std::string name = FirstWord(action.value);
    if (action.attribute != "operator" || !IsVariable(name) || known.contains(name) || proposed.contains(name))
      continue;
    if (action.value.ends_with("-")) continue;  // Reported as an unbound variable.
    if (!told.insert(name).second) continue;
    const std::string sign = action.value.substr(std::min(action.value.find(' ') + 1, action.value.size()));
    slips.push_back({rule.name, "operator", true,
                     "rule " + rule.name + " makes the operator " + name + " and does not propose it: " + sign +
                         " alone only compares it with others",
                     "add a +: (<s> ^operator " + name + " + " + sign + ")"});
  }
}

void FindOddActions(const RuleText& rule, std::vector<Slip>& slips) {
  if (!rule.acts)
    slips.push_back({rule.name,
                     {},
                     false,
                     "rule " + rule.name + " does nothing: no action follows its -->",
                     "an action looks like (<s> ^attribute value)"});
  for (const std::string& call : rule.calls) {
    if (!call.starts_with("exec ")) continue;
    const std::string name = call.substr(5);
    const std::string_view near = rule_reading::NearestFunction(name);
    const std::string former = FormerFunctionHint(name);
    slips.push_back({rule.name, name, false,
                     "rule " + rule.name + " calls the function " + name + ", which does not exist",
                     !former.empty() ? former
                     : near.empty()  ? "built in are write, crlf, halt, + - * / and others"
                                     : "did you mean " + std::string(near) + "?"});
  }
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.attribute != "superstate" || condition.value.empty() || condition.value == "nil") continue;
    if (VariablesIn(condition.value).empty() && condition.value.find('{') == std::string::npos)
      slips.push_back({rule.name, condition.value, false,
                       "rule " + rule.name +
                           " never matches: ^superstate is nil at the top and a state below it, never " +
                           condition.value,
                       "write ^superstate nil"});
  }
}

bool IsZero(const std::string& word) {
  double number = 1;
  const auto [end, error] = NumberFromChars(word, number);
  return error == std::errc{} && end == word.data() + word.size() && number == 0;
}

/// "(write |done| crlf)" and "(/ <n> 0)": calls that load but do not do what was meant.
void FindOddArguments(const RuleText& rule, std::vector<Slip>& slips) {
  for (const RuleCall& call : rule.all_calls) {
    std::string function = call.function;
    if (function.size() > 2 && function.front() == '|') function = function.substr(1, function.size() - 2);
    for (const std::string& word : call.arguments) {
      if (!IsSameButForCase(word, "crlf")) continue;
      slips.push_back({rule.name, word, false,
                       "rule " + rule.name + " prints the word " + word + " instead of ending the line",
                       "call the function between brackets: (crlf)", true});
      break;
    }
    const bool divides = function == "/" || function == "div" || function == "mod";
    if (divides && call.arguments.size() > 1 && std::any_of(call.arguments.begin() + 1, call.arguments.end(), IsZero)) {
      slips.push_back({rule.name, function, false, "rule " + rule.name + " divides by 0 in (" + function + " ...)",
                       "an action whose value cannot be computed does nothing: write another divisor", true});
    }
  }
}

/// Finds variables that occur only in actions, where they create a new identifier. If the name is similar to a bound
/// variable, this is probably a typing mistake.
void FindUnboundValues(const RuleText& rule, std::vector<Slip>& slips) {
  std::map<std::string, int> in_actions;
  std::set<std::string> bound;
  for (const RuleAttribute& condition : rule.conditions) {
    bound.insert(condition.id);
    for (const auto* text : {&condition.value, &condition.attribute})
      for (const std::string& variable : VariablesIn(*text)) bound.insert(variable);
  }
  std::set<std::string> ids;
  for (const RuleAttribute& action : rule.actions) {
    ids.insert(action.id);
    for (const std::string& variable : VariablesIn(action.value)) ++in_actions[variable];
  }
  for (const RuleAttribute& action : rule.actions) {
    // "^next <n> -" with an unbound <n>: a kernel simplifies { <n> 3 } to 3 and drops <n>.
    if (action.value.ends_with('-')) {
      const std::string gone = action.value.substr(0, action.value.find(' '));
      if (IsVariable(gone) && !bound.contains(gone) && !ids.contains(gone))
        slips.push_back({rule.name, gone, false,
                         "no condition of rule " + rule.name + " binds " + gone + ": the action removes nothing",
                         action.attribute == "operator"
                             ? "bind it in a condition: ^operator " + gone
                             : "a condition { " + gone + " constant } does not bind it either: write the constant"});
      continue;
    }
    if (!IsVariable(action.value)) continue;
    const std::string& variable = action.value;
    if (bound.contains(variable) || ids.contains(variable) || in_actions[variable] > 1) continue;
    const std::string_view near = Suggest(variable, {bound.begin(), bound.end()});
    if (near.empty() || near.size() < 5 || variable.size() < 5) continue;
    slips.push_back({rule.name, variable, false,
                     "no condition of rule " + rule.name + " binds " + variable + ": the action makes a new identifier",
                     "did you mean " + std::string(near) + "?"});
  }
}

}  // namespace

std::vector<Slip> FindSlipsOfForm(const std::vector<RuleText>& rules) {
  std::vector<Slip> slips;
  for (const RuleText& rule : rules) {
    const bool has_odd_variable = FindOddWords(rule, slips);
    FindComparedWords(rule, slips);
    FindJoiningWords(rule, slips);
    FindJoinedTests(rule, slips);
    FindUnproposed(rule, slips);
    // A variable with a missing bracket is reported as such.
    if (!has_odd_variable) FindUnlinked(rule, slips);
    FindOddActions(rule, slips);
    FindOddArguments(rule, slips);
    FindUnboundValues(rule, slips);
  }
  return slips;
}

}  // namespace soarbox::explain
