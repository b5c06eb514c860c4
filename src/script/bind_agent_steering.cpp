// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <lua.hpp>
#include <span>
#include <vector>

#include "script/api_call.h"
#include "script/argument_check.h"
#include "script/lua_order.h"
#include "world/agent_store.h"
#include "world/steer_group.h"

// Agent: steering forces (lua_api.md 7).

namespace soarbox::script {
namespace {

using world::Agent;
using world::EntityId;
using world::Vec3;
using enum WrongCount;

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

/// The agents within the distance, in creation order, without the agent itself.
std::vector<Handle> GetNeighbours(lua_State* state, const Agent& agent, float distance,
                                  std::optional<std::string_view> team) {
  world::AgentStore& store = world::AgentStore::Of(agent);
  std::vector<Handle> neighbours;
  for (const std::uint32_t index : store.NearInOrder(agent.Position(), std::max(distance, 0.0f), team)) {
    const Agent& other = store.agent(index);
    if (other.id() != agent.id() && Length(other.Position() - agent.Position()) <= distance)
      neighbours.push_back({ValueKind::kAgent, Number(other.id())});
  }
  LuaMachine::Of(state).Charge(neighbours.size());
  return neighbours;
}

/// (agent, max distance, max angle in degrees [, agents or team])
template <Vec3 (Agent::*kForce)(float, float, const Agent::Group&) const>
Vec3 GroupForce(lua_State* state, const Agent& agent, float distance, float angle) {
  static thread_local std::vector<EntityId> buffer;
  return (agent.*kForce)(distance, angle, AgentsArgument(state, 4, agent, distance, buffer));
}

template <Vec3 (Agent::*kForce)(float) const>
Vec3 LookAheadForce(const Agent& agent, std::optional<float> seconds) {
  return (agent.*kForce)(seconds.value_or(Agent::kDefaultLookAhead_s));
}

/// (agent, other agent [, longest prediction in seconds]): not among the original sandbox's forces.
template <Vec3 (Agent::*kForce)(EntityId, float) const>
Vec3 ChaseForce(lua_State* state, const Agent& agent, const Agent& other, std::optional<float> prediction_s) {
  if (other.id() == agent.id()) WarnAtCaller(state, "the agent chases or flees itself: there is no force");
  return (agent.*kForce)(other.id(), prediction_s.value_or(1));
}

constexpr ApiFunction kAgentSteeringFunctions[] = {
    {"Agent.ForceToAlign", kCall<GroupForce<&Agent::ForceToAlign>>, kIgnored,
     "agent: Agent, distance: number 0..inf [m], angle: number [deg], agents: Agents = everybody", "Vector",
     "A force towards the average direction that the neighbours face. Neighbours are the agents within the distance "
     "and "
     "within the angle on either side of the front (180 is all around). The force has length 1; without neighbours it "
     "is zero. `agents` selects who can be a neighbour: everybody if you leave it out, a team if it is the team's "
     "name, "
     "or the agents of a table. Without a table, only agents nearby are read, so a large flock is much faster.",
     R"(local force = agent:ForceToAlign(10, 180, agent:GetTeam()))"},
    {"Agent.ForceToAvoidAgents", kCall<LookAheadForce<&Agent::ForceToAvoidAgents>>, kIgnored,
     "agent: Agent, time: number 0.1..1000 [s] = 0.1", "Vector",
     "A force sideways to avoid a collision with another living agent within this time. It considers the first agent "
     "that would be hit.",
     R"(local force = agent:ForceToAvoidAgents(1.5) * 3)"},
    {"Agent.ForceToAvoidObjects", kCall<LookAheadForce<&Agent::ForceToAvoidObjects>>, kIgnored,
     "agent: Agent, time: number 0.1..1000 [s] = 0.1", "Vector",
     "A force sideways to avoid movable objects that the agent would reach within this time. For fixed objects, use "
     "the navigation mesh.",
     R"(local force = agent:ForceToAvoidObjects(1.5) * 3)"},
    {"Agent.ForceToCombine", kCall<GroupForce<&Agent::ForceToCombine>>, kIgnored,
     "agent: Agent, distance: number 0..inf [m], angle: number [deg], agents: Agents = everybody", "Vector",
     "A force towards the centre of the neighbours. Neighbours are defined as for ForceToAlign.",
     R"(local force = agent:ForceToCombine(100, 180, {other})
print(Vector.Length(force) > 0.99)  --> true)"},
    {"Agent.ForceToEvade", kCall<ChaseForce<&Agent::ForceToEvade>>, kError,
     "agent: Agent, other: Agent, time: number [s] = 1", "Vector",
     "A force away from the predicted position of the other agent. The prediction looks ahead by at most this time.",
     R"(local force = agent:ForceToEvade(other))", true},
    {"Agent.ForceToFleePosition", kCall<&Agent::ForceToFleePosition>, kError, "agent: Agent, position: Vector [m]",
     "Vector", "A force straight away from a place.",
     R"(print(agent:ForceToFleePosition(Vector.new(3, 0.8, 0)).x)  --> -3)"},
    {"Agent.ForceToFollowPath", kCall<LookAheadForce<&Agent::ForceToFollowPath>>, kError,
     "agent: Agent, time: number 0.1..1000 [s] = 0.1, unused: value = nil", "Vector",
     "A force back to the path if the agent would leave it within this time, or forwards along the path if it would go "
     "backwards.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
local force = agent:ForceToFollowPath(0.5) + agent:ForceToTargetSpeed(3))"},
    {"Agent.ForceToPosition", kCall<&Agent::ForceToPosition>, kError, "agent: Agent, position: Vector [m]", "Vector",
     "A force straight towards a place.", R"(print(agent:ForceToPosition(Vector.new(3, 0.8, 0)).x)  --> 3)"},
    {"Agent.ForceToPursue", kCall<ChaseForce<&Agent::ForceToPursue>>, kError,
     "agent: Agent, other: Agent, time: number [s] = 1", "Vector",
     "A force towards the predicted position of the other agent. The prediction looks ahead by at most this time.",
     R"(local force = agent:ForceToPursue(other))", true},
    {"Agent.ForceToSeparate", kCall<GroupForce<&Agent::ForceToSeparate>>, kError,
     "agent: Agent, distance: number 0..inf [m], angle: number [deg], agents: Agents = everybody", "Vector",
     "A force away from the neighbours; the nearer they are, the stronger it is. Neighbours are defined as for "
     "ForceToAlign.",
     R"(print(agent:ForceToSeparate(10, 180) == agent:ForceToSeparate(10, 180, "team1"))  --> true)"},
    {"Agent.ForceToStayOnPath", kCall<LookAheadForce<&Agent::ForceToStayOnPath>>, kError,
     "agent: Agent, time: number 0.1..1000 [s] = 0.1, unused: value = nil", "Vector",
     "A force back to the path if the agent would leave it within this time.",
     R"(agent:SetPath({Vector.new(), Vector.new(0, 0, 10)})
local force = agent:ForceToStayOnPath(0.5))"},
    {"Agent.ForceToTargetSpeed", kCall<&Agent::ForceToTargetSpeed>, kError, "agent: Agent, speed: number [m/s]",
     "Vector", "A force forwards or backwards that brings the agent to this speed, limited to its maximum force.",
     R"(print(agent:ForceToTargetSpeed(3).z)  --> 3)"},
    {"Agent.ForceToWander", kCall<&Agent::ForceToWander>, kError, "agent: Agent, delta: number [ms]", "Vector",
     "A direction to the side and up or down that changes at random. The larger delta is, the larger the changes are. "
     "With 33, the duration of a step, the direction jumps from side to side.",
     R"(local force = agent:ForceToWander(33))"},
    {"Agent.GetNeighbours", kCall<GetNeighbours>, kError,
     "agent: Agent, distance: number 0..1e6 [m], team: string = any", "table",
     "The agents within a distance, without the agent itself, in the order of their creation. With a team, only the "
     "agents of that team. The cost depends only on the number of agents nearby, so it is low even in a flock of "
     "1,000.",
     R"(print(#agent:GetNeighbours(10))  --> 1)", true},
};

}  // namespace

std::span<const ApiFunction> AgentSteeringApi() {
  return kAgentSteeringFunctions;
}

}  // namespace soarbox::script
