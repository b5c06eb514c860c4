// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::world {

/// A stream of random numbers (O'Neill's PCG with 64 bits of state and 32 bits of output). It is the same on every
/// machine and standard library. Streams with different numbers are independent even with the same seed.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed = 1, std::uint64_t stream = 0);

  /// 0 .. 2^32 - 1.
  std::uint32_t Next();
  /// 0 .. bound - 1, unbiased; 0 if bound is 0.
  std::uint32_t Below(std::uint32_t bound);
  /// [0, 1) with 24 random bits.
  float Unit();
  /// [0, 1) with 53 random bits. Draws two numbers.
  double UnitDouble();
  /// Restarts the stream with another seed; keeps the stream's number.
  void Reseed(std::uint64_t seed);
  /// The state that determines all later numbers, for the state hash.
  std::uint64_t state() const { return state_; }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

}  // namespace soarbox::world
