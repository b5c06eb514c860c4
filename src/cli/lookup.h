// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string_view>

#include "kernel/agent.h"

namespace soarbox::cli {

/// An identifier "S1" or "s1" as a letter and a number; nothing if the text does not have this form.
struct IdentifierName {
  char letter = 0;
  std::uint64_t number = 0;
};
std::optional<IdentifierName> ParseIdentifierName(std::string_view text);

/// Whether the word is one of <s> <o> <ss> <so> <sss> <sso> <ts> <to>.
bool IsContextVariable(std::string_view text);

/// The identifier that a word names: "s1", or a context variable. The null symbol if it does not exist now.
kernel::Symbol FindIdentifier(const kernel::Agent& agent, std::string_view text);

/// Converts a word to a constant like the lexer of rules: a number, |a quoted| string or a bare one. Interns it.
kernel::Symbol MakeConstant(kernel::Agent& agent, std::string_view text);

/// Parses the entire word as an integer; nothing if that fails.
std::optional<std::int64_t> ParseInteger(std::string_view text);
/// Parses the integer at the start of a word, after blanks: "2.9" is 2, "3x" is 3. Nothing if there is none or it is
/// out of range.
std::optional<std::int64_t> ParseLeadingInteger(std::string_view text);
std::optional<double> ParseDouble(std::string_view text);

}  // namespace soarbox::cli
