// SPDX-License-Identifier: BSD-2-Clause
#include "editors/byte_pipe.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>

namespace soarbox::editors {

BytePipe::Got BytePipe::Read(int most_ms) {
  pollfd waits{in_, POLLIN, 0};
  const int ready = poll(&waits, 1, most_ms);
  if (ready < 0 && errno == EINTR) return {};
  if (ready == 0) return {};
  char block[64 * 1024];
  const ssize_t size = read(in_, block, sizeof block);
  if (size < 0 && (errno == EINTR || errno == EAGAIN)) return {};
  if (size <= 0) return {{}, true};
  return {std::string(block, static_cast<std::size_t>(size)), false};
}

void BytePipe::Write(std::string_view bytes) {
  while (!bytes.empty() && !broken_) {
    const ssize_t size = write(out_, bytes.data(), bytes.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) {
      broken_ = true;
    } else {
      bytes.remove_prefix(static_cast<std::size_t>(size));
    }
  }
}

}  // namespace soarbox::editors
