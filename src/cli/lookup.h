// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string_view>

#include "kernel/agent.h"

namespace soarbox::cli {

/// "S1" or "s1" as a letter and a number; nothing if the text does not look like an identifier.
struct IdentifierName {
  char letter = 0;
  std::uint64_t number = 0;
};
std::optional<IdentifierName> ParseIdentifierName(std::string_view text);

/// True for the words <s> <o> <ss> <so> <sss> <sso> <ts> <to>.
bool IsContextVariable(std::string_view text);

/// The identifier that a word names: "s1", or a context variable. The none symbol if it does not exist now.
kernel::Symbol FindIdentifier(const kernel::Agent& agent, std::string_view text);

/// A constant as the lexer of rules reads a word: a number, |a quoted| string or a bare one. Interns.
kernel::Symbol MakeConstant(kernel::Agent& agent, std::string_view text);

/// A whole word as a number; nothing if it is not one or does not fit.
std::optional<std::int64_t> ParseInteger(std::string_view text);
/// The number at the start of a word, after blanks: "2.9" is 2, "3x" is 3. Nothing if there is none or it does not fit.
std::optional<std::int64_t> ParseLeadingInteger(std::string_view text);
std::optional<double> ParseDouble(std::string_view text);

}  // namespace soarbox::cli
