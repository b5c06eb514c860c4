// SPDX-License-Identifier: BSD-2-Clause
// Where there are no other processes (WebAssembly): each piece of work runs in this one, and Start returns when it has
// ended. A piece that hangs or crashes takes the program with it; the limits are not enforced.
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
    // Memory that ran out, mostly: no whole output, so it counts as crashed.
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
