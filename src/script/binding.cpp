// SPDX-License-Identifier: BSD-2-Clause
#include "script/binding.h"

#include <algorithm>
#include <lua.hpp>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "script/argument_check.h"
#include "script/lua_library.h"
#include "script/lua_machine.h"
#include "script/script_context.h"
#include "script/script_path.h"

namespace soarbox::script {
namespace {

/// In instructions, so that a loop over calls is stopped after about the same time as other loops.
constexpr std::uint64_t kCallPrice = 20;
constexpr std::uint64_t kWarningPrice = 200;

/// Shared by the functions of all machines for this binding.
struct Bound {
  const Binding* binding;
  std::string name;         ///< "Table.Name".
  const CheckedCall* call;  ///< Null: no argument needs a check.
};

/// Created once for each binding; its address never changes.
const Bound& BoundOf(const Binding& binding, const char* table) {
  // Shared by worlds on several threads.
  static std::mutex mutex;
  static std::map<std::pair<const Binding*, std::string_view>, Bound> all;
  const std::lock_guard lock(mutex);
  const auto found = all.find({&binding, table});
  if (found != all.end()) return found->second;
  std::string name = std::string(table) + "." + binding.name;
  const ApiFunction* entry = FindApiFunction(name);
  const CheckedCall* call = entry ? &CheckedCallOf(*entry) : nullptr;
  const auto needs_check = [](const ApiArgument& argument) {
    return argument.type != ApiType::kValue && argument.type != ApiType::kBoolean;
  };
  if (call && std::ranges::none_of(call->arguments, needs_check)) call = nullptr;
  return all.emplace(std::pair{&binding, std::string_view(table)}, Bound{&binding, std::move(name), call})
      .first->second;
}

int CallChecked(lua_State* state, const Bound& bound) {
  const Binding& binding = *bound.binding;
  const int count = lua_gettop(state);
  if (count >= binding.min_arguments && count <= binding.max_arguments) {
    if (bound.call && !CheckArguments(state, *bound.call)) return 0;
    return binding.function(state);
  }

  const char* name = bound.name.c_str();
  const char* text =
      binding.min_arguments == binding.max_arguments
          ? lua_pushfstring(state, "\"%s\" expected %d arguments, encountered %d", name, binding.min_arguments, count)
          : lua_pushfstring(state, "\"%s\" expected %d to %d arguments, encountered %d", name, binding.min_arguments,
                            binding.max_arguments, count);
  if (binding.wrong_count == WrongCount::kError) return luaL_error(state, "%s", text);
  WarnIgnored(state, text);
  return 0;
}

/// Reports unknown names of materials, meshes and so on that the call used, at the script's line.
void PlaceMediaWarnings(lua_State* state, ScriptContext& context) {
  const ScriptPath& path = LuaMachine::Of(state).path();
  for (Diagnostic& warning : context.world.TakeMediaWarnings()) {
    LocateCaller(state, warning.file, warning.line);
    warning.excerpt = path.LineOf(warning.file, warning.line);
    warning.file = path.PathOf(warning.file);
    context.reporter.Warn(warning);
  }
}

/// Upvalue: the Bound.
int CallBinding(lua_State* state) {
  const auto& bound = *static_cast<const Bound*>(lua_touserdata(state, lua_upvalueindex(1)));
  LuaMachine& machine = LuaMachine::Of(state);
  machine.Charge(kCallPrice);
  if (machine.instructions_left() == 0) machine.RaiseOutOfBudget(state);
  const int results = CallChecked(state, bound);
  if (ScriptContext* context = machine.context(); context != nullptr && context->world.HasMediaWarnings())
    PlaceMediaWarnings(state, *context);
  return results;
}

}  // namespace

void RegisterTable(lua_State* state, const char* table, std::span<const Binding> bindings) {
  lua_getglobal(state, table);
  if (!lua_istable(state, -1)) {
    lua_pop(state, 1);
    lua_newtable(state);
    lua_pushvalue(state, -1);
    lua_setglobal(state, table);
    MarkLoaded(state, table);
    GuardNames(state, table);
  }
  for (const Binding& binding : bindings) {
    lua_pushlightuserdata(state, const_cast<Bound*>(&BoundOf(binding, table)));
    lua_pushcclosure(state, CallBinding, 1);
    lua_setfield(state, -2, binding.name);
  }
  lua_pop(state, 1);
}

const char* NameOfRunning(lua_State* state) {
  lua_Debug frame;
  if (lua_getstack(state, 0, &frame) != 1 || lua_getinfo(state, "f", &frame) == 0) return nullptr;
  const bool is_binding = lua_tocfunction(state, -1) == CallBinding;
  lua_pop(state, 1);
  return is_binding ? static_cast<const Bound*>(lua_touserdata(state, lua_upvalueindex(1)))->name.c_str() : nullptr;
}

void WarnAtCaller(lua_State* state, std::string message) {
  WarnAtCallerOnce(state, std::move(message), {});
}

void WarnAtCallerOnce(lua_State* state, std::string message, std::string_view subject) {
  ScriptContext* context = LuaMachine::Of(state).context();
  if (!context || LuaMachine::Of(state).is_paused_) return;
  LuaMachine::Of(state).Charge(kWarningPrice);
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  LocateCaller(state, warning.file, warning.line);
  const ScriptPath& path = LuaMachine::Of(state).path();
  warning.excerpt = path.LineOf(warning.file, warning.line);
  warning.file = path.PathOf(warning.file);
  warning.message = std::move(message);
  context->reporter.Warn(warning, subject);
}

void WarnIgnored(lua_State* state, const char* why) {
  if (LuaMachine::Of(state).is_paused_) return;
  auto& [file, line] = LuaMachine::Of(state).ignored_;
  LocateCaller(state, file, line);
  WarnAtCaller(state, std::string(why) + ": the call is ignored");
}

}  // namespace soarbox::script
