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
  std::string condition;  ///< An expression of Lua that must be true; empty: always.
};

/// How far a script goes on after a pause.
enum class ScriptStep : std::uint8_t { kGo, kInto, kOver, kOut };

/// The lines of a script at which it can pause, in order; empty if the text does not compile.
std::vector<int> LinesOfScript(std::string_view text);

/// A debugger of the scripts of a world: breakpoints and steps.
///
/// A script pauses inside a hook of Lua, in the middle of a tick: the debugger calls `pause`, which returns when the
/// script is to go on. Meanwhile, on the same thread, view() shows its calls and variables. Between two ticks nothing
/// is paused. Used by one thread at a time.
class ScriptDebugger final : public ScriptObserver {
 public:
  using Pause = std::function<void()>;

  explicit ScriptDebugger(Pause pause) : pause_(std::move(pause)) {}

  /// Replaces all breakpoints of a file.
  void SetBreakpoints(const std::filesystem::path& file, std::vector<ScriptBreakpoint> breakpoints);
  bool HasBreakpoints() const { return !marks_.empty(); }
  /// Whether it pauses at errors that no script catches.
  void SetStopAtErrors(bool stop) { stop_at_errors_ = stop; }
  /// Pauses at the next line that the machine of this agent executes; 0: the sandbox's.
  void StopIn(std::uint32_t owner) { stop_in_ = owner; }
  /// Forgets a step, or a line to pause at, that has not been reached.
  void ForgetStep();
  /// How the paused script goes on when `pause` returns. kGo unless it is called in the pause.
  void SetStep(ScriptStep step) { next_step_ = step; }
  /// False: it pauses nowhere, whatever was set.
  void SetEnabled(bool enabled) { enabled_ = enabled; }
  /// True if something may pause: breakpoints, a step, or errors.
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

  /// A place in a call: the same function at the same line is not paused at again until it has gone on.
  struct Place {
    LuaMachine* machine = nullptr;
    lua_State* state = nullptr;
    int call = 0;  ///< lua_Debug::i_ci: larger for inner calls.
    int line = 0;
  };

  const ScriptBreakpoint* BreakpointAt(LuaMachine& machine, lua_State* state, lua_Debug& frame) const;
  const std::vector<ScriptBreakpoint>* MarksOf(const LuaMachine& machine, std::string_view script) const;
  /// Whether it has paused there, and the call has not gone on since.
  bool IsHit(const Place& place);
  bool IsStepOver(const LuaMachine& machine, lua_State* state, const lua_Debug& frame) const;
  void PauseHere(LuaMachine& machine, lua_State* state, int first_level, std::string reason, std::string error);
  void BeginStep(LuaMachine& machine, lua_State* state, const lua_Debug& frame);
  void EndStep();

  Pause pause_;
  ScriptView view_;
  std::map<std::filesystem::path, std::vector<ScriptBreakpoint>> marks_;
  std::vector<bool> lines_;  ///< Those with a breakpoint in any file.
  mutable std::map<std::string, const std::vector<ScriptBreakpoint>*, std::less<>> marks_by_script_;
  bool stop_at_errors_ = false, enabled_ = true;
  std::optional<std::uint32_t> stop_in_;

  ScriptStep step_ = ScriptStep::kGo, next_step_ = ScriptStep::kGo;
  LuaMachine* step_machine_ = nullptr;
  Place step_from_;  ///< Its state is kept alive; null: any place will do.
  int step_thread_ = 0;
  std::vector<Place> hits_;  ///< Where it has paused in calls that are under way, the outermost first.
};

}  // namespace soarbox::script
