// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/lexer.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "kernel/base/characters.h"

namespace soarbox::kernel {

namespace {

/// What a character can be part of.
enum CharacterClass : std::uint8_t {
  kWordCharacter = 1,  ///< Of symbols written without bars.
  kDigitCharacter = 2,
  kLetterCharacter = 4,
  kSignCharacter = 8,  ///< Of the signs that are made of word characters.
  kStartsToken = 16,   ///< Anything but blanks.
  kStartsComment = 32,
};

struct CharacterTable {
  std::array<std::uint8_t, 256> classes{};
  std::array<TokenKind, 256> single{};  ///< The tokens of one character that end words; kEnd for others.

  constexpr std::uint8_t ClassOf(char c) const { return classes[static_cast<unsigned char>(c)]; }
  constexpr TokenKind Single(char c) const { return single[static_cast<unsigned char>(c)]; }
};

constexpr CharacterTable kCharacters = [] {
  CharacterTable table;
  for (int n = 0; n < 256; ++n) {
    const char c = static_cast<char>(n);
    const bool sign = std::string_view("+-=<>&").find(c) != std::string_view::npos;
    table.classes[static_cast<std::size_t>(n)] = static_cast<std::uint8_t>(
        (IsConstituent(c) ? kWordCharacter | kStartsToken : 0) | (IsDigit(c) ? kDigitCharacter : 0) |
        (IsLetter(c) ? kLetterCharacter : 0) | (sign ? kSignCharacter : 0) | (c == '|' || c == '"' ? kStartsToken : 0) |
        (c == '#' ? kStartsComment : 0));
  }
  constexpr std::pair<char, TokenKind> kSingles[] = {
      {'(', TokenKind::kLeftParen},  {')', TokenKind::kRightParen}, {'{', TokenKind::kLeftBrace},
      {'}', TokenKind::kRightBrace}, {'^', TokenKind::kUpArrow},    {'!', TokenKind::kExclamation},
      {'~', TokenKind::kTilde},      {'.', TokenKind::kPeriod},     {',', TokenKind::kComma}};
  for (const auto& [c, kind] : kSingles) {
    table.single[static_cast<unsigned char>(c)] = kind;
    table.classes[static_cast<unsigned char>(c)] |= kStartsToken;
  }
  return table;
}();

/// A word of up to three characters as a number.
constexpr std::uint32_t Packed(std::string_view word) {
  std::uint32_t packed = 0;
  for (const char c : word) {
    packed = packed << 8 | static_cast<unsigned char>(c);
  }
  return packed;
}

/// The sign that a word of up to three characters is, or kEnd.
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

/// Numbers too large to hold are 0, as in Soar; false then.
template <typename Number>
bool ReadNumber(std::string_view text, Number& number) {
  number = 0;
  if (!text.empty() && text[0] == '+') {
    text.remove_prefix(1);
  }
  Number read = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), read);
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

inline void Lexer::Finish(RuleToken& token, TokenKind kind, std::size_t end) {
  token.kind = kind;
  token.offset = at_;
  token.length = end - at_;
  at_ = end;
  after_name_ = kind == TokenKind::kString || kind == TokenKind::kVariable || kind == TokenKind::kIdentifier;
}

inline void Lexer::SkipBlanks() {
  const std::size_t begin = at_;
  const char* const end = text_.data() + text_.size();
  const char* p = text_.data() + at_;
  while (p != end) {
    const std::uint8_t c = kCharacters.ClassOf(*p);
    if ((c & (kStartsToken | kStartsComment)) == 0) {
      ++p;
    } else if ((c & kStartsToken) != 0) {
      break;
    } else {
      p = std::find(p, end, '\n');
    }
  }
  at_ = static_cast<std::size_t>(p - text_.data());
  if (at_ != begin) {
    after_name_ = false;
  }
}

void Lexer::Read(RuleToken& token) {
  SkipBlanks();
  token.suspicious = false;
  if (at_ >= text_.size()) {
    token.text = {};
    return Finish(token, TokenKind::kEnd, at_);
  }
  const char c = text_[at_];
  if (const TokenKind single = kCharacters.Single(c); single != TokenKind::kEnd) {
    const bool starts_float = c == '.' && !after_name_ && at_ + 1 < text_.size() && IsDigit(text_[at_ + 1]);
    if (!starts_float) {
      token.text = text_.substr(at_, 1);
      return Finish(token, single, at_ + 1);
    }
  } else if (c == '|') {
    return ReadDelimited(token, c, TokenKind::kString);
  } else if (c == '"') {
    return ReadDelimited(token, c, TokenKind::kQuoted);
  } else if (c == '@') {
    const bool with_sign = WordEnd(at_) - at_ == 2 && (text_[at_ + 1] == '+' || text_[at_ + 1] == '-');
    const std::size_t length = with_sign ? 2 : 1;
    token.text = text_.substr(at_, length);
    const TokenKind kind = !with_sign              ? TokenKind::kAt
                           : text_[at_ + 1] == '+' ? TokenKind::kAtPlus
                                                   : TokenKind::kAtMinus;
    return Finish(token, kind, at_ + length);
  }
  ReadWord(token);
}

void Lexer::ReadDelimited(RuleToken& token, char delimiter, TokenKind kind) {
  std::size_t i = at_ + 1;
  bool escapes = false;
  for (; i < text_.size() && text_[i] != delimiter; ++i) {
    if (text_[i] == '\\' && i + 1 < text_.size()) {
      escapes = true;
      ++i;
    }
  }
  const bool closed = i < text_.size();
  token.text = text_.substr(at_ + 1, i - at_ - 1);
  token.suspicious = !closed;
  if (escapes && closed) {
    std::string text;
    for (std::size_t n = 0; n < token.text.size(); ++n) {
      n += token.text[n] == '\\' && n + 1 < token.text.size() ? 1 : 0;
      text += token.text[n];
    }
    token.text = arena_.Copy(text);
  }
  Finish(token, closed ? kind : TokenKind::kUnclosed, closed ? i + 1 : text_.size());
}

std::size_t Lexer::WordEnd(std::size_t from) const {
  while (from < text_.size() && (kCharacters.ClassOf(text_[from]) & kWordCharacter) != 0) {
    ++from;
  }
  return from;
}

/// Reads a number that goes on behind the dot at `end`; if that does not make a float, the dot is a token of its own.
bool Lexer::ReadFloat(RuleToken& token, std::size_t end) {
  const std::size_t float_end = WordEnd(end + 1);
  const std::string_view candidate = text_.substr(at_, float_end - at_);
  if (ReadsAsFloat(candidate)) {
    token.text = candidate;
    token.suspicious = !ReadNumber(candidate, token.real);
    Finish(token, TokenKind::kFloat, float_end);
    return true;
  }
  if (end == at_) {
    token.text = text_.substr(at_, 1);
    Finish(token, TokenKind::kPeriod, at_ + 1);
    return true;
  }
  return false;
}

void Lexer::ReadWord(RuleToken& token) {
  const char* const begin = text_.data() + at_;
  const char* const text_end = text_.data() + text_.size();
  // The classes that all characters but the first share.
  std::uint8_t shared = 0xFF;
  const char* p = begin;
  const std::uint8_t first = kCharacters.ClassOf(*begin);
  if ((first & kWordCharacter) != 0) {
    for (++p; p != text_end; ++p) {
      const std::uint8_t c = kCharacters.ClassOf(*p);
      if ((c & kWordCharacter) == 0) {
        break;
      }
      shared &= c;
    }
  }
  const std::size_t end = static_cast<std::size_t>(p - text_.data());
  const std::string_view word(begin, static_cast<std::size_t>(p - begin));
  if (p != text_end && *p == '.' && IsSignOrDigits(word) && ReadFloat(token, end)) {
    return;
  }
  token.text = word;
  if (word.front() == '<' && p[-1] == '>' && word.size() >= 3 && word != "<=>") {
    return Finish(token, TokenKind::kVariable, end);
  }
  if ((first & kSignCharacter) != 0 && word.size() <= 3) {
    if (const TokenKind sign = SignOf(word); sign != TokenKind::kEnd) {
      return Finish(token, sign, end);
    }
  }
  if ((shared & kDigitCharacter) != 0) {
    const bool signed_number = (word.front() == '+' || word.front() == '-') && word.size() > 1;
    if ((first & kDigitCharacter) != 0 || signed_number) {
      token.suspicious = !ReadInteger(word, token.integer);
      return Finish(token, TokenKind::kInteger, end);
    }
    if ((first & kLetterCharacter) != 0 && word.size() > 1) {
      token.text = NormalIdentifier(word, arena_);
      return Finish(token, TokenKind::kIdentifier, end);
    }
  }
  token.suspicious = word.front() == '<' || word.back() == '>';
  Finish(token, TokenKind::kString, end);
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
