// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::server {

/// The events that a client has not answered yet. For each event, stores the response to the call that may have crossed
/// it.
///
/// While a client waits for the response to a call, it processes all messages. If an event arrives first, its handler
/// may call the kernel. The client may then receive the response to the outer call while it waits for the inner one.
/// Clients built on Soar's own library store that response, but look for it only when no message has arrived for a
/// second. In a running world they wait forever. Therefore the response is sent again after the event was answered;
/// clients ignore responses that they do not wait for. Only the first call after an event can have crossed it, because
/// a client has one outer call at a time.
class OpenEvents {
 public:
  void Sent(std::string id) {
    if (open_.size() < kMost) open_.push_back({std::move(id), false, {}});
  }
  /// A call that is not nested in another one was answered with this document.
  void Called(const std::string& answer) {
    for (Event& event : open_) {
      if (!event.called) event.answer = answer;
      event.called = true;
    }
  }
  bool Has(std::string_view id) const { return Find(id) != open_.end(); }
  bool empty() const { return open_.empty(); }
  /// The event was answered: returns the document to send again, or an empty text.
  std::string Answered(std::string_view id) {
    const auto found = Find(id);
    if (found == open_.end()) return {};
    std::string answer = std::move(open_[static_cast<std::size_t>(found - open_.begin())].answer);
    open_.erase(found);
    return answer;
  }

 private:
  /// Usually one event is open; more are open only if the client is slow.
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
