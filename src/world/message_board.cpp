// SPDX-License-Identifier: BSD-2-Clause
#include "world/message_board.h"

#include <algorithm>

namespace soarbox::world {

void MessageBoard::Post(Message message, std::uint64_t tick) {
  message.number = ++posted_;
  message.tick = tick;
  messages_.push_back(std::move(message));
  if (messages_.size() > kMostMessages) messages_.pop_front();
}

void MessageBoard::Forget(std::uint64_t tick, std::uint64_t age_ticks) {
  while (!messages_.empty() && messages_.front().tick + age_ticks < tick) messages_.pop_front();
}

std::size_t MessageBoard::FirstAfter(std::uint32_t number) const {
  // Numbers are consecutive: the last one is that of the last message.
  return messages_.size() - std::min<std::size_t>(messages_.size(), posted_ - number);
}

bool MessageBoard::IsFor(const Message& message, EntityId agent, std::string_view team) {
  if (message.from == agent) return false;
  return message.to == kNoEntity ? message.team == team : message.to == agent;
}

}  // namespace soarbox::world
