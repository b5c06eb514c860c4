// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "editors/json_type.h"
#include "language/complete.h"
#include "language/text_document.h"

namespace soarbox::editors {

// Conversions to types of the Language Server Protocol.

Json ToLsp(const language::Position& position);
Json RangeOf(const language::Lines& lines, const language::Span& span);
/// The hint is added to the message, and stored in `data` for code actions.
Json ToLsp(const Diagnostic& problem, const language::Document& document);
Json ToLsp(const language::Proposal& proposal, const Json& range, std::size_t order);

/// The names of the kinds of tokens, by number.
const std::vector<std::string>& TokenTypes();
/// The tokens of a text in the encoding of the protocol: five numbers each.
std::vector<std::size_t> PackTokens(const language::Document& document);

/// The word that a hint suggests: "color" for "did you mean ^color?"; empty for other hints.
std::string MeantBy(std::string_view hint);

}  // namespace soarbox::editors
