// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <new>

#include "kernel/agent.h"
#include "kernel/observer.h"

namespace soarbox {

/// Rules that multiply what they match are sound, but would keep a fuzzer busy for ages: behind so many firings the
/// agent gets no more memory, which ends it.
class FiringLimit : public kernel::Observer {
 public:
  static constexpr int kFirings = 5000;

  void OnFiring(const kernel::Agent&, const kernel::FiringInfo&) override {
    if (++firings_ > kFirings) throw std::bad_alloc();
  }

 private:
  int firings_ = 0;
};

}  // namespace soarbox
