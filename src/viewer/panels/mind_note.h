// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// Opens a place in a file for editing: in the panel Edit, or in the user's own editor if that panel cannot reload the
/// file.
void GoToFile(PanelFrame& frame, const std::string& file, int line);

/// A text that is a link if it names a place in a file.
void TextWithPlace(PanelFrame& frame, const char* id, std::string_view text, ImVec4 color);

/// Shows an object of working memory in the panel Memory.
void ShowObject(PanelFrame& frame, std::string_view id);

}  // namespace soarbox::viewer
