// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <lua.hpp>
#include <span>
#include <vector>

#include "script/argument_check.h"
#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/lua_order.h"
#include "world/agent_store.h"
#include "world/steer_group.h"

// Agent: steering forces (lua_api.md 7).

namespace soarbox::script {
namespace {

using world::Agent;
using world::EntityId;
using world::Vec3;

/// Returns the agent at the top of the stack; the error for other values names the list.
EntityId ListedAgent(lua_State* state, int list_index) {
  const Handle* handle = ToHandle(state, -1);
  if (!handle || handle->kind != ValueKind::kAgent)
    ArgumentError(state, list_index,
                  lua_pushfstring(state, "a table of agents expected; it holds a %s", NameOfValue(state, -1)));
  return EntityId{handle->number};
}

/// Reads the table in Lua's own order; false if the keys are not 1, 2, 3, ...
bool ReadInPlainOrder(lua_State* state, int index, std::vector<EntityId>& buffer) {
  // An array of agents, which is usual, is read by number, which takes a third of the time.
  const int count = static_cast<int>(lua_objlen(state, index));
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(state, index, i);
    if (lua_isnil(state, -1)) break;
    buffer.push_back(ListedAgent(state, index));
    lua_pop(state, 1);
  }
  // The table must contain nothing else.
  const bool is_whole = buffer.size() == static_cast<std::size_t>(count);
  if (!is_whole || count == 0) {
    lua_pushnil(state);
  } else {
    lua_pushinteger(state, count);
  }
  if (lua_next(state, index) == 0) return true;
  lua_pop(state, 2);
  if (!is_whole) lua_pop(state, 1);
  buffer.clear();
  lua_pushnil(state);
  while (lua_next(state, index) != 0) {
    if (lua_tonumber(state, -2) != static_cast<double>(buffer.size() + 1)) {
      lua_pop(state, 2);
      return false;
    }
    buffer.push_back(ListedAgent(state, index));
    lua_pop(state, 1);
  }
  return true;
}

/// The agents of the team with the name at `index` that can be neighbours at this distance, in creation order. Valid
/// until the next search.
std::span<const std::uint32_t> NearInTeam(lua_State* state, int index, const Agent& agent, float distance_m) {
  const std::string_view team = TextArgument(state, index);
  world::AgentStore& store = world::AgentStore::Of(agent);
  const float range_m = world::NeighbourhoodRange(agent.Radius(), std::max(distance_m, 0.0f));
  const std::size_t all_near = store.NearInOrder(agent.Position(), range_m).size();
  const std::span<const std::uint32_t> near = store.NearInOrder(agent.Position(), range_m, team);
  // Agents of other teams cost a comparison each.
  LuaMachine::Of(state).Charge(all_near / 4);
  LuaMachine::Of(state).Charge(near.size());
  return near;
}

/// Returns the agents that the argument at `index` selects for a force with this distance: in the order of a table, and
/// otherwise in creation order. Returns the world's own list if it is equal, because the world then finds near
/// neighbours faster.
Agent::Group AgentsArgument(lua_State* state, int index, const Agent& agent, float distance_m,
                            std::vector<EntityId>& buffer) {
  if (lua_isnoneornil(state, index)) return ContextOf(state).world.AgentIds();
  if (lua_type(state, index) == LUA_TSTRING) return NearInTeam(state, index, agent, distance_m);
  luaL_checktype(state, index, LUA_TTABLE);
  const auto everybody = ContextOf(state).world.AgentIds();
  LuaMachine& machine = LuaMachine::Of(state);
  if (machine.agent_lists.Holds(state, index, everybody)) {
    machine.Charge(everybody.size());
    return everybody;
  }
  buffer.clear();
  if (!ReadInPlainOrder(state, index, buffer)) {
    buffer.clear();
    PushOrderedKeys(state, index);
    const int keys = static_cast<int>(lua_objlen(state, -1));
    for (int i = 1; i <= keys; ++i) {
      lua_rawgeti(state, -1, i);
      lua_rawget(state, index);
      buffer.push_back(ListedAgent(state, index));
      lua_pop(state, 1);
    }
    lua_pop(state, 1);
  }
  machine.Charge(buffer.size());
  return std::ranges::equal(buffer, everybody) ? everybody : std::span<const EntityId>(buffer);
}

/// (agent, distance [, team]): the agents within the distance, in creation order, without the agent itself.
int GetNeighbours(lua_State* state) {
  const Agent& agent = AgentArgument(state, 1);
  const float distance = CheckFloat(state, 2);
  std::optional<std::string_view> team;
  if (!lua_isnoneornil(state, 3)) team = TextArgument(state, 3);
  world::AgentStore& store = world::AgentStore::Of(agent);
  lua_newtable(state);
  int count = 0;
  for (const std::uint32_t index : store.NearInOrder(agent.Position(), std::max(distance, 0.0f), team)) {
    const Agent& other = store.agent(index);
    if (other.id() == agent.id()) continue;
    if (Length(other.Position() - agent.Position()) > distance) continue;
    PushAgent(state, other.id());
    lua_rawseti(state, -2, ++count);
  }
  LuaMachine::Of(state).Charge(static_cast<std::uint64_t>(count));
  return 1;
}

using GroupForce = Vec3 (Agent::*)(float, float, const Agent::Group&) const;

/// (agent, max distance, max angle in degrees [, agents or team])
template <GroupForce Force>
int PushGroupForce(lua_State* state) {
  static thread_local std::vector<EntityId> buffer;
  const Agent& agent = AgentArgument(state, 1);
  const float distance = CheckFloat(state, 2), angle = CheckFloat(state, 3);
  PushVector(state, (agent.*Force)(distance, angle, AgentsArgument(state, 4, agent, distance, buffer)));
  return 1;
}

/// (agent [, seconds])
template <Vec3 (Agent::*Force)(float) const>
int PushLookAheadForce(lua_State* state) {
  const Agent& agent = AgentArgument(state, 1);
  const float seconds = lua_gettop(state) > 1 ? CheckFloat(state, 2) : Agent::kDefaultLookAhead_s;
  PushVector(state, (agent.*Force)(seconds));
  return 1;
}

template <Vec3 (Agent::*Force)(Vec3) const>
int PushPositionForce(lua_State* state) {
  const Vec3 position = CheckVector(state, 2);
  PushVector(state, (AgentArgument(state, 1).*Force)(position));
  return 1;
}

/// (agent, other agent [, longest prediction in seconds]): not among the original sandbox's forces.
template <Vec3 (Agent::*Force)(EntityId, float) const>
int PushChaseForce(lua_State* state) {
  const Agent& agent = AgentArgument(state, 1);
  const EntityId other = AgentArgument(state, 2).id();
  if (other == agent.id()) WarnAtCaller(state, "the agent chases or flees itself: there is no force");
  PushVector(state, (agent.*Force)(other, lua_gettop(state) > 2 ? CheckFloat(state, 3) : 1.0f));
  return 1;
}

int ForceToTargetSpeed(lua_State* state) {
  const float speed = CheckFloat(state, 2);
  PushVector(state, AgentArgument(state, 1).ForceToTargetSpeed(speed));
  return 1;
}

int ForceToWander(lua_State* state) {
  const float delta = CheckFloat(state, 2);
  PushVector(state, AgentArgument(state, 1).ForceToWander(delta));
  return 1;
}

constexpr Binding kAgentSteeringBindings[] = {
    {"ForceToAlign", PushGroupForce<&Agent::ForceToAlign>, 3, 4, WrongCount::kIgnored},
    {"ForceToAvoidAgents", PushLookAheadForce<&Agent::ForceToAvoidAgents>, 1, 2, WrongCount::kIgnored},
    {"ForceToAvoidObjects", PushLookAheadForce<&Agent::ForceToAvoidObjects>, 1, 2, WrongCount::kIgnored},
    {"ForceToCombine", PushGroupForce<&Agent::ForceToCombine>, 3, 4, WrongCount::kIgnored},
    {"ForceToEvade", PushChaseForce<&Agent::ForceToEvade>, 2, 3, WrongCount::kError},
    {"ForceToFleePosition", PushPositionForce<&Agent::ForceToFleePosition>, 2, 2, WrongCount::kError},
    {"ForceToFollowPath", PushLookAheadForce<&Agent::ForceToFollowPath>, 1, 3, WrongCount::kError},
    {"ForceToPosition", PushPositionForce<&Agent::ForceToPosition>, 2, 2, WrongCount::kError},
    {"ForceToPursue", PushChaseForce<&Agent::ForceToPursue>, 2, 3, WrongCount::kError},
    {"ForceToSeparate", PushGroupForce<&Agent::ForceToSeparate>, 3, 4, WrongCount::kError},
    {"ForceToStayOnPath", PushLookAheadForce<&Agent::ForceToStayOnPath>, 1, 3, WrongCount::kError},
    {"ForceToTargetSpeed", ForceToTargetSpeed, 2, 2, WrongCount::kError},
    {"ForceToWander", ForceToWander, 2, 2, WrongCount::kError},
    {"GetNeighbours", GetNeighbours, 2, 3, WrongCount::kError},
};

}  // namespace

void BindAgentSteering(lua_State* state) {
  RegisterTable(state, "Agent", kAgentSteeringBindings);
}

}  // namespace soarbox::script
