// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "viewer/panels/panel.h"
#include "workbench/document/document.h"

namespace soarbox::viewer {

/// Executes the action of a part of a document.
void Press(PanelFrame& frame, const workbench::document::Action& action);
/// Executes the action of a row: its request with the row's key or argument. Does nothing if the row has no action.
void Press(PanelFrame& frame, const workbench::document::RowAction& action, const std::string& key,
           const std::vector<std::string>& arguments, bool is_open = true);

ImVec4 ColorOf(workbench::document::Role role);
std::string TextOf(const PanelFrame& frame, const workbench::document::Span& span);
std::string TextOf(const PanelFrame& frame, const workbench::document::Spans& spans);

/// Draws spans one after another. They wrap at the panel's edge, or are cut there if `cuts`.
void DrawSpans(PanelFrame& frame, const workbench::document::Spans& spans, bool cuts = false);

}  // namespace soarbox::viewer
