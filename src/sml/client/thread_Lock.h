// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <mutex>

namespace soar_thread {

/// A mutex that the same thread may lock several times. Locked by the two classes below, for client programs.
class Mutex {
 private:
  friend class Lock;
  friend class ConditionalLock;
  std::recursive_mutex mutex_;
};

/// Holds a mutex for as long as it lives.
class Lock {
 public:
  explicit Lock(Mutex* mutex) : mutex_(mutex) { LockMutex(); }
  ~Lock() { UnlockMutex(); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

  /// For a break in between; the mutex must be held again when the lock goes.
  void UnlockMutex() { mutex_->mutex_.unlock(); }
  void LockMutex() { mutex_->mutex_.lock(); }

 private:
  Mutex* mutex_;
};

/// Holds a mutex from the moment in which it could be had.
class ConditionalLock {
 public:
  ConditionalLock() = default;
  ~ConditionalLock() {
    if (mutex_) mutex_->mutex_.unlock();
  }
  ConditionalLock(const ConditionalLock&) = delete;
  ConditionalLock& operator=(const ConditionalLock&) = delete;

  /// Does not wait. False if another thread has the mutex, or if this holds one already.
  bool TryToLock(Mutex* mutex) {
    if (mutex_ || !mutex->mutex_.try_lock()) return false;
    mutex_ = mutex;
    return true;
  }

 private:
  Mutex* mutex_ = nullptr;
};

}  // namespace soar_thread
