// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <utility>

#include "diagnostics/result.h"

namespace soarbox::serve {

/// Keeps other servers from running the world of a place that this one runs. The system takes it away when the server
/// ends, however it ends; on a disk that several machines share, too, if that disk knows locks (NFS does).
class PlaceLock {
 public:
  /// `root`: the folder of the place. An error if another server has it.
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
