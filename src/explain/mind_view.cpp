// SPDX-License-Identifier: BSD-2-Clause
#include "explain/mind_view.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <unordered_set>
#include <utility>

#include "explain/command_inspector.h"
#include "explain/command_text.h"
#include "explain/rule_from_facts.h"
#include "explain/rule_text.h"
#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_Inspection.h"
#endif

namespace soarbox::explain {
namespace {

constexpr std::size_t kMostFollowed = 50;  ///< Identifiers of one step of a path.

/// The values behind each ^attribute in "(I2 ^attribute a ^attribute b)".
void ReadValues(const std::string& text, const std::string& attribute, std::vector<std::string>& values) {
  const std::string mark = " ^" + attribute + " ";
  for (const std::string& line : Lines(text)) {
    for (std::size_t at = line.find(mark); at != std::string::npos; at = line.find(mark, at + 1)) {
      const std::string rest = line.substr(at + mark.size());
      std::string value = Trimmed(rest.substr(0, std::min(rest.find(" ^"), rest.find_last_of(')'))));
      if (value.ends_with(" +")) value.resize(value.size() - 2);
      if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(std::move(value));
    }
  }
}

std::string Dotted(const std::vector<std::string>& path) {
  std::string text = "^";
  for (std::size_t i = 0; i < path.size(); ++i) text += (i == 0 ? "" : ".") + path[i];
  return text;
}

bool IsRelation(const std::string& word) {
  return word == "<" || word == ">" || word == "<=" || word == ">=" || word == "<>" || word == "<=>" || word == "=";
}

/// "{ > 50 <h*1> }" as its author wrote it, "> 50"; what it is compared with as the place where that lies.
void ReadTests(const std::string& value, const PathMap& paths, ConditionText& text) {
  std::istringstream in(value);
  std::vector<std::string> words;
  const std::vector<std::string> given{std::istream_iterator<std::string>(in), {}};
  const bool relates = std::ranges::any_of(given, IsRelation);
  std::string before;
  for (const std::string& word : given) {
    const std::string sign = std::exchange(before, word);
    if (IsVariable(word) && IsRelation(sign)) {
      const auto path = paths.find(word);
      // The path may be this condition's own, if another one binds the variable.
      if (path != paths.end() && path->second != text.path) {
        text.compared.push_back(path->second);
        words.push_back(Dotted(path->second));
        continue;
      }
    } else if (IsVariable(word) && (IsMadeUpVariable(word) || relates)) {
      continue;  // It only names the value.
    }
    words.push_back(word);
  }
  const bool braced = words.size() >= 2 && words.front() == "{" && words.back() == "}";
  if (braced && words.size() <= 4) words = {words.begin() + 1, words.end() - 1};
  for (const std::string& word : words) text.value += (text.value.empty() ? "" : " ") + word;
}

}  // namespace

std::string MindView::Ask(const std::string& command) {
  const char* answer = agent_.ExecuteCommandLine(command.c_str());
  return answer == nullptr ? std::string() : answer;
}

const std::vector<RuleText>& MindView::rules() {
  if (std::exchange(read_, true)) return rules_;
#ifdef SOARBOX_OWN_KERNEL
  if (const std::optional<std::vector<mind::RuleFacts>> contents = AskRuleContents(agent_)) {
    // The newest first, as `print --all` lists them.
    for (const mind::RuleFacts& facts : *contents) rules_.push_back(TextOf(facts));
    std::ranges::reverse(rules_);
    return rules_;
  }
#endif
  // Names first: `print --all` lists them, `print --full` shows one.
  for (const std::string& line : Lines(Ask("print --all --user"))) {
    const std::string name = Trimmed(line);
    if (name.empty() || name.find(' ') != std::string::npos) continue;
    std::vector<RuleText> read = ReadRules(Ask("print --full " + name));
    rules_.insert(rules_.end(), read.begin(), read.end());
  }
  return rules_;
}

const RuleText* MindView::FindRule(std::string_view name) {
  for (const RuleText& rule : rules())
    if (rule.name == name) return &rule;
  return nullptr;
}

std::vector<StackEntry> MindView::Stack() {
  std::vector<StackEntry> stack;
  for (const StateFact& state : ReadStack(Ask("print --stack"))) {
    stack.push_back({true, state.id, state.attribute.empty() ? "" : state.attribute + " " + state.impasse});
    if (!state.operator_id.empty()) stack.push_back({false, state.operator_id, state.operator_name});
  }
  return stack;
}

RuleMatch MindView::Match(const std::string& rule) {
  const MatchFacts facts = ReadMatches(rule, Ask("matches " + rule));
  RuleMatch match;
  match.total = static_cast<int>(facts.conditions.size());
  match.matched = static_cast<int>(facts.failing.value_or(facts.conditions.size()));
  if (!facts.failing) return match;
  match.failing = facts.conditions[*facts.failing].text;
  constexpr std::string_view kOpen = "-{ ", kClose = " }";
  match.is_group = match.failing.starts_with(kOpen) && match.failing.ends_with(kClose);
  if (match.is_group)
    match.failing = match.failing.substr(kOpen.size(), match.failing.size() - kOpen.size() - kClose.size());
  return match;
}

bool MindView::HasFired(const std::string& rule) {
  return Firings(rule).value_or(1) > 0;
}

std::optional<std::uint64_t> MindView::Firings(const std::string& rule) {
  // " 3:  rule"
  std::istringstream in(Ask("production firing-counts " + rule));
  std::uint64_t count = 0;
  return in >> count ? std::optional(count) : std::nullopt;
}

bool MindView::IsPending(const std::string& rule) {
  for (const std::string& line : Lines(Ask("matches --assertions"))) {
    std::istringstream in(line);
    for (std::string word; in >> word;)
      if (word == rule) return true;
  }
  return false;
}

std::vector<Preference> MindView::Preferences(const std::string& state, bool with_elements) {
  std::vector<Preference> found;
  std::string section;
  for (const std::string& line :
       Lines(Ask("preferences " + state + " operator --names" + (with_elements ? " --wmes" : "")))) {
    const std::string text = Trimmed(line);
    constexpr std::string_view kTag = "WME with time tag ";
    if (text.starts_with("selection prob")) break;
    if (text.starts_with("Preferences for")) continue;
    if (text.ends_with("s:") && text.find('(') == std::string::npos) {
      section = text.substr(0, text.size() - 2);
    } else if (text.starts_with("From ")) {
      if (!found.empty() && found.back().rule.empty()) found.back().rule = text.substr(5);
    } else if (text.starts_with(kTag)) {
      if (!found.empty()) found.back().elements.push_back(text.substr(kTag.size()));
    } else if (const std::size_t open = text.find(" ("); open != std::string::npos && !section.empty()) {
      Preference& preference = found.emplace_back();
      preference.section = section;
      preference.operator_id = text.substr(0, open);
      preference.name = text.substr(open + 2, text.find(')') - open - 2);
      preference.text = Trimmed(text.substr(0, text.find(" :")));
    }
  }
  return found;
}

std::vector<std::string> MindView::ValuesOf(const std::string& attribute) {
  std::vector<std::string> values;
  ReadValues(Ask("print {(* ^" + attribute + " *)}"), attribute, values);
  return values;
}

std::vector<std::string> MindView::ValuesAt(const std::string& id, const std::vector<std::string>& path) {
  std::vector<std::string> at = {id};
  for (const std::string& attribute : path) {
    std::vector<std::string> next;
    for (std::size_t i = 0; i < at.size() && i < kMostFollowed; ++i)
      if (IsIdentifier(at[i])) ReadValues(Ask("print --exact (" + at[i] + " ^" + attribute + " *)"), attribute, next);
    at.clear();
    std::unordered_set<std::string> seen;
    for (std::string& value : next)
      if (seen.insert(value).second) at.push_back(std::move(value));
  }
  return at;
}

std::vector<std::string> MindView::Elements(const Preference& preference) {
  constexpr std::size_t kMost = 12;
  std::vector<std::string> found;
  for (const std::string& tag : preference.elements) {
    if (found.size() >= kMost) break;
    // "(12: S1 ^io I1)", the element alone.
    std::string text = Trimmed(Ask("print --internal " + tag));
    const std::string mark = "(" + tag + ": ";
    const std::size_t begin = text.find(mark);
    if (begin == std::string::npos) continue;
    text = "(" + text.substr(begin + mark.size(), text.find(')', begin) - begin - mark.size()) + ")";
    if (std::find(found.begin(), found.end(), text) == found.end()) found.push_back(std::move(text));
  }
  return found;
}

std::string MindView::DescribeOperator(const std::string& id) {
  std::string text = Trimmed(Ask("print " + id));
  if (!text.starts_with("(" + id) || !text.ends_with(')')) return id;
  text = text.substr(1, text.size() - 2);
  std::string name, rest;
  for (std::size_t at = text.find(" ^"); at != std::string::npos;) {
    const std::size_t end = text.find(" ^", at + 2);
    const std::string one = Trimmed(text.substr(at, end == std::string::npos ? end : end - at));
    if (one.starts_with("^name ")) {
      name = one.substr(6);
    } else {
      rest += " " + one;
    }
    at = end;
  }
  return name.empty() ? id + rest : name + rest;
}

std::string ConditionText::Text() const {
  const std::string text = (negated ? "-" : "") + Dotted(path);
  return value.empty() ? text : text + " " + value;
}

std::vector<ConditionText> ReadCondition(const RuleText& rule, const std::string& printed) {
  const PathMap& paths = rule.paths;
  std::vector<ConditionText> found;
  for (const RuleAttribute& part : ReadConditions(printed)) {
    ConditionText& text = found.emplace_back();
    if (const auto from = paths.find(part.id); from != paths.end()) text.path = from->second;
    text.path.push_back(part.attribute);
    ReadTests(part.value, paths, text);
    text.negated = part.negated;
  }
  return found;
}

}  // namespace soarbox::explain
