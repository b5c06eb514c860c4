// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// Reasons as a tree that unfolds, open down to this depth; clicks on what they name lead on.
void DrawWhyTree(PanelFrame& frame, const debugger::WhyNode& root, int open_to = 4);

}  // namespace soarbox::viewer
