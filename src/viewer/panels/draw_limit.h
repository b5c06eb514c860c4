// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

namespace soarbox::viewer {

/// ImGui counts the corners of each window with 16 bits and ends the program when there are more. Panels bound what
/// they draw by what can be seen. If one does not, its picture is cut here, so that the run goes on.
///
/// Call it between ImGui::EndFrame and ImGui::Render. Returns the names of the windows that were cut.
std::vector<std::string> CutOverfullWindows();

}  // namespace soarbox::viewer
