// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "kernel/observer.h"

namespace soarbox::kernel {

/// The observers of an agent. `Wants` is one test, so an event without observers costs almost nothing.
class Observers {
 public:
  explicit Observers(Agent& agent) : agent_(&agent) {}

  void Add(Observer& observer, EventMask events) {
    Remove(observer);
    entries_.push_back({&observer, events});
    mask_ |= events;
  }
  void Remove(Observer& observer) {
    std::erase_if(entries_, [&](const Entry& entry) { return entry.observer == &observer; });
    mask_ = 0;
    for (const Entry& entry : entries_) mask_ |= entry.events;
  }
  EventMask mask() const { return mask_; }
  bool Wants(Event event) const { return (mask_ & Mask(event)) != 0; }
  /// Calls `tell(observer)` for each observer that subscribed to the event. Call Wants first if the arguments are
  /// expensive.
  template <typename Tell>
  void Notify(Event event, Tell tell) const {
    if (!Wants(event)) return;
    for (std::size_t index = 0; index < entries_.size(); ++index) {
      const Entry entry = entries_[index];
      if ((entry.events & Mask(event)) != 0) tell(*entry.observer);
    }
  }

  [[gnu::noinline]] void Print(std::string_view text) const {
    Notify(Event::kPrint, [&](Observer& o) { o.OnPrint(*agent_, text); });
  }
  [[gnu::noinline]] void Warn(WarningKind kind, std::string_view text) const {
    Notify(Event::kPrint, [&](Observer& o) { o.OnWarning(*agent_, kind, text); });
  }

 private:
  struct Entry {
    Observer* observer;
    EventMask events;
  };
  Agent* agent_;
  std::vector<Entry> entries_;
  EventMask mask_ = 0;
};

}  // namespace soarbox::kernel
