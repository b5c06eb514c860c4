// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace soarbox::kernel {

enum class TokenKind : std::uint8_t {
  kEnd,
  kString,          ///< A string constant; `text` without bars.
  kQuoted,          ///< "documentation"; `text` as written between the quotes.
  kInteger, kFloat,
  kVariable,        ///< `text` with its brackets.
  kIdentifier,      ///< s1: `text` in upper case without leading zeros. A string constant inside rules.
  kLeftParen, kRightParen, kLeftBrace, kRightBrace,
  kUpArrow, kExclamation, kTilde, kPeriod, kComma,
  kAt, kAtPlus, kAtMinus,
  kPlus, kMinus, kEqual, kLess, kGreater, kLessOrEqual, kGreaterOrEqual, kNotEqual, kSameType,
  kLeftAngles, kRightAngles,  ///< << and >>
  kArrow,           ///< -->
  kAmpersand,       ///< A sign that nothing uses any more.
  kUnclosed,        ///< A bar or quote without its partner.
};

struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::string text;            ///< Contents; for signs the characters themselves.
  std::int64_t integer = 0;
  double real = 0;
  std::size_t offset = 0;      ///< Of the first character in the text that is read.
  std::size_t length = 0;
  int line = 1, column = 1;    ///< Of the first character, from 1, within the text that is read.
  std::string warning;         ///< What Soar prints when it meets the token, with its line end; usually empty.
};

/// Cuts the text of a rule into tokens, as Soar's lexer does: any text gives tokens, characters that no token can hold
/// count as blanks.
class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  /// The next token; kEnd again and again once the text is used up.
  Token Next();

 private:
  void SkipBlanks();
  void Step();
  Token ReadBarred();
  Token ReadQuoted();
  Token ReadWord();
  std::size_t WordEnd(std::size_t from) const;
  Token Finish(Token token, std::size_t end);

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  bool after_name_ = false;    ///< The character before is the last of a string or variable: a dot here is a path dot.
};

}  // namespace soarbox::kernel
