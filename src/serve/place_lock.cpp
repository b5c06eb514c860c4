// SPDX-License-Identifier: BSD-2-Clause
#include "serve/place_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "diagnostics/problem.h"

namespace soarbox::serve {

Result<PlaceLock> PlaceLock::Take(const std::filesystem::path& root) {
  const int file = open((root / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0)
    return NewProblem(std::string("this place cannot be locked: ") + std::strerror(errno),
                      "ask the server's administrator");
  PlaceLock lock(file);
  if (flock(file, LOCK_EX | LOCK_NB) == 0) return lock;
  if (errno == EWOULDBLOCK)
    return NewProblem("another server runs a world of this place now",
                      "close its page there and wait until that run has ended; the servers' administrator can send "
                      "each place to one of them (docs/serve.md)");
  // If the file system has no locks, the result holds none and nothing is prevented.
  return lock;
}

PlaceLock::~PlaceLock() {
  if (file_ >= 0) close(file_);
}

}  // namespace soarbox::serve
