// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "world/entity_ids.h"

namespace soarbox::world {

/// A message from one agent to others.
struct Message {
  using Value = std::variant<std::int64_t, double, std::string>;
  struct Field {
    std::string name;
    Value value;
  };

  std::uint32_t number = 0;  ///< From 1, in the order of posting.
  std::uint64_t tick = 0;
  EntityId from = kNoEntity;
  EntityId to = kNoEntity;  ///< kNoEntity: all members of `team` except the sender.
  std::string team;
  std::string about;
  std::vector<Field> fields;
};

/// The messages between agents: at most the last 1,000. They are deleted after some time.
class MessageBoard {
 public:
  /// Adds a message and sets its number and tick.
  void Post(Message message, std::uint64_t tick);
  /// Deletes messages that are older than age_ticks.
  void Forget(std::uint64_t tick, std::uint64_t age_ticks);
  const std::deque<Message>& messages() const { return messages_; }
  /// The number of the last posted message; 0 if there was none.
  std::uint32_t posted() const { return posted_; }
  /// Index in messages() of the first message after that number.
  std::size_t FirstAfter(std::uint32_t number) const;
  static bool IsFor(const Message& message, EntityId agent, std::string_view team);

 private:
  static constexpr std::size_t kMostMessages = 1000;
  std::deque<Message> messages_;
  std::uint32_t posted_ = 0;
};

}  // namespace soarbox::world
