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

/// An index of circles around a viewer by direction, seen from above. A line of sight among hundreds of bodies needs to
/// test only the few in its direction.
class Directions {
 public:
  /// Removes all circles and reserves memory for circles with numbers below `count`.
  void Reset(std::size_t count) {
    words_ = (count + kBits - 1) / kBits;
    marks_.assign((kDirections + 1) * words_, 0);
  }

  /// Adds a circle. x and z are relative to the viewer.
  void Add(std::size_t number, btScalar x, btScalar z, btScalar radius) {
    const btScalar away = std::sqrt(x * x + z * z);
    constexpr btScalar kInside = 0.999f;
    if (!(radius < away * kInside)) return Mark(kDirections, number);
    // An upper bound of the angle between the directions to its centre and its edge. A turn never grows faster than the
    // angle.
    constexpr btScalar kNarrow = 0.5f, kOfNarrow = 1.05f, kOfAny = 1.571f, kSlack = 1e-3f;
    const btScalar ratio = radius / away, half = ratio * (ratio < kNarrow ? kOfNarrow : kOfAny) + kSlack;
    const btScalar turn = TurnOf(x, z) + kFull;
    const std::size_t last = static_cast<std::size_t>((turn + half) * kOfTurn);
    for (std::size_t n = static_cast<std::size_t>((turn - half) * kOfTurn); n <= last; ++n)
      Mark(n % kDirections, number);
  }

  /// Calls visit(number) for each circle that a line in this direction may enter, and possibly for others. If visit
  /// returns false, stops and returns false.
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

  /// A monotonic function of the angle, from 0 to 4.
  static btScalar TurnOf(btScalar x, btScalar z) {
    const btScalar sum = std::abs(x) + std::abs(z);
    if (!(sum > 0)) return 0;
    return z >= 0 ? 1 + x / sum : 3 - x / sum;
  }
  void Mark(std::size_t direction, std::size_t number) {
    marks_[direction * words_ + number / kBits] |= 1ull << (number % kBits);
  }

  std::size_t words_ = 0;             ///< Words per direction.
  std::vector<std::uint64_t> marks_;  ///< By direction; the last row is for circles around the viewer, which are in all
                                      ///< directions.
};

}  // namespace soarbox::world
