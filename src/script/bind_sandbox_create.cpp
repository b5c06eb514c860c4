// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>
#include <string>

#include "script/argument_check.h"
#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/script_asset.h"
#include "script/script_error.h"

// Sandbox: creating and finding agents and objects.

namespace soarbox::script {
namespace {

using world::EntityId;

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
  if (!SandboxArgument(state, 1)) return 0;
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

template <class Create>
int MakeObject(lua_State* state, Create create) {
  if (!SandboxArgument(state, 1)) return 0;
  ChargeForCreation(state, Made::kObject);
  const EntityId id = create(ContextOf(state).world);
  if (id == world::kNoEntity) {
    WarnUnless(state, false);
    return 0;
  }
  PushObject(state, id);
  return 1;
}

int CreateBox(lua_State* state) {
  const float width = CheckFloat(state, 2), height = CheckFloat(state, 3), length = CheckFloat(state, 4);
  const bool tiled = lua_gettop(state) >= 6;
  const float u_tile = tiled ? CheckFloat(state, 5) : 1, v_tile = tiled ? CheckFloat(state, 6) : 1;
  return MakeObject(state, [&](world::World& world) { return world.CreateBox(width, height, length, u_tile, v_tile); });
}

int CreateCapsule(lua_State* state) {
  const float height = CheckFloat(state, 2), radius = CheckFloat(state, 3);
  WarnOfShortCapsule(state, height, radius);
  return MakeObject(state, [&](world::World& world) { return world.CreateCapsule(height, radius); });
}

int CreateObject(lua_State* state) {
  const std::string_view mesh = MeshArgument(state, 2);
  return MakeObject(state, [&](world::World& world) { return world.CreateObject(mesh); });
}

int CreatePhysicsCapsule(lua_State* state) {
  const float height = CheckFloat(state, 2), radius = CheckFloat(state, 3);
  WarnOfShortCapsule(state, height, radius);
  return MakeObject(state, [&](world::World& world) { return world.CreatePhysicsCapsule(height, radius); });
}

int CreatePhysicsSphere(lua_State* state) {
  const float radius = CheckFloat(state, 2);
  return MakeObject(state, [&](world::World& world) { return world.CreatePhysicsSphere(radius); });
}

int CreatePlane(lua_State* state) {
  const float length = CheckFloat(state, 2), width = CheckFloat(state, 3);
  return MakeObject(state, [&](world::World& world) { return world.CreatePlane(length, width); });
}

int CreateSensor(lua_State* state) {
  const float width = CheckFloat(state, 2), height = CheckFloat(state, 3), length = CheckFloat(state, 4);
  return MakeObject(state, [&](world::World& world) { return world.CreateSensor(width, height, length); });
}

/// Repeated calls have no effect, also in later steps. Collision callbacks often call it more than once.
int RemoveObject(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
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
  if (!SandboxArgument(state, 1)) return 0;
  ContextOf(state).world.RemoveAgent(EntityId{CheckHandle(state, 2, ValueKind::kAgent)});
  return 0;
}

int GetAgents(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  PushAgents(state, ContextOf(state).world.AgentIds());
  return 1;
}

int GetObjects(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  const auto ids = ContextOf(state).world.ObjectIds();
  lua_createtable(state, static_cast<int>(ids.size()), 0);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    PushObject(state, ids[i]);
    lua_rawseti(state, -2, static_cast<int>(i + 1));
  }
  return 1;
}

int RayCastToObject(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  const world::Vec3 from = CheckVector(state, 2);
  const world::World& world = ContextOf(state).world;
  const auto hit = world.RayCast(from, CheckVector(state, 3));
  lua_createtable(state, 0, 3);
  lua_pushboolean(state, hit.has_value());
  lua_setfield(state, -2, "result");
  if (!hit) return 1;
  PushVector(state, hit->point);
  lua_setfield(state, -2, "hitPoint");
  if (world.FindAgent(hit->entity)) {
    PushAgent(state, hit->entity);
  } else {
    PushObject(state, hit->entity);
  }
  lua_setfield(state, -2, "object");
  return 1;
}

constexpr Binding kSandboxCreateBindings[] = {
    {"CreateAgent", CreateAgent, 2, 2, WrongCount::kIgnored},
    {"CreateBox", CreateBox, 4, kAnyCount, WrongCount::kIgnored},
    {"CreateCapsule", CreateCapsule, 3, 3, WrongCount::kIgnored},
    {"CreateObject", CreateObject, 2, 2, WrongCount::kIgnored},
    {"CreatePhysicsCapsule", CreatePhysicsCapsule, 3, 3, WrongCount::kIgnored},
    {"CreatePhysicsSphere", CreatePhysicsSphere, 2, 2, WrongCount::kIgnored},
    {"CreatePlane", CreatePlane, 3, 3, WrongCount::kIgnored},
    {"CreateSensor", CreateSensor, 4, 4, WrongCount::kError},
    {"CreateSoarAgent", CreateSoarAgent, 2, 4, WrongCount::kError},
    {"CreateSoarFollowerAgent", CreateSoarFollowerAgent, 2, 4, WrongCount::kIgnored},
    {"CreateSoarSeekingAgent", CreateSoarSeekingAgent, 2, 4, WrongCount::kIgnored},
    {"CreateSoarWaypointAgent", CreateSoarWaypointAgent, 2, 4, WrongCount::kIgnored},
    {"GetAgents", GetAgents, 1, 1, WrongCount::kIgnored},
    {"GetObjects", GetObjects, 1, 1, WrongCount::kIgnored},
    {"RayCastToObject", RayCastToObject, 3, 3, WrongCount::kError},
    {"RemoveAgent", RemoveAgent, 2, 2, WrongCount::kError},
    {"RemoveObject", RemoveObject, 2, 2, WrongCount::kIgnored},
};

}  // namespace

void BindSandboxCreate(lua_State* state) {
  RegisterTable(state, "Sandbox", kSandboxCreateBindings);
}

}  // namespace soarbox::script
