// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <concepts>
#include <lua.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "script/api_table.h"
#include "script/bind_arguments.h"
#include "script/binding.h"

// Turns C++ functions into functions of the API: `kCall<&Agent::SetPosition>`, or the name of a free function. The
// types of the parameters say how the arguments are read. CheckArguments has checked them before.

namespace soarbox::script {

template <class Type>
inline constexpr bool kIsOptional = false;
template <class Type>
inline constexpr bool kIsOptional<std::optional<Type>> = true;

/// Reads a parameter of this type from argument `index` on, and advances the index. lua_State*, Ui and Scene belong to
/// the call and use no argument. World and Camera use the argument that is the sandbox. A component of the user
/// interface counts as changed unless the parameter is const.
template <class Parameter>
decltype(auto) ReadParameter(lua_State* state, int& index) {
  using Type = std::remove_const_t<Parameter>;
  const int at = index;
  const auto context = [&]() -> ScriptContext& { return ContextOf(state); };
  if constexpr (std::same_as<Type, lua_State*>) {
    return state;
  } else if constexpr (std::same_as<Type, world::Ui>) {
    return (context().world.ui());
  } else if constexpr (std::same_as<Type, world::Scene>) {
    return (context().world.scene());
  } else {
    ++index;
    if constexpr (std::same_as<Type, world::World>) {
      return (context().world);
    } else if constexpr (std::same_as<Type, world::Camera>) {
      return (context().world.camera());
    } else if constexpr (std::same_as<Type, world::Agent>) {
      return AgentArgument(state, at);
    } else if constexpr (std::same_as<Type, world::Object>) {
      return ObjectArgument(state, at);
    } else if constexpr (std::same_as<Type, world::NodeId>) {
      return NodeArgument(state, at);
    } else if constexpr (std::same_as<Type, world::UiId>) {
      return UiArgument(state, at);
    } else if constexpr (std::same_as<Parameter, const world::UiComponent>) {
      return (*context().world.ui().Find(UiArgument(state, at)));
    } else if constexpr (std::same_as<Type, world::UiComponent>) {
      return (*context().world.ui().Edit(UiArgument(state, at)));
    } else if constexpr (std::same_as<Type, Body>) {
      return BodyArgument(state, at);
    } else if constexpr (std::same_as<Type, world::Scene::FoundAnimation>) {
      return AnimationArgument(state, at);
    } else if constexpr (std::same_as<Type, world::Vec3>) {
      return CheckVector(state, at);
    } else if constexpr (std::same_as<Type, std::vector<world::Vec3>>) {
      return VectorsArgument(state, at);
    } else if constexpr (std::same_as<Type, float>) {
      return CheckFloat(state, at);
    } else if constexpr (std::same_as<Type, double>) {
      return luaL_checknumber(state, at);
    } else if constexpr (std::same_as<Type, bool>) {
      return lua_toboolean(state, at) != 0;
    } else if constexpr (std::same_as<Type, std::string_view>) {
      return TextArgument(state, at);
    } else {
      static_assert(kIsOptional<Type>);
      if (lua_isnoneornil(state, at)) return Type();
      index = at;
      return Type(ReadParameter<typename Type::value_type>(state, index));
    }
  }
}

// Results: each function returns their number. An empty optional is no result.

inline int PushResult(lua_State* state, world::Vec3 vector) {
  PushVector(state, vector);
  return 1;
}
inline int PushResult(lua_State* state, Handle handle) {
  PushHandle(state, handle);
  return 1;
}
inline int PushResult(lua_State* state, std::string_view text) {
  lua_pushlstring(state, text.data(), text.size());
  return 1;
}
inline int PushResult(lua_State* state, world::UiPoint point) {
  PushPoint(state, point.x, point.y);
  return 1;
}
template <class Number>
requires std::is_arithmetic_v<Number>
int PushResult(lua_State* state, Number number) {
  if constexpr (std::same_as<Number, bool>) {
    lua_pushboolean(state, number);
  } else {
    lua_pushnumber(state, static_cast<lua_Number>(number));
  }
  return 1;
}
template <class Result>
int PushResult(lua_State* state, const std::optional<Result>& result) {
  return result ? PushResult(state, *result) : 0;
}
/// An array with the first index `first`.
template <class Result>
int PushResult(lua_State* state, std::span<const Result> results, int first = 1) {
  lua_createtable(state, static_cast<int>(results.size()), 0);
  for (const Result& result : results) {
    PushResult(state, result);
    lua_rawseti(state, -2, first++);
  }
  return 1;
}
template <class Result>
int PushResult(lua_State* state, const std::vector<Result>& results) {
  return PushResult(state, std::span<const Result>(results));
}

/// If `kIsSetter`, a bool is not a result but says whether the world accepted the values; see WarnUnless.
template <auto kFunction, bool kIsSetter, class Result, class... Parameters>
int RunCall(lua_State* state) {
  [[maybe_unused]] int index = 1;
  const auto call = [&]() -> Result {
    // Braces: the arguments are read from left to right.
    std::tuple<decltype(ReadParameter<std::remove_reference_t<Parameters>>(state, index))...> arguments{
        ReadParameter<std::remove_reference_t<Parameters>>(state, index)...};
    return std::apply(kFunction, std::move(arguments));
  };
  if constexpr (std::same_as<Result, void>) {
    call();
    return 0;
  } else if constexpr (kIsSetter && std::same_as<Result, bool>) {
    WarnUnless(state, call());
    return 0;
  } else {
    return PushResult(state, call());
  }
}

template <auto kFunction, class Result, class... Parameters>
consteval lua_CFunction CallOf(Result (*)(Parameters...)) {
  return RunCall<kFunction, false, Result, Parameters...>;
}
template <auto kFunction, class Result, class Thing, class... Parameters>
consteval lua_CFunction CallOf(Result (Thing::*)(Parameters...)) {
  return RunCall<kFunction, true, Result, Thing&, Parameters...>;
}
template <auto kFunction, class Result, class Thing, class... Parameters>
consteval lua_CFunction CallOf(Result (Thing::*)(Parameters...) const) {
  return RunCall<kFunction, false, Result, const Thing&, Parameters...>;
}
template <auto kFunction>
inline constexpr lua_CFunction kCall = CallOf<kFunction>(kFunction);

}  // namespace soarbox::script
