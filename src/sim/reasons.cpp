// SPDX-License-Identifier: BSD-2-Clause
#include "sim/reasons.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

#include "diagnostics/diagnostic.h"
#include "sim/vocabulary.h"
#include "sml_Client.h"

namespace soarbox::sim {
namespace {

constexpr std::size_t kMostRulesAsked = 60;
constexpr std::size_t kMostValuesShown = 4;

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string Trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string List(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size() && i < kMostValuesShown; ++i) text += (i == 0 ? "" : ", ") + words[i];
  if (words.size() > kMostValuesShown) text += " and " + std::to_string(words.size() - kMostValuesShown) + " more";
  return text;
}

/// What `matches RULE` says.
struct MatchState {
  int matched = 0, total = 0;
  std::string failing;  ///< The first condition that fails; empty: all match.
};

MatchState ReadMatches(const std::string& text) {
  MatchState state;
  bool after = false;
  for (const std::string& line : Lines(text)) {
    const std::string trimmed = Trimmed(line);
    if (trimmed.empty()) continue;
    if (trimmed.find("complete match") != std::string::npos) break;
    ++state.total;
    if (trimmed.starts_with(">>>>")) {
      state.failing = Trimmed(trimmed.substr(4));
      after = true;
    } else if (!after && std::isdigit(static_cast<unsigned char>(trimmed[0])) != 0) {
      ++state.matched;
    }
  }
  return state;
}

}  // namespace

std::string SuggestAttribute(std::string_view attribute, const std::set<std::string>& known) {
  if (attribute.size() < 3) return {};
  const std::vector<std::string> more(known.begin(), known.end());
  const std::string_view near = NearestAttribute(attribute, more);
  return near.empty() ? std::string() : "did you mean ^" + std::string(near) + "?";
}

std::string MindReasons::Ask(const std::string& command) {
  const char* answer = agent_.ExecuteCommandLine(command.c_str());
  return answer == nullptr ? std::string() : answer;
}

const std::vector<RuleText>& MindReasons::rules() {
  if (!read_) {
    // Names first: `print --all` lists them, `print --full` shows one.
    for (const std::string& line : Lines(Ask("print --all --user"))) {
      const std::string name = Trimmed(line);
      if (name.empty() || name.find(' ') != std::string::npos) continue;
      std::vector<RuleText> read = ReadRules(Ask("print --full " + name));
      rules_.insert(rules_.end(), read.begin(), read.end());
      constexpr std::size_t kMostRules = 2000;
      if (rules_.size() >= kMostRules) break;
    }
    read_ = true;
  }
  return rules_;
}

std::vector<StackEntry> MindReasons::Stack() {
  std::vector<StackEntry> stack;
  for (const std::string& line : Lines(Ask("print --stack"))) {
    const bool is_state = line.find("==>S:") != std::string::npos;
    const std::size_t at = is_state ? line.find("S:") : line.find("O:");
    if (at == std::string::npos) continue;
    StackEntry& entry = stack.emplace_back();
    entry.is_state = is_state;
    const std::string rest = Trimmed(line.substr(at + 2));
    entry.id = rest.substr(0, rest.find(' '));
    const std::size_t open = rest.find('('), close = rest.rfind(')');
    if (open != std::string::npos && close != std::string::npos) entry.about = rest.substr(open + 1, close - open - 1);
  }
  return stack;
}

std::vector<std::string> MindReasons::ValuesOf(const std::string& attribute) {
  std::vector<std::string> values;
  for (const std::string& line : Lines(Ask("print {(* ^" + attribute + " *)}"))) {
    const std::string mark = " ^" + attribute + " ";
    for (std::size_t at = line.find(mark); at != std::string::npos; at = line.find(mark, at + 1)) {
      const std::size_t begin = at + mark.size();
      const std::string rest = line.substr(begin);
      const std::string value = Trimmed(rest.substr(0, std::min(rest.find(" ^"), rest.find(')'))));
      if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
    }
  }
  return values;
}

