// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "script/script_observer.h"

namespace soarbox::script {

/// Measures all functions of a world's scripts: the number of calls, which is the same in every run, and their
/// durations, which are wall times. Built-in functions count as part of their callers. Measuring slows down calls, so
/// the times of frequently called functions are too long.
class ScriptProfiler final : public ScriptObserver {
 public:
  struct Row {
    std::string function;  ///< "Agent_Update", "the main chunk".
    std::string place;     ///< File and line of its definition.
    std::uint64_t calls = 0;
    double self_s = 0;   ///< Without the script functions that it calls.
    double total_s = 0;  ///< With them. For recursive functions, only the outermost call counts.
  };
  /// One row for each function, by name and place.
  std::vector<Row> Rows() const;

  /// Formats a table of at most `most` functions per tick, those with the largest `self_s` first.
  std::string Table(std::uint64_t ticks, std::size_t most) const;

  Wants WantsOf(const LuaMachine&) override { return {.calls = true}; }
  void OnCall(LuaMachine& machine, lua_State* state, lua_Debug& frame) override;
  void OnReturn(LuaMachine& machine, lua_State* state, lua_Debug& frame) override;
  void OnEnd(LuaMachine& machine) override;

 private:
  struct Totals {
    std::uint64_t calls = 0;
    double self_s = 0, total_s = 0;
    int under_way = 0;
  };
  using Function = std::pair<std::string, int>;  ///< File, line.
  struct Call {
    lua_State* state = nullptr;
    int place = 0;  ///< lua_Debug::i_ci.
    Totals* totals = nullptr;
    double began_s = 0, inner_s = 0;
  };
  /// Ends the calls of this machine at or above a place in the stack of a state.
  void EndCalls(const lua_State* state, int place, double now_s);
  void EndLast(double now_s);

  std::map<Function, Totals> totals_;
  std::map<Function, std::string> names_;
  std::vector<Call> calls_;  ///< Active calls, outermost first; of all machines, because one may call another.
  std::map<LuaMachine*, std::size_t> begun_;  ///< Number of active calls when a machine was called.
};

}  // namespace soarbox::script
