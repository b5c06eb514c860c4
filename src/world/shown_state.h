// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::world {

/// One line of what a script shows of an agent's state: a node of a tree, a state, a score, or a value of a blackboard.
struct ShownRow {
  int depth = 0;  ///< 0: a topic; its values below have a depth greater by 1 than their parent.
  std::string name;
  std::string value;             ///< May be empty.
  bool active = false;           ///< It is on the active path: what the agent does, or what was chosen.
  std::uint64_t since_tick = 0;  ///< The tick in which `value` or `active` changed last.
  friend bool operator==(const ShownRow&, const ShownRow&) = default;
};

/// What a script shows of an agent's state (Agent.Show), for display. Nothing in the world depends on it.
class ShownState {
 public:
  /// Maximum number of rows; further ones are dropped.
  static constexpr std::size_t kMostRows = 500;

  /// Sets a topic: its row of depth 0, and the rows below it. Replaces the previous rows of the topic; unchanged rows
  /// keep their `since_tick`. Without rows, removes the topic. Returns false if nothing changed.
  bool Show(std::string_view topic, std::vector<ShownRow> rows, std::uint64_t tick);

  const std::vector<ShownRow>& rows() const { return rows_; }
  /// The rows as a text, for snapshots and recordings; ReadShown parses it.
  const std::string& text() const { return text_; }

 private:
  std::vector<ShownRow> rows_;
  std::string text_;
};

/// Parses such a text. Skips invalid lines.
std::vector<ShownRow> ReadShown(std::string_view text);

/// What the agent does, in one line. Returns the value of the topic "doing" if there is one; else the value of the
/// first topic, or the names along its active path: "fight > reload". Empty if there is neither.
std::string DoingOf(std::span<const ShownRow> rows);

}  // namespace soarbox::world
