// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/lexer.h"

#include <charconv>
#include <utility>

#include "kernel/base/characters.h"

namespace soarbox::kernel {

namespace {

constexpr std::pair<std::string_view, TokenKind> kSigns[] = {
    {"+", TokenKind::kPlus},           {"-", TokenKind::kMinus},         {"=", TokenKind::kEqual},
    {"<", TokenKind::kLess},           {">", TokenKind::kGreater},       {"<=", TokenKind::kLessOrEqual},
    {">=", TokenKind::kGreaterOrEqual}, {"<>", TokenKind::kNotEqual},    {"<=>", TokenKind::kSameType},
    {"<<", TokenKind::kLeftAngles},    {">>", TokenKind::kRightAngles},  {"-->", TokenKind::kArrow},
    {"&", TokenKind::kAmpersand},
};

TokenKind SingleCharacterKind(char c) {
  switch (c) {
    case '(': return TokenKind::kLeftParen;
    case ')': return TokenKind::kRightParen;
    case '{': return TokenKind::kLeftBrace;
    case '}': return TokenKind::kRightBrace;
    case '^': return TokenKind::kUpArrow;
    case '!': return TokenKind::kExclamation;
    case '~': return TokenKind::kTilde;
    case '.': return TokenKind::kPeriod;
    case ',': return TokenKind::kComma;
    default: return TokenKind::kEnd;
  }
}

bool IsSignOrDigits(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
    text.remove_prefix(1);
  }
  for (const char c : text) {
    if (!IsDigit(c)) {
      return false;
    }
  }
  return true;
}

/// What Soar takes for a float: a sign, digits, a dot, digits, an `e`, a sign, digits; all but the dot may be missing.
bool ReadsAsFloat(std::string_view text) {
  std::size_t i = 0;
  const auto skip_sign = [&] { i += i < text.size() && (text[i] == '+' || text[i] == '-') ? 1 : 0; };
  const auto skip_digits = [&] {
    while (i < text.size() && IsDigit(text[i])) {
      ++i;
    }
  };
  skip_sign();
  skip_digits();
  if (i == text.size() || text[i] != '.') {
    return false;
  }
  ++i;
  skip_digits();
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    skip_sign();
    skip_digits();
  }
  return i == text.size();
}

/// Numbers too large to hold are 0 and give a warning, as in Soar.
template <typename Number>
void ReadNumber(std::string_view text, Number& number, std::string& warning, const char* message) {
  if (!text.empty() && text[0] == '+') {
    text.remove_prefix(1);
  }
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec == std::errc::result_out_of_range) {
    number = 0;
    warning = message;
  } else if (result.ec != std::errc()) {
    number = 0;
  }
}

std::string NormalIdentifier(std::string_view text) {
  std::string out(1, ToUpper(text[0]));
  text.remove_prefix(1);
  while (text.size() > 1 && text[0] == '0') {
    text.remove_prefix(1);
  }
  return out.append(text);
}

}  // namespace

void Lexer::Step() {
  if (text_[at_] == '\n') {
    ++line_;
    column_ = 1;
  } else {
    ++column_;
  }
  ++at_;
}

void Lexer::SkipBlanks() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '#') {
      while (at_ < text_.size() && text_[at_] != '\n') {
        Step();
      }
    } else if (IsConstituent(c) || c == '|' || c == '"' || SingleCharacterKind(c) != TokenKind::kEnd) {
      return;
    } else {
      Step();
    }
    after_name_ = false;
  }
}

Token Lexer::Finish(Token token, std::size_t end) {
  token.offset = at_;
  token.length = end - at_;
  token.line = line_;
  token.column = column_;
  while (at_ < end) {
    Step();
  }
  after_name_ = token.kind == TokenKind::kString || token.kind == TokenKind::kVariable ||
                token.kind == TokenKind::kIdentifier;
  return token;
}

