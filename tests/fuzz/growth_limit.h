// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <new>

#include "kernel/agent.h"
#include "kernel/observer.h"

namespace soarbox {

/// Rules that multiply what they match are sound, but would keep a fuzzer busy for ages and fill its memory. An agent
/// that fires very often, or whose working memory grows beyond what a few conditions can combine in a moment, gets no
/// more memory, which ends it.
class GrowthLimit : public kernel::Observer {
 public:
  static constexpr kernel::EventMask kEvents = kernel::Event::kFiring | kernel::Event::kWme;
  static constexpr int kFirings = 5000;
  static constexpr std::uint32_t kElements = 64;

  void OnFiring(const kernel::Agent&, const kernel::FiringInfo&) override {
    if (++firings_ > kFirings) throw std::bad_alloc();
  }
  void OnWmeAdded(const kernel::Agent& agent, const kernel::WmeInfo&) override {
    if (agent.memory().wme_count() > kElements) throw std::bad_alloc();
  }

 private:
  int firings_ = 0;
};

}  // namespace soarbox
