// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <mutex>

namespace soar_thread {

/// A recursive mutex for client programs. The two classes below lock it.
class Mutex {
 private:
  friend class Lock;
  friend class ConditionalLock;
  std::recursive_mutex mutex_;
};

/// Locks a mutex during its lifetime.
class Lock {
 public:
  explicit Lock(Mutex* mutex) : mutex_(mutex) { LockMutex(); }
  ~Lock() { UnlockMutex(); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

  /// Unlocks temporarily; the mutex must be locked again before the destructor runs.
  void UnlockMutex() { mutex_->mutex_.unlock(); }
  void LockMutex() { mutex_->mutex_.lock(); }

 private:
  Mutex* mutex_;
};

/// Locks a mutex, if possible, until it is destroyed.
class ConditionalLock {
 public:
  ConditionalLock() = default;
  ~ConditionalLock() {
    if (mutex_) mutex_->mutex_.unlock();
  }
  ConditionalLock(const ConditionalLock&) = delete;
  ConditionalLock& operator=(const ConditionalLock&) = delete;

  /// Does not wait. Returns false if another thread holds the mutex or if this object holds one already.
  bool TryToLock(Mutex* mutex) {
    if (mutex_ || !mutex->mutex_.try_lock()) return false;
    mutex_ = mutex;
    return true;
  }

 private:
  Mutex* mutex_ = nullptr;
};

}  // namespace soar_thread
