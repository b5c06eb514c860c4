// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

namespace soarbox::viewer {

/// ImGui counts the vertices of each window with 16 bits and ends the program if there are more. Panels draw only what
/// is visible. If a panel exceeds the limit, its drawing is cut here, so that the run continues.
///
/// Call it between ImGui::EndFrame and ImGui::Render. Returns the names of the windows that were cut.
std::vector<std::string> CutOverfullWindows();

}  // namespace soarbox::viewer
