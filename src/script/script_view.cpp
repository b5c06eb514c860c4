// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_view.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <lua.hpp>
#include <set>
#include <utility>

#include "diagnostics/problem.h"
#include "script/lua_function_names.h"
#include "script/lua_machine.h"
#include "script/lua_protected.h"
#include "script/lua_values.h"
#include "script/script_context.h"
#include "script/script_expression.h"
#include "script/script_path.h"

namespace soarbox::script {
namespace {

constexpr std::size_t kMostFrames = 200, kMostShownFields = 500, kMostReferences = 20'000;
constexpr std::size_t kLongestText = 300, kPreviewed = 4;
/// Limit of the built-in functions of one expression, in instructions.
constexpr std::uint64_t kEvaluationBudget = 5'000'000;

std::string QuotedText(const char* text, std::size_t length) {
  std::string quoted = "\"";
  for (std::size_t i = 0; i < std::min(length, kLongestText); ++i) {
    const char sign = text[i];
    if (sign == '"' || sign == '\\') quoted += '\\';
    if (sign == '\n') {
      quoted += "\\n";
    } else {
      quoted += static_cast<unsigned char>(sign) < ' ' ? '?' : sign;
    }
  }
  return quoted + (length > kLongestText ? "...\"" : "\"");
}

bool IsFieldName(std::string_view text) {
  if (text.empty() || std::isdigit(static_cast<unsigned char>(text[0])) != 0) return false;
  return std::ranges::all_of(text, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

std::string NumberText(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.14g", number);
  return text;
}

/// Keys of the table at `index` in a fixed order: numbers, names, others. Each with its text.
struct Key {
  int rank = 0;
  double number = 0;
  std::string text;
  int place = 0;  ///< Index in the list on the stack.
  friend bool operator<(const Key& a, const Key& b) {
    if (a.rank != b.rank) return a.rank < b.rank;
    return a.rank == 0 ? a.number < b.number : a.text < b.text;
  }
};

/// Pushes an array of at most `most` keys of the table at `index`, and returns them in order.
std::vector<Key> PushKeys(lua_State* state, int index, std::size_t most) {
  std::vector<Key> keys;
  lua_newtable(state);
  const int list = lua_gettop(state);
  lua_pushnil(state);
  while (keys.size() < most && lua_next(state, index) != 0) {
    lua_pop(state, 1);
    Key key;
    key.place = static_cast<int>(keys.size()) + 1;
    if (lua_type(state, -1) == LUA_TNUMBER) {
      key.number = lua_tonumber(state, -1);
      key.text = "[" + NumberText(key.number) + "]";
    } else if (lua_type(state, -1) == LUA_TSTRING) {
      std::size_t length = 0;
      const char* text = lua_tolstring(state, -1, &length);
      key.rank = 1;
      key.text = IsFieldName({text, length}) ? std::string(text, length) : "[" + QuotedText(text, length) + "]";
    } else {
      key.rank = 2;
      key.text = std::string("[") + luaL_typename(state, -1) + "]";
    }
    lua_pushvalue(state, -1);
    lua_rawseti(state, list, key.place);
    keys.push_back(std::move(key));
  }
  lua_settop(state, list);
  std::stable_sort(keys.begin(), keys.end());
  return keys;
}

std::string Described(lua_State* state, int index, bool is_inner = false);

std::string DescribedTable(lua_State* state, int index, bool is_inner) {
  if (is_inner) return "{...}";
  const int top = lua_gettop(state);
  const std::vector<Key> keys = PushKeys(state, index, kMostShownFields);
  const int list = lua_gettop(state);
  std::string text = "{";
  for (std::size_t i = 0; i < std::min(keys.size(), kPreviewed); ++i) {
    lua_rawgeti(state, list, keys[i].place);
    lua_rawget(state, index);
    const std::string name =
        keys[i].rank == 0 && keys[i].number == static_cast<double>(i + 1) ? "" : keys[i].text + " = ";
    text += (i == 0 ? "" : ", ") + name + Described(state, lua_gettop(state), true);
    lua_pop(state, 1);
  }
  if (keys.size() > kPreviewed) text += ", ...";
  lua_settop(state, top);
  return text + "}";
}

std::string DescribedFunction(lua_State* state, int index) {
  lua_Debug info{};
  lua_pushvalue(state, index);
  lua_getinfo(state, ">S", &info);
  if (*info.what == 'C') return "built-in function";
  const std::string file = info.source[0] == '@' ? info.source + 1 : info.short_src;
  return "function " + file + ":" + std::to_string(info.linedefined);
}

/// The thing of the world that a handle refers to: "scout", "object 4".
std::string DescribedHandle(lua_State* state, Handle handle) {
  const std::string number = " " + std::to_string(handle.number);
  switch (handle.kind) {
    case ValueKind::kAgent: {
      const ScriptContext* const context = LuaMachine::Of(state).context();
      const world::Agent* const agent =
          context == nullptr ? nullptr : std::as_const(context->world).FindAgent(world::EntityId{handle.number});
      return agent == nullptr ? "agent" + number : agent->name();
    }
    case ValueKind::kSandbox:
      return "sandbox";
    case ValueKind::kObject:
      return "object" + number;
    case ValueKind::kNode:
      return "scene node" + number;
    case ValueKind::kUi:
      return "panel" + number;
    case ValueKind::kAnimation:
      return "animation" + number;
    default:
      return "userdata";
  }
}

/// Formats the value at `index` (not relative to the top) for a debugger. Calls no script.
std::string Described(lua_State* state, int index, bool is_inner) {
  switch (lua_type(state, index)) {
    case LUA_TNIL:
      return "nil";
    case LUA_TBOOLEAN:
      return lua_toboolean(state, index) != 0 ? "true" : "false";
    case LUA_TNUMBER:
      return NumberText(lua_tonumber(state, index));
    case LUA_TSTRING: {
      std::size_t length = 0;
      const char* text = lua_tolstring(state, index, &length);
      return QuotedText(text, length);
    }
    case LUA_TTABLE:
      return DescribedTable(state, index, is_inner);
    case LUA_TFUNCTION:
      return DescribedFunction(state, index);
    case LUA_TUSERDATA: {
      if (const Handle* handle = ToHandle(state, index)) return DescribedHandle(state, *handle);
      std::string text = "userdata";
      if (luaL_getmetafield(state, index, "__tostring") == 0) return text;
      if (lua_iscfunction(state, -1) != 0) {
        lua_pushvalue(state, index);
        lua_call(state, 1, 1);
        if (const char* shown = lua_tostring(state, -1)) text = shown;
      }
      lua_pop(state, 1);
      return text;
    }
    default:
      return luaL_typename(state, index);
  }
}

/// Adds a variable and replaces an earlier one with the same name.
void Put(std::vector<ScriptVariable>& list, ScriptVariable variable) {
  const auto same = std::ranges::find(list, variable.name, &ScriptVariable::name);
  if (same != list.end()) list.erase(same);
  list.push_back(std::move(variable));
}

}  // namespace

/// The calls of a paused script, from Lua's stack.
struct ScriptView::Calls {
  std::vector<lua_Debug> list;
};

ScriptView::ScriptView() : calls_(std::make_unique<Calls>()) {}

ScriptView::~ScriptView() = default;

std::uint32_t ScriptView::owner() const {
  return machine_ == nullptr ? 0 : machine_->owner();
}

std::vector<ScriptFrame> ScriptView::Frames() const {
  std::vector<ScriptFrame> list;
  if (!is_paused()) return list;
  for (lua_Debug call : calls_->list) {
    lua_getinfo(state_, "Snl", &call);
    ScriptFrame frame;
    const bool is_built_in = *call.what == 'C';
    frame.function = call.name != nullptr ? call.name : is_built_in ? "a built-in function" : "the main chunk";
    if (call.name == nullptr && !is_built_in && *call.what != 'm') frame.function = NameOfGlobalFunction(state_, call);
    if (!is_built_in) {
      const std::string script = call.source[0] == '@' ? call.source + 1 : "";
      frame.file =
          script.empty() ? call.short_src : std::filesystem::absolute(machine_->path().PathOf(script)).string();
      frame.line = call.currentline;
    }
    list.push_back(std::move(frame));
  }
  // The outermost calls are our own, around all scripts.
  while (!list.empty() && list.back().line == 0) list.pop_back();
  return list;
}

ScriptVariable ScriptView::Take(LuaMachine& machine, lua_State* state, std::string name) {
  const int index = lua_gettop(state);
  ScriptVariable variable{std::move(name), Described(state, index), luaL_typename(state, index)};
  const bool is_table = lua_istable(state, index);
  if (is_table && references_.size() < kMostReferences) {
    references_.push_back({&machine, luaL_ref(state, LUA_REGISTRYINDEX)});
    variable.reference = static_cast<int>(references_.size());
  } else {
    lua_pop(state, 1);
  }
  return variable;
}

std::vector<ScriptVariable> ScriptView::Locals(std::size_t frame) {
  std::vector<ScriptVariable> list;
  if (frame >= calls_->list.size() || !is_paused()) return list;
  (void)Guarded(state_, [&](lua_State* inner) {
    lua_Debug call{};
    if (lua_getstack(inner, LevelOf(frame), &call) == 0) return;
    for (int i = 1;; ++i) {
      const char* name = lua_getlocal(inner, &call, i);
      if (name == nullptr) return;
      if (*name == '(') {
        lua_pop(inner, 1);
      } else {
        Put(list, Take(*machine_, inner, name));
      }
    }
  });
  return list;
}

std::vector<ScriptVariable> ScriptView::Upvalues(std::size_t frame) {
  std::vector<ScriptVariable> list;
  if (frame >= calls_->list.size() || !is_paused()) return list;
  (void)Guarded(state_, [&](lua_State* inner) {
    lua_Debug call{};
    if (lua_getstack(inner, LevelOf(frame), &call) == 0) return;
    lua_getinfo(inner, "f", &call);
    const int function = lua_gettop(inner);
    if (lua_iscfunction(inner, function) != 0) return;
    for (int i = 1;; ++i) {
      const char* name = lua_getupvalue(inner, function, i);
      if (name == nullptr) return;
      Put(list, Take(*machine_, inner, name));
    }
  });
  return list;
}

std::vector<ScriptView::Machine> ScriptView::Machines() const {
  std::vector<Machine> list;
  for (const LuaMachine* machine : machines_) {
    const ScriptContext* context = machine->context();
    const world::Agent* agent =
        context == nullptr ? nullptr : std::as_const(context->world).FindAgent(world::EntityId{machine->owner()});
    list.push_back({machine->owner(), agent == nullptr ? "sandbox" : agent->name()});
  }
  return list;
}

LuaMachine* ScriptView::MachineOf(std::uint32_t owner) const {
  const auto found = std::ranges::find(machines_, owner, &LuaMachine::owner);
  return found == machines_.end() ? nullptr : *found;
}

std::vector<ScriptVariable> ScriptView::Globals(std::uint32_t owner) {
  std::vector<ScriptVariable> list;
  LuaMachine* machine = MachineOf(owner);
  if (machine == nullptr) return list;
  const auto collect = [&](lua_State* state) {
    lua_pushvalue(state, LUA_GLOBALSINDEX);
    const int globals = lua_gettop(state);
    lua_getfield(state, LUA_REGISTRYINDEX, "_LOADED");
    const int loaded = lua_gettop(state);
    const std::vector<Key> keys = PushKeys(state, globals, kMostShownFields);
    const int names = lua_gettop(state);
    for (const Key& key : keys) {
      static const std::set<std::string_view> kOurs{"_G",      "_VERSION", "decoda_name",      "debug",
                                                    "package", "os",       "Sandbox_TurnTicks"};
      if (kOurs.contains(key.text)) continue;
      lua_rawgeti(state, names, key.place);
      lua_rawget(state, loaded);
      const bool is_library = lua_istable(state, -1);
      lua_pop(state, 1);
      lua_rawgeti(state, names, key.place);
      lua_rawget(state, globals);
      if (is_library || lua_isfunction(state, -1)) {
        lua_pop(state, 1);
      } else {
        list.push_back(Take(*machine, state, key.text));
      }
    }
  };
  if (is_paused() && machine == machine_) {
    (void)Guarded(state_, collect);
  } else {
    (void)machine->Protected(collect);
  }
  return list;
}

std::vector<ScriptVariable> ScriptView::FieldsAt(LuaMachine& machine, lua_State* state, int index) {
  std::vector<ScriptVariable> list;
  const std::vector<Key> keys = PushKeys(state, index, kMostShownFields);
  const int names = lua_gettop(state);
  for (const Key& key : keys) {
    lua_rawgeti(state, names, key.place);
    lua_rawget(state, index);
    list.push_back(Take(machine, state, key.text));
  }
  if (keys.size() == kMostShownFields)
    list.push_back({"...", "only " + std::to_string(kMostShownFields) + " are listed", "", 0});
  if (lua_getmetatable(state, index) != 0) list.push_back(Take(machine, state, "(metatable)"));
  return list;
}

std::vector<ScriptVariable> ScriptView::Fields(int reference) {
  std::vector<ScriptVariable> list;
  if (reference < 1 || static_cast<std::size_t>(reference) > references_.size()) return list;
  const Reference held = references_[static_cast<std::size_t>(reference) - 1];
  if (held.machine == nullptr) return list;
  const auto collect = [&](lua_State* state) {
    lua_rawgeti(state, LUA_REGISTRYINDEX, held.kept);
    list = FieldsAt(*held.machine, state, lua_gettop(state));
  };
  if (is_paused() && held.machine == machine_) {
    (void)Guarded(state_, collect);
  } else {
    (void)held.machine->Protected(collect);
  }
  return list;
}

namespace {

/// Pushes the variable to which `name` refers in the call at this level: a local one, one of an enclosing function, or
/// a global one.
bool PushVariableOf(lua_State* state, int level, const std::string& name) {
  lua_Debug call{};
  if (lua_getstack(state, level, &call) == 0) return false;
  int found = 0;
  for (int i = 1;; ++i) {
    const char* local = lua_getlocal(state, &call, i);
    if (local == nullptr) break;
    if (name == local) found = i;
    lua_pop(state, 1);
  }
  if (found > 0) return lua_getlocal(state, &call, found) != nullptr;
  lua_getinfo(state, "f", &call);
  const int function = lua_gettop(state);
  for (int i = 1; lua_iscfunction(state, function) == 0; ++i) {
    const char* upvalue = lua_getupvalue(state, function, i);
    if (upvalue == nullptr) break;
    if (name == upvalue) {
      lua_remove(state, function);
      return true;
    }
    lua_pop(state, 1);
  }
  lua_getfenv(state, function);
  lua_pushlstring(state, name.data(), name.size());
  lua_rawget(state, -2);
  lua_replace(state, function);
  lua_settop(state, function);
  return true;
}

bool PushGlobal(lua_State* state, const std::string& name) {
  lua_pushlstring(state, name.data(), name.size());
  lua_rawget(state, LUA_GLOBALSINDEX);
  return true;
}

}  // namespace

Result<ScriptVariable> ScriptView::Evaluate(std::size_t frame, std::string_view expression, MayCall may_call) {
  if (!is_paused()) return NewProblem("no script is paused");
  if (frame >= calls_->list.size()) return NewProblem("there is no such call any more");
  ScriptVariable value;
  const LuaMachine::OwnBudget budget(*machine_, kEvaluationBudget);
  const auto failed = Guarded(state_, [&](lua_State* inner) {
    EvaluateExpression(
        inner, expression,
        [&](lua_State* state, const std::string& name) { return PushVariableOf(state, LevelOf(frame), name); },
        may_call);
    value = Take(*machine_, inner, std::string(expression));
  });
  if (failed) return NewProblem(*failed);
  return value;
}

Result<ScriptVariable> ScriptView::EvaluateGlobal(std::uint32_t owner, std::string_view expression) {
  LuaMachine* machine = MachineOf(owner);
  if (machine == nullptr) return NewProblem("there is no such script");
  ScriptVariable value;
  const auto failed = machine->Protected([&](lua_State* state) {
    EvaluateExpression(state, expression, PushGlobal);
    value = Take(*machine, state, std::string(expression));
  });
  if (failed) return NewProblem(failed->diagnostic.message);
  return value;
}

Result<bool> ScriptView::Holds(LuaMachine& machine, lua_State* state, const std::string& condition, MayCall may_call) {
  bool holds = false;
  const LuaMachine::OwnBudget budget(machine, kEvaluationBudget);
  const auto failed = Guarded(state, [&](lua_State* inner) {
    EvaluateExpression(
        inner, condition, [&](lua_State* at, const std::string& name) { return PushVariableOf(at, 1, name); },
        may_call);
    holds = lua_toboolean(inner, -1) != 0;
  });
  if (failed) return NewProblem(*failed);
  return holds;
}

void ScriptView::BeginPause(LuaMachine& machine, lua_State* state, int first_level, std::string reason,
                            std::string error) {
  machine_ = &machine;
  state_ = state;
  first_level_ = first_level;
  reason_ = std::move(reason);
  error_ = std::move(error);
  lua_Debug call{};
  calls_->list.clear();
  for (int level = first_level; calls_->list.size() < kMostFrames && lua_getstack(state, level, &call) == 1; ++level)
    calls_->list.push_back(call);
}

void ScriptView::EndPause() {
  DropReferences();
  machine_ = nullptr;
  state_ = nullptr;
  calls_->list.clear();
}

void ScriptView::Forget(LuaMachine& machine) {
  std::erase(machines_, &machine);
  for (Reference& held : references_)
    if (held.machine == &machine) held.machine = nullptr;
}

void ScriptView::DropReferences() {
  for (const Reference& held : references_)
    if (held.machine != nullptr) held.machine->Release(held.kept);
  references_.clear();
}

}  // namespace soarbox::script
