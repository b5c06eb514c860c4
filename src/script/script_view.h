// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "script/script_expression.h"

struct lua_State;
struct lua_Debug;

namespace soarbox::script {

class LuaMachine;

/// An active call.
struct ScriptFrame {
  std::string function;  ///< "Agent_Update", "the main chunk".
  std::string file;      ///< Path of the script file; empty for a built-in function.
  int line = 0;
};

/// A variable, a field of a table, or the value of an expression.
struct ScriptVariable {
  std::string name, value, type;
  int reference = 0;  ///< Argument of Fields; 0: it has no fields.
};

/// A debugger's view of a world's scripts: machines, and the calls and variables of a paused one.
///
/// Expressions are evaluated by EvaluateExpression, which calls only built-in functions: a function of a script could
/// run forever, because Lua counts no instructions inside a hook. Used by the thread that runs the scripts.
class ScriptView {
 public:
  ScriptView();
  ~ScriptView();
  ScriptView(const ScriptView&) = delete;
  ScriptView& operator=(const ScriptView&) = delete;

  struct Machine {
    std::uint32_t owner = 0;  ///< The agent's number; 0: the sandbox.
    std::string name;         ///< Of the agent; "sandbox".
  };
  /// In the order of their creation, the sandbox first.
  std::vector<Machine> Machines() const;

  // While a script is paused:
  bool is_paused() const { return state_ != nullptr; }
  /// Of the paused script; 0: the sandbox.
  std::uint32_t owner() const;
  /// "breakpoint", "step" or "error".
  const std::string& reason() const { return reason_; }
  /// The error's message; empty for other reasons.
  const std::string& error() const { return error_; }
  /// Innermost first.
  std::vector<ScriptFrame> Frames() const;
  /// Parameters and local variables; if two have one name, the visible one.
  std::vector<ScriptVariable> Locals(std::size_t frame);
  /// Local variables of enclosing functions that the function of this frame uses.
  std::vector<ScriptVariable> Upvalues(std::size_t frame);
  /// The value of an expression in a frame.
  Result<ScriptVariable> Evaluate(std::size_t frame, std::string_view expression, MayCall may_call = MayCall::kBuiltIn);

  // At any time:
  /// Global variables of a machine's scripts, without functions and without those of the language and the API.
  std::vector<ScriptVariable> Globals(std::uint32_t owner);
  /// Fields of a value, by ScriptVariable::reference. References become invalid when scripts continue.
  std::vector<ScriptVariable> Fields(int reference);
  /// The value of an expression of global variables.
  Result<ScriptVariable> EvaluateGlobal(std::uint32_t owner, std::string_view expression);
  /// Makes all references invalid.
  void DropReferences();

 private:
  friend class ScriptDebugger;
  struct Calls;

  /// `first_level` is the level of the innermost call that is shown.
  void BeginPause(LuaMachine& machine, lua_State* state, int first_level, std::string reason, std::string error);
  void EndPause();
  /// Call it before the machine is destroyed. References to its values become invalid.
  void Forget(LuaMachine& machine);
  /// Evaluates a condition in the innermost call.
  static Result<bool> Holds(LuaMachine& machine, lua_State* state, const std::string& condition, MayCall may_call);
  /// The level of a call inside our own protected call, where Lua finds its local variables.
  int LevelOf(std::size_t frame) const { return first_level_ + 1 + static_cast<int>(frame); }
  LuaMachine* MachineOf(std::uint32_t owner) const;
  /// Describes the value on top of the stack under this name, and pops it.
  ScriptVariable Take(LuaMachine& machine, lua_State* state, std::string name);
  std::vector<ScriptVariable> FieldsAt(LuaMachine& machine, lua_State* state, int index);

  std::vector<LuaMachine*> machines_;
  LuaMachine* machine_ = nullptr;  ///< Of the paused script.
  lua_State* state_ = nullptr;
  int first_level_ = 0;  ///< Of its innermost call.
  std::string reason_, error_;
  std::unique_ptr<Calls> calls_;
  struct Reference {
    LuaMachine* machine;  ///< Null: the machine was destroyed.
    int kept;
  };
  std::vector<Reference> references_;
};

}  // namespace soarbox::script
