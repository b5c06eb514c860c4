// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "diagnostics/result.h"
#include "viewer/panels/layout.h"

namespace soarbox::app {

/// Returns a layout with these panels: "default", or their words separated by commas.
Result<viewer::Layout> LayoutNamed(const std::string& named, int text_percent);

}  // namespace soarbox::app
