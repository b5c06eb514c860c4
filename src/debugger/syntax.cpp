// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/syntax.h"

#include <cctype>

namespace soarbox::debugger {
namespace {

bool IsBlankLetter(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool IsDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool IsNumber(std::string_view word) {
  std::size_t i = !word.empty() && (word[0] == '+' || word[0] == '-') ? 1 : 0;
  bool digits = false;
  for (; i < word.size(); ++i) {
    if (IsDigit(word[i])) {
      digits = true;
    } else if ((word[i] == 'e' || word[i] == 'E') && digits && i + 1 < word.size()) {
      if (word[i + 1] == '+' || word[i + 1] == '-') ++i;
    } else if (word[i] != '.') {
      return false;
    }
  }
  return digits;
}

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : text_(text) {}

  std::vector<Token> Read() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (IsBlankLetter(c)) {
        ++at_;
      } else if (c == '#') {
        Add(TokenKind::kComment, LineEnd());
      } else if (c == '|') {
        Add(TokenKind::kQuoted, Closing('|'));
      } else if (c == '"') {
        Add(TokenKind::kQuoted, Closing('"'));
      } else if (text_.substr(at_).starts_with("-->")) {
        Add(TokenKind::kArrow, at_ + 3);
      } else if (c == '^') {
        Add(TokenKind::kAttribute, AttributeEnd());
      } else if (const std::size_t variable = VariableEnd(at_); variable != at_) {
        Add(TokenKind::kVariable, variable);
      } else if (IsSign(c) || (c == '-' && !NumberFollows()) || (c == '+' && !NumberFollows())) {
        ReadSign();
      } else {
        ReadWord();
      }
    }
    return std::move(tokens_);
  }

 private:
  static bool IsSign(char c) {
    return c == '(' || c == ')' || c == '{' || c == '}' || c == '<' || c == '>' || c == '=' || c == '!' || c == '~' ||
           c == '&' || c == ',' || c == ';' || c == '@';
  }

  void Add(TokenKind kind, std::size_t end) {
    tokens_.push_back({kind, at_, end - at_});
    at_ = end;
  }

  std::size_t LineEnd() const {
    const std::size_t end = text_.find('\n', at_);
    return end == std::string_view::npos ? text_.size() : end;
  }

  /// Position after the sign that closes the token that begins here.
  std::size_t Closing(char sign) const {
    for (std::size_t i = at_ + 1; i < text_.size(); ++i) {
      if (text_[i] == '\\') {
        ++i;
      } else if (text_[i] == sign) {
        return i + 1;
      }
    }
    return text_.size();
  }

  /// Position after a variable that begins here; `begin` if there is none.
  std::size_t VariableEnd(std::size_t begin) const {
    if (begin >= text_.size() || text_[begin] != '<') return begin;
    std::size_t i = begin + 1;
    const auto is_inner = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
             std::string_view("-_*$%&?/:+").find(c) != std::string_view::npos;
    };
    while (i < text_.size() && is_inner(text_[i])) ++i;
    return i > begin + 1 && i < text_.size() && text_[i] == '>' ? i + 1 : begin;
  }

  bool NumberFollows() const { return at_ + 1 < text_.size() && IsDigit(text_[at_ + 1]); }

  /// Includes parts after dots: ^color.shade.
  std::size_t AttributeEnd() const {
    std::size_t i = at_ + 1;
    while (i < text_.size()) {
      if (text_[i] == '|') {
        std::size_t close = i + 1;
        while (close < text_.size() && text_[close] != '|') ++close;
        i = close == text_.size() ? close : close + 1;
      } else if (const std::size_t variable = VariableEnd(i); variable != i) {
        i = variable;
      } else if (IsBlankLetter(text_[i]) || IsSign(text_[i])) {
        break;
      } else {
        ++i;
      }
    }
    return i;
  }

  void ReadSign() {
    const char c = text_[at_];
    std::size_t end = at_ + 1;
    if (c == '{') {
      ++depth_;
    } else if (c == '}') {
      depth_ = depth_ > 0 ? depth_ - 1 : 0;
      if (depth_ == 0) in_rule_ = expects_name_ = false;
    } else if (c == '<' || c == '>' || c == '=') {
      while (end < text_.size() && (text_[end] == '<' || text_[end] == '>' || text_[end] == '=') &&
             VariableEnd(end) == end)
        ++end;
    }
    Add(TokenKind::kSign, end);
  }

  void ReadWord() {
    std::size_t end = at_ + 1;
    while (end < text_.size() && !IsBlankLetter(text_[end]) && !IsSign(text_[end]) && text_[end] != '"' &&
           text_[end] != '^')
      ++end;
    const std::string_view word = text_.substr(at_, end - at_);
    TokenKind kind = TokenKind::kConstant;
    if (expects_name_ && depth_ == 1) {
      kind = TokenKind::kRuleName;
      expects_name_ = false;
    } else if (depth_ == 0 && BeginsLine()) {
      kind = TokenKind::kCommand;
      in_rule_ = expects_name_ = word == "sp" || word == "gp" || word == "explain-sp";
    } else if (IsNumber(word)) {
      kind = TokenKind::kNumber;
    } else if (in_rule_ && (word[0] == ':' || ((word == "state" || word == "impasse") && AfterBracket()))) {
      kind = TokenKind::kKeyword;
    }
    Add(kind, end);
  }

  bool BeginsLine() const {
    for (std::size_t i = at_; i > 0 && text_[i - 1] != '\n'; --i)
      if (!IsBlankLetter(text_[i - 1]) && text_[i - 1] != ';') return false;
    return true;
  }

  bool AfterBracket() const {
    return !tokens_.empty() && tokens_.back().kind == TokenKind::kSign && text_[tokens_.back().begin] == '(';
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;  ///< Nesting depth of braces.
  bool in_rule_ = false, expects_name_ = false;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> Tokenize(std::string_view text) {
  return Tokenizer(text).Read();
}

std::string_view NameOf(TokenKind kind) {
  constexpr std::string_view kNames[] = {"comment",  "command", "rule-name", "keyword", "variable", "attribute",
                                         "constant", "number",  "quoted",    "arrow",   "sign"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace soarbox::debugger
