// SPDX-License-Identifier: BSD-2-Clause
#include "editors/pausable_task.h"

#include <utility>

namespace soarbox::editors {

PausableTask::~PausableTask() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    turn_ = Turn::kWork;
  }
  turn_changed_.notify_all();
  thread_.join();
}

bool PausableTask::Start(std::function<void()> work) {
  work_ = std::move(work);
  if (!thread_.joinable()) thread_ = std::thread([this] { Run(); });
  GiveTurn();
  return !paused_;
}

bool PausableTask::Resume() {
  if (!paused_) return true;
  paused_ = false;
  GiveTurn();
  return !paused_;
}

void PausableTask::Do(const std::function<void()>& job) {
  if (!paused_) return;
  job_ = &job;
  GiveTurn();
}

void PausableTask::GiveTurn() {
  std::unique_lock lock(mutex_);
  turn_ = Turn::kWork;
  turn_changed_.notify_all();
  turn_changed_.wait(lock, [this] { return turn_ == Turn::kCaller; });
}

void PausableTask::Pause() {
  std::unique_lock lock(mutex_);
  if (ends_) return;
  paused_ = true;
  while (true) {
    turn_ = Turn::kCaller;
    turn_changed_.notify_all();
    turn_changed_.wait(lock, [this] { return turn_ == Turn::kWork; });
    if (job_ == nullptr) break;
    const std::function<void()>& job = *std::exchange(job_, nullptr);
    lock.unlock();
    job();
    lock.lock();
  }
  paused_ = false;
}

void PausableTask::Run() {
  std::unique_lock lock(mutex_);
  while (true) {
    turn_changed_.wait(lock, [this] { return turn_ == Turn::kWork; });
    if (ends_) return;
    const std::function<void()> work = std::exchange(work_, nullptr);
    lock.unlock();
    work();
    lock.lock();
    if (ends_) return;
    turn_ = Turn::kCaller;
    turn_changed_.notify_all();
  }
}

}  // namespace soarbox::editors
