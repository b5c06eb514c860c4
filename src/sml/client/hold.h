// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sml/client/agent_data.h"
#include "sml/client/kernel_data.h"
#include "sml/client/link.h"

namespace sml {

/// Locks the kernel during its lifetime.
class Lock {
 public:
  /// With null, nothing is locked.
  explicit Lock(soarbox::server::CallMutex* mutex) : mutex_(mutex) {
    if (mutex_ != nullptr) mutex_->lock();
  }
  ~Lock() {
    if (mutex_ != nullptr) mutex_->unlock();
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  soarbox::server::CallMutex* const mutex_;
};

/// Locks the kernel for one call; locks nothing if the kernel no longer exists. Inlined, because a tick with many
/// agents locks hundreds of thousands of times.
[[gnu::always_inline]] inline Lock Hold(KernelData& data) {
  return Lock(data.link ? &data.link->mutex() : nullptr);
}
[[gnu::always_inline]] inline Lock Hold(AgentData& data) {
  return Hold(data.kernel_data());
}

}  // namespace sml
