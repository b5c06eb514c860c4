// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <new>

#include "kernel/agent.h"
#include "kernel/observer.h"

namespace soarbox {

/// Rules that multiply their matches are valid, but would take a fuzzer very long and fill its memory. An agent that
/// fires very often or has very many partial matches gets no more memory, which ends it.
class GrowthLimit : public kernel::Observer {
 public:
  void Guard(kernel::Agent& agent) {
    agent.AddObserver(*this, kernel::Mask(kernel::Event::kFiring));
    agent.mutable_settings().max_partial_matches = 10000;
  }

  void OnFiring(const kernel::Agent&, const kernel::FiringInfo&) override {
    if (++firings_ > kFirings) throw std::bad_alloc();
  }

 private:
  static constexpr int kFirings = 1000;
  int firings_ = 0;
};

}  // namespace soarbox
