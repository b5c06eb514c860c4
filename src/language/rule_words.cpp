// SPDX-License-Identifier: BSD-2-Clause
#include "language/rule_words.h"

#include <algorithm>
#include <optional>

#include "debugger/syntax.h"

namespace soarbox::language {
namespace {

using debugger::Token;
using debugger::TokenKind;

std::string WithoutBars(std::string_view text) {
  if (text.size() > 1 && text.front() == '|' && text.back() == '|') text = text.substr(1, text.size() - 2);
  return std::string(text);
}

/// The contents of a parenthesis.
struct Clause {
  std::string head;                         ///< Its variable; empty: a function, or not typed yet.
  std::string attribute;                    ///< The last part of the attribute of its next values.
  std::string steps;                        ///< All parts of it.
  std::optional<std::size_t> last_of_path;  ///< The word of the last part.
};

/// The object of a variable can be reached from another variable's by these attributes.
struct Edge {
  std::string from, steps;
};

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  RuleWords Read() {
    for (const Token& token : debugger::Tokenize(text_)) Take(token);
    FindPaths();
    for (std::size_t i = 0; i < rule_.words.size(); ++i) {
      Word& word = rule_.words[i];
      word.path = word.kind == WordKind::kVariable ? PathOf(word.text) : Join(PathOf(heads_[i]), steps_[i]);
    }
    return std::move(rule_);
  }

 private:
  static std::string Join(const std::string& path, const std::string& steps) {
    return path.empty() || steps.empty() ? path + steps : path + "." + steps;
  }

  void Add(WordKind kind, Span span, std::string text, const std::string& head, std::string steps) {
    Word word;
    word.kind = kind;
    word.span = span;
    word.text = std::move(text);
    word.in_actions = rule_.arrow != std::string::npos;
    word.negated = kind == WordKind::kAttribute && negated_;
    rule_.words.push_back(std::move(word));
    heads_.push_back(head);
    steps_.push_back(std::move(steps));
  }

  void Take(const Token& token) {
    const std::string_view text = text_.substr(token.begin, token.length);
    const Span span{token.begin, token.begin + token.length};
    if (TakeTest(token.kind, text, span)) return;
    switch (token.kind) {
      case TokenKind::kComment:
      case TokenKind::kCommand:
        return;
      case TokenKind::kRuleName:
        if (!rule_.name.empty()) return;
        rule_.name = text;
        rule_.name_span = span;
        return Add(WordKind::kRuleName, span, rule_.name, "", "");
      case TokenKind::kArrow:
        rule_.arrow = token.begin;
        clauses_.clear();
        opened_ = false;
        return;
      case TokenKind::kKeyword:
        if (text == "state" || text == "impasse") opens_state_ = true;
        return;
      case TokenKind::kVariable:
        return TakeVariable(std::string(text), span);
      case TokenKind::kAttribute:
        return TakeAttribute(text, span);
      case TokenKind::kSign:
        return TakeSign(text);
      case TokenKind::kConstant:
      case TokenKind::kNumber:
      case TokenKind::kQuoted:
        return TakeConstant(text, span);
    }
  }

  /// Handles a test in the place of an attribute: ^{ << a b >> <way> }, ^<< a b >>. Returns whether the token is part
  /// of one.
  bool TakeTest(TokenKind kind, std::string_view text, Span span) {
    if (!awaits_test_ && test_depth_ == 0) return false;
    awaits_test_ = false;
    if (kind == TokenKind::kArrow || text == "(" || text == ")") {
      test_depth_ = 0;  // It is being typed.
      return false;
    }
    if (text == "{" || text == "<<") ++test_depth_;
    if (text == "}" || text == ">>") --test_depth_;
    test_end_ = span.end;
    Clause& clause = clauses_.back();
    if (kind == TokenKind::kVariable) Add(WordKind::kVariable, span, std::string(text), clause.head, clause.steps);
    if (kind == TokenKind::kConstant || kind == TokenKind::kQuoted || kind == TokenKind::kNumber) {
      // Each of the choices is a possible attribute.
      const std::string above = clause.steps.substr(0, clause.steps.rfind('.') + 1);
      Add(WordKind::kAttribute, span, WithoutBars(text), clause.head, above + WithoutBars(text));
    }
    return true;
  }

  void TakeSign(std::string_view text) {
    if (text == "(") {
      clauses_.emplace_back();
      opened_ = true;
      opens_state_ = false;
    } else if (text == ")") {
      if (!clauses_.empty()) clauses_.pop_back();
      opened_ = false;
    }
    negated_ = text == "-";
  }

