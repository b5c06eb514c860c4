// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "script/script_observer.h"
#include "script/script_view.h"

namespace soarbox::script {

/// A breakpoint in a line of a script file.
struct ScriptBreakpoint {
  int line = 0;
  /// An expression of Lua that must be true; empty: always. If it cannot be evaluated, the script pauses, and the
  /// view's error says why.
  std::string condition = {};
  MayCall may_call = MayCall::kBuiltIn;  ///< The calls that the condition may contain.
};

/// How a script continues after a pause.
enum class ScriptStep : std::uint8_t { kGo, kInto, kOver, kOut };

/// Which lines of a script are meant.
enum class ScriptLines : std::uint8_t {
  kAll,
  kInFunctions,  ///< Without those that are executed only when the script is loaded.
};

/// Returns the lines of a script at which it can pause, in order; empty if the text does not compile.
std::vector<int> LinesOfScript(std::string_view text, ScriptLines which = ScriptLines::kAll);

/// A debugger of the scripts of a world: breakpoints and steps.
///
/// A script pauses inside a Lua hook, during a tick: the debugger calls `pause`, and the script continues when that
/// returns. Meanwhile, on the same thread, view() shows its calls and variables. Nothing is paused between two ticks.
/// Use it on one thread at a time.
class ScriptDebugger final : public ScriptObserver {
 public:
  using Pause = std::function<void()>;

  explicit ScriptDebugger(Pause pause) : pause_(std::move(pause)) {}

  /// Replaces all breakpoints of a file.
  void SetBreakpoints(const std::filesystem::path& file, std::vector<ScriptBreakpoint> breakpoints);
  bool HasBreakpoints() const { return !marks_.empty(); }
  /// Whether it pauses at uncaught errors.
  void SetStopAtErrors(bool stop) { stop_at_errors_ = stop; }
  /// Pauses at the next line that this agent's machine executes; 0: the sandbox's.
  void StopIn(std::uint32_t owner) { stop_in_ = owner; }
  /// Cancels a step or a StopIn that has not been reached.
  void ForgetStep();
  /// Sets how the paused script continues when `pause` returns; kGo unless it is called during the pause.
  void SetStep(ScriptStep step) { next_step_ = step; }
  /// False: it never pauses.
  void SetEnabled(bool enabled) { enabled_ = enabled; }
  /// True if something may cause a pause: breakpoints, a step, or errors.
  bool IsWanted() const;

  ScriptView& view() { return view_; }

 private:
  void OnWorld() override;
  void OnMachine(LuaMachine& machine) override;
  void OnGone(LuaMachine& machine) override;
  Wants WantsOf(const LuaMachine& machine) override;
  void OnLine(LuaMachine& machine, lua_State* state, lua_Debug& frame) override;
  void OnError(LuaMachine& machine, lua_State* state) override;
  void OnEnd(LuaMachine& machine) override;

  /// A place in a call. The debugger does not pause again at the same line of the same call until the call has executed
  /// another line.
  struct Place {
    LuaMachine* machine = nullptr;
    lua_State* state = nullptr;
    int call = 0;  ///< lua_Debug::i_ci: larger for inner calls.
    int line = 0;
  };

  const ScriptBreakpoint* BreakpointAt(LuaMachine& machine, lua_State* state, lua_Debug& frame) const;
  const std::vector<ScriptBreakpoint>* MarksOf(const LuaMachine& machine, std::string_view script) const;
  /// Whether it has paused there, and the call has not continued since.
  bool IsHit(const Place& place);
  bool IsStepOver(const LuaMachine& machine, lua_State* state, const lua_Debug& frame) const;
  void PauseHere(LuaMachine& machine, lua_State* state, int first_level, std::string reason, std::string error);
  void BeginStep(LuaMachine& machine, lua_State* state, const lua_Debug& frame);
  void EndStep();

  Pause pause_;
  ScriptView view_;
  std::map<std::filesystem::path, std::vector<ScriptBreakpoint>> marks_;
  std::vector<bool> lines_;  ///< The lines with a breakpoint in any file.
  mutable std::map<std::string, const std::vector<ScriptBreakpoint>*, std::less<>> marks_by_script_;
  bool stop_at_errors_ = false, enabled_ = true;
  std::optional<std::uint32_t> stop_in_;

  ScriptStep step_ = ScriptStep::kGo, next_step_ = ScriptStep::kGo;
  LuaMachine* step_machine_ = nullptr;
  Place step_from_;  ///< Its state is kept alive; null: any place.
  int step_thread_ = 0;
  std::vector<Place> hits_;  ///< Places of pauses in active calls, outermost first.
};

}  // namespace soarbox::script
