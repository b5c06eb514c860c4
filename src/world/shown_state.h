// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::world {

/// One line of what a script shows of an agent's state: a node of a tree, a state, a score, a value of a blackboard.
struct ShownRow {
  int depth = 0;  ///< 0: a topic; below it its values, each deeper by one than the one that it belongs to.
  std::string name;
  std::string value;             ///< May be empty.
  bool active = false;           ///< On the active path: it is what the agent does, or what was chosen.
  std::uint64_t since_tick = 0;  ///< Since when it has this value and is active, or not.
  friend bool operator==(const ShownRow&, const ShownRow&) = default;
};

/// What a script shows of an agent's state (Agent.Show), for people who watch: nothing in the world depends on it.
class ShownState {
 public:
  /// At most so many rows; further ones are dropped.
  static constexpr std::size_t kMostRows = 500;

  /// Shows a topic: its row of depth 0, and those below it. It replaces what the topic showed before; rows that stay
  /// the same keep their `since_tick`. Without rows the topic is removed. False if nothing changed.
  bool Show(std::string_view topic, std::vector<ShownRow> rows, std::uint64_t tick);

  const std::vector<ShownRow>& rows() const { return rows_; }
  /// The rows as a text, for snapshots and recordings: ReadShown.
  const std::string& text() const { return text_; }

 private:
  std::vector<ShownRow> rows_;
  std::string text_;
};

/// The rows of such a text; lines that are none are left out.
std::vector<ShownRow> ReadShown(std::string_view text);

/// What the agent does, in one line: the value of the topic "doing" if there is one; else the value of the first topic,
/// or the names along its active path: "fight > reload". Empty if neither is there.
std::string DoingOf(std::span<const ShownRow> rows);

}  // namespace soarbox::world
