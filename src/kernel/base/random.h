// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <random>

namespace soarbox::kernel {

/// A stream of random numbers: the Mersenne Twister MT19937, used as Soar uses it, so that equal seeds give equal
/// choices. Each agent owns one stream and is its only user. The state (2.5 KB) is allocated at the first draw.
class RandomStream {
 public:
  static constexpr std::uint32_t kDefaultSeed = 5489u;

  RandomStream() = default;
  explicit RandomStream(std::uint32_t seed) : seed_(seed) {}
  RandomStream(const RandomStream& other);
  RandomStream& operator=(const RandomStream& other);
  RandomStream(RandomStream&&) noexcept = default;
  RandomStream& operator=(RandomStream&&) noexcept = default;

  /// Restarts the stream. Equal seeds give equal streams.
  void Seed(std::uint32_t seed);
  /// A number from 0 to 2^32 - 1, uniformly distributed.
  std::uint32_t Next32();
  /// A number from 0.0 to 1.0, both included.
  double Real() { return static_cast<double>(Next32()) / 4294967295.0; }
  /// A number from 0.0 to `limit`, both included.
  double Real(double limit) { return Real() * limit; }
  /// A number from 0 to `limit`, both included, uniformly distributed. May draw more than once.
  std::uint32_t Integer(std::uint32_t limit);

 private:
  using AgentCore = std::mersenne_twister_engine<std::uint32_t, 32, 624, 397, 31, 0x9908b0dfu, 11, 0xffffffffu, 7,
                                                 0x9d2c5680u, 15, 0xefc60000u, 18, 1812433253u>;
  std::uint32_t seed_ = kDefaultSeed;
  std::unique_ptr<AgentCore> core_;
};

}  // namespace soarbox::kernel
