// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace soarbox::sim {

/// The thread that runs job `number` of `threads` threads. Agents read their surroundings in every third tick,
/// depending on their number. If the number of threads is a multiple of three, each round starts one thread later, so
/// that the same threads are not used each time.
constexpr std::size_t ThreadOf(std::uint64_t number, std::size_t threads) {
  return static_cast<std::size_t>((threads % 3 == 0 ? number + number / threads : number) % threads);
}

/// Threads that execute a job together, repeatedly. The thread that owns the pool is one of them. If some threads
/// cannot be started, the owner does their work.
class WorkerPool {
 public:
  /// `threads`: number of threads including the owner; at least 1.
  explicit WorkerPool(std::size_t threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Calls job(0), job(1), ... job(threads - 1), each on its own thread, and returns when all have returned. The owner
  /// executes job(0). A job must not throw.
  void Run(const std::function<void(std::size_t)>& job);
  /// The same in two calls, between which the owner can do other work. Begin starts job(1), job(2), ...; job(0) is not
  /// called. Begin executes the jobs of missing threads before it returns. Join returns when all have returned, at once
  /// if nothing was begun. `job` must live until then.
  void Begin(const std::function<void(std::size_t)>& job);
  void Join();

 private:
  void Work(std::size_t number);

  std::size_t wanted_;  ///< Includes the owner and missing threads.
  std::mutex mutex_;
  std::condition_variable begun_, ended_;
  const std::function<void(std::size_t)>* job_ = nullptr;
  std::uint64_t round_ = 0;
  std::size_t busy_ = 0;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace soarbox::sim
