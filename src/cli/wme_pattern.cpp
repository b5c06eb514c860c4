// SPDX-License-Identifier: BSD-2-Clause
#include "cli/wme_pattern.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "cli/lookup.h"

namespace soarbox::cli {
namespace {

using kernel::Agent;
using kernel::Symbol;
using kernel::Wme;
using kernel::WmeId;

/// Splits a pattern into words: parentheses and ^ are separate words, |bars| and "quotes" may contain blanks.
class PatternLexer {
 public:
  explicit PatternLexer(std::string_view text) : text_(text) {}

  /// The next word; empty at the end.
  std::string Next() {
    while (position_ < text_.size() &&
           (text_[position_] == ' ' || text_[position_] == '\t' || text_[position_] == '\n')) {
      ++position_;
    }
    if (position_ == text_.size()) return {};
    const char first = text_[position_];
    if (first == '(' || first == ')' || first == '^') {
      ++position_;
      return std::string(1, first);
    }
    const std::size_t start = position_;
    if (first == '|' || first == '"') {
      ++position_;
      while (position_ < text_.size() && text_[position_] != first) position_ += text_[position_] == '\\' ? 2 : 1;
      position_ = std::min(position_ + 1, text_.size());
      return std::string(text_.substr(start, position_ - start));
    }
    while (position_ < text_.size() && std::string_view(" \t\n()^").find(text_[position_]) == std::string_view::npos) {
      ++position_;
    }
    return std::string(text_.substr(start, position_ - start));
  }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
};

/// Parses a field; false if the word is not allowed there or names nothing that exists.
bool ReadPatternField(Agent& agent, const std::string& word, Symbol& field) {
  if (word == "*") return true;
  if (word.empty() || word == ")" || word == "(" || word == "^" || word.front() == '@') return false;
  if (word.front() != '|' && word.front() != '"') {
    if (IsContextVariable(word) || ParseIdentifierName(word)) {
      field = FindIdentifier(agent, word);
      // An identifier that does not exist may be the name of a constant.
      if (!field && !IsContextVariable(word)) field = MakeConstant(agent, word);
      return static_cast<bool>(field);
    }
    field = MakeConstant(agent, word);
    return true;
  }
  field = MakeConstant(agent, word.front() == '"' ? "|" + word.substr(1, word.size() - 2) + "|" : word);
  return true;
}

bool IsVariable(const std::string& word) {
  return word.size() > 2 && word.front() == '<' && word.back() == '>' && !IsContextVariable(word);
}

}  // namespace

WmePattern ParseWmePattern(Agent& agent, std::string_view text) {
  WmePattern pattern;
  PatternLexer lexer(text);
  const std::string first = lexer.Next();
  if (first != "(") {
    pattern.error = "Expected '(' to begin wme pattern not string '" + first + "' or char ' '\n";
    return pattern;
  }
  const auto read = [&](Symbol& field) {
    const std::string word = lexer.Next();
    if (IsVariable(word)) {
      pattern.error = "Expected identifier (or context variable)\n";
    } else if (!ReadPatternField(agent, word, field)) {
      pattern.error = IsContextVariable(word) ? "There is no current " + word + ".\n"
                                              : "Expected identifier or constant in wme pattern\n";
    }
    return pattern.error.empty();
  };
  if (!read(pattern.id)) return pattern;
  if (lexer.Next() != "^") {
    pattern.error = "Expected ^ in wme pattern\n";
    return pattern;
  }
  if (!read(pattern.attribute) || !read(pattern.value)) return pattern;
  std::string last = lexer.Next();
  if (last == "+") {
    pattern.acceptable = true;
    last = lexer.Next();
  }
  if (last != ")") pattern.error = "Expected ')' to end wme pattern\n";
  return pattern;
}

bool Matches(const WmePattern& pattern, const Wme& wme) {
  return wme.live && wme.acceptable == pattern.acceptable && (!pattern.id || pattern.id == wme.id) &&
         (!pattern.attribute || pattern.attribute == wme.attribute) && (!pattern.value || pattern.value == wme.value);
}

std::vector<WmeId> FindWmes(const Agent& agent, const WmePattern& pattern, bool by_object) {
  const kernel::WorkingMemory& memory = agent.memory();
  std::vector<WmeId> found;
  for (std::uint32_t i = 0; i < memory.wmes().size(); ++i) {
    if (Matches(pattern, memory.wmes()[i])) found.push_back(static_cast<WmeId>(i));
  }
  std::sort(found.begin(), found.end(), [&](WmeId a, WmeId b) {
    const std::uint32_t object_a = by_object ? memory.wme(a).id.index() : 0;
    const std::uint32_t object_b = by_object ? memory.wme(b).id.index() : 0;
    return std::pair(object_a, ArrivalOf(agent.rete(), a)) < std::pair(object_b, ArrivalOf(agent.rete(), b));
  });
  return found;
}

}  // namespace soarbox::cli
