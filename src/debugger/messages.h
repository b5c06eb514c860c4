// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/revision.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

/// A message from one agent to others, or an order from a user to an agent.
struct MessageRow {
  std::uint64_t tick = 0;
  double time_s = 0;
  std::string from;   ///< Empty for an order from the user.
  std::string to;     ///< An agent, or "team red".
  std::string about;  ///< Its subject, if it has one.
  std::string text;   ///< The complete content: "^about contact ^range 12".
};

/// The messages between agents in the ticks that were added.
class MessageLog {
 public:
  /// Ticks come in order. Adding an earlier tick removes everything from that tick on.
  void Add(const record::TickRecord& tick);
  void Clear() {
    rows_.clear();
    revision_ = NewRevision();
  }
  const std::deque<MessageRow>& rows() const { return rows_; }
  /// Changes whenever the rows change (see NewRevision).
  std::uint64_t revision() const { return revision_; }
  /// Messages from or to an agent or a team that contain each word of the text. An empty `who` means all.
  std::vector<MessageRow> Find(std::string_view who, std::string_view text) const;

  static constexpr std::size_t kMost = 10'000;

 private:
  std::deque<MessageRow> rows_;
  std::uint64_t revision_ = NewRevision();
};

std::string ToText(const std::vector<MessageRow>& rows);

}  // namespace soarbox::debugger
