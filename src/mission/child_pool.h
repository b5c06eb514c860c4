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
  double cpu_s = 60;               ///< Processor time; a child that uses more is treated as hung.
  std::uint64_t memory_bytes = 0;  ///< Address space; 0: no limit.
};

/// The result of a child.
struct ChildEnd {
  bool is_whole = false;  ///< It returned its complete output; otherwise it crashed or hung.
  bool hung = false;      ///< It exceeded its processor time, or ten times that in real time.
  int signal = 0;         ///< The signal that ended it; 0: none.
  std::string output;     ///< The return value of `work`.
  double cpu_s = 0;
  double peak_mb = 0;
};

/// Runs jobs in separate processes, a limited number at a time. A job that crashes, hangs or runs out of memory does
/// not affect others. The process that owns the pool must have only one thread, because the children are forks of it.
/// On platforms without processes, jobs run in this process (child_pool_absent.cpp).
class ChildPool {
 public:
  explicit ChildPool(int jobs);
  ~ChildPool();  ///< Kills running children.
  ChildPool(const ChildPool&) = delete;
  ChildPool& operator=(const ChildPool&) = delete;

  bool HasRoom() const { return static_cast<int>(running_.size()) < jobs_ && !ended_; }
  bool IsIdle() const { return running_.empty() && !ended_; }
  /// Starts a job. Fails if no process can be created.
  Result<void> Start(std::size_t id, const std::function<std::string()>& work, const ChildLimits& limits);
  struct Done {
    std::size_t id = 0;
    ChildEnd end;
  };
  /// Waits at most `seconds` for any child to end. Returns nothing if none has ended, or if a signal came.
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
  std::optional<Done> ended_;     ///< Without processes: the next result of Wait.
};

/// Number of processors that this process may use.
int Processors();

}  // namespace soarbox::mission
