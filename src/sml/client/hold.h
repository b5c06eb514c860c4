// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <mutex>

#include "sml/client/agent_data.h"
#include "sml/client/kernel_data.h"
#include "sml/client/link.h"

namespace sml {

using Lock = std::unique_lock<std::recursive_mutex>;

/// Locks the kernel for one call; locks nothing if the kernel no longer exists.
inline Lock Hold(KernelData& data) {
  return data.link ? Lock(data.link->mutex()) : Lock();
}
inline Lock Hold(AgentData& data) {
  return Hold(data.kernel_data());
}

}  // namespace sml
