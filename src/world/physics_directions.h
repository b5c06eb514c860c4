// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "world/physics_bullet.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// Circles about somebody who looks around, by the directions in which they lie, seen from above: a line of sight among
/// hundreds of bodies looks at the few of its own direction.
class Directions {
 public:
  /// Makes room for so many circles, whose numbers are below this.
  void Reset(std::size_t count) {
    words_ = (count + kBits - 1) / kBits;
    marks_.assign((kDirections + 1) * words_, 0);
  }

  /// A circle about that place, from the viewer.
  void Add(std::size_t number, btScalar x, btScalar z, btScalar radius) {
    const btScalar away = std::sqrt(x * x + z * z);
    constexpr btScalar kInside = 0.999f;
    if (!(radius < away * kInside)) return Mark(kDirections, number);
    // No less than the angle from its middle to its edge; turns are no faster than angles.
    constexpr btScalar kNarrow = 0.5f, kOfNarrow = 1.05f, kOfAny = 1.571f, kSlack = 1e-3f;
    const btScalar ratio = radius / away, half = ratio * (ratio < kNarrow ? kOfNarrow : kOfAny) + kSlack;
    const btScalar turn = TurnOf(x, z) + kFull;
    const std::size_t last = static_cast<std::size_t>((turn + half) * kOfTurn);
    for (std::size_t n = static_cast<std::size_t>((turn - half) * kOfTurn); n <= last; ++n)
      Mark(n % kDirections, number);
  }

  /// Calls visit with the number of each circle that a line in that direction may enter, and perhaps of others, until
  /// it answers false; returns whether it never did.
  template <class Visit>
  bool VisitAlong(btScalar x, btScalar z, const Visit& visit) const {
    const std::size_t n = static_cast<std::size_t>(TurnOf(x, z) * kOfTurn) % kDirections;
    for (std::size_t word = 0; word < words_; ++word) {
      for (std::uint64_t left = marks_[n * words_ + word] | marks_[kDirections * words_ + word]; left != 0;
           left &= left - 1)
        if (!visit(word * kBits + static_cast<std::size_t>(std::countr_zero(left)))) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t kBits = 64, kDirections = 64;
  static constexpr btScalar kFull = 4, kOfTurn = kDirections / kFull;

  /// Grows with the angle, from 0 to 4.
  static btScalar TurnOf(btScalar x, btScalar z) {
    const btScalar sum = std::abs(x) + std::abs(z);
    if (!(sum > 0)) return 0;
    return z >= 0 ? 1 + x / sum : 3 - x / sum;
  }
  void Mark(std::size_t direction, std::size_t number) {
    marks_[direction * words_ + number / kBits] |= 1ull << (number % kBits);
  }

  std::size_t words_ = 0;             ///< Of each direction.
  std::vector<std::uint64_t> marks_;  ///< By direction; those around the viewer lie in all of them and come last.
};

}  // namespace soarbox::world