std::vector<std::string> MindReasons::UnwrittenAttributes(const std::set<std::string>& given) {
  std::set<std::string> known = given;
  for (const RuleText& rule : rules()) {
    for (const RuleAttribute& action : rule.actions) known.insert(action.attribute);
  }
  std::vector<std::string> found;
  std::set<std::string> told;
  for (const RuleText& rule : rules()) {
    for (const RuleAttribute& condition : rule.conditions) {
      const std::string& attribute = condition.attribute;
      if (!IsConstantAttribute(attribute) || IsArchitectureAttribute(attribute) || IsPerceptAttribute(attribute))
        continue;
      if (known.contains(attribute) || condition.negated || !told.insert(attribute).second) continue;
      if (!ValuesOf(attribute).empty()) continue;
      const std::string hint = SuggestAttribute(attribute, known);
      found.push_back("rule " + rule.name + " tests ^" + attribute + ", which no sense and no rule ever writes" +
                      (hint.empty() ? "" : ": " + hint));
    }
  }
  return found;
}

std::string MindReasons::ExplainCondition(const std::string& condition) {
  const std::vector<RuleAttribute> parts = ReadConditions(condition);
  for (const RuleAttribute& part : parts) {
    if (!IsConstantAttribute(part.attribute)) continue;
    const std::vector<std::string> values = ValuesOf(part.attribute);
    if (part.negated) return values.empty() ? "" : "^" + part.attribute + " is there: " + List(values);
    if (!values.empty()) return "^" + part.attribute + " is now " + List(values);
    const auto makes = std::find_if(rules().begin(), rules().end(), [&](const RuleText& rule) {
      return std::any_of(rule.actions.begin(), rule.actions.end(),
                         [&](const RuleAttribute& action) { return action.attribute == part.attribute; });
    });
    if (makes != rules().end()) return "nothing has ^" + part.attribute + " yet; rule " + makes->name + " makes it";
    return "nothing has ^" + part.attribute + " now";
  }
  return {};
}

std::vector<std::string> MindReasons::Nearest(const std::vector<const RuleText*>& candidates, std::size_t most) {
  struct Near {
    double share;
    std::string text;
  };
  std::vector<Near> found;
  for (std::size_t i = 0; i < candidates.size() && i < kMostRulesAsked; ++i) {
    const MatchState state = ReadMatches(Ask("matches " + candidates[i]->name));
    if (state.failing.empty() || state.total == 0) continue;
    std::string text = "rule " + candidates[i]->name + " came to " + std::to_string(state.matched) + " of " +
                       std::to_string(state.total) + " conditions: " + state.failing + " does not hold";
    if (const std::string why = ExplainCondition(state.failing); !why.empty()) text += ", " + why;
    found.push_back({static_cast<double>(state.matched) / state.total, std::move(text)});
  }
  std::stable_sort(found.begin(), found.end(), [](const Near& a, const Near& b) { return a.share > b.share; });
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < found.size() && i < most; ++i) texts.push_back(std::move(found[i].text));
  return texts;
}

std::string MindReasons::ExplainTie(const std::string& state) {
  std::map<std::string, std::string> rules_by_operator;
  std::string current;
  bool acceptable = false;
  for (const std::string& line : Lines(Ask("preferences " + state + " operator --names"))) {
    const std::string trimmed = Trimmed(line);
    if (trimmed.ends_with("s:")) acceptable = trimmed.starts_with("acceptable");
    if (!acceptable) continue;
    if (trimmed.starts_with("From ")) {
      if (!current.empty()) rules_by_operator[current] = trimmed.substr(5);
    } else if (trimmed.find('+') != std::string::npos && trimmed.find('(') != std::string::npos) {
      current = trimmed.substr(0, trimmed.find(')') + 1);
      rules_by_operator[current];
    }
  }
  std::vector<std::string> operators;
  for (const auto& [name, rule] : rules_by_operator) operators.push_back(name + (rule.empty() ? "" : " from " + rule));
  return "operator tie in " + state + " between " + List(operators) +
         ": no preference decides. If it does not matter which, add = where they are proposed: (<s> ^operator <o> + "
         "=); "
         "if one is better, a rule (<s> ^operator <better> > <other>)";
}

