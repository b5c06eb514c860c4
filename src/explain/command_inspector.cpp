// SPDX-License-Identifier: BSD-2-Clause
#include "explain/command_inspector.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <sstream>

#include "explain/command_text.h"
#include "explain/rule_text.h"
#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_Inspection.h"
#endif

namespace soarbox::explain {
namespace {

/// Splits the text of elements into words; |quoted words| are not split.
std::vector<std::string> Words(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == ' ') {
      ++i;
      continue;
    }
    const std::size_t begin = i;
    bool quoted = false;
    for (; i < text.size() && (quoted || text[i] != ' '); ++i)
      if (text[i] == '|') quoted = !quoted;
    words.emplace_back(text.substr(begin, i - begin));
  }
  return words;
}

std::uint64_t Number(std::string_view text) {
  std::uint64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// Splits "O1 (name)".
void SplitOperator(std::string_view text, std::string& id, std::string& name) {
  text = WithoutBlanks(text);
  id = std::string(text.substr(0, text.find(' ')));
  name.clear();
  const std::size_t open = text.find('('), close = text.find(')');
  if (open != std::string_view::npos && close != std::string_view::npos && close > open)
    name = std::string(text.substr(open + 1, close - open - 1));
}

struct Section {
  std::string_view title, type;
};
constexpr Section kSections[] = {{"acceptables", "acceptable"},
                                 {"requires", "require"},
                                 {"rejects", "reject"},
                                 {"prohibits", "prohibit"},
                                 {"bests", "best"},
                                 {"worsts", "worst"},
                                 {"betters", "better"},
                                 {"worses", "worse"},
                                 {"unary indifferents", "indifferent"},
                                 {"numeric indifferents", "numeric"},
                                 {"binary indifferents", "equal"}};

/// Parses "O1 (name) > O2 (other) :I", "O1 (name) + :I", "O1 (name) = 5. :I".
PreferenceFact ReadPreference(std::string_view line, std::string_view type) {
  PreferenceFact preference;
  preference.type = type;
  SplitOperator(line, preference.value, preference.name);
  const std::size_t close = line.find(')');
  std::string_view rest =
      WithoutBlanks(close == std::string_view::npos ? line.substr(preference.value.size()) : line.substr(close + 1));
  preference.sign = std::string(rest.substr(0, 1));
  rest = WithoutBlanks(rest.substr(std::min<std::size_t>(1, rest.size())));
  const std::size_t support = rest.rfind(':');
  preference.maker.o_supported = support != std::string_view::npos && rest.substr(support).starts_with(":O");
  const std::string_view referent = WithoutBlanks(rest.substr(0, support));
  if (!referent.empty())
    SplitOperator(referent.starts_with("= ") ? referent.substr(2) : referent, preference.referent,
                  preference.other_name);
  return preference;
}

}  // namespace

std::vector<ElementFact> ReadElements(std::string_view text) {
  std::vector<ElementFact> elements;
  for (std::size_t at = text.find('('); at != std::string_view::npos; at = text.find('(', at + 1)) {
    std::size_t end = at + 1;
    bool quoted = false;
    while (end < text.size() && (quoted || text[end] != ')')) quoted = (text[end++] == '|') != quoted;
    const std::string_view inner = text.substr(at + 1, end - at - 1);
    const std::size_t colon = inner.find(':');
    if (colon == std::string_view::npos || colon == 0 ||
        inner.substr(0, colon).find_first_not_of("0123456789") != std::string_view::npos)
      continue;
    const std::vector<std::string> words = Words(inner.substr(colon + 1));
    if (words.size() < 3 || !words[1].starts_with('^')) continue;
    elements.push_back({Number(inner.substr(0, colon)), words[0], words[1].substr(1), words[2],
                        words.size() > 3 && words[3] == "+", IsIdentifier(words[2])});
    at = end;
  }
  return elements;
}

