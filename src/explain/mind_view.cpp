// SPDX-License-Identifier: BSD-2-Clause
#include "explain/mind_view.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <unordered_set>
#include <utility>

#include "explain/command_inspector.h"
#include "explain/rule_from_facts.h"
#include "explain/rule_text.h"
#include "sml_Client.h"
#include "wording/number_words.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_Inspection.h"
#endif

namespace soarbox::explain {
namespace {

constexpr std::size_t kMostFollowed = 50;  ///< ValuesAt follows at most this number of identifiers at each step.

/// "(S1 ^operator O1 +)"
std::string ElementText(const ElementFact& element) {
  return "(" + element.id + " ^" + element.attribute + " " + wording::WithoutZeros(element.value) +
         (element.acceptable ? " +)" : ")");
}

/// "O1 (left)"
std::string WithName(const std::string& id, const std::string& name) {
  return name.empty() ? id : id + " (" + name + ")";
}

bool IsRelation(const std::string& word) {
  return word == "<" || word == ">" || word == "<=" || word == ">=" || word == "<>" || word == "<=>" || word == "=";
}

/// Converts "{ > 50 <h*1> }" to what its author wrote, "> 50". A variable that it is compared with is replaced by its
/// path.
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
      // The path may be the condition's own, if another condition binds the variable.
      if (path != paths.end() && path->second != text.path) {
        text.compared.push_back(path->second);
        words.push_back(Dotted(path->second));
        continue;
      }
    } else if (IsVariable(word) && (IsMadeUpVariable(word) || relates)) {
      continue;  // The word only binds the value to a variable.
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
  // The newest first, as `print --all` lists them.
  const std::vector<RuleFact> listed = inspector_->Rules();
  for (auto rule = listed.rbegin(); rule != listed.rend(); ++rule) {
    std::vector<RuleText> read = ReadRules(inspector_->RuleSource(rule->name));
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
  for (const StateFact& state : inspector_->Stack()) {
    stack.push_back({true, state.id, state.attribute.empty() ? "" : state.attribute + " " + state.impasse});
    if (!state.operator_id.empty()) stack.push_back({false, state.operator_id, state.operator_name});
  }
  return stack;
}

RuleMatch MindView::Match(const std::string& rule) {
  RuleMatch match;
  const std::optional<MatchFacts> facts = inspector_->Match(rule);
  if (!facts) return match;
  match.total = static_cast<int>(facts->conditions.size());
  match.matched = static_cast<int>(facts->failing.value_or(facts->conditions.size()));
  if (!facts->failing) return match;
  match.failing = facts->conditions[*facts->failing].text;
  constexpr std::string_view kOpen = "-{", kClose = "}";
  match.is_group = match.failing.starts_with(kOpen) && match.failing.ends_with(kClose);
  if (match.is_group)
    match.failing = match.failing.substr(kOpen.size(), match.failing.size() - kOpen.size() - kClose.size());
  return match;
}

bool MindView::HasFired(const std::string& rule) {
  return Firings(rule).value_or(1) > 0;
}

std::optional<std::uint64_t> MindView::Firings(const std::string& rule) {
  if (!inspector_->TellsAll()) {
    // Parses " 3:  rule". Querying all rules would send a request for each rule to another process.
    std::istringstream in(Ask("production firing-counts " + rule));
    std::uint64_t count = 0;
    return in >> count ? std::optional(count) : std::nullopt;
  }
  if (firings_.empty())
    for (const RuleFact& each : inspector_->Rules()) firings_.emplace(each.name, each.firings);
  const auto at = firings_.find(rule);
  return at == firings_.end() ? std::nullopt : std::optional(at->second);
}

bool MindView::IsPending(const std::string& rule) {
  return ReadIsPending(rule, Ask("matches --assertions"));
}

mind::Decision MindView::DecisionOf(const std::string& state) {
  return inspector_->Operators(state).decision.value_or(mind::Decision());
}

std::string PreferenceText(const PreferenceFact& preference) {
  const std::string text = WithName(preference.value, preference.name) + " " + preference.sign;
  if (preference.referent.empty()) return text;
  return text + " " + WithName(wording::WithoutZeros(preference.referent), preference.other_name);
}

std::vector<std::string> MindView::ValuesOf(const std::string& attribute) {
  std::vector<std::string> values;
  for (const ElementFact& element : inspector_->Search(attribute, std::numeric_limits<std::size_t>::max()))
    if (element.attribute == attribute && std::ranges::find(values, element.value) == values.end())
      values.push_back(element.value);
  return values;
}

std::vector<std::string> MindView::ValuesAt(const std::string& id, const std::vector<std::string>& path) {
  std::vector<std::string> at = {id};
  for (const std::string& attribute : path) {
    std::vector<std::string> next;
    std::unordered_set<std::string> seen;
    for (std::size_t i = 0; i < at.size() && i < kMostFollowed; ++i)
      for (ElementFact& element : inspector_->ElementsOf(at[i]))
        // A variable matches any attribute.
        if ((element.attribute == attribute || IsVariable(attribute)) && seen.insert(element.value).second)
          next.push_back(std::move(element.value));
    at = std::move(next);
  }
  return at;
}

std::vector<std::string> MindView::Elements(const std::string& state, const PreferenceFact& preference) {
  constexpr std::size_t kMost = 12;
  std::vector<ElementFact> elements = preference.maker.elements;
  if (!inspector_->TellsAll()) {
    for (const std::uint64_t tag : ReadRestsOn(preference, Ask("preferences " + state + " operator --names --wmes"))) {
      if (elements.size() >= kMost) break;
      if (std::optional<ElementFact> element = inspector_->Element(tag)) elements.push_back(std::move(*element));
    }
  }
  std::vector<std::string> found;
  for (const ElementFact& element : elements) {
    if (found.size() >= kMost) break;
    std::string text = ElementText(element);
    if (std::ranges::find(found, text) == found.end()) found.push_back(std::move(text));
  }
  return found;
}

std::string MindView::DescribeOperator(const std::string& id) {
  std::string name, rest;
  for (const ElementFact& element : inspector_->ElementsOf(id)) {
    if (element.attribute == "name") {
      name = element.value;
    } else {
      rest += " ^" + element.attribute + " " + wording::WithoutZeros(element.value);
    }
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
