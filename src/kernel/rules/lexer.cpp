// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/lexer.h"

#include <algorithm>
#include <array>

#include "diagnostics/number_from_chars.h"
#include "kernel/base/characters.h"

namespace soarbox::kernel {

namespace {

struct CharacterTable {
  std::array<bool, 256> word{};  ///< Characters of symbols that are written without bars.
  /// The kind of a token with this first character: the kind of a single-character sign that ends words, kString for
  /// words, kQuoted for texts between two delimiters, kEnd for blanks and comments.
  std::array<TokenKind, 256> first{};

  constexpr bool InWord(char c) const { return word[static_cast<unsigned char>(c)]; }
  constexpr TokenKind First(char c) const { return first[static_cast<unsigned char>(c)]; }
};

constexpr CharacterTable kCharacters = [] {
  CharacterTable table;
  for (std::size_t n = 0; n < 256; ++n) {
    table.word[n] = IsConstituent(static_cast<char>(n));
    table.first[n] = table.word[n] ? TokenKind::kString : TokenKind::kEnd;
  }
  constexpr std::pair<char, TokenKind> kOthers[] = {
      {'(', TokenKind::kLeftParen},  {')', TokenKind::kRightParen}, {'{', TokenKind::kLeftBrace},
      {'}', TokenKind::kRightBrace}, {'^', TokenKind::kUpArrow},    {'!', TokenKind::kExclamation},
      {'~', TokenKind::kTilde},      {'.', TokenKind::kPeriod},     {',', TokenKind::kComma},
      {'@', TokenKind::kAt},         {'|', TokenKind::kQuoted},     {'"', TokenKind::kQuoted}};
  for (const auto& [c, kind] : kOthers) {
    table.first[static_cast<unsigned char>(c)] = kind;
  }
  return table;
}();

const char* WordEnd(const char* from, const char* text_end) {
  while (from != text_end && kCharacters.InWord(*from)) {
    ++from;
  }
  return from;
}

bool AllDigits(const char* from, const char* end) {
  while (from != end && IsDigit(*from)) {
    ++from;
  }
  return from == end;
}

/// A word of up to three characters as a number.
constexpr std::uint32_t Packed(std::string_view word) {
  std::uint32_t packed = 0;
  for (const char c : word) {
    packed = packed << 8 | static_cast<unsigned char>(c);
  }
  return packed;
}

/// The kind of the sign that consists of up to three characters, or kEnd.
TokenKind SignOf(std::string_view word) {
  switch (Packed(word)) {
    case Packed("+"):
      return TokenKind::kPlus;
    case Packed("-"):
      return TokenKind::kMinus;
    case Packed("="):
      return TokenKind::kEqual;
    case Packed("<"):
      return TokenKind::kLess;
    case Packed(">"):
      return TokenKind::kGreater;
    case Packed("<="):
      return TokenKind::kLessOrEqual;
    case Packed(">="):
      return TokenKind::kGreaterOrEqual;
    case Packed("<>"):
      return TokenKind::kNotEqual;
    case Packed("<=>"):
      return TokenKind::kSameType;
    case Packed("<<"):
      return TokenKind::kLeftAngles;
    case Packed(">>"):
      return TokenKind::kRightAngles;
    case Packed("-->"):
      return TokenKind::kArrow;
    case Packed("&"):
      return TokenKind::kAmpersand;
    default:
      return TokenKind::kEnd;
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

/// Soar's format of floats: a sign, digits, a dot, digits, an `e`, a sign, digits; all except the dot are optional.
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

/// Reads a number. As in Soar, numbers that are too large are read as 0; then returns false.
template <typename Number>
bool ReadNumber(std::string_view text, Number& number) {
  number = 0;
  if (!text.empty() && text[0] == '+') {
    text.remove_prefix(1);
  }
  Number read = 0;
  const auto result = NumberFromChars(text, read);
  if (result.ec == std::errc()) {
    number = read;
  }
  return result.ec != std::errc::result_out_of_range;
}

bool ReadInteger(std::string_view word, std::int64_t& number) {
  constexpr std::size_t kSurelyFits = 18;
  if (word.size() > kSurelyFits) {
    return ReadNumber(word, number);
  }
  const bool negative = word[0] == '-';
  number = 0;
  for (const char c : word.substr(negative || word[0] == '+' ? 1 : 0)) {
    number = number * 10 + (c - '0');
  }
  number = negative ? -number : number;
  return true;
}

std::string_view NormalIdentifier(std::string_view text, Arena& arena) {
  const char letter = ToUpper(text[0]);
  text.remove_prefix(1);
  while (text.size() > 1 && text[0] == '0') {
    text.remove_prefix(1);
  }
  std::string out(1, letter);
  return arena.Copy(out.append(text));
}

}  // namespace

std::string RuleToken::Warning() const {
  if (!suspicious) {
    return {};
  }
  switch (kind) {
    case TokenKind::kUnclosed: {
      const char mark = text.data()[-1];
      return std::string("Error:  opening '") + mark + "' without closing '" + mark + "'\n";
    }
    case TokenKind::kFloat:
      return "Error: bad floating point number\n";
    case TokenKind::kInteger:
      return "Error: bad integer (probably too large)\n";
    default:
      return "Warning: Suspicious string constant \"" + std::string(text) + "\"\n";
  }
}

// Recognizes the common tokens. Calls other functions only at the ends of paths, so that no registers need to be saved.
void Lexer::Read(RuleToken& token) {
  const char* const text_end = end_;
  const char* first = at_;
  token.suspicious = false;
  TokenKind kind = TokenKind::kEnd;
  for (; first != text_end; ++first) {
    kind = kCharacters.First(*first);
    if (kind != TokenKind::kEnd) {
      break;
    }
    if (*first == '#') {
      first = std::find(first, text_end, '\n') - 1;
    }
  }
  if (kind == TokenKind::kString) {
    const char* const end = WordEnd(first + 1, text_end);
    token.text = {first, end};
    if (IsLetter(*first) && !IsDigit(end[-1])) {
      token.suspicious = end[-1] == '>';
      return FinishName(token, TokenKind::kString, first, end);
    }
    if (*first == '<' && end[-1] == '>' && end - first >= 3 && (end - first != 3 || first[1] != '=')) {
      return FinishName(token, TokenKind::kVariable, first, end);
    }
    return ReadRareWord(token, first, end);
  }
  switch (kind) {
    case TokenKind::kEnd:
      token.text = {};
      return Finish(token, kind, first, first);
    case TokenKind::kQuoted:
      return ReadDelimited(token, first);
    case TokenKind::kPeriod:
      if (first != name_end_ && first + 1 != text_end && IsDigit(first[1])) {
        return ReadRareWord(token, first, first);
      }
      break;
    case TokenKind::kAt:
      if (WordEnd(first, text_end) - first == 2 && (first[1] == '+' || first[1] == '-')) {
        token.text = {first, 2};
        return Finish(token, first[1] == '+' ? TokenKind::kAtPlus : TokenKind::kAtMinus, first, first + 2);
      }
      break;
    default:
      break;
  }
  token.text = {first, 1};
  Finish(token, kind, first, first + 1);
}

void Lexer::ReadDelimited(RuleToken& token, const char* first) {
  const char delimiter = *first;
  const char* end = first + 1;
  bool escapes = false;
  for (; end != end_ && *end != delimiter; ++end) {
    if (*end == '\\' && end + 1 != end_) {
      escapes = true;
      ++end;
    }
  }
  token.text = {first + 1, end};
  if (end == end_) {
    token.suspicious = true;
    return Finish(token, TokenKind::kUnclosed, first, end);
  }
  if (escapes) {
    std::string text;
    for (std::size_t n = 0; n < token.text.size(); ++n) {
      n += token.text[n] == '\\' && n + 1 < token.text.size() ? 1 : 0;
      text += token.text[n];
    }
    token.text = arena_.Copy(text);
  }
  if (delimiter == '"') {
    return Finish(token, TokenKind::kQuoted, first, end + 1);
  }
  FinishName(token, TokenKind::kString, first, end + 1);
}

/// Reads a number that continues after a dot. If the result is not a float, the dot is a separate token.
bool Lexer::ReadFloat(RuleToken& token, const char* first, const char* dot) {
  const char* const end = WordEnd(dot + 1, end_);
  const std::string_view candidate(first, end);
  if (ReadsAsFloat(candidate)) {
    token.text = candidate;
    token.suspicious = !ReadNumber(candidate, token.real);
    Finish(token, TokenKind::kFloat, first, end);
    return true;
  }
  if (dot == first) {
    token.text = {first, 1};
    Finish(token, TokenKind::kPeriod, first, first + 1);
    return true;
  }
  return false;
}

/// Reads a word that may be a sign, a number or an identifier.
void Lexer::ReadRareWord(RuleToken& token, const char* first, const char* end) {
  const std::string_view word(first, end);
  if (word.size() > 1 && IsLetter(*first)) {
    if (AllDigits(first + 1, end)) {
      token.text = NormalIdentifier(word, arena_);
      return FinishName(token, TokenKind::kIdentifier, first, end);
    }
    return FinishName(token, TokenKind::kString, first, end);
  }
  if (end != end_ && *end == '.' && IsSignOrDigits(word) && ReadFloat(token, first, end)) {
    return;
  }
  if (word.size() <= 3) {
    if (const TokenKind sign = SignOf(word); sign != TokenKind::kEnd) {
      return Finish(token, sign, first, end);
    }
  }
  if (AllDigits(first + 1, end)) {
    const bool signed_number = (word.front() == '+' || word.front() == '-') && word.size() > 1;
    if (IsDigit(word.front()) || signed_number) {
      token.suspicious = !ReadInteger(word, token.integer);
      return Finish(token, TokenKind::kInteger, first, end);
    }
  }
  token.suspicious = word.front() == '<' || word.back() == '>';
  FinishName(token, TokenKind::kString, first, end);
}

TextPlace PlaceFinder::Find(std::size_t offset) {
  offset = std::min(offset, text_.size());
  const auto lines = [this](std::size_t from, std::size_t to) {
    return static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(from),
                                       text_.begin() + static_cast<std::ptrdiff_t>(to), '\n'));
  };
  line_ += offset >= at_ ? lines(at_, offset) : -lines(offset, at_);
  at_ = offset;
  const std::size_t before = offset == 0 ? std::string_view::npos : text_.rfind('\n', offset - 1);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  return {line_, static_cast<int>(offset - begin) + 1};
}

}  // namespace soarbox::kernel
