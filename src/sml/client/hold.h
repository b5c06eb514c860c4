// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sml/client/agent_data.h"
#include "sml/client/kernel_data.h"
#include "sml/client/link.h"

namespace sml {

/// Holds the kernel while it lives.
class Lock {
 public:
  /// Null: there is nothing to hold.
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

/// Holds the kernel for a call; nothing to hold once the kernel is gone. (Without a call: a tick of a crowd makes
/// hundreds of thousands.)
[[gnu::always_inline]] inline Lock Hold(KernelData& data) {
  return Lock(data.link ? &data.link->mutex() : nullptr);
}
[[gnu::always_inline]] inline Lock Hold(AgentData& data) {
  return Hold(data.kernel_data());
}

}  // namespace sml
