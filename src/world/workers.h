// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace soarbox::world {

/// Does job(0), job(1), ... job(count - 1), on several threads at a time and in any order, and returns when all are
/// done. A job must not throw. Empty where there is but one thread.
using Workers = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

/// Cuts `size` things that are alike into few pieces: calls job(begin, end) for each. What is less than a piece is not
/// worth another thread.
inline void WorkInPieces(const Workers& workers, std::size_t size, std::size_t least,
                         const std::function<void(std::size_t, std::size_t)>& job) {
  constexpr std::size_t kMost = 64;
  const std::size_t pieces = workers ? std::min(kMost, size / least) : 1;
  if (pieces <= 1) return job(0, size);
  workers(pieces, [&](std::size_t n) { job(size * n / pieces, size * (n + 1) / pieces); });
}

}  // namespace soarbox::world
