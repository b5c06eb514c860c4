// SPDX-License-Identifier: BSD-2-Clause
#include "script/binding.h"

#include <lua.hpp>
#include <string>

#include "script/argument_check.h"
#include "script/lua_library.h"
#include "script/lua_machine.h"
#include "script/script_context.h"
#include "script/script_path.h"

namespace soarbox::script {
namespace {

/// In instructions: so that a loop over calls is stopped as early as any other loop of the same length in time.
constexpr std::uint64_t kCallPrice = 20;

/// Upvalues: the binding, "Table.Name", its arguments in the table of the API.
int CallBinding(lua_State* state) {
  const auto& binding = *static_cast<const Binding*>(lua_touserdata(state, lua_upvalueindex(1)));
  LuaMachine& machine = LuaMachine::Of(state);
  machine.Charge(kCallPrice);
  if (machine.instructions_left() == 0) machine.RaiseOutOfBudget(state);
  const int count = lua_gettop(state);
  if (count >= binding.min_arguments && count <= binding.max_arguments) {
    const auto* arguments = static_cast<const std::vector<ApiArgument>*>(lua_touserdata(state, lua_upvalueindex(3)));
    if (arguments && !CheckArguments(state, *arguments)) return 0;
    return binding.function(state);
  }

  const char* name = lua_tostring(state, lua_upvalueindex(2));
  const char* text =
      binding.min_arguments == binding.max_arguments
          ? lua_pushfstring(state, "\"%s\" expected %d arguments, encountered %d", name, binding.min_arguments, count)
          : lua_pushfstring(state, "\"%s\" expected %d to %d arguments, encountered %d", name, binding.min_arguments,
                            binding.max_arguments, count);
  if (binding.wrong_count == WrongCount::kError) return luaL_error(state, "%s", text);
  WarnIgnored(state, text);
  return 0;
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
    lua_pushlightuserdata(state, const_cast<Binding*>(&binding));
    const char* name = lua_pushfstring(state, "%s.%s", table, binding.name);
    const ApiFunction* entry = FindApiFunction(name);
    lua_pushlightuserdata(state, entry ? const_cast<std::vector<ApiArgument>*>(&ArgumentsOf(*entry)) : nullptr);
    lua_pushcclosure(state, CallBinding, 3);
    lua_setfield(state, -2, binding.name);
  }
  lua_pop(state, 1);
}

void WarnAtCaller(lua_State* state, std::string message) {
  ScriptContext* context = LuaMachine::Of(state).context();
  if (!context) return;
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  LocateCaller(state, warning.file, warning.line);
  const ScriptPath& path = LuaMachine::Of(state).path();
  warning.excerpt = path.LineOf(warning.file, warning.line);
  warning.file = path.PathOf(warning.file);
  warning.message = std::move(message);
  context->reporter.Warn(warning);
}

void WarnIgnored(lua_State* state, const char* why) {
  WarnAtCaller(state, std::string(why) + ": the call is ignored");
}

}  // namespace soarbox::script
