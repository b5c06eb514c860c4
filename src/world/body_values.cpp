// SPDX-License-Identifier: BSD-2-Clause
#include "world/body_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "world/physics_world.h"

namespace soarbox::world {
namespace {

std::string Short(float number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

BodyValue Within(std::string_view what, float asked, float least, float most, std::string_view unit) {
  if (asked >= least && asked <= most) return {asked, {}};
  BodyValue taken{std::isnan(asked) ? least : std::clamp(asked, least, most), {}};
  taken.problem.append("a ").append(what).append(" of ").append(Short(asked)).append(" ").append(unit);
  taken.problem.append(" is not possible: ").append(Short(taken.value)).append(" ").append(unit);
  taken.problem.append(" is used");
  return taken;
}

}  // namespace

BodyValue BodySize(std::string_view what, float metres) {
  return Within(what, metres, PhysicsWorld::kMinSize_m, PhysicsWorld::kMaxSize_m, "m");
}

BodyValue BodyMass(float kg) {
  return Within("mass", kg, 0, PhysicsWorld::kMaxMass_kg, "kg");
}

}  // namespace soarbox::world
