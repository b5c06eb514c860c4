// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::mission {

struct ChildLimits {
  double cpu_s = 60;               ///< Processor time; a child that takes more counts as hung.
  std::uint64_t memory_bytes = 0;  ///< Address space; 0: none.
};

/// How a child ended.
struct ChildEnd {
  bool is_whole = false;  ///< It handed over its output; else it crashed or hung.
  bool hung = false;
  int signal = 0;      ///< That killed it; 0: none.
  std::string output;  ///< What the work returned.
  double cpu_s = 0;
  double peak_mb = 0;
};

/// Runs pieces of work in processes of their own, a fixed number at a time: a piece that crashes, hangs or runs out of
/// memory costs nothing but itself. The process that owns the pool must have one thread, as its children are forks of
/// it. On platforms without processes the work runs in this one (child_pool_absent.cpp).
class ChildPool {
 public:
  explicit ChildPool(int jobs);
  ~ChildPool();  ///< Kills what still runs.
  ChildPool(const ChildPool&) = delete;
  ChildPool& operator=(const ChildPool&) = delete;

  bool HasRoom() const { return static_cast<int>(running_.size()) < jobs_ && !ended_; }
  bool IsIdle() const { return running_.empty() && !ended_; }
  /// Begins a piece of work. Fails if the system gives no process.
  Result<void> Start(std::size_t id, const std::function<std::string()>& work, const ChildLimits& limits);
  /// Waits at most so long for any of them to end.
  struct Done {
    std::size_t id = 0;
    ChildEnd end;
  };
  std::optional<Done> Wait(double seconds);

 private:
  struct Child {
    std::size_t id = 0;
    int pipe = -1;
    std::string read;
    std::chrono::steady_clock::time_point deadline;
    bool hung = false;
  };
  Done Reap(int pid);

  int jobs_;
  std::map<int, Child> running_;  ///< By process id.
  std::optional<Done> ended_;     ///< Without processes: what Wait returns next.
};

/// How many processors this process may use.
int Processors();

}  // namespace soarbox::mission
