// SPDX-License-Identifier: BSD-2-Clause
#include "explain/rule_text.h"

#include <algorithm>
#include <cctype>

namespace soarbox::explain {
namespace {

bool IsBlank(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// Words, single brackets, and "-(" or "-{" as "-" before the bracket. |quoted words| stay whole.
std::vector<std::string> Tokens(std::string_view text) {
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (IsBlank(c)) {
      ++i;
    } else if (c == '(' || c == ')' || c == '{' || c == '}') {
      tokens.emplace_back(1, c);
      ++i;
    } else if (c == '-' && i + 1 < text.size() && (text[i + 1] == '^' || text[i + 1] == '(' || text[i + 1] == '{')) {
      tokens.emplace_back("-");
      ++i;
    } else {
      const std::size_t begin = i;
      bool quoted = false;
      while (i < text.size()) {
        if (text[i] == '|') quoted = !quoted;
        if (!quoted && (IsBlank(text[i]) || text[i] == '(' || text[i] == ')' || text[i] == '{' || text[i] == '}'))
          break;
        ++i;
      }
      tokens.emplace_back(text.substr(begin, i - begin));
      // A preference that takes away, told apart from a negation.
      if (tokens.back() == "-") tokens.back() = "--";
    }
  }
  return tokens;
}

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// The clauses of one side.
std::vector<RuleAttribute> ReadSide(const std::vector<std::string>& tokens) {
  std::vector<RuleAttribute> found;
  std::string id;
  bool in_clause = false, has_id = false, on_state = false, clause_negated = false, attribute_negated = false;
  int conjunction = 0, group_negations = 0;
  std::vector<bool> groups;
  std::vector<std::string> value;
  RuleAttribute current;
  bool has_attribute = false;
  bool attribute_in_braces = false;
  const auto finish = [&] {
    if (has_attribute) {
      current.removes = value.size() > 1 && value.back() == "--";
      current.value = Joined(value);
      found.push_back(current);
    }
    has_attribute = attribute_in_braces = false;
    value.clear();
  };
  bool minus = false;
  for (const std::string& token : tokens) {
    if (!in_clause) {
      if (token == "-") {
        minus = true;
        continue;
      }
      if (token == "{") {
        groups.push_back(minus);
        group_negations += minus ? 1 : 0;
      } else if (token == "}" && !groups.empty()) {
        group_negations -= groups.back() ? 1 : 0;
        groups.pop_back();
      } else if (token == "(") {
        in_clause = true;
        has_id = on_state = false;
        clause_negated = minus;
        id.clear();
      }
      minus = false;
      continue;
    }
    if (token == "(") {
      ++conjunction;  // A function call on the right-hand side.
      value.push_back(token);
    } else if (token == ")" && conjunction > 0) {
      --conjunction;
      value.push_back(token);
    } else if (token == ")") {
      finish();
      in_clause = false;
    } else if (token == "-") {
      finish();
      attribute_negated = true;
    } else if (token.size() > 1 && token[0] == '^') {
      finish();
      has_attribute = true;
      current = {id,       token.substr(1),
                 {},       clause_negated || attribute_negated || group_negations > 0,
                 on_state, clause_negated || group_negations > 0};
      attribute_negated = false;
    } else if (token == "^") {
      // ^{ <name> <> io }: no constant.
      finish();
      has_attribute = true;
      attribute_in_braces = true;
      current = {id,       "{}",
                 {},       clause_negated || attribute_negated || group_negations > 0,
                 on_state, clause_negated || group_negations > 0};
      attribute_negated = false;
    } else if (!has_id && token == "state") {
      on_state = true;
    } else if (!has_id && IsVariable(token)) {
      id = token;
      has_id = true;
    } else if (has_attribute) {
      if (attribute_in_braces) {
        if (token == "}") attribute_in_braces = false;
        continue;
      }
      value.push_back(token);
    }
  }
  return found;
}

/// The constants that a name test allows: one, those of << a b >>, or "" for anything else.
std::set<std::string> NamesOf(const std::string& value) {
  if (value.empty()) return {""};
  if (value.find("<<") != std::string::npos) {
    std::set<std::string> names;
    std::string_view rest = value;
    rest.remove_prefix(rest.find("<<") + 2);
    for (const std::string& token : Tokens(rest.substr(0, rest.find(">>")))) names.insert(token);
    return names;
  }
  const std::string first = FirstWord(value);
  if (IsVariable(first) || first == "{" || first == "<>" || first == "(") return {""};
  return {first};
}

/// Calls of functions in the actions, those within others, too.
std::vector<RuleCall> CallsIn(const std::vector<std::string>& actions) {
  std::vector<RuleCall> calls;
  std::vector<std::size_t> open;  // Brackets: the call that they belong to.
  constexpr std::size_t kClause = static_cast<std::size_t>(-1);
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const std::string& token = actions[i];
    if (token == ")") {
      if (!open.empty()) open.pop_back();
    } else if (token == "(") {
      if (!open.empty() && open.back() != kClause) calls[open.back()].arguments.push_back(token);
      const bool is_call = i + 1 < actions.size() && !IsVariable(actions[i + 1]);
      open.push_back(is_call ? calls.size() : kClause);
      if (is_call) calls.push_back({actions[++i], {}});
    } else if (!open.empty() && open.back() != kClause) {
      calls[open.back()].arguments.push_back(token);
    }
  }
  return calls;
}

void Classify(RuleText& rule) {
  std::set<std::string> outputs;
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.attribute == "output-link" && !condition.negated) outputs.insert(FirstWord(condition.value));
  }
  for (const RuleAttribute& action : rule.actions) {
    if (outputs.contains(action.id) && !action.value.ends_with("-")) rule.says.insert(action.attribute);
    if (action.attribute != "operator" || action.value.find('+') == std::string::npos) continue;
    const std::string id = FirstWord(action.value);
    bool named = false;
    for (const RuleAttribute& name : rule.actions) {
      if (name.id != id || name.attribute != "name") continue;
      const std::set<std::string> names = NamesOf(name.value);
      rule.proposes.insert(names.begin(), names.end());
      named = true;
    }
    if (!named) rule.proposes.insert("");
  }
  std::set<std::string> states;
  for (const RuleAttribute& condition : rule.conditions)
    if (condition.on_state) states.insert(condition.id);
  for (const RuleAttribute& condition : rule.conditions) {
    if (condition.attribute != "operator" || condition.negated) continue;
    if (condition.value.ends_with(" +") || condition.value == "+") continue;
    const bool is_above = !states.contains(condition.id) && !rule.proposes.empty();
    std::set<std::string>& tested = is_above ? rule.works_on : rule.applies;
    const std::string id = FirstWord(condition.value);
    bool named = false;
    for (const RuleAttribute& name : rule.conditions) {
      if (name.id != id || name.attribute != "name" || name.negated) continue;
      const std::set<std::string> names = NamesOf(name.value);
      tested.insert(names.begin(), names.end());
      named = true;
    }
    if (!named) tested.insert("");
  }
}

}  // namespace

