// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include "world/math.h"

namespace soarbox::world {

/// A 64-bit hash of a sequence of values. It depends on their order, not on addresses. Not cryptographic.
class StateHash {
 public:
  void Add(std::uint64_t value) {
    state_ = (state_ ^ value) * 0x9e3779b97f4a7c15ull;
    state_ ^= state_ >> 29;
  }
  void Add(float value) { Add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value))); }
  void Add(float first, float second) {
    Add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(first)) << 32 | std::bit_cast<std::uint32_t>(second));
  }
  void Add(Vec3 v) {
    Add(v.x, v.y);
    Add(v.z);
  }
  void Add(Quat q) {
    Add(q.w, q.x);
    Add(q.y, q.z);
  }
  void Add(std::string_view text) {
    Add(static_cast<std::uint64_t>(text.size()));
    for (const unsigned char c : text) Add(static_cast<std::uint64_t>(c));
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x51a7b0c5d3e9f126ull;
};

}  // namespace soarbox::world
