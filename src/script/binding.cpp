// SPDX-License-Identifier: BSD-2-Clause
#include "script/binding.h"

#include <lua.hpp>
#include <map>
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

Binding BindingOf(const ApiFunction& function) {
  Binding binding{&function, ParseArguments(function.arguments)};
  for (const ApiArgument& argument : binding.arguments) {
    binding.min_arguments += argument.optional ? 0 : 1;
    binding.needs_check |= argument.type != ApiType::kValue && argument.type != ApiType::kBoolean;
  }
  binding.max_arguments = static_cast<int>(binding.arguments.size()) + function.more_arguments;
  binding.takes_any_number = function.name.starts_with("Vector.");
  return binding;
}

/// The bindings of a group, in its order. Their addresses never change.
const std::vector<Binding>& BindingsOf(const ApiGroup& group) {
  static const auto kBindings = [] {
    std::map<std::string_view, std::vector<Binding>> bindings;
    for (const ApiGroup& each : ApiGroups())
      for (const ApiFunction& function : each.functions) bindings[each.name].push_back(BindingOf(function));
    return bindings;
  }();
  return kBindings.at(group.name);
}

int CallChecked(lua_State* state, const Binding& binding) {
  const int count = lua_gettop(state);
  if (count >= binding.min_arguments && count <= binding.max_arguments) {
    if (binding.needs_check && !CheckArguments(state, binding)) return 0;
    return binding.function->function(state);
  }

  const char* name = binding.function->name.data();
  const char* text =
      binding.min_arguments == binding.max_arguments
          ? lua_pushfstring(state, "\"%s\" expected %d arguments, encountered %d", name, binding.min_arguments, count)
          : lua_pushfstring(state, "\"%s\" expected %d to %d arguments, encountered %d", name, binding.min_arguments,
                            binding.max_arguments, count);
  if (binding.function->wrong_count == WrongCount::kError) return luaL_error(state, "%s", text);
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

/// Upvalue: the Binding.
int CallBinding(lua_State* state) {
  const auto& binding = *static_cast<const Binding*>(lua_touserdata(state, lua_upvalueindex(1)));
  LuaMachine& machine = LuaMachine::Of(state);
  machine.Charge(kCallPrice);
  if (machine.instructions_left() == 0) machine.RaiseOutOfBudget(state);
  const int results = CallChecked(state, binding);
  if (ScriptContext* context = machine.context(); context != nullptr && context->world.HasMediaWarnings())
    PlaceMediaWarnings(state, *context);
  return results;
}

}  // namespace

void RegisterTable(lua_State* state, const ApiGroup& group) {
  const char* table = group.name.data();
  lua_newtable(state);
  lua_pushvalue(state, -1);
  lua_setglobal(state, table);
  MarkLoaded(state, table);
  GuardNames(state, table);
  for (const Binding& binding : BindingsOf(group)) {
    lua_pushlightuserdata(state, const_cast<Binding*>(&binding));
    lua_pushcclosure(state, CallBinding, 1);
    lua_setfield(state, -2, binding.function->name.data() + group.name.size() + 1);
  }
  lua_pop(state, 1);
}

const char* NameOfRunning(lua_State* state) {
  lua_Debug frame;
  if (lua_getstack(state, 0, &frame) != 1 || lua_getinfo(state, "f", &frame) == 0) return nullptr;
  const bool is_binding = lua_tocfunction(state, -1) == CallBinding;
  lua_pop(state, 1);
  if (!is_binding) return nullptr;
  return static_cast<const Binding*>(lua_touserdata(state, lua_upvalueindex(1)))->function->name.data();
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