bool IsIdentifier(std::string_view value) {
  return value.size() > 1 && std::isupper(static_cast<unsigned char>(value[0])) != 0 &&
         value.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

std::string FirstWord(const std::string& value) {
  return value.substr(0, value.find(' '));
}

bool IsVariable(std::string_view word) {
  return word.size() > 2 && word.front() == '<' && word.back() == '>' && word[1] != '<' && word != "<=>";
}

std::vector<std::string> VariablesIn(std::string_view text) {
  std::vector<std::string> found;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    std::size_t end = at + 1;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '-' ||
                                 text[end] == '_' || text[end] == '*'))
      ++end;
    if (end > at + 1 && end < text.size() && text[end] == '>') found.emplace_back(text.substr(at, end + 1 - at));
  }
  return found;
}

bool IsMadeUpVariable(std::string_view variable) {
  const std::size_t star = variable.rfind('*');
  return star != std::string_view::npos && star + 2 < variable.size() &&
         variable.find_first_not_of("0123456789", star + 1) == variable.size() - 1;
}

bool IsElaboration(const RuleText& rule) {
  if (rule.support != RuleSupport::kByConditions) return rule.support == RuleSupport::kISupport;
  return std::ranges::none_of(rule.conditions, [&](const RuleAttribute& condition) {
    if (condition.attribute != "operator" || condition.negated || condition.value.ends_with('+')) return false;
    // Below an operator of the state above, a rule elaborates its own state.
    const auto path = rule.paths.find(condition.id);
    return path == rule.paths.end() || path->second.empty();
  });
}

