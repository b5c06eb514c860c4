// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "workbench/contents.h"
#include "workbench/requests.h"

namespace soarbox::workbench {

/// What panels and a desk pass to each other. Panels add requests and draw the contents; Desk::Serve carries out the
/// requests and fills in the contents.
struct PanelExchange {
  std::vector<Request> requests;  ///< In the order in which the user made them.
  Contents contents;
};

}  // namespace soarbox::workbench
