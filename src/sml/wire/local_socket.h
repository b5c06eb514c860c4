// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace soarbox::wire {

/// The file of the socket at which programs of the same user on the same machine find a kernel that listens on a port:
/// `.soartmp/PORT` in the home folder. Empty if there is no home folder, or if the name is too long for a socket.
std::string LocalSocketPath(long long port);

/// The file of a listening socket. Removes a file that an earlier kernel left, and removes its own file in the
/// destructor, unless another program has replaced it.
class LocalSocketFile {
 public:
  /// Creates the folder with access only for this user, and removes an old file. Returns false on failure.
  static bool Prepare(const std::string& path);
  /// `path` must exist.
  explicit LocalSocketFile(std::string path);
  ~LocalSocketFile();
  LocalSocketFile(const LocalSocketFile&) = delete;
  LocalSocketFile& operator=(const LocalSocketFile&) = delete;

 private:
  std::string path_;
  std::optional<std::pair<unsigned long long, unsigned long long>> identity_;  ///< Device and inode.
};

}  // namespace soarbox::wire
