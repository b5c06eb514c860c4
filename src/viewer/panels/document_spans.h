// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "viewer/panels/panel.h"
#include "workbench/document/document.h"

namespace soarbox::viewer {

/// What happens when something of a document is pressed.
void Press(PanelFrame& frame, const workbench::document::Action& action);
/// The action of a row: its request with the row's key or argument. Nothing happens if the row has none.
void Press(PanelFrame& frame, const workbench::document::RowAction& action, const std::string& key,
           const std::vector<std::string>& arguments, bool is_open = true);

ImVec4 ColorOf(workbench::document::Role role);
std::string TextOf(const PanelFrame& frame, const workbench::document::Span& span);
std::string TextOf(const PanelFrame& frame, const workbench::document::Spans& spans);

/// Draws spans one after another. They break at the panel's edge, or are cut there if `cuts`.
void DrawSpans(PanelFrame& frame, const workbench::document::Spans& spans, bool cuts = false);

}  // namespace soarbox::viewer
