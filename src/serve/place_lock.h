// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <utility>

#include "diagnostics/result.h"

namespace soarbox::serve {

/// Prevents other servers from running the world of a place at the same time. The operating system releases the lock
/// when the server ends, in any way. It also works on a disk shared by several machines if that supports locks (NFS
/// does).
class PlaceLock {
 public:
  /// `root`: the folder of the place. Fails if another server has the lock.
  static Result<PlaceLock> Take(const std::filesystem::path& root);
  PlaceLock(PlaceLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  PlaceLock& operator=(PlaceLock&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  ~PlaceLock();
  PlaceLock(const PlaceLock&) = delete;
  PlaceLock& operator=(const PlaceLock&) = delete;

 private:
  explicit PlaceLock(int file) : file_(file) {}

  int file_;
};

}  // namespace soarbox::serve
