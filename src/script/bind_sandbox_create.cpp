// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>
#include <optional>
#include <string>
#include <vector>

#include "script/api_call.h"
#include "script/argument_check.h"
#include "script/script_asset.h"
#include "script/script_error.h"

// Sandbox: creating and finding agents and objects.

namespace soarbox::script {
namespace {

using world::EntityId;
using world::World;
using enum WrongCount;

/// Reads the options table into the request; raises an error for values of a wrong type. Nested vectors and tables
/// become options with dotted names: "position.x", "senses.sight"; lists "senses.only.1". `argument` is the table in
/// the call, `index` the nested table to be read.
void ReadOptions(lua_State* state, int argument, int index, AgentCreationRequest& request,
                 const std::string& prefix = {}) {
  constexpr std::size_t kMostOptions = 200;
  luaL_checktype(state, index, LUA_TTABLE);
  luaL_checkstack(state, 6, "nested options");
  lua_pushnil(state);
  while (lua_next(state, index) != 0) {
    std::string name = prefix;
    if (lua_type(state, -2) == LUA_TNUMBER && !prefix.empty()) {
      name += std::to_string(static_cast<int>(lua_tonumber(state, -2)));
    } else if (lua_type(state, -2) == LUA_TSTRING) {
      name += lua_tostring(state, -2);
    } else {
      ArgumentError(state, argument, "the names of options are strings");
    }
    if (request.options.size() >= kMostOptions || name.size() > 200)
      ArgumentError(state, argument, "these are too many options");
    switch (lua_type(state, -1)) {
      case LUA_TBOOLEAN:
        request.options[name] = lua_toboolean(state, -1) != 0;
        break;
      case LUA_TNUMBER:
        request.options[name] = static_cast<double>(lua_tonumber(state, -1));
        break;
      case LUA_TSTRING:
        request.options[name] = std::string(lua_tostring(state, -1));
        break;
      case LUA_TTABLE:
        ReadOptions(state, argument, lua_gettop(state), request, name + ".");
        break;
      default: {
        const world::Vec3* vector = ToVector(state, -1);
        const Handle* handle = ToHandle(state, -1);
        if (vector != nullptr) {
          request.options[name + ".x"] = static_cast<double>(vector->x);
          request.options[name + ".y"] = static_cast<double>(vector->y);
          request.options[name + ".z"] = static_cast<double>(vector->z);
        } else if (handle != nullptr && handle->kind == ValueKind::kAgent) {
          const auto* agent = ContextOf(state).world.FindAgent(EntityId{handle->number});
          request.options[name] = agent != nullptr ? agent->name() : std::string();
        } else {
          ArgumentError(state, argument,
                        "the values of options are strings, numbers, booleans, vectors, agents and tables");
        }
      }
    }
    lua_pop(state, 1);
  }
}

int PushMadeAgent(lua_State* state, const AgentCreationRequest& request) {
  ChargeForCreation(state, Made::kAgent);
  const Result<EntityId> agent = ContextOf(state).agents.MakeAgent(request);
  if (agent.ok()) {
    PushAgent(state, agent.value());
    return 1;
  }
  const Diagnostic& error = agent.error();
  const std::string text = error.message + (error.hint.empty() ? "" : " (" + error.hint + ")");
  lua_pushlstring(state, text.data(), text.size());
  luaL_where(state, 1);
  lua_insert(state, -2);
  lua_concat(state, 2);
  return lua_error(state);
}

/// (sandbox, script [, rules [, options]])
int MakeAgent(lua_State* state, const char* kind) {
  AgentCreationRequest request;
  request.kind = kind;
  LocateCaller(state, request.made_in, request.made_in_line);
  if (lua_istable(state, 2) && request.kind == "soar") {
    // One table with all options: the agent needs no script.
    ReadOptions(state, 2, 2, request);
    for (const auto& [option, field] : {std::pair{"rules", &request.rules}, std::pair{"script", &request.script}}) {
      const auto given = request.options.find(option);
      if (given == request.options.end()) continue;
      if (const auto* text = std::get_if<std::string>(&given->second)) *field = *text;
      request.options.erase(given);
    }
    return PushMadeAgent(state, request);
  }
  request.script = TextArgument(state, 2);
  if (!lua_isnoneornil(state, 3)) request.rules = TextArgument(state, 3);
  if (!lua_isnoneornil(state, 4)) ReadOptions(state, 4, 4, request);
  return PushMadeAgent(state, request);
}

int CreateAgent(lua_State* state) {
  return MakeAgent(state, "lua");
}
int CreateSoarSeekingAgent(lua_State* state) {
  return MakeAgent(state, "seeking");
}
int CreateSoarFollowerAgent(lua_State* state) {
  return MakeAgent(state, "follower");
}
int CreateSoarWaypointAgent(lua_State* state) {
  return MakeAgent(state, "waypoint");
}
int CreateSoarAgent(lua_State* state) {
  return MakeAgent(state, "soar");
}

/// `kCreate`: the function of World.
template <auto kCreate, class... Values>
std::optional<Handle> MakeObject(lua_State* state, World& world, Values... values) {
  ChargeForCreation(state, Made::kObject);
  const EntityId id = (world.*kCreate)(values...);
  WarnUnless(state, id != world::kNoEntity);
  if (id == world::kNoEntity) return std::nullopt;
  return Handle{ValueKind::kObject, Number(id)};
}

/// The numbers of tiles are used only together.
std::optional<Handle> CreateBox(lua_State* state, World& world, float width, float height, float length,
                                std::optional<float> u_tiles, std::optional<float> v_tiles) {
  return MakeObject<&World::CreateBox>(state, world, width, height, length, v_tiles ? u_tiles.value_or(1) : 1,
                                       v_tiles.value_or(1));
}

template <auto kCreate>
std::optional<Handle> MakeCapsule(lua_State* state, World& world, float height, float radius) {
  WarnOfShortCapsule(state, height, radius);
  return MakeObject<kCreate>(state, world, height, radius);
}

std::optional<Handle> CreateObject(lua_State* state, World& world) {
  return MakeObject<&World::CreateObject>(state, world, MeshArgument(state, 2));
}

/// Repeated calls have no effect, also in later steps. Collision callbacks often call it more than once.
int RemoveObject(lua_State* state) {
  const Handle* handle = ToHandle(state, 2);
  if (handle && handle->kind == ValueKind::kObject) {
    ContextOf(state).world.RemoveObject(EntityId{handle->number});
  } else if (handle && handle->kind == ValueKind::kAgent) {
    WarnIgnored(state, "argument 2 is an agent, which Sandbox.RemoveAgent removes");
  } else {
    WarnIgnored(state, "argument 2 is not a sandbox object");
  }
  return 0;
}

/// Repeated calls have no effect.
int RemoveAgent(lua_State* state) {
  ContextOf(state).world.RemoveAgent(EntityId{CheckHandle(state, 2, ValueKind::kAgent)});
  return 0;
}

int GetAgents(lua_State* state) {
  PushAgents(state, ContextOf(state).world.AgentIds());
  return 1;
}

std::vector<Handle> GetObjects(const World& world) {
  std::vector<Handle> objects;
  for (const EntityId id : world.ObjectIds()) objects.push_back({ValueKind::kObject, Number(id)});
  return objects;
}

/// Returns {result=, hitPoint=, object=}.
int RayCastToObject(lua_State* state) {
  const World& world = ContextOf(state).world;
  const auto hit = world.RayCast(CheckVector(state, 2), CheckVector(state, 3));
  lua_createtable(state, 0, 3);
  lua_pushboolean(state, hit.has_value());
  lua_setfield(state, -2, "result");
  if (!hit) return 1;
  PushVector(state, hit->point);
  lua_setfield(state, -2, "hitPoint");
  PushHandle(state, {world.FindAgent(hit->entity) ? ValueKind::kAgent : ValueKind::kObject, Number(hit->entity)});
  lua_setfield(state, -2, "object");
  return 1;
}

constexpr ApiFunction kSandboxCreateFunctions[] = {
    {"Sandbox.CreateAgent", CreateAgent, kIgnored, "sandbox: Sandbox, script: string", "Agent",
     "Creates an agent at the origin that this script controls, and calls the script's Agent_Initialize.",
     R"(local walker = Sandbox.CreateAgent(sandbox, "Quiet.lua")
walker:SetPosition(Vector.new(2, 0.8, 0)))"},
    {"Sandbox.CreateBox", kCall<CreateBox>, kIgnored,
     "sandbox: Sandbox, width: number 0.001..100000 [m], height: number 0.001..100000 [m], length: number "
     "0.001..100000 [m], u_tiles: number = 1, v_tiles: number = 1",
     "Object",
     "A box with a body of 1 kg at the origin. u_tiles and v_tiles are the numbers of times that the texture is "
     "repeated on each side.",
     R"(local floor = Sandbox.CreateBox(sandbox, 20, 1, 20, 10, 10)
Core.SetMass(floor, 0)
Core.SetPosition(floor, Vector.new(0, -0.5, 0)))",
     false, kAnyCount},
    {"Sandbox.CreateCapsule", kCall<MakeCapsule<&World::CreateCapsule>>, kIgnored,
     "sandbox: Sandbox, height: number 0.001..100000 [m], radius: number 0.001..100000 [m]", "Object",
     "An upright capsule with a body of 1 kg at the origin; the height includes the caps.",
     R"(local pillar = Sandbox.CreateCapsule(sandbox, 3, 0.5))"},
    {"Sandbox.CreateObject", kCall<CreateObject>, kIgnored, "sandbox: Sandbox, mesh: string", "Object",
     "A mesh of the media library, or a model from a .glb or .gltf file of the scenario's folder (docs/lua/models.md), "
     "with a box-shaped body of 1 kg at the origin.",
     R"(local block = Sandbox.CreateObject(sandbox, "models/nobiax_modular/modular_block.mesh"))"},
    {"Sandbox.CreatePhysicsCapsule", kCall<MakeCapsule<&World::CreatePhysicsCapsule>>, kIgnored,
     "sandbox: Sandbox, height: number 0.001..100000 [m], radius: number 0.001..100000 [m]", "Object",
     "An invisible capsule with a body of 1 kg.",
     R"(local bullet = Sandbox.CreatePhysicsCapsule(sandbox, 0.3, 0.01)
Core.SetMass(bullet, 0.1))"},
    {"Sandbox.CreatePhysicsSphere", kCall<MakeObject<&World::CreatePhysicsSphere, float>>, kIgnored,
     "sandbox: Sandbox, radius: number 0.001..100000 [m]", "Object", "An invisible ball with a body of 1 kg.",
     R"(local ball = Sandbox.CreatePhysicsSphere(sandbox, 0.2))"},
    {"Sandbox.CreatePlane", kCall<MakeObject<&World::CreatePlane, float, float>>, kIgnored,
     "sandbox: Sandbox, length: number 0..1e6 [m], width: number 0..1e6 [m]", "Object",
     "A visible plane at y = 0 on an endless fixed floor. Navigation meshes ignore it.",
     R"(local ground = Sandbox.CreatePlane(sandbox, 200, 200)
Core.SetMaterial(ground, "Ground2"))"},
    {"Sandbox.CreateSensor", kCall<MakeObject<&World::CreateSensor, float, float, float>>, kError,
     "sandbox: Sandbox, width: number 0.001..100000 [m], height: number 0.001..100000 [m], length: number "
     "0.001..100000 [m]",
     "Object",
     "Creates an invisible box that nothing collides with. When an agent or a movable object enters or leaves it, it "
     "sends the event \"SensorEntered\" or \"SensorLeft\" to all listeners (Sandbox.AddEventCallback). The event has "
     "the field sensor, and the field agent or object with the one that entered or left. Agents without physics are "
     "not detected.",
     R"(local goal = Sandbox.CreateSensor(sandbox, 4, 3, 4)
Sandbox.AddEventCallback(sandbox, goal, function(sandbox, goal, type, event)
  if type == "SensorEntered" and event.sensor == goal then print("goal!") end
end))",
     true},
    {"Sandbox.CreateSoarAgent", CreateSoarAgent, kError,
     "sandbox: Sandbox, script: value, rules: string = none, options: table = none", "Agent",
     "Creates an agent whose body is a script and whose mind is a file of Soar rules. Agent_Update(agent, "
     "milliseconds, command, parameters) runs once for each command of its mind, or over several ticks if it returns "
     "\"running\"; Agent_Tick(agent, milliseconds) runs in each tick. If you pass a table of options "
     "instead of the script ({rules = \"scout.soar\", body = \"soldier\", team = \"blue\", position = Vector.new(0, 0, "
     "3)}), the agent needs no script: its body knows the commands of docs/commands.md.",
     R"(local thinker = Sandbox.CreateSoarAgent(sandbox, "Quiet.lua", "walk.soar"))", true},
    {"Sandbox.CreateSoarFollowerAgent", CreateSoarFollowerAgent, kIgnored,
     "sandbox: Sandbox, script: string, rules: string = followeragent.soar, options: table = none", "Agent",
     "Creates an agent whose mind perceives the distance to its leader (Agent.SetLeader) and commands \"follow\" or "
     "\"stop\".",
     R"(local follower = Sandbox.CreateSoarFollowerAgent(sandbox, "Quiet.lua")
follower:SetLeader(agent))",
     true},
    {"Sandbox.CreateSoarSeekingAgent", CreateSoarSeekingAgent, kIgnored,
     "sandbox: Sandbox, script: string, rules: string = seekingagent.soar, options: table = none", "Agent",
     "Creates an agent whose mind perceives the distance to its target and commands \"newtarget\" or \"sametarget\".",
     R"(local seeker = Sandbox.CreateSoarSeekingAgent(sandbox, "Quiet.lua"))", true},
    {"Sandbox.CreateSoarWaypointAgent", CreateSoarWaypointAgent, kIgnored,
     "sandbox: Sandbox, script: string, rules: string = waypointagent.soar, options: table = none", "Agent",
     "Creates an agent whose mind perceives the distance to its target and commands \"nextwaypoint\" or "
     "\"samewaypoint\".",
     R"(local guard = Sandbox.CreateSoarWaypointAgent(sandbox, "Quiet.lua"))", true},
    {"Sandbox.GetAgents", GetAgents, kIgnored, "sandbox: Sandbox", "table of Agent",
     "All agents in the order of their creation, including dead ones.", R"(print(#Sandbox.GetAgents(sandbox))  --> 2)"},
    {"Sandbox.GetObjects", kCall<GetObjects>, kIgnored, "sandbox: Sandbox", "table of Object",
     "All objects in ascending order of their numbers, without agents.",
     R"(for _, object in ipairs(Sandbox.GetObjects(sandbox)) do Core.GetMass(object) end)"},
    {"Sandbox.RayCastToObject", RayCastToObject, kError, "sandbox: Sandbox, from: Vector [m], to: Vector [m]", "table",
     "Finds the first body on a line: {result, hitPoint, object}, the last two only if result is true. A ray that "
     "starts inside a body does not hit that body.",
     R"(local hit = Sandbox.RayCastToObject(sandbox, Vector.new(5, 10, 5), Vector.new(5, -1, 5))
print(hit.result, hit.hitPoint.y)  --> true	1)"},
    {"Sandbox.RemoveAgent", RemoveAgent, kError, "sandbox: Sandbox, agent: value", "",
     "Removes an agent, with everything attached to it, at the beginning of the next step. Until then it acts as "
     "before; then Agent_Cleanup of its script is called and its mind ends. A second call has no effect.",
     R"(Sandbox.RemoveAgent(sandbox, agent))", true},
    {"Sandbox.RemoveObject", RemoveObject, kIgnored, "sandbox: Sandbox, object: value", "",
     "Removes an object from the world at the beginning of the next step. A second call has no effect.",
     R"(Sandbox.RemoveObject(sandbox, object))"},
};

}  // namespace

std::span<const ApiFunction> SandboxCreateApi() {
  return kSandboxCreateFunctions;
}

}  // namespace soarbox::script
