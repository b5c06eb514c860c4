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

constexpr std::string_view kMark = "\n--@keep";
constexpr const char* kTable = "soarbox.kept";
constexpr int kDeepest = 16;          ///< Functions that functions hold.
constexpr std::size_t kMost = 10000;  ///< Functions looked at.

bool IsName(std::string_view word) {
  return !word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) == 0 &&
         std::all_of(word.begin(), word.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
}

/// Declarations at the beginning of a line, "local x = 3" and "x = {...", each up to the next line that begins at the
/// margin with more than a closing bracket.
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

/// Calls visit(function at the top of the stack) for the global functions of a script and those that they hold.
class Functions {
 public:
  Functions(lua_State* state, std::string_view script) : state_(state), script_(script) {}

  void VisitAll(const std::function<void()>& visit) {
    lua_pushvalue(state_, LUA_GLOBALSINDEX);
    lua_pushnil(state_);
    while (lua_next(state_, -2) != 0) {
      Visit(visit, 0);
      lua_pop(state_, 1);
    }
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

  void Visit(const std::function<void()>& visit, int depth) {
    if (!lua_isfunction(state_, -1) || lua_iscfunction(state_, -1) != 0 || depth > kDeepest) return;
    if (seen_.size() >= kMost || !seen_.insert(lua_topointer(state_, -1)).second || !IsMine()) return;
    if (lua_checkstack(state_, 8) == 0) return;
    visit();
    for (int i = 1; lua_getupvalue(state_, -1, i) != nullptr; ++i) {
      Visit(visit, depth + 1);
      lua_pop(state_, 1);
    }
  }

  lua_State* state_;
  std::string_view script_;
  std::set<const void*> seen_;
};

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

std::string WithKept(std::string text, const std::vector<std::string>& names) {
  if (names.empty()) return text;
  text += kMark;
  for (const std::string& name : names) text += " " + name;
  return text;
}

std::vector<std::string> KeptNames(std::string_view text) {
  const std::size_t mark = text.rfind(kMark);
  if (mark == std::string_view::npos || text.find('\n', mark + 1) != std::string_view::npos) return {};
  std::vector<std::string> names;
  std::string_view rest = text.substr(mark + kMark.size());
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (IsName(rest.substr(0, end))) names.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return names;
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
      if (lua_isfunction(state, -1) || std::find(names.begin(), names.end(), name) == names.end()) {
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
  for (const std::string& name : names) {
    lua_pushlstring(state, name.data(), name.size());
    lua_rawget(state, LUA_GLOBALSINDEX);
    const bool is_global = !lua_isnil(state, -1) && !lua_isfunction(state, -1);
    lua_pop(state, 1);
    lua_getfield(state, kept, name.c_str());
    if (is_global && !lua_isnil(state, -1)) {
      lua_pushlstring(state, name.data(), name.size());
      lua_insert(state, -2);
      lua_rawset(state, LUA_GLOBALSINDEX);
    } else {
      lua_pop(state, 1);
    }
  }
  Functions(state, script).VisitAll([&] {
    const int function = lua_gettop(state);
    const char* name = nullptr;
    for (int i = 1; (name = lua_getupvalue(state, function, i)) != nullptr; ++i) {
      const bool is_kept = !lua_isfunction(state, -1) && std::find(names.begin(), names.end(), name) != names.end();
      lua_pop(state, 1);
      if (!is_kept) continue;
      lua_getfield(state, kept, name);
      if (lua_isnil(state, -1)) {
        lua_pop(state, 1);
      } else {
        lua_setupvalue(state, function, i);
      }
    }
  });
  lua_pop(state, 1);
  lua_pushnil(state);
  lua_setfield(state, LUA_REGISTRYINDEX, kTable);
}

}  // namespace soarbox::script
