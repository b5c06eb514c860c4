// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/base/random.h"

#include <bit>

namespace soarbox::kernel {

RandomStream::RandomStream(const RandomStream& other)
    : seed_(other.seed_), core_(other.core_ ? std::make_unique<AgentCore>(*other.core_) : nullptr) {}

RandomStream& RandomStream::operator=(const RandomStream& other) {
  if (this != &other) {
    seed_ = other.seed_;
    core_ = other.core_ ? std::make_unique<AgentCore>(*other.core_) : nullptr;
  }
  return *this;
}

void RandomStream::Seed(std::uint32_t seed) {
  seed_ = seed;
  if (core_) {
    core_->seed(seed);
  }
}

std::uint32_t RandomStream::Next32() {
  if (!core_) {
    core_ = std::make_unique<AgentCore>(seed_);
  }
  return (*core_)();
}

std::uint32_t RandomStream::Integer(std::uint32_t limit) {
  // Draws as many bits as the limit has, and repeats this until the result is not above the limit.
  const int bits = std::bit_width(limit);
  const std::uint32_t mask = bits == 32 ? 0xFFFFFFFFu : (1u << bits) - 1;
  for (;;) {
    const std::uint32_t drawn = Next32() & mask;
    if (drawn <= limit) {
      return drawn;
    }
  }
}

}  // namespace soarbox::kernel
