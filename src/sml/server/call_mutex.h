// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>

namespace soarbox::server {

/// A recursive mutex for the calls of the client API. It costs a few instructions while there is no contention. A
/// thread that finds it locked sleeps until it is free. The order of waiting threads is unspecified.
class CallMutex {
 public:
  [[gnu::always_inline]] void lock() {
    if (owner_.load(std::memory_order_relaxed) != Self()) return Take();
    ++depth_;
  }
  bool try_lock() {
    const void* self = Self();
    if (owner_.load(std::memory_order_relaxed) != self) {
      int expected = kFree;
      if (!state_.compare_exchange_strong(expected, kHeld, std::memory_order_acquire, std::memory_order_relaxed))
        return false;
      owner_.store(self, std::memory_order_relaxed);
    }
    ++depth_;
    return true;
  }
  [[gnu::always_inline]] void unlock() {
    if (--depth_ == 0) Release();
  }

 private:
  enum : int { kFree, kHeld, kWanted };

  /// An address that differs from thread to thread.
  static const void* Self() {
    static thread_local const char mark = 0;
    return &mark;
  }
  [[gnu::noinline]] void Take() {
    int expected = kFree;
    if (!state_.compare_exchange_strong(expected, kHeld, std::memory_order_acquire, std::memory_order_relaxed)) Wait();
    owner_.store(Self(), std::memory_order_relaxed);
    depth_ = 1;
  }
  [[gnu::noinline]] void Release() {
    owner_.store(nullptr, std::memory_order_relaxed);
    if (state_.exchange(kFree, std::memory_order_release) == kWanted) state_.notify_one();
  }
  /// The holder wakes a sleeper only if it reads kWanted, so a thread that has slept must store that mark.
  [[gnu::noinline]] void Wait() {
    while (state_.exchange(kWanted, std::memory_order_acquire) != kFree)
      state_.wait(kWanted, std::memory_order_relaxed);
  }

  std::atomic<int> state_{kFree};
  std::atomic<const void*> owner_{nullptr};
  int depth_ = 0;  ///< Number of locks of the owner.
};

}  // namespace soarbox::server
