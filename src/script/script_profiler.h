// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "script/script_observer.h"

namespace soarbox::script {

/// Measures the functions of all scripts of a world: how often they are called, which is the same in every run, and how
/// long they take, which is real time. Built-in functions count towards their callers. Measuring makes calls slower:
/// times of functions that are called often are too long.
class ScriptProfiler final : public ScriptObserver {
 public:
  struct Row {
    std::string function;  ///< "Agent_Update", "the main chunk".
    std::string place;     ///< File and line of its definition.
    std::uint64_t calls = 0;
    double self_s = 0;   ///< Without the functions of scripts that it calls.
    double total_s = 0;  ///< With them; of functions that call themselves, the outermost call counts.
  };
  /// One for each function, by name and place.
  std::vector<Row> Rows() const;

  /// A table: at most `most` functions, those with the longest times of their own first, per tick.
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
  /// Ends the calls of this machine that lie at or above a place in the stack of a state.
  void EndCalls(const lua_State* state, int place, double now_s);
  void EndLast(double now_s);

  std::map<Function, Totals> totals_;
  std::map<Function, std::string> names_;
  std::vector<Call> calls_;  ///< Under way, the outermost first; of all machines, because one may call another.
  std::map<LuaMachine*, std::size_t> begun_;  ///< How many calls were under way when a machine was called.
};

}  // namespace soarbox::script