Token Lexer::Next() {
  SkipBlanks();
  if (at_ >= text_.size()) {
    return Finish({}, at_);
  }
  const char c = text_[at_];
  if (c == '|') {
    return ReadBarred();
  }
  if (c == '"') {
    return ReadQuoted();
  }
  if (c == '@') {
    const bool with_sign = WordEnd(at_) - at_ == 2 && (text_[at_ + 1] == '+' || text_[at_ + 1] == '-');
    Token token;
    token.kind = !with_sign ? TokenKind::kAt : text_[at_ + 1] == '+' ? TokenKind::kAtPlus : TokenKind::kAtMinus;
    token.text.push_back('@');
    if (with_sign) {
      token.text.push_back(text_[at_ + 1]);
    }
    return Finish(std::move(token), at_ + (with_sign ? 2 : 1));
  }
  const bool starts_float = c == '.' && !after_name_ && at_ + 1 < text_.size() && IsDigit(text_[at_ + 1]);
  if (SingleCharacterKind(c) != TokenKind::kEnd && !starts_float) {
    Token token;
    token.kind = SingleCharacterKind(c);
    token.text = c;
    return Finish(std::move(token), at_ + 1);
  }
  return ReadWord();
}

Token Lexer::ReadBarred() {
  Token token;
  token.kind = TokenKind::kString;
  std::size_t i = at_ + 1;
  for (; i < text_.size() && text_[i] != '|'; ++i) {
    if (text_[i] == '\\' && i + 1 < text_.size()) {
      ++i;
    }
    token.text += text_[i];
  }
  if (i >= text_.size()) {
    token.kind = TokenKind::kUnclosed;
    token.warning = "Error:  opening '|' without closing '|'\n";
    return Finish(std::move(token), text_.size());
  }
  return Finish(std::move(token), i + 1);
}

Token Lexer::ReadQuoted() {
  Token token;
  token.kind = TokenKind::kQuoted;
  std::size_t i = at_ + 1;
  for (; i < text_.size() && text_[i] != '"'; ++i) {
    if (text_[i] == '\\' && i + 1 < text_.size()) {
      ++i;
    }
    token.text += text_[i];
  }
  if (i >= text_.size()) {
    token.kind = TokenKind::kUnclosed;
    token.warning = "Error:  opening '\"' without closing '\"'\n";
    return Finish(std::move(token), text_.size());
  }
  return Finish(std::move(token), i + 1);
}

std::size_t Lexer::WordEnd(std::size_t from) const {
  while (from < text_.size() && IsConstituent(text_[from])) {
    ++from;
  }
  return from;
}

Token Lexer::ReadWord() {
  Token token;
  std::size_t end = WordEnd(at_);
  // A number may go on behind a dot; if that does not make a float, the dot is a token of its own.
  if (end < text_.size() && text_[end] == '.' && IsSignOrDigits(text_.substr(at_, end - at_))) {
    const std::size_t float_end = WordEnd(end + 1);
    const std::string_view candidate = text_.substr(at_, float_end - at_);
    if (ReadsAsFloat(candidate)) {
      token.kind = TokenKind::kFloat;
      token.text = candidate;
      ReadNumber(candidate, token.real, token.warning, "Error: bad floating point number\n");
      return Finish(std::move(token), float_end);
    }
    if (end == at_) {
      token.kind = TokenKind::kPeriod;
      token.text = ".";
      return Finish(std::move(token), at_ + 1);
    }
  }
  const std::string_view word = text_.substr(at_, end - at_);
  token.text = word;
  for (const auto& [sign, kind] : kSigns) {
    if (word == sign) {
      token.kind = kind;
      return Finish(std::move(token), end);
    }
  }
  if (LooksLikeVariable(word)) {
    token.kind = TokenKind::kVariable;
  } else if (LooksLikeInteger(word)) {
    token.kind = TokenKind::kInteger;
    ReadNumber(word, token.integer, token.warning, "Error: bad integer (probably too large)\n");
  } else if (LooksLikeIdentifier(word)) {
    token.kind = TokenKind::kIdentifier;
    token.text = NormalIdentifier(word);
  } else {
    token.kind = TokenKind::kString;
    if (word.front() == '<' || word.back() == '>') {
      token.warning.append("Warning: Suspicious string constant \"").append(word).append("\"\n");
    }
  }
  return Finish(std::move(token), end);
}

}  // namespace soarbox::kernel