std::vector<StateFact> ReadStack(std::string_view text) {
  std::vector<StateFact> stack;
  for (const std::string& line : Lines(text)) {
    if (const std::size_t at = line.find("==>S:"); at != std::string::npos) {
      std::string about;
      StateFact& state = stack.emplace_back();
      state.level = static_cast<int>(stack.size());
      SplitOperator(std::string_view(line).substr(at + 5), state.id, about);
      state.impasse = "none";
      if (const std::size_t blank = about.find(' '); blank != std::string::npos) {
        state.attribute = about.substr(0, blank);
        state.impasse = about.substr(blank + 1);
      }
    } else if (const std::size_t op = line.find("O:"); op != std::string::npos && !stack.empty()) {
      SplitOperator(std::string_view(line).substr(op + 2), stack.back().operator_id, stack.back().operator_name);
    }
  }
  return stack;
}

OperatorFacts ReadPreferences(std::string_view text) {
  OperatorFacts facts;
  std::string_view type;
  bool chances = false;
  for (const std::string& line : Lines(text)) {
    const std::string_view trimmed = WithoutBlanks(line);
    if (trimmed.empty()) continue;
    if (trimmed.starts_with("selection probabilities")) {
      chances = true;
    } else if (trimmed.starts_with("From ")) {
      if (!chances && !facts.preferences.empty()) facts.preferences.back().maker.rule = trimmed.substr(5);
    } else if (trimmed.ends_with(':')) {
      for (const Section& section : kSections)
        if (trimmed == std::string(section.title) + ":") type = section.type;
    } else if (IsIdentifier(trimmed.substr(0, trimmed.find(' '))) && !type.empty()) {
      const PreferenceFact read = ReadPreference(trimmed, type);
      if (!chances) {
        facts.preferences.push_back(read);
        continue;
      }
      CandidateFact& candidate = facts.candidates.emplace_back();
      candidate.id = read.value;
      candidate.name = read.name;
      candidate.value = std::strtod(read.referent.c_str(), nullptr);
      if (const std::size_t open = trimmed.rfind('('); open != std::string_view::npos)
        candidate.probability = std::strtod(std::string(trimmed.substr(open + 1)).c_str(), nullptr) / 100;
    }
  }
  return facts;
}

MatchFacts ReadMatches(std::string_view rule, std::string_view text) {
  MatchFacts facts;
  facts.rule = rule;
  std::string group;
  int depth = 0;
  for (const std::string& line : Lines(text)) {
    const std::string_view trimmed = WithoutBlanks(line);
    if (trimmed.empty()) continue;
    if (trimmed.find("complete match") != std::string_view::npos) {
      facts.complete = Number(trimmed);
      break;
    }
    ConditionFact condition;
    bool is_failing = false;
    std::string_view shown = trimmed;
    if (trimmed.starts_with(">>>>")) {
      is_failing = true;
      shown = WithoutBlanks(trimmed.substr(4));
    } else if (std::isdigit(static_cast<unsigned char>(trimmed[0])) != 0) {
      condition.partial_matches = Number(trimmed);
      const std::size_t blank = trimmed.find(' ');
      shown = blank == std::string_view::npos ? std::string_view() : WithoutBlanks(trimmed.substr(blank));
    }
    // The conditions of a conjunctive negation are reported as one, with its closing brace.
    if (shown == "-{") ++depth;
    if (depth > 0) group += (group.empty() ? "" : " ") + std::string(shown);
    if (shown == "}" && depth > 0 && --depth == 0) shown = group;
    if (depth > 0) continue;
    if (is_failing && !facts.failing) facts.failing = facts.conditions.size();
    condition.text = shown;
    group.clear();
    condition.negated = condition.text.starts_with('-') || condition.text.find("-^") != std::string::npos;
    facts.conditions.push_back(std::move(condition));
  }
  return facts;
}

std::string CommandInspector::SceneFacts() {
  return Ask("svs facts");
}

