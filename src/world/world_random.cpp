// SPDX-License-Identifier: BSD-2-Clause
#include "world/world_random.h"

namespace soarbox::world {
namespace {

constexpr std::uint64_t kMultiplier = 6364136223846793005ull;

// Spreads similar seeds and stream numbers over all 64 bits (Stafford's mix 13).
std::uint64_t MixBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream) : increment_((MixBits(stream + 1) << 1) | 1) {
  Reseed(seed);
}

void RandomStream::Reseed(std::uint64_t seed) {
  state_ = MixBits(seed + 0x9e3779b97f4a7c15ull) + increment_;
  Next();
}

std::uint32_t RandomStream::Next() {
  const std::uint64_t old = state_;
  state_ = old * kMultiplier + increment_;
  const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
  const auto rotation = static_cast<std::uint32_t>(old >> 59);
  return (shifted >> rotation) | (shifted << ((32 - rotation) & 31));
}

std::uint32_t RandomStream::Below(std::uint32_t bound) {
  if (bound == 0) return 0;
  // Numbers below the remainder of 2^32 / bound would make small results more likely.
  const std::uint32_t remainder = (0u - bound) % bound;
  std::uint32_t number = Next();
  while (number < remainder) number = Next();
  return number % bound;
}

float RandomStream::Unit() {
  return static_cast<float>(Next() >> 8) * 0x1p-24f;
}

double RandomStream::UnitDouble() {
  const std::uint64_t high = Next() >> 5;
  const std::uint64_t low = Next() >> 6;
  return static_cast<double>((high << 26) | low) * 0x1p-53;
}

}  // namespace soarbox::world