std::vector<std::string> MindReasons::WhyIdle(const std::set<std::string>& known) {
  std::vector<std::string> reasons;
  if (rules().empty()) return {"it has no rules"};
  const std::vector<StackEntry> stack = Stack();
  const StackEntry* selected = nullptr;
  std::string state = "S1";
  for (const StackEntry& entry : stack) {
    if (entry.is_state && entry.about == "operator tie") {
      reasons.push_back(ExplainTie(state));
      break;
    }
    if (entry.is_state && (entry.about == "operator conflict" || entry.about == "operator constraint-failure"))
      reasons.push_back(entry.about + " in " + state + ": its preferences contradict each other; see `preferences " +
                        state + " operator --names`");
    if (entry.is_state) {
      state = entry.id;
      if (entry.about != "operator no-change") selected = nullptr;
    } else {
      selected = &entry;
    }
  }
  const std::vector<std::string> unwritten = UnwrittenAttributes(known);
  reasons.insert(reasons.end(), unwritten.begin(), unwritten.end());
  if (!reasons.empty() && selected == nullptr && reasons.size() > unwritten.size()) return reasons;

  std::vector<const RuleText*> candidates;
  if (selected != nullptr) {
    std::string applied_by;
    for (const RuleText& rule : rules()) {
      if (!rule.applies.contains(selected->about)) continue;
      candidates.push_back(&rule);
      if (applied_by.empty() && ReadMatches(Ask("matches " + rule.name)).failing.empty()) applied_by = rule.name;
    }
    if (candidates.empty()) {
      reasons.push_back("operator " + selected->about +
                        " is selected in S1 and no rule applies it: write one that tests ^operator.name " +
                        selected->about + " and says a command");
    } else if (!applied_by.empty()) {
      reasons.push_back("operator " + selected->about + " has been applied (" + applied_by +
                        ") and stays selected: what proposes it still holds, and an operator is applied once");
    } else {
      reasons.push_back("operator " + selected->about + " is selected and no rule that applies it matches");
      for (std::string& near : Nearest(candidates, 3)) reasons.push_back(std::move(near));
    }
    return reasons;
  }
  for (const RuleText& rule : rules())
    if (!rule.proposes.empty()) candidates.push_back(&rule);
  if (candidates.empty()) {
    reasons.push_back("no rule proposes an operator: write one with (<s> ^operator <o> +)");
    return reasons;
  }
  reasons.push_back("no operator is proposed in " + state);
  for (std::string& near : Nearest(candidates, 3)) reasons.push_back(std::move(near));
  return reasons;
}

std::vector<std::string> MindReasons::OperatorTree(const std::string& command) {
  std::vector<std::string> lines;
  std::string state = "S1";
  std::vector<StackEntry> selected;
  for (const StackEntry& entry : Stack()) {
    if (entry.is_state) continue;
    selected.push_back(entry);
  }
  for (const RuleText& rule : rules())
    if (!command.empty() && rule.says.contains(command)) lines.push_back("  said by rule " + rule.name);
  if (selected.empty()) {
    lines.push_back("  no operator is selected now");
    return lines;
  }
  lines.push_back("  operator " + selected.front().about + " (" + selected.front().id + "), selected in " + state);
  bool mine = false;
  std::string section;
  std::set<std::string> told;
  for (const std::string& line : Lines(Ask("preferences " + state + " operator --names --wmes"))) {
    const std::string trimmed = Trimmed(line);
    if (trimmed.starts_with("selection prob")) break;
    if (trimmed.ends_with(":") && trimmed.find('(') == std::string::npos) {
      section = trimmed.substr(0, trimmed.size() - 1);
      mine = false;
    } else if (trimmed.find(" (") != std::string::npos && !trimmed.starts_with("From")) {
      mine = trimmed.substr(0, trimmed.find(' ')) == selected.front().id;
      const std::string text =
          "    " + section + ": " +
          trimmed.substr(0, trimmed.find("  ") == std::string::npos ? std::string::npos : trimmed.find("  "));
      if (mine || section != "acceptables") lines.push_back(text);
      if (!mine && section == "acceptables")
        lines.push_back("    also proposed: " + trimmed.substr(0, trimmed.find(')') + 1));
    } else if (mine && trimmed.starts_with("From ")) {
      lines.push_back("      by rule " + trimmed.substr(5));
      if (!told.insert(trimmed).second) mine = false;
    } else if (mine && trimmed.starts_with("WME with time tag ")) {
      const std::string element = Trimmed(Ask("print " + trimmed.substr(18)));
      if (!element.empty() && element[0] == '(') lines.push_back("        " + element);
    }
  }
  return lines;
}

}  // namespace soarbox::sim