bool IsConstantAttribute(std::string_view attribute) {
  return !attribute.empty() && attribute[0] != '<' && attribute[0] != '{' && attribute[0] != '>' && attribute[0] != '=';
}

bool IsArchitectureAttribute(std::string_view attribute) {
  static const std::set<std::string_view> known = {
      "superstate", "io", "input-link", "output-link", "operator", "type", "name", "attribute", "choices", "impasse",
      "quiescence", "record", "params", "child", "item", "item-count", "non-numeric", "non-numeric-count",
      "reward-link", "smem", "epmem", "command", "result", "svs", "status", "reason", "parameter", "progress", "reward",
      "value", "present-id", "spatial-scene",
      // What memories answer.
      "retrieved", "success", "failure", "bad-cmd", "memory-id", "match-score", "cue-size", "normalized-match-score",
      "match-cardinality", "graph-match", "mapping", "node", "cue"};
  return known.contains(attribute);
}

bool TestsWhatWasRecalled(const RuleText& rule) {
  return std::ranges::any_of(rule.conditions, [](const RuleAttribute& one) { return one.attribute == "retrieved"; });
}

std::string BlankComments(std::string text) {
  bool quoted = false, comment = false;
  for (char& c : text) {
    if (c == '\n') comment = quoted = false;
    if (comment) {
      c = ' ';
    } else if (c == '|') {
      quoted = !quoted;
    } else if (c == '#' && !quoted) {
      comment = true;
      c = ' ';
    }
  }
  return text;
}

std::vector<RuleAttribute> ReadConditions(std::string_view text) {
  return ReadSide(Tokens(text));
}

namespace {

PathMap VariablePaths(const RuleText& rule) {
  PathMap paths;
  for (const RuleAttribute& condition : rule.conditions)
    if (condition.on_state) paths.try_emplace(condition.id);
  for (bool grows = true; grows;) {
    grows = false;
    for (const RuleAttribute& condition : rule.conditions) {
      const auto from = paths.find(condition.id);
      if (from == paths.end()) continue;
      // <x>, or { <x> <> ... }: a variable behind a relation is bound elsewhere.
      std::string first = condition.value.substr(condition.value.starts_with("{ ") ? 2 : 0);
      first = first.substr(0, first.find(' '));
      if (!IsVariable(first)) continue;
      std::vector<std::string> path = from->second;
      path.push_back(condition.attribute);
      grows |= paths.try_emplace(first, std::move(path)).second;
    }
  }
  return paths;
}

}  // namespace

std::vector<RuleText> ReadRules(std::string_view text) {
  std::vector<RuleText> rules;
  constexpr std::string_view kBegin = "sp {";
  std::size_t at = 0;
  while ((at = text.find(kBegin, at)) != std::string_view::npos) {
    if (at > 0 && text[at - 1] != '\n') {
      at += kBegin.size();
      continue;
    }
    at += kBegin.size();
    std::size_t end = text.find("\n}", at);
    if (end == std::string_view::npos) end = text.size();
    const std::string_view body = text.substr(at, end - at);
    at = end;
    RuleText rule;
    const std::size_t name_end = std::min(body.find_first_of(" \n\t"), body.size());
    rule.name = body.substr(0, name_end);
    const std::size_t arrow = body.find("-->");
    if (arrow == std::string_view::npos) continue;
    const std::vector<std::string> tests = Tokens(body.substr(name_end, arrow - name_end));
    rule.conditions = ReadSide(tests);
    for (const std::string& token : tests) {
      if (token == "(" || token == "{" || token == "-") break;
      if (token == ":o-support") rule.support = RuleSupport::kOSupport;
      if (token == ":i-support") rule.support = RuleSupport::kISupport;
    }
    const std::vector<std::string> actions = Tokens(body.substr(arrow + 3));
    rule.actions = ReadSide(actions);
    rule.acts = !actions.empty();
    rule.all_calls = CallsIn(actions);
    for (const RuleCall& call : rule.all_calls) {
      rule.calls.insert(call.function);
      // A function that is not built in is printed as the first argument of exec.
      if (call.function == "exec" && !call.arguments.empty()) rule.calls.insert("exec " + call.arguments.front());
    }
    Classify(rule);
    rule.paths = VariablePaths(rule);
    rules.push_back(std::move(rule));
  }
  return rules;
}

}  // namespace soarbox::explain