  void TakeVariable(const std::string& name, Span span) {
    if (opened_) {
      opened_ = false;
      clauses_.back().head = name;
      rule_.heads.insert(span.begin);
      if (opens_state_) states_.push_back(name);
      return Add(WordKind::kVariable, span, name, name, "");
    }
    if (!clauses_.empty() && !clauses_.back().head.empty() && !clauses_.back().steps.empty())
      edges_.try_emplace(name, Edge{clauses_.back().head, clauses_.back().steps});
    Add(WordKind::kVariable, span, name, name, "");
  }

  void TakeAttribute(std::string_view text, Span span) {
    opened_ = false;
    if (clauses_.empty()) clauses_.emplace_back();
    clauses_.back().steps.clear();
    TakeSteps(text, span);
    negated_ = false;
  }

  /// "^io.input-link", or ".content" after a test of an attribute.
  void TakeSteps(std::string_view text, Span span) {
    Clause& clause = clauses_.back();
    std::size_t at = 1;
    while (at <= text.size()) {
      std::size_t end = at;
      bool barred = false;
      while (end < text.size() && (barred || text[end] != '.')) {
        if (text[end] == '|') barred = !barred;
        ++end;
      }
      const std::string_view part = text.substr(at, end - at);
      const Span place{span.begin + at, span.begin + end};
      const bool is_variable = part.size() > 2 && part.front() == '<' && part.back() == '>';
      const bool is_test = part.empty() && TestFollows(span.end);
      clause.steps += (clause.steps.empty() ? "" : ".") + std::string(is_variable || is_test ? "*" : WithoutBars(part));
      if (is_test) {
        awaits_test_ = true;  // Its words follow.
      } else if (is_variable) {
        Add(WordKind::kVariable, place, std::string(part), clause.head, clause.steps);
      } else {
        Add(WordKind::kAttribute, place, WithoutBars(part), clause.head, clause.steps);
      }
      at = end + 1;
    }
  }

  /// Whether the next token is { or <<.
  bool TestFollows(std::size_t at) const {
    at = text_.find_first_not_of(" \t\r\n", at);
    return at != std::string_view::npos && (text_[at] == '{' || text_.substr(at).starts_with("<<"));
  }

  void TakeConstant(std::string_view text, Span span) {
    if (opened_ && rule_.arrow != std::string::npos) {
      opened_ = false;
      return Add(WordKind::kFunction, span, std::string(text), "", "");
    }
    opened_ = false;
    if (span.begin == test_end_ && text.starts_with('.')) return TakeSteps(text, span);
    if (text.starts_with('"') || clauses_.empty() || clauses_.back().steps.empty()) return;
    Add(WordKind::kValue, span, WithoutBars(text), clauses_.back().head, clauses_.back().steps);
  }

  void FindPaths() {
    for (const std::string& state : states_) rule_.paths.try_emplace(state, "");
    // Each iteration follows the edges by one more step.
    for (bool found = true; found;) {
      found = false;
      for (const auto& [variable, edge] : edges_) {
        if (rule_.paths.contains(variable)) continue;
        const auto from = rule_.paths.find(edge.from);
        if (from == rule_.paths.end() || from->second.size() > kLongestPath) continue;
        rule_.paths.emplace(variable, Join(from->second, edge.steps));
        found = true;
      }
    }
  }

  std::string PathOf(const std::string& variable) const {
    if (variable.empty()) return {};
    const auto known = rule_.paths.find(variable);
    return known == rule_.paths.end() ? variable : known->second;
  }

  static constexpr std::size_t kLongestPath = 500;

  std::string_view text_;
  RuleWords rule_;
  std::vector<std::string> heads_, steps_;  ///< Of the words.
  std::vector<Clause> clauses_;
  std::vector<std::string> states_;
  std::map<std::string, Edge> edges_;
  bool opened_ = false, opens_state_ = false, negated_ = false;
  bool awaits_test_ = false;                       ///< An attribute that is a test has begun.
  int test_depth_ = 0;                             ///< Number of its open { and <<.
  std::size_t test_end_ = std::string_view::npos;  ///< The end of it.
};

bool BeginsRule(std::string_view line) {
  if (!line.starts_with("sp") && !line.starts_with("gp")) return false;
  line.remove_prefix(2);
  const std::size_t at = line.find_first_not_of(" \t\r");
  return at == std::string_view::npos ? !line.empty() : line[at] == '{';
}

}  // namespace

bool IsOperatorName(const Word& word) {
  return word.kind == WordKind::kValue && (word.path == "operator.name" || word.path.ends_with(".operator.name") ||
                                           word.path == "name" || word.path == "superstate.name");
}

RuleWords ReadWords(std::string_view rule) {
  return Reader(rule).Read();
}

std::vector<Span> SplitAtRules(std::string_view text) {
  std::vector<Span> parts;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (BeginsRule(text.substr(at, end - at))) {
      if (!parts.empty()) parts.back().end = at;
      parts.push_back({at, text.size()});
    }
    at = end + 1;
  }
  return parts;
}

}  // namespace soarbox::language
