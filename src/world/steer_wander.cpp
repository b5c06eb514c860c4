// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_wander.h"

#include <algorithm>

namespace soarbox::world {
namespace {

constexpr float kWanderRate = 12.0f;

float Walk(float value, RandomStream& random, float delta) {
  return std::clamp(value + (2 * random.Unit() - 1) * kWanderRate * delta, -1.0f, 1.0f);
}

}  // namespace

Vec3 SteerWander(const AgentMotion& self, WanderState& state, RandomStream& random, float delta) {
  state.side = Walk(state.side, random, delta);
  state.up = Walk(state.up, random, delta);
  return self.left * state.side + self.up * state.up;
}

}  // namespace soarbox::world
