// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "debugger/syntax.h"
#include "viewer/panels/theme.h"

namespace soarbox::viewer {

/// The colour of a kind of token.
ImVec4 ColorOf(debugger::TokenKind kind);

/// Draws a text of rules, line by line, with each token in its colour. Skips lines outside of `top` to `bottom`.
void DrawSource(ImDrawList& out, ImVec2 at, std::string_view text, const std::vector<debugger::Token>& tokens,
                float top, float bottom);

/// Draws the same as an item of the panel, which takes its own space.
void SourceItem(std::string_view text, const std::vector<debugger::Token>& tokens);

}  // namespace soarbox::viewer
