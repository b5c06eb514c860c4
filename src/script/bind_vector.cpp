// SPDX-License-Identifier: BSD-2-Clause
#include "script/bind_vector.h"

#include <algorithm>
#include <cstdio>
#include <lua.hpp>
#include <string>

#include "script/binding.h"
#include "script/lua_values.h"
#include "world/rotation.h"

namespace soarbox::script {
namespace {

using world::Vec3;

/// Reads the number at `index`. Most numbers are not 0, and then lua_tonumber alone shows that the value is one.
bool ReadNumber(lua_State* state, int index, float& number) {
  const double full = lua_tonumber(state, index);
  number = static_cast<float>(full);
  return full != 0 || lua_isnumber(state, index);
}

/// Vector.new: no argument, a vector, one number for all three, or three numbers; anything else gives nil. Three
/// numbers come first, and no argument needs a check before: this saves `rover` 8 % of all instructions.
int New(lua_State* state) {
  const int count = lua_gettop(state);
  Vec3 vector;
  const Vec3* other = nullptr;
  if (count == 3 && ReadNumber(state, 1, vector.x) && ReadNumber(state, 2, vector.y) &&
      ReadNumber(state, 3, vector.z)) {
    PushVector(state, vector);
  } else if (count == 0) {
    PushVector(state, {});
  } else if (count == 1 && (other = ToVector(state, 1)) != nullptr) {
    PushVector(state, *other);
  } else if (count == 1 && ReadNumber(state, 1, vector.x)) {
    PushVector(state, {vector.x, vector.x, vector.x});
  } else {
    WarnAtCaller(state, "Vector.new takes nothing, a vector, a number or three numbers: this gives nil");
    lua_pushnil(state);
  }
  return 1;
}

int CrossProduct(lua_State* state) {
  PushVector(state, Cross(CheckVector(state, 1), CheckVector(state, 2)));
  return 1;
}

int Distance(lua_State* state) {
  lua_pushnumber(state, Distance(CheckVector(state, 1), CheckVector(state, 2)));
  return 1;
}

int DistanceSquared(lua_State* state) {
  lua_pushnumber(state, LengthSquared(CheckVector(state, 1) - CheckVector(state, 2)));
  return 1;
}

int DotProduct(lua_State* state) {
  lua_pushnumber(state, Dot(CheckVector(state, 1), CheckVector(state, 2)));
  return 1;
}

/// Returns the vector to measure; null after a warning.
const Vec3* MeasuredVector(lua_State* state) {
  const Vec3* vector = ToVector(state, 1);
  if (!vector) WarnIgnored(state, lua_pushfstring(state, "argument 1 is not a vector but %s", NameOfValue(state, 1)));
  return vector;
}

int Length(lua_State* state) {
  const Vec3* vector = MeasuredVector(state);
  if (!vector) return 0;
  lua_pushnumber(state, Length(*vector));
  return 1;
}

int LengthSquared(lua_State* state) {
  const Vec3* vector = MeasuredVector(state);
  if (!vector) return 0;
  lua_pushnumber(state, LengthSquared(*vector));
  return 1;
}

int Normalize(lua_State* state) {
  PushVector(state, world::Normalized(CheckVector(state, 1)));
  return 1;
}

int Rotate(lua_State* state) {
  const Vec3 vector = CheckVector(state, 1);
  PushVector(state, Rotate(world::FromRotationVector(CheckVector(state, 2)), vector));
  return 1;
}

int RotationTo(lua_State* state) {
  const Vec3 from = CheckVector(state, 1);
  PushVector(state, world::ToRotationVector(world::ShortestArc(from, CheckVector(state, 2))));
  return 1;
}

constexpr Binding kVectorBindings[] = {
    {"new", New, 0, kAnyCount, WrongCount::kIgnored},
    {"CrossProduct", CrossProduct, 2, 2, WrongCount::kIgnored},
    {"Distance", Distance, 2, 2, WrongCount::kIgnored},
    {"DistanceSquared", DistanceSquared, 2, 2, WrongCount::kIgnored},
    {"DotProduct", DotProduct, 2, 2, WrongCount::kIgnored},
    {"Length", Length, 1, 1, WrongCount::kIgnored},
    {"LengthSquared", LengthSquared, 1, 1, WrongCount::kIgnored},
    {"Normalize", Normalize, 1, 1, WrongCount::kIgnored},
    {"Rotate", Rotate, 2, 2, WrongCount::kIgnored},
    {"RotationTo", RotationTo, 2, 2, WrongCount::kIgnored},
};

/// Warns why an operation on vectors gives nil.
void WarnOfOperands(lua_State* state, const char* operation) {
  if (!ToVector(state, 1) && lua_type(state, 1) == LUA_TNUMBER) {
    WarnAtCaller(state, std::string("a number ") + operation + " a vector gives nil: put the vector on the left");
    return;
  }
  const int wrong = ToVector(state, 1) ? 2 : 1;
  std::string text = "a vector " + std::string(operation) + " " + NameOfValue(state, wrong);
  if (wrong == 1) text = NameOfValue(state, 1) + (" " + std::string(operation)) + " a vector";
  WarnAtCaller(state, text + " gives nil: put a vector or a number on the right");
}

/// v op w and v op s, component by component; nil if the left side is not a vector or the right side is neither a
/// vector nor a number.
template <class Operation>
int Componentwise(lua_State* state, const char* name, Operation operation) {
  const Vec3* left = ToVector(state, 1);
  const Vec3* right = ToVector(state, 2);
  Vec3 operand;
  if (right) {
    operand = *right;
  } else if (lua_type(state, 2) == LUA_TNUMBER) {
    const float number = CheckFloat(state, 2);
    operand = {number, number, number};
  } else {
    left = nullptr;
  }
  if (!left) {
    WarnOfOperands(state, name);
    lua_pushnil(state);
  } else {
    PushVector(state, {operation(left->x, operand.x), operation(left->y, operand.y), operation(left->z, operand.z)});
  }
  return 1;
}

int Add(lua_State* state) {
  return Componentwise(state, "+", [](float a, float b) { return a + b; });
}
int Subtract(lua_State* state) {
  return Componentwise(state, "-", [](float a, float b) { return a - b; });
}
int Multiply(lua_State* state) {
  return Componentwise(state, "*", [](float a, float b) { return a * b; });
}
int Divide(lua_State* state) {
  return Componentwise(state, "/", [](float a, float b) { return a / b; });
}

int Negate(lua_State* state) {
  PushVector(state, -CheckVector(state, 1));
  return 1;
}

int IsEqual(lua_State* state) {
  const Vec3* left = ToVector(state, 1);
  const Vec3* right = ToVector(state, 2);
  lua_pushboolean(state, left && right && *left == *right);
  return 1;
}

float* Component(Vec3& vector, lua_State* state, int key_index) {
  if (lua_type(state, key_index) != LUA_TSTRING) return nullptr;
  std::size_t length = 0;
  const char* key = lua_tolstring(state, key_index, &length);
  if (length != 1) return nullptr;
  switch (*key) {
    case 'x':
      return &vector.x;
    case 'y':
      return &vector.y;
    case 'z':
      return &vector.z;
    default:
      return nullptr;
  }
}

/// Formats a key for messages: its text, or its kind.
std::string NameOfKey(lua_State* state, int index) {
  std::size_t length = 0;
  const char* text = lua_type(state, index) == LUA_TSTRING ? lua_tolstring(state, index, &length) : nullptr;
  return text ? std::string(text, std::min<std::size_t>(length, 40)) : NameOfValue(state, index);
}

int Index(lua_State* state) {
  Vec3* vector = ToVector(state, 1);
  const float* component = vector ? Component(*vector, state, 2) : nullptr;
  if (!component) return 0;
  lua_pushnumber(state, *component);
  return 1;
}

int NewIndex(lua_State* state) {
  Vec3* vector = ToVector(state, 1);
  float* component = vector ? Component(*vector, state, 2) : nullptr;
  if (!component) {
    WarnAtCaller(state, std::string("a vector has x, y and z: the field '") + NameOfKey(state, 2) + "' is not set");
    return 0;
  }
  if (!lua_isnumber(state, 3))
    return luaL_error(state, "the field '%s' of a vector is a number, not %s", lua_tostring(state, 2),
                      NameOfValue(state, 3));
  *component = static_cast<float>(lua_tonumber(state, 3));
  return 0;
}

int ToText(lua_State* state) {
  const Vec3 vector = CheckVector(state, 1);
  char text[160];
  std::snprintf(text, sizeof text, "{ x=%f, y=%f, z=%f }", static_cast<double>(vector.x), static_cast<double>(vector.y),
                static_cast<double>(vector.z));
  lua_pushstring(state, text);
  return 1;
}

}  // namespace

void BindVector(lua_State* state) {
  RegisterTable(state, "Vector", kVectorBindings);
}

void InstallVectorMetamethods(lua_State* state) {
  static constexpr luaL_Reg kMetamethods[] = {
      {"__add", Add},    {"__sub", Subtract}, {"__mul", Multiply},      {"__div", Divide},      {"__unm", Negate},
      {"__eq", IsEqual}, {"__index", Index},  {"__newindex", NewIndex}, {"__tostring", ToText}, {nullptr, nullptr},
  };
  luaL_register(state, nullptr, kMetamethods);
  lua_pushliteral(state, "Vector3Type");
  lua_setfield(state, -2, "__metatable");
}

}  // namespace soarbox::script
