// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace soar_thread {

/// An event on which threads wait. A trigger wakes one waiting thread; if no thread waits, it wakes the next one that
/// starts to wait. For client programs. Callable from any thread.
class Event {
 public:
  void TriggerEvent() {
    const std::lock_guard<std::mutex> lock(mutex_);
    triggered_ = true;
    changed_.notify_one();
  }

  void WaitForEventForever() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return triggered_; });
    triggered_ = false;
  }

  /// Returns false if the time elapsed before the event was triggered.
  bool WaitForEvent(int seconds, int milliseconds) {
    std::unique_lock<std::mutex> lock(mutex_);
    const auto limit = std::chrono::seconds(seconds) + std::chrono::milliseconds(milliseconds);
    if (!changed_.wait_for(lock, limit, [this] { return triggered_; })) return false;
    triggered_ = false;
    return true;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool triggered_ = false;
};

}  // namespace soar_thread
