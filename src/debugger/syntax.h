// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace soarbox::debugger {

enum class TokenKind : std::uint8_t {
  kComment,
  kCommand,  ///< sp, gp, source, ...: the first word of a command.
  kRuleName,
  kKeyword,    ///< `state`, `impasse` and flags (:o-support).
  kVariable,   ///< <s>
  kAttribute,  ///< ^color.shade, including the ^.
  kConstant,
  kNumber,
  kQuoted,  ///< |quoted| and "documentation".
  kArrow,   ///< -->
  kSign,    ///< Brackets, relations, preferences, negation.
};

struct Token {
  TokenKind kind = TokenKind::kConstant;
  std::size_t begin = 0, length = 0;  ///< In bytes.
  friend bool operator==(const Token&, const Token&) = default;
};

/// Splits a text of rules into tokens for syntax colouring, in order. Blanks belong to no token. It accepts any text: a
/// comment, quote or variable without an end extends to the end.
std::vector<Token> Tokenize(std::string_view text);

/// "comment", "variable", ...
std::string_view NameOf(TokenKind kind);

}  // namespace soarbox::debugger
