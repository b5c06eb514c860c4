// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace soarbox::editors {

/// Runs work that can pause in the middle, on a separate thread. The caller waits while the work runs: Start and Resume
/// return when it has paused or ended. Therefore, both threads can use the same data without locks.
class PausableTask {
 public:
  PausableTask() = default;
  /// Lets paused work continue to its end.
  ~PausableTask();
  PausableTask(const PausableTask&) = delete;
  PausableTask& operator=(const PausableTask&) = delete;

  /// Starts the work; no other work may be paused. Returns true if it has ended, false if it has paused.
  bool Start(std::function<void()> work);
  /// Continues after a pause. Returns the same as Start.
  bool Resume();
  /// Executes a job on the thread of the paused work, and waits for its end. The work stays paused. Does nothing if no
  /// work is paused.
  void Do(const std::function<void()>& job);
  bool is_paused() const { return paused_; }

  /// The work calls this to pause until Resume. Does nothing while the task is being destroyed.
  void Pause();

 private:
  enum class Turn : std::uint8_t { kCaller, kWork };

  /// Lets the work run, and waits until it pauses or ends.
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
