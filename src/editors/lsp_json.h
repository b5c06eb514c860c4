// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "editors/json.h"
#include "language/complete.h"
#include "language/document.h"

namespace soarbox::editors {

// What the Language Server Protocol calls things.

Json ToLsp(const language::Position& position);
Json RangeOf(const language::Lines& lines, const language::Span& span);
/// With the hint behind the message, and in `data` for code actions.
Json ToLsp(const Diagnostic& problem, const language::Document& document);
Json ToLsp(const language::Proposal& proposal, const Json& range, std::size_t order);

/// The names of the kinds of tokens, in the order of their numbers.
const std::vector<std::string>& TokenTypes();
/// The tokens of a text as the protocol packs them: five numbers each.
std::vector<std::size_t> PackTokens(const language::Document& document);

/// The text that a hint says was meant: of "did you mean ^color?" it is "color"; empty for other hints.
std::string MeantBy(std::string_view hint);

}  // namespace soarbox::editors
