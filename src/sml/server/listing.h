// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "kernel/agent.h"
#include "sml/server/hosted_agent.h"

namespace soarbox::server {

/// The element of the output link itself: (I1 ^output-link I3). Its time tag is 0 before the first state exists.
kernel::WmeInfo OutputLinkWme(const kernel::Agent& agent);

/// An element of the input with the time tag of its client (or the kernel's).
struct InputListing {
  kernel::WmeInfo wme;
  long long tag = 0;
};
/// Everything on the input link and below it, parents before children.
std::vector<InputListing> ListInput(HostedAgent& hosted);

}  // namespace soarbox::server
