// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace soarbox::world {

/// Executes job(0), job(1), ... job(count - 1) on several threads, in any order, and returns when all are complete. A
/// job must not throw. Empty if there is only one thread.
using Workers = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

/// Splits `size` items of equal cost into a few ranges and calls job(begin, end) for each. A range has at least `least`
/// items, so that an additional thread is worthwhile.
inline void WorkInPieces(const Workers& workers, std::size_t size, std::size_t least,
                         const std::function<void(std::size_t, std::size_t)>& job) {
  constexpr std::size_t kMost = 64;
  const std::size_t pieces = workers ? std::min(kMost, size / least) : 1;
  if (pieces <= 1) return job(0, size);
  workers(pieces, [&](std::size_t n) { job(size * n / pieces, size * (n + 1) / pieces); });
}

}  // namespace soarbox::world