std::string CommandInspector::Ask(const std::string& command) {
  const char* answer = agent_.ExecuteCommandLine(command.c_str());
  return answer == nullptr ? std::string() : answer;
}

MindFacts CommandInspector::Mind() {
  MindFacts facts;
  facts.decisions = static_cast<std::uint64_t>(std::max(agent_.GetDecisionCycleCounter(), 0));
  for (const std::string& line : Lines(Ask("print --all --user")))
    if (!WithoutBlanks(line).empty() && WithoutBlanks(line).find(' ') == std::string_view::npos) ++facts.rules;
  for (const ElementFact& io : ElementsOf("S1")) {
    if (io.attribute != "io") continue;
    for (const ElementFact& link : ElementsOf(io.value)) {
      if (link.attribute == "input-link") facts.input_link = link.value;
      if (link.attribute == "output-link") facts.output_link = link.value;
    }
  }
  return facts;
}

std::vector<StateFact> CommandInspector::Stack() {
  return ReadStack(Ask("print --stack"));
}

std::vector<ElementFact> CommandInspector::ElementsOf(std::string_view id) {
  return IsIdentifier(id) ? ReadElements(Ask("print --internal " + std::string(id))) : std::vector<ElementFact>();
}

std::vector<ElementFact> CommandInspector::Search(std::string_view text, std::size_t most) {
  std::vector<ElementFact> found;
  for (ElementFact& element : ReadElements(Ask("print --internal {(* ^* *)}"))) {
    if (element.attribute.find(text) != std::string::npos || element.value.find(text) != std::string::npos ||
        element.id == text)
      found.push_back(std::move(element));
  }
  std::ranges::sort(found, {}, &ElementFact::timetag);
  const auto is_same = [](const ElementFact& a, const ElementFact& b) { return a.timetag == b.timetag; };
  found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
  if (found.size() > most) found.resize(most);
  return found;
}

std::optional<ElementFact> CommandInspector::Element(std::uint64_t timetag) {
  const std::vector<ElementFact> found = ReadElements(Ask("print --internal " + std::to_string(timetag)));
  for (const ElementFact& element : found)
    if (element.timetag == timetag) return element;
  return std::nullopt;
}

std::vector<MakerFact> CommandInspector::MakersOf(std::uint64_t) {
  return {};
}

std::vector<TesterFact> CommandInspector::TestersOf(std::uint64_t) {
  return {};
}

OperatorFacts CommandInspector::Operators(std::string_view state) {
  OperatorFacts facts;
  const std::vector<StateFact> stack = Stack();
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (stack[i].id != state) continue;
    facts = ReadPreferences(Ask("preferences " + std::string(state) + " operator --names"));
    facts.state = state;
    facts.selected = stack[i].operator_id;
    facts.impasse = i + 1 < stack.size() ? stack[i + 1].impasse : "none";
#ifdef SOARBOX_OWN_KERNEL
    facts.decision = AskDecision(agent_, state);
#endif
  }
  return facts;
}

std::vector<RuleFact> CommandInspector::Rules() {
  std::vector<RuleFact> rules;
  for (const std::string& line : Lines(Ask("print --all --user"))) {
    const std::string_view name = WithoutBlanks(line);
    if (name.empty() || name.find(' ') != std::string_view::npos) continue;
    RuleFact& rule = rules.emplace_back();
    rule.name = name;
    rule.type = "user";
  }
  // Kernels list the newest first.
  std::ranges::reverse(rules);
  for (const std::string& line : Lines(Ask("production firing-counts"))) {
    const std::vector<std::string> words = Words(WithoutBlanks(line));
    if (words.size() != 2) continue;
    for (RuleFact& rule : rules)
      if (words[1] == rule.name) rule.firings = Number(words[0].substr(0, words[0].find(':')));
  }
  // Each rule is a separate query, so it is skipped for programs with very many rules.
  constexpr std::size_t kMostAsked = 300;
  for (std::size_t i = 0; i < rules.size() && rules.size() <= kMostAsked; ++i)
    rules[i].matches = ReadMatches(rules[i].name, Ask("matches " + rules[i].name)).complete;
  return rules;
}

