// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

#include "thread_Event.h"

namespace soar_thread {

/// A base class for threads: Run() is the work, and the thread ends when Run() returns. For client programs. Stop the
/// thread and wait for its end before the derived object is destroyed.
class Thread {
 public:
  Thread() = default;
  virtual ~Thread() {
    if (!thread_.joinable()) return;
    quit_ = true;
    if (thread_.get_id() == std::this_thread::get_id()) {
      thread_.detach();
    } else {
      thread_.join();
    }
  }
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

  /// Starts a thread that executes Run(). Call it once.
  void Start() {
    if (started_.exchange(true)) return;
    thread_ = std::thread([this] {
      Run();
      SetStopped(true);
    });
  }
  /// Asks the thread to end; waits for its end if `wait_till_stopped`.
  void Stop(bool wait_till_stopped) {
    quit_ = true;
    while (wait_till_stopped && started_ && !stopped_) Sleep(0, 1);
  }
  bool IsStopped() { return stopped_; }
  bool IsStarted() { return started_; }
  /// Blocks the calling thread until Resume() is called.
  void Suspend() { pause_.WaitForEventForever(); }
  void Resume() { pause_.TriggerEvent(); }
  /// The thread's work. It should end when QuitNow() is true.
  virtual void Run() = 0;
  void SetStopped(bool stopped) { stopped_ = stopped; }

 protected:
  bool QuitNow() { return quit_; }
  void Sleep(int seconds, int milliseconds) {
    std::this_thread::sleep_for(std::chrono::seconds(seconds) + std::chrono::milliseconds(milliseconds));
  }

 private:
  std::atomic<bool> quit_{false}, started_{false}, stopped_{false};
  Event pause_;
  std::thread thread_;
};

}  // namespace soar_thread
