// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "debugger/syntax.h"
#include "viewer/panels/theme.h"

namespace soarbox::viewer {

/// The colour of a part of a rule.
ImVec4 ColorOf(debugger::TokenKind kind);

/// Draws a text of rules at a place, line by line, each part in its colour. Lines outside of `top` to `bottom` are
/// passed over.
void DrawSource(ImDrawList& out, ImVec2 at, std::string_view text, const std::vector<debugger::Token>& tokens,
                float top, float bottom);

/// The same as an item of the panel, with the room that it takes.
void SourceItem(std::string_view text, const std::vector<debugger::Token>& tokens);

}  // namespace soarbox::viewer
