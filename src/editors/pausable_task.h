// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace soarbox::editors {

/// Runs work that may pause in the middle, on a thread of its own. Of this thread and the caller's, only one runs at a
/// time: each call below returns when the work has paused or ended, so both may use the same data.
class PausableTask {
 public:
  PausableTask() = default;
  /// Lets work that is paused go on to its end.
  ~PausableTask();
  PausableTask(const PausableTask&) = delete;
  PausableTask& operator=(const PausableTask&) = delete;

  /// Begins; nothing may be paused. Returns true if the work has ended, false if it has paused.
  bool Start(std::function<void()> work);
  /// Goes on after a pause; the same results.
  bool Resume();
  /// Runs a job on the thread of the paused work, which stays paused.
  void Do(const std::function<void()>& job);
  bool is_paused() const { return paused_; }

  /// Called by the work: pauses it until Resume. Does nothing while the task is being destroyed.
  void Pause();

 private:
  enum class Turn : std::uint8_t { kCaller, kWork };

  /// Hands the turn to the work, and waits until it comes back.
  void GiveTurn();
  void Run();

  std::mutex mutex_;
  std::condition_variable turn_changed_;
  Turn turn_ = Turn::kCaller;
  std::function<void()> work_;
  const std::function<void()>* job_ = nullptr;
  bool paused_ = false, ends_ = false;
  std::thread thread_;
};

}  // namespace soarbox::editors
