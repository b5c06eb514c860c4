// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "kernel/base/bump_arena.h"

namespace soarbox::kernel {

enum class TokenKind : std::uint8_t {
  kEnd,
  kString,  ///< A string constant; `text` without bars.
  kQuoted,  ///< "documentation"; `text` as written between the quotes.
  kInteger,
  kFloat,
  kVariable,    ///< `text` with its brackets.
  kIdentifier,  ///< s1: `text` in upper case without leading zeros. A string constant inside rules.
  kLeftParen,
  kRightParen,
  kLeftBrace,
  kRightBrace,
  kUpArrow,
  kExclamation,
  kTilde,
  kPeriod,
  kComma,
  kAt,
  kAtPlus,
  kAtMinus,
  kPlus,
  kMinus,
  kEqual,
  kLess,
  kGreater,
  kLessOrEqual,
  kGreaterOrEqual,
  kNotEqual,
  kSameType,
  kLeftAngles,
  kRightAngles,  ///< << and >>
  kArrow,        ///< -->
  kAmpersand,    ///< & has no meaning any more.
  kUnclosed,     ///< A bar or quote that is never closed.
};

struct RuleToken {
  TokenKind kind = TokenKind::kEnd;
  bool suspicious = false;  ///< The token is probably a mistake: see Warning().
  std::string_view text;    ///< Contents; the characters themselves for signs. Valid as long as the text and the arena.
  std::int64_t integer = 0;
  double real = 0;
  std::size_t offset = 0;  ///< Offset of the first character in the text.
  std::size_t length = 0;

  /// The message that Soar prints when it reads the token, with its line end; usually empty.
  std::string Warning() const;
};

/// Splits the text of a rule into tokens, as Soar's lexer does. Every text can be split; characters that cannot be in a
/// token count as blanks. Token texts that differ from the source (because of escapes) are allocated in the arena.
class Lexer {
 public:
  Lexer(std::string_view text, Arena& arena)
      : begin_(text.data()), end_(text.data() + text.size()), at_(begin_), arena_(arena) {}

  /// Reads the next token. Returns kEnd again after the end of the text.
  void Read(RuleToken& token);
  RuleToken Next() {
    RuleToken token;
    Read(token);
    return token;
  }

 private:
  void ReadDelimited(RuleToken& token, const char* first);
  void ReadRareWord(RuleToken& token, const char* first, const char* end);
  bool ReadFloat(RuleToken& token, const char* first, const char* dot);
  void Finish(RuleToken& token, TokenKind kind, const char* first, const char* end) {
    token.kind = kind;
    token.offset = static_cast<std::size_t>(first - begin_);
    token.length = static_cast<std::size_t>(end - first);
    at_ = end;
  }
  /// Ends a token that may be followed by the dot of a path.
  void FinishName(RuleToken& token, TokenKind kind, const char* first, const char* end) {
    name_end_ = end;
    Finish(token, kind, first, end);
  }

  const char* begin_;
  const char* end_;
  const char* at_;
  const char* name_end_ = nullptr;  ///< A dot at this position belongs to a path.
  Arena& arena_;
};

/// A position in a text, counted from 1.
struct TextPlace {
  int line = 1;
  int column = 1;
};

/// Converts offsets in a text to lines and columns. Fast if each offset is close to the previous one.
class PlaceFinder {
 public:
  explicit PlaceFinder(std::string_view text) : text_(text) {}
  TextPlace Find(std::size_t offset);

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace soarbox::kernel
