// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::server {

/// Events that a client has been sent and has not answered yet, and the call that may have crossed each of them.
///
/// A client that waits for the answer to a call looks at messages as they come. If an event comes first, its handler
/// may call the kernel too, and then meets the answer to the outer call while it waits for its own. Clients built on
/// Soar's own library put such an answer aside, and look for it only when no message has come for a second: in a world
/// that runs they wait for ever. So that answer is sent once more when the event has been answered; clients drop what
/// they do not wait for. Only the first call that comes after an event can have crossed it, since a client has one
/// outer call at a time.
class OpenEvents {
 public:
  void Sent(std::string id) {
    if (open_.size() < kMost) open_.push_back({std::move(id), false, {}});
  }
  /// A call that is inside no other has been answered with this document.
  void Called(const std::string& answer) {
    for (Event& event : open_) {
      if (!event.called) event.answer = answer;
      event.called = true;
    }
  }
  bool Has(std::string_view id) const { return Find(id) != open_.end(); }
  bool empty() const { return open_.empty(); }
  /// The event is over: returns what must be sent once more, if anything.
  std::string Answered(std::string_view id) {
    const auto found = Find(id);
    if (found == open_.end()) return {};
    std::string answer = std::move(open_[static_cast<std::size_t>(found - open_.begin())].answer);
    open_.erase(found);
    return answer;
  }

 private:
  /// Usually one; more are open only if the client is slow.
  static constexpr std::size_t kMost = 64;

  struct Event {
    std::string id;
    bool called = false;
    std::string answer;
  };

  std::vector<Event>::const_iterator Find(std::string_view id) const {
    return std::find_if(open_.begin(), open_.end(), [&](const Event& event) { return event.id == id; });
  }

  std::vector<Event> open_;
};

}  // namespace soarbox::server