std::vector<NumberFact> ReadNumbers(std::string_view text) {
  std::vector<NumberFact> numbers;
  for (const std::string& line : Lines(std::string(text))) {
    const std::vector<std::string> words = Words(WithoutBlanks(line));
    // In the mode delta-bar-delta, two more numbers come first.
    if (words.size() < 3) continue;
    NumberFact& number = numbers.emplace_back();
    number.rule = words.front();
    number.updates = static_cast<std::uint64_t>(std::strtod(words[words.size() - 2].c_str(), nullptr));
    number.value = std::strtod(words.back().c_str(), nullptr);
  }
  // Kernels list the newest first.
  std::ranges::reverse(numbers);
  return numbers;
}

LearningFacts CommandInspector::Learning() {
  LearningFacts facts;
  facts.by_reward = Ask("rl --get learning").find("on") != std::string::npos;
  facts.numbers = ReadNumbers(Ask("print --rl"));
  facts.last_reward = std::strtod(Ask("rl --stats total-reward").c_str(), nullptr);
  facts.total_reward = std::strtod(Ask("rl --stats global-reward").c_str(), nullptr);
  return facts;
}

std::string CommandInspector::RuleSource(std::string_view rule) {
  std::string text = Ask("print --full " + std::string(rule));
  text.erase(text.find_last_not_of("\n") + 1);
  return text.starts_with("sp {") || text.starts_with("sp \"") ? text : std::string();
}

std::optional<MatchFacts> CommandInspector::Match(std::string_view rule) {
  if (RuleSource(rule).empty()) return std::nullopt;
  MatchFacts facts = ReadMatches(rule, Ask("matches " + std::string(rule)));
  if (!facts.failing) return facts;
  // Adds elements of working memory that have an attribute of the failing condition.
  constexpr std::size_t kMostSeen = 20;
  for (const RuleAttribute& part : ReadConditions(facts.conditions[*facts.failing].text)) {
    if (!IsConstantAttribute(part.attribute)) continue;
    for (ElementFact& element : Search(part.attribute, kMostSeen))
      if (element.attribute == part.attribute) facts.seen.push_back(std::move(element));
  }
  return facts;
}

bool ReadIsPending(std::string_view rule, std::string_view text) {
  return std::ranges::any_of(Lines(text), [&](const std::string& line) {
    const std::vector<std::string> words = Words(WithoutBlanks(line));
    return std::ranges::find(words, rule) != words.end();
  });
}

std::vector<std::uint64_t> ReadRestsOn(const PreferenceFact& preference, std::string_view text) {
  std::vector<std::uint64_t> tags;
  std::string_view type;
  bool is_it = false;
  for (const std::string& line : Lines(text)) {
    const std::string_view trimmed = WithoutBlanks(line);
    constexpr std::string_view kTag = "WME with time tag ";
    if (trimmed.starts_with("selection probabilities")) break;
    if (trimmed.starts_with(kTag)) {
      if (is_it) tags.push_back(Number(trimmed.substr(kTag.size())));
    } else if (trimmed.starts_with("From ")) {
      is_it = is_it && trimmed.substr(5) == preference.maker.rule;
    } else if (trimmed.ends_with(':')) {
      for (const Section& section : kSections)
        if (trimmed == std::string(section.title) + ":") type = section.type;
    } else if (IsIdentifier(trimmed.substr(0, trimmed.find(' '))) && !type.empty()) {
      const PreferenceFact read = ReadPreference(trimmed, type);
      is_it = read.type == preference.type && read.value == preference.value && read.referent == preference.referent;
    }
  }
  return tags;
}

std::vector<std::string> CommandInspector::Complete(std::string_view) {
  return {};
}

}  // namespace soarbox::explain
