// SPDX-License-Identifier: BSD-2-Clause
#include "script/percept_graph.h"

#include <algorithm>
#include <cmath>
#include <lua.hpp>
#include <map>
#include <set>
#include <string>

namespace soarbox::script {
namespace {

constexpr std::size_t kMostNodes = 2'000, kMostElements = 20'000;
constexpr const char *kKey = "_key", *kNew = "_new";

/// Numbers the tables that it visits. A list on the stack keeps the tables alive.
class GraphCopier {
 public:
  explicit GraphCopier(lua_State* state) : state_(state) {
    luaL_checkstack(state, 10, "percepts");
    lua_newtable(state);
    found_ = lua_gettop(state);
  }

  PerceptGraph Copy(int index) {
    Meet(index);
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      lua_rawgeti(state_, found_, static_cast<int>(n + 1));
      CopyFields(n, lua_gettop(state_));
      lua_pop(state_, 1);
    }
    return std::move(graph_);
  }

 private:
  std::size_t Meet(int index) {
    const auto [at, is_new] = numbers_.try_emplace(lua_topointer(state_, index), graph_.nodes.size());
    if (!is_new) return at->second;
    if (graph_.nodes.size() >= kMostNodes) luaL_error(state_, "these are too many percepts: 2000 objects at most");
    graph_.nodes.emplace_back();
    lua_pushvalue(state_, index);
    lua_rawseti(state_, found_, static_cast<int>(graph_.nodes.size()));
    return at->second;
  }

  /// In alphabetical order, because it determines the numbers and Lua's own order differs from process to process.
  void CopyFields(std::size_t node, int table) {
    std::vector<std::string> names;
    lua_pushnil(state_);
    while (lua_next(state_, table) != 0) {
      if (lua_type(state_, -2) == LUA_TSTRING) names.emplace_back(lua_tostring(state_, -2));
      lua_pop(state_, 1);
    }
    std::sort(names.begin(), names.end());
    ReadNew(table);
    for (const std::string& name : names) {
      lua_pushlstring(state_, name.data(), name.size());
      lua_rawget(state_, table);
      const int value = lua_gettop(state_);
      if (name == kNew) {
        // It describes the other fields.
      } else if (name == kKey) {
        if (lua_isstring(state_, value) != 0) graph_.nodes[node].key = lua_tostring(state_, value);
      } else if (IsList(value)) {
        CopyList(node, name, value);
      } else {
        CopyValue(node, name, value);
      }
      lua_pop(state_, 1);
    }
  }

  /// Reads which constants of a table are new.
  void ReadNew(int table) {
    new_names_.clear();
    lua_getfield(state_, table, kNew);
    const int value = lua_gettop(state_);
    all_are_new_ = lua_isboolean(state_, value) && lua_toboolean(state_, value) != 0;
    for (int i = 1; lua_istable(state_, value); ++i) {
      lua_rawgeti(state_, value, i);
      const bool is_name = lua_type(state_, -1) == LUA_TSTRING;
      if (is_name) new_names_.insert(lua_tostring(state_, -1));
      lua_pop(state_, 1);
      if (!is_name) break;
    }
    lua_pop(state_, 1);
  }

  bool IsList(int value) const {
    if (!lua_istable(state_, value)) return false;
    lua_rawgeti(state_, value, 1);
    const bool is_list = !lua_isnil(state_, -1);
    lua_pop(state_, 1);
    return is_list;
  }

  void CopyList(std::size_t node, const std::string& name, int list) {
    for (int i = 1;; ++i) {
      lua_rawgeti(state_, list, i);
      const bool at_end = lua_isnil(state_, -1);
      if (!at_end) CopyValue(node, name, lua_gettop(state_));
      lua_pop(state_, 1);
      if (at_end) return;
    }
  }

  void CopyValue(std::size_t node, const std::string& name, int value) {
    if (++elements_ > kMostElements) luaL_error(state_, "these are too many percepts: 20000 elements at most");
    PerceptGraph::Value constant;
    switch (lua_type(state_, value)) {
      case LUA_TTABLE: {
        const std::size_t below = Meet(value);
        graph_.nodes[node].links.push_back({name, below});
        return;
      }
      case LUA_TNUMBER: {
        const double number = lua_tonumber(state_, value);
        if (!std::isfinite(number)) return;
        constexpr double kLargestWhole = 1e15;
        if (number == std::floor(number) && std::abs(number) < kLargestWhole) {
          constant = static_cast<std::int64_t>(number);
        } else {
          constant = number;
        }
        break;
      }
      case LUA_TSTRING:
        constant = std::string(lua_tostring(state_, value));
        break;
      case LUA_TBOOLEAN:
        constant = std::string(lua_toboolean(state_, value) != 0 ? "yes" : "no");
        break;
      default:
        return;
    }
    graph_.nodes[node].constants.push_back({name, std::move(constant), all_are_new_ || new_names_.contains(name)});
  }

  lua_State* state_;
  int found_ = 0;
  std::size_t elements_ = 0;
  bool all_are_new_ = false;  ///< In the table that is being read.
  std::set<std::string> new_names_;
  std::map<const void*, std::size_t> numbers_;
  PerceptGraph graph_;
};

}  // namespace

PerceptGraph CopyGraph(lua_State* state, int index) {
  const int top = lua_gettop(state);
  PerceptGraph graph = GraphCopier(state).Copy(index < 0 ? top + 1 + index : index);
  lua_settop(state, top);
  return graph;
}

}  // namespace soarbox::script
