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

/// Which of `threads` threads gets the job of this number: they take turns. Agents look around in every third tick, by
/// their number: where that would pick the same threads each time, each round begins one thread later.
constexpr std::size_t ThreadOf(std::uint64_t number, std::size_t threads) {
  return static_cast<std::size_t>((threads % 3 == 0 ? number + number / threads : number) % threads);
}

/// A few threads that do one job together, again and again. The thread that owns the pool is one of them. If fewer
/// threads can be started, it does the work of the missing ones.
class WorkerPool {
 public:
  /// `threads`: how many take part, the owner included; at least 1.
  explicit WorkerPool(std::size_t threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Calls job(0), job(1), ... job(threads - 1), each on a thread of its own, and returns when all have returned. The
  /// owner's is job(0). A job must not throw.
  void Run(const std::function<void(std::size_t)>& job);
  /// The same in two halves, between which the owner does something else: job(1), job(2), ... begin; the owner's own
  /// job is up to the owner. Jobs of missing threads are done before Begin returns. `job` must live until Join, which
  /// returns when all have returned, at once if nothing was begun.
  void Begin(const std::function<void(std::size_t)>& job);
  void Join();

 private:
  void Work(std::size_t number);

  std::size_t wanted_;  ///< Threads, the owner and missing ones included.
  std::mutex mutex_;
  std::condition_variable begun_, ended_;
  const std::function<void(std::size_t)>* job_ = nullptr;
  std::uint64_t round_ = 0;
  std::size_t busy_ = 0;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace soarbox::sim
