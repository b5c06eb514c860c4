// SPDX-License-Identifier: BSD-2-Clause
#include "script/bind_vector.h"

#include <algorithm>
#include <cstdio>
#include <lua.hpp>
#include <string>

#include "script/api_call.h"
#include "world/rotation.h"

namespace soarbox::script {
namespace {

using world::Vec3;
using enum WrongCount;

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

float DistanceSquared(Vec3 a, Vec3 b) {
  return world::LengthSquared(a - b);
}

/// Other values than vectors give nothing, with a warning.
template <float (*kMeasure)(Vec3)>
int Measure(lua_State* state) {
  if (const Vec3* vector = ToVector(state, 1)) return PushResult(state, kMeasure(*vector));
  WarnIgnored(state, lua_pushfstring(state, "argument 1 is not a vector but %s", NameOfValue(state, 1)));
  return 0;
}

Vec3 Normalize(Vec3 vector) {
  return world::Normalized(vector);
}

Vec3 Rotate(Vec3 vector, Vec3 rotation) {
  return world::Rotate(world::FromRotationVector(rotation), vector);
}

Vec3 RotationTo(Vec3 from, Vec3 to) {
  return world::ToRotationVector(world::ShortestArc(from, to));
}

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

constexpr ApiFunction kVectorFunctions[] = {
    {"Vector.CrossProduct", kCall<world::Cross>, kIgnored, "a: Vector, b: Vector", "Vector",
     "The vector that is perpendicular to both, by the right-hand rule.",
     R"(local up = Vector.CrossProduct(Vector.new(0, 0, 1), Vector.new(1, 0, 0))
print(up.x, up.y, up.z)  --> 0	1	0)"},
    {"Vector.Distance", kCall<world::Distance>, kIgnored, "a: Vector [m], b: Vector [m]", "number [m]",
     "The distance between two points.", R"(print(Vector.Distance(Vector.new(), Vector.new(3, 4, 0)))  --> 5)"},
    {"Vector.DistanceSquared", kCall<DistanceSquared>, kIgnored, "a: Vector [m], b: Vector [m]", "number [m^2]",
     "The square of the distance; faster if you only compare distances.",
     R"(print(Vector.DistanceSquared(Vector.new(), Vector.new(3, 4, 0)))  --> 25)"},
    {"Vector.DotProduct", kCall<world::Dot>, kIgnored, "a: Vector, b: Vector", "number",
     "The product of the lengths and the cosine of the angle between the vectors; 0 if they are perpendicular.",
     R"(print(Vector.DotProduct(Vector.new(1, 2, 3), Vector.new(1)))  --> 6)"},
    {"Vector.Length", Measure<world::Length>, kIgnored, "vector: value", "number",
     "The length of a vector; nothing for other values.", R"(print(Vector.Length(Vector.new(0, 3, 4)))  --> 5)"},
    {"Vector.LengthSquared", Measure<world::LengthSquared>, kIgnored, "vector: value", "number",
     "The square of the length; nothing for other values.",
     R"(print(Vector.LengthSquared(Vector.new(0, 3, 4)))  --> 25)"},
    {"Vector.Normalize", kCall<Normalize>, kIgnored, "vector: Vector", "Vector",
     "A new vector with the same direction and length 1; the zero vector stays zero.",
     R"(print(Vector.Normalize(Vector.new(0, 0, 7)).z)  --> 1)"},
    {"Vector.Rotate", kCall<Rotate>, kIgnored, "vector: Vector, rotation: Vector [deg]", "Vector",
     "Turns a vector by a rotation vector: about z first, then y, then x.",
     R"(local left = Vector.Rotate(Vector.new(0, 0, 1), Vector.new(0, 90, 0))
print(string.format("%.2f", left.x))  --> 1.00)"},
    {"Vector.RotationTo", kCall<RotationTo>, kIgnored, "from: Vector, to: Vector", "Vector [deg]",
     "The rotation vector of the shortest turn from one direction to another; their lengths do not matter.",
     R"(local turn = Vector.RotationTo(Vector.new(0, 0, 1), Vector.new(5, 0, 0))
print(string.format("%.0f", turn.y))  --> 90)"},
    {"Vector.new", New, kIgnored, "x: value = 0, y: value = x, z: value = x", "Vector",
     "Creates a vector from three numbers, from one number for all three, or as a copy of another vector. Other "
     "arguments give nil.",
     R"(local v = Vector.new(1, 2, 3)
print(v.y)  --> 2
print(Vector.new(v) == v)  --> true)",
     false, kAnyCount},
};

}  // namespace

std::span<const ApiFunction> VectorApi() {
  return kVectorFunctions;
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
