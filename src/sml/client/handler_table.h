// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sml {

/// The registered handlers of one kind, in the order in which they run. While they run, handlers may register and
/// unregister any handler, including themselves.
template <typename Handler>
class HandlerTable {
 public:
  struct Entry {
    int event = 0;
    int id = 0;
    Handler handler{};
    void* data = nullptr;
    bool flag = false;
    bool dead = false;
  };

  /// Returns the id of an identical registration, or 0.
  int Find(int event, Handler handler, void* data) const {
    for (const Entry& entry : entries_) {
      if (!entry.dead && entry.event == event && entry.handler == handler && entry.data == data) return entry.id;
    }
    return 0;
  }
  bool empty() const { return entries_.empty(); }
  /// True if the event has no handler.
  bool Empty(int event) const {
    return std::none_of(entries_.begin(), entries_.end(),
                        [&](const Entry& entry) { return !entry.dead && entry.event == event; });
  }
  void Add(Entry entry, bool to_back) {
    if (to_back || running_ > 0) {
      entries_.push_back(std::move(entry));
    } else {
      entries_.insert(entries_.begin(), std::move(entry));
    }
  }
  /// Removes a handler. Returns its event, or 0 if there is no handler with this id.
  int Remove(int id) {
    for (Entry& entry : entries_) {
      if (entry.dead || entry.id != id) continue;
      const int event = entry.event;
      entry.dead = true;
      Purge();
      return event;
    }
    return 0;
  }
  /// Calls `call(entry)` for the handlers of an event.
  template <typename Call>
  void ForEach(int event, Call call) {
    ++running_;
    const std::size_t count = entries_.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (entries_[i].dead || entries_[i].event != event) continue;
      // A copy, because the handler may add others, which moves the entries.
      const Entry entry = entries_[i];
      call(entry);
    }
    --running_;
    Purge();
  }
  void Clear() {
    for (Entry& entry : entries_) entry.dead = true;
    Purge();
  }

 private:
  void Purge() {
    if (running_ == 0) std::erase_if(entries_, [](const Entry& entry) { return entry.dead; });
  }

  std::vector<Entry> entries_;
  int running_ = 0;
};

}  // namespace sml
