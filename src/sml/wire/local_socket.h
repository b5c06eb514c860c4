// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace soarbox::wire {

/// Where a kernel that listens on a port is also found by programs of the same user and machine: a socket in the file
/// `.soartmp/PORT` of the home folder. Empty without a home folder, or if the name is too long for a socket.
std::string LocalSocketPath(long long port);

/// The file of a socket that is listened on. Whatever a kernel left there before is removed first, and the file goes
/// with this object, unless somebody else has put another in its place.
class LocalSocketFile {
 public:
  /// Makes the folder, which nobody else may enter, and clears the place. False if that cannot be.
  static bool Prepare(const std::string& path);
  /// For a file that exists now.
  explicit LocalSocketFile(std::string path);
  ~LocalSocketFile();
  LocalSocketFile(const LocalSocketFile&) = delete;
  LocalSocketFile& operator=(const LocalSocketFile&) = delete;

 private:
  std::string path_;
  std::optional<std::pair<unsigned long long, unsigned long long>> identity_;  ///< Device and inode.
};

}  // namespace soarbox::wire
