// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::record {

/// Distributes the lines of a client's log (sml/server/client_log.h) to ticks, so that no agent decides twice in a
/// tick. A tick begins with what the client did since the decisions of the previous tick.
///
/// The lines of a tick contain no wall time, so two equal runs give equal ticks.
class ClientTicks {
 public:
  /// `on_file` gets each file that a command of the client read: its absolute path and its content.
  using OnFile = std::function<void(const std::string& path, const std::string& content)>;
  explicit ClientTicks(OnFile on_file) : on_file_(std::move(on_file)) {}

  /// Adds a line, without its line end. Delays lines that end an agent until another line comes, so that the last state
  /// of the agents can be inspected after the program has ended.
  void Add(std::string_view line);
  /// Ends the current tick, if it has lines. Call it when no more lines are available at present.
  void Flush();

  /// Ticks that are complete.
  std::size_t complete() const { return ticks_.size() - 1; }
  /// The lines of a complete tick, each with its end.
  const std::string& At(std::size_t tick) const { return ticks_[tick]; }

 private:
  void Put(std::string_view line);
  void PutDecision(const std::string& agent, std::string_view line);
  void TellFunction(const std::string& agent, const std::string& function);
  void Go(const std::vector<std::string>& parts);

  OnFile on_file_;
  std::vector<std::string> ticks_ = {{}};  ///< The last one is not complete.
  std::set<std::string> in_this_tick_;     ///< Agents that have decided in it.
  std::string before_next_;                ///< Lines for the tick of the next decision.
  std::vector<std::string> gone_;          ///< Lines that are delayed.
  std::map<std::string, std::uint64_t> decided_;
  std::vector<std::string> functions_;
};

}  // namespace soarbox::record
