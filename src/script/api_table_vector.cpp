// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

namespace soarbox::script {
namespace {

constexpr ApiFunction kVectorFunctions[] = {
    {"Vector.new", "x: value = 0, y: value = x, z: value = x", "Vector",
     "Creates a vector from three numbers, from one number for all three, or as a copy of another vector. Other "
     "arguments give nil.",
     R"(local v = Vector.new(1, 2, 3)
print(v.y)  --> 2
print(Vector.new(v) == v)  --> true)"},
    {"Vector.CrossProduct", "a: Vector, b: Vector", "Vector",
     "The vector that is perpendicular to both, by the right-hand rule.",
     R"(local up = Vector.CrossProduct(Vector.new(0, 0, 1), Vector.new(1, 0, 0))
print(up.x, up.y, up.z)  --> 0	1	0)"},
    {"Vector.Distance", "a: Vector [m], b: Vector [m]", "number [m]", "The distance between two points.",
     R"(print(Vector.Distance(Vector.new(), Vector.new(3, 4, 0)))  --> 5)"},
    {"Vector.DistanceSquared", "a: Vector [m], b: Vector [m]", "number [m^2]",
     "The square of the distance; faster if you only compare distances.",
     R"(print(Vector.DistanceSquared(Vector.new(), Vector.new(3, 4, 0)))  --> 25)"},
    {"Vector.DotProduct", "a: Vector, b: Vector", "number",
     "The product of the lengths and the cosine of the angle between the vectors; 0 if they are perpendicular.",
     R"(print(Vector.DotProduct(Vector.new(1, 2, 3), Vector.new(1)))  --> 6)"},
    {"Vector.Length", "vector: value", "number", "The length of a vector; nothing for other values.",
     R"(print(Vector.Length(Vector.new(0, 3, 4)))  --> 5)"},
    {"Vector.LengthSquared", "vector: value", "number", "The square of the length; nothing for other values.",
     R"(print(Vector.LengthSquared(Vector.new(0, 3, 4)))  --> 25)"},
    {"Vector.Normalize", "vector: Vector", "Vector",
     "A new vector with the same direction and length 1; the zero vector stays zero.",
     R"(print(Vector.Normalize(Vector.new(0, 0, 7)).z)  --> 1)"},
    {"Vector.Rotate", "vector: Vector, rotation: Vector [deg]", "Vector",
     "Turns a vector by a rotation vector: about z first, then y, then x.",
     R"(local left = Vector.Rotate(Vector.new(0, 0, 1), Vector.new(0, 90, 0))
print(string.format("%.2f", left.x))  --> 1.00)"},
    {"Vector.RotationTo", "from: Vector, to: Vector", "Vector [deg]",
     "The rotation vector of the shortest turn from one direction to another; their lengths do not matter.",
     R"(local turn = Vector.RotationTo(Vector.new(0, 0, 1), Vector.new(5, 0, 0))
print(string.format("%.0f", turn.y))  --> 90)"},
};

}  // namespace

std::span<const ApiFunction> VectorApi() {
  return kVectorFunctions;
}

}  // namespace soarbox::script
