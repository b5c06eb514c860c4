// SPDX-License-Identifier: BSD-2-Clause
#include "language/format_rules.h"

#include <algorithm>
#include <vector>

#include "debugger/syntax.h"

namespace soarbox::language {
namespace {

using debugger::Token;
using debugger::TokenKind;

constexpr std::size_t kIndent = 3;

std::string_view Trimmed(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r\f\v");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t\r\f\v") - begin + 1);
}

/// An open bracket or brace of a rule, and the column of its contents in the output.
struct Opened {
  char sign = '(';
  std::size_t column = 0;     ///< Of the bracket.
  std::size_t attribute = 0;  ///< Of the first attribute after it; 0: none yet.
};

class Formatter {
 public:
  explicit Formatter(std::string_view text) : text_(text), tokens_(debugger::Tokenize(text)) {}

  std::string Format() {
    for (std::size_t at = 0; at < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      TakeLine(at, end);
      at = end + 1;
    }
    while (made_.ends_with("\n\n")) made_.pop_back();
    return made_ == "\n" ? std::string() : std::move(made_);
  }

 private:
  /// Whether a place is in a token after its first character: a quotation that began in an earlier line.
  bool IsWithinToken(std::size_t at) {
    while (next_ < tokens_.size() && tokens_[next_].begin + tokens_[next_].length <= at) ++next_;
    return next_ < tokens_.size() && tokens_[next_].begin < at;
  }

  void TakeLine(std::size_t begin, std::size_t end) {
    const bool is_quoted = IsWithinToken(begin);
    std::string_view line = text_.substr(begin, end - begin);
    while (line.ends_with('\r')) line.remove_suffix(1);
    const bool ends_within = Ends(end);
    if (is_quoted) {
      made_ += line;
      Walk(begin, end, 0, begin);
    } else {
      const std::string_view words = Trimmed(line);
      if (words.empty()) {
        if (!made_.empty() && !made_.ends_with("\n\n")) made_ += '\n';
        return;
      }
      const std::size_t indent = IndentOf(words, line);
      made_.append(indent, ' ');
      const std::size_t first = static_cast<std::size_t>(words.data() - text_.data());
      made_ += ends_within ? text_.substr(first, end - first) : words;
      Walk(begin, end, indent, first);
    }
    while (ends_within && made_.ends_with('\r')) made_.pop_back();
    made_ += '\n';
  }

  /// Whether a quotation continues after the end of a line.
  bool Ends(std::size_t end) const {
    for (std::size_t i = next_; i < tokens_.size() && tokens_[i].begin < end; ++i)
      if (tokens_[i].begin + tokens_[i].length > end && tokens_[i].kind != TokenKind::kComment) return true;
    return false;
  }

  std::size_t IndentOf(std::string_view words, std::string_view line) const {
    if (opened_.empty() || !in_rule_) {
      const std::size_t was = line.find_first_not_of(" \t");
      const bool begins_rule =
          words.starts_with("sp ") || words.starts_with("gp ") || words.starts_with("sp{") || words.starts_with("gp{");
      return opened_.empty() && begins_rule ? 0 : was;
    }
    // Comments in the first column are unchanged: they are disabled lines.
    if (words.front() == '#' && line.front() == '#') return 0;
    const Opened& inner = opened_.back();
    if (words.starts_with("-->")) return 0;
    if (words.front() == '}') return opened_.size() == 1 ? 0 : inner.column;
    if (inner.sign == '{') {
      // A negated clause: its bracket is aligned with those of others.
      return opened_.size() == 1 ? kIndent : inner.column + 2;
    }
    if (words.front() == ')') return inner.column;
    if (inner.attribute == 0) return inner.column + kIndent;
    const bool negated = words.size() > 1 && words.front() == '-' && words[1] == '^';
    return negated && inner.attribute > 0 ? inner.attribute - 1 : inner.attribute;
  }

  /// Follows the brackets of a line. `first`: the beginning of its words, which are now at column `indent`.
  void Walk(std::size_t begin, std::size_t end, std::size_t indent, std::size_t first) {
    for (std::size_t i = next_; i < tokens_.size() && tokens_[i].begin < end; ++i) {
      const Token& token = tokens_[i];
      if (token.begin < begin) continue;
      const std::size_t column = token.begin >= first ? indent + token.begin - first : indent;
      const char sign = text_[token.begin];
      if (token.kind == TokenKind::kCommand && opened_.empty()) {
        const std::string_view word = text_.substr(token.begin, token.length);
        in_rule_ = word == "sp" || word == "gp";
      } else if (token.kind == TokenKind::kAttribute && !opened_.empty() && opened_.back().attribute == 0) {
        opened_.back().attribute = column;
      } else if (token.kind == TokenKind::kSign && (sign == '(' || sign == '{')) {
        opened_.push_back({sign, column, 0});
      } else if (token.kind == TokenKind::kSign && (sign == ')' || sign == '}')) {
        if (!opened_.empty()) opened_.pop_back();
      }
    }
  }

  std::string_view text_;
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
  std::vector<Opened> opened_;
  bool in_rule_ = false;
  std::string made_;
};

}  // namespace

std::string FormatRules(std::string_view text) {
  return Formatter(text).Format();
}

}  // namespace soarbox::language
