// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// The agents whose minds are looked at side by side, each with a sign that takes it away, and a list to add others
/// from. Panels that compare minds share them.
void DrawBeside(PanelFrame& frame);

}  // namespace soarbox::viewer
