// SPDX-License-Identifier: BSD-2-Clause
#include "script/keep_state.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <functional>
#include <lua.hpp>
#include <map>
#include <set>

namespace soarbox::script {
namespace {

constexpr std::string_view kMark = "\n--@reload\t";
constexpr std::string_view kOldMark = "\n--@keep";  ///< Used by recordings that contain no file name.
constexpr const char* kTable = "soarbox.kept";
constexpr int kDeepest = 16;          ///< Maximum depth of nested functions and tables.
constexpr std::size_t kMost = 10000;  ///< Maximum number of functions and tables that are visited.

bool IsName(std::string_view word) {
  return !word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) == 0 &&
         std::all_of(word.begin(), word.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

/// Finds declarations at the beginning of a line, "local x = 3" and "x = {...". Each extends to the next line without
/// indentation that contains more than a closing bracket.
std::vector<std::pair<std::string, std::string>> Declarations(std::string_view text) {
  std::vector<std::pair<std::string, std::string>> found;
  std::string statement;
  const auto close = [&] {
    std::string_view rest = statement;
    if (rest.starts_with("local ")) rest.remove_prefix(6);
    const std::size_t equals = rest.find('=');
    const bool declares = equals != std::string_view::npos || statement.starts_with("local ");
    for (std::string_view left = rest.substr(0, equals); declares && !left.empty();) {
      const std::size_t comma = std::min(left.find(','), left.size());
      std::string name(left.substr(0, comma));
      left.remove_prefix(std::min(comma + 1, left.size()));
      name.erase(name.find_last_not_of(" \t\r\n;") + 1);
      name.erase(0, std::min(name.find_first_not_of(" \t"), name.size()));
      if (IsName(name)) found.emplace_back(name, statement);
    }
    statement.clear();
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (const std::size_t last = line.find_last_not_of(" \t\r"); last == std::string_view::npos) continue;
    const bool goes_on = std::isspace(static_cast<unsigned char>(line[0])) != 0 || line[0] == '}' || line[0] == ')';
    if (!goes_on) close();
    if (!line.starts_with("--")) statement += std::string(line) + "\n";
  }
  close();
  return found;
}

/// Returns the names of a table's fields, sorted, so that their order in memory does not matter.
std::vector<std::string> FieldNames(lua_State* state, int table) {
  std::vector<std::string> names;
  lua_pushnil(state);
  while (lua_next(state, table) != 0) {
    lua_pop(state, 1);
    std::size_t length = 0;
    if (lua_type(state, -1) != LUA_TSTRING) continue;
    const char* name = lua_tolstring(state, -1, &length);
    names.emplace_back(name, length);
  }
  std::sort(names.begin(), names.end());
  return names;
}

void PushField(lua_State* state, int table, const std::string& name) {
  lua_pushlstring(state, name.data(), name.size());
  lua_rawget(state, table);
}

/// Calls visit() with a function on top of the stack for each function of a script: those in globals, in tables in
/// globals, and in upvalues of these functions.
class Functions {
 public:
  Functions(lua_State* state, std::string_view script) : state_(state), script_(script) {}

  void VisitAll(const std::function<void()>& visit) {
    lua_pushvalue(state_, LUA_GLOBALSINDEX);
    Visit(visit, 0);
    lua_pop(state_, 1);
  }

 private:
  bool IsMine() {
    lua_Debug info;
    lua_pushvalue(state_, -1);
    lua_getinfo(state_, ">S", &info);
    const std::string_view source = info.source == nullptr ? "" : info.source;
    return source.ends_with(script_) || source.ends_with("console");
  }

  /// Visits the value on top of the stack.
  void Visit(const std::function<void()>& visit, int depth) {
    const bool is_table = lua_istable(state_, -1);
    const bool is_function = lua_isfunction(state_, -1) && lua_iscfunction(state_, -1) == 0;
    if ((!is_table && !is_function) || depth > kDeepest || seen_.size() >= kMost) return;
    if (!seen_.insert(lua_topointer(state_, -1)).second || lua_checkstack(state_, 8) == 0) return;
    if (is_table) return VisitFields(visit, depth);
    if (!IsMine()) return;
    visit();
    for (int i = 1; lua_getupvalue(state_, -1, i) != nullptr; ++i) {
      Visit(visit, depth + 1);
      lua_pop(state_, 1);
    }
  }

  void VisitFields(const std::function<void()>& visit, int depth) {
    const int table = lua_gettop(state_);
    for (const std::string& name : FieldNames(state_, table)) {
      PushField(state_, table, name);
      Visit(visit, depth + 1);
      lua_pop(state_, 1);
    }
    const int length = static_cast<int>(std::min<std::size_t>(lua_objlen(state_, table), kMost));
    for (int i = 1; i <= length; ++i) {
      lua_rawgeti(state_, table, i);
      Visit(visit, depth + 1);
      lua_pop(state_, 1);
    }
  }

  lua_State* state_;
  std::string_view script_;
  std::set<const void*> seen_;
};

/// Copies the functions of the table at `from`, and its new fields, to the table at `to`. Does the same for tables that
/// both contain under the same name.
void TakeFunctions(lua_State* state, int to, int from, std::set<const void*>& seen, int depth = 0) {
  if (depth > kDeepest || lua_rawequal(state, to, from) != 0 || lua_checkstack(state, 8) == 0) return;
  if (seen.size() >= kMost || !seen.insert(lua_topointer(state, from)).second) return;
  for (const std::string& name : FieldNames(state, from)) {
    PushField(state, to, name);
    PushField(state, from, name);
    if (lua_isfunction(state, -1) || lua_isnil(state, -2)) {
      lua_pushlstring(state, name.data(), name.size());
      lua_insert(state, -2);
      lua_rawset(state, to);
      lua_pop(state, 1);
      continue;
    }
    if (lua_istable(state, -1) && lua_istable(state, -2))
      TakeFunctions(state, lua_gettop(state) - 1, lua_gettop(state), seen, depth + 1);
    lua_pop(state, 2);
  }
}

}  // namespace

std::vector<std::string> UnchangedVariables(std::string_view before, std::string_view after) {
  std::map<std::string, std::string> old;
  for (auto& [name, statement] : Declarations(before)) old.emplace(name, statement);
  std::vector<std::string> names;
  for (const auto& [name, statement] : Declarations(after)) {
    const auto same = old.find(name);
    if (same != old.end() && same->second == statement) names.push_back(name);
  }
  return names;
}

std::string WithReload(std::string text, const Reload& reload) {
  text += kMark;
  text += reload.file + "\t";
  for (std::size_t i = 0; i < reload.names.size(); ++i) text += (i == 0 ? "" : " ") + reload.names[i];
  return text;
}

std::optional<Reload> ReadReload(std::string_view text) {
  Reload reload;
  std::string_view rest;
  const std::size_t at = text.rfind('\n');
  if (at == std::string_view::npos) return std::nullopt;
  if (text.substr(at).starts_with(kMark)) {
    rest = text.substr(at + kMark.size());
    const std::size_t tab = rest.find('\t');
    if (tab == std::string_view::npos) return std::nullopt;
    reload.file = rest.substr(0, tab);
    rest.remove_prefix(tab + 1);
  } else if (text.substr(at).starts_with(kOldMark)) {
    rest = text.substr(at + kOldMark.size());
  } else {
    return std::nullopt;
  }
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (IsName(rest.substr(0, end))) reload.names.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return reload;
}

std::string_view WithoutReload(std::string_view text) {
  return ReadReload(text) ? text.substr(0, text.rfind('\n')) : text;
}

void CollectKept(lua_State* state, const std::vector<std::string>& names, std::string_view script) {
  lua_newtable(state);
  const int kept = lua_gettop(state);
  for (const std::string& name : names) {
    lua_pushlstring(state, name.data(), name.size());
    lua_rawget(state, LUA_GLOBALSINDEX);
    if (lua_isfunction(state, -1)) {
      lua_pop(state, 1);
    } else {
      lua_setfield(state, kept, name.c_str());
    }
  }
  Functions(state, script).VisitAll([&] {
    const char* name = nullptr;
    for (int i = 1; (name = lua_getupvalue(state, -1, i)) != nullptr; ++i) {
      if (lua_isnil(state, -1) || lua_isfunction(state, -1) ||
          std::find(names.begin(), names.end(), name) == names.end()) {
        lua_pop(state, 1);
      } else {
        lua_setfield(state, kept, name);
      }
    }
  });
  lua_setfield(state, LUA_REGISTRYINDEX, kTable);
}

void RestoreKept(lua_State* state, const std::vector<std::string>& names, std::string_view script) {
  lua_getfield(state, LUA_REGISTRYINDEX, kTable);
  const int kept = lua_gettop(state);
  if (!lua_istable(state, kept)) return lua_pop(state, 1);
  std::set<const void*> taken;
  for (const std::string& name : names) {
    lua_pushlstring(state, name.data(), name.size());
    lua_rawget(state, LUA_GLOBALSINDEX);
    const bool is_global = !lua_isnil(state, -1) && !lua_isfunction(state, -1);
    lua_getfield(state, kept, name.c_str());
    if (is_global && !lua_isnil(state, -1)) {
      const int was = lua_gettop(state);
      if (lua_istable(state, was) && lua_istable(state, was - 1)) TakeFunctions(state, was, was - 1, taken);
      lua_pushlstring(state, name.data(), name.size());
      lua_insert(state, -2);
      lua_rawset(state, LUA_GLOBALSINDEX);
    } else {
      lua_pop(state, 1);
    }
    lua_pop(state, 1);
  }
  Functions(state, script).VisitAll([&] {
    const int function = lua_gettop(state);
    const char* name = nullptr;
    for (int i = 1; (name = lua_getupvalue(state, function, i)) != nullptr; ++i) {
      const bool is_kept = !lua_isfunction(state, -1) && std::find(names.begin(), names.end(), name) != names.end();
      const int is = lua_gettop(state);
      if (is_kept) {
        lua_getfield(state, kept, name);
        if (lua_istable(state, -1) && lua_istable(state, is)) TakeFunctions(state, is + 1, is, taken);
        if (lua_isnil(state, -1)) {
          lua_pop(state, 1);
        } else {
          lua_setupvalue(state, function, i);
        }
      }
      lua_settop(state, function);
    }
  });
  lua_pop(state, 1);
  lua_pushnil(state);
  lua_setfield(state, LUA_REGISTRYINDEX, kTable);
}

}  // namespace soarbox::script
