// SPDX-License-Identifier: BSD-2-Clause
// For platforms without processes (WebAssembly). Each job runs in this process, and Start returns when it has ended. A
// job that hangs or crashes ends the program; limits are not enforced.
#include <exception>
#include <utility>

#include "mission/child_pool.h"
#include "world/shared_navigation.h"

namespace soarbox::mission {

ChildPool::ChildPool(int) : jobs_(1) {
  world::ShareNavigation();
}

ChildPool::~ChildPool() = default;

Result<void> ChildPool::Start(std::size_t id, const std::function<std::string()>& work, const ChildLimits&) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Done& done = ended_.emplace();
  done.id = id;
  try {
    done.end.output = work();
    done.end.is_whole = true;
  } catch (const std::exception&) {
    // Usually out of memory. The output is incomplete, so it counts as a crash.
  }
  done.end.cpu_s = std::chrono::duration<double>(Clock::now() - start).count();
  return {};
}

std::optional<ChildPool::Done> ChildPool::Wait(double) {
  return std::exchange(ended_, std::nullopt);
}

int Processors() {
  return 1;
}

}  // namespace soarbox::mission
