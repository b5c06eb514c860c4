// SPDX-License-Identifier: BSD-2-Clause
#include "sim/worker_pool.h"

#include <system_error>

namespace soarbox::sim {

WorkerPool::WorkerPool(std::size_t threads) : wanted_(threads) {
  try {
    for (std::size_t number = 1; number < threads; ++number) threads_.emplace_back([this, number] { Work(number); });
  } catch (const std::system_error&) {
    // There are too many threads, or the platform has no threads.
  }
}

WorkerPool::~WorkerPool() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerPool::Run(const std::function<void(std::size_t)>& job) {
  Begin(job);
  job(0);
  Join();
}

void WorkerPool::Begin(const std::function<void(std::size_t)>& job) {
  if (!threads_.empty()) {
    const std::lock_guard lock(mutex_);
    job_ = &job;
    busy_ = threads_.size();
    ++round_;
  }
  begun_.notify_all();
  for (std::size_t number = threads_.size() + 1; number < wanted_; ++number) job(number);
}

void WorkerPool::Join() {
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [this] { return busy_ == 0; });
}

void WorkerPool::Work(std::size_t number) {
  std::uint64_t done = 0;
  while (true) {
    const std::function<void(std::size_t)>* job = nullptr;
    {
      std::unique_lock lock(mutex_);
      begun_.wait(lock, [&] { return stopping_ || round_ != done; });
      if (stopping_) return;
      done = round_;
      job = job_;
    }
    (*job)(number);
    const std::lock_guard lock(mutex_);
    if (--busy_ == 0) ended_.notify_one();
  }
}

}  // namespace soarbox::sim
