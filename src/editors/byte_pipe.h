// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::editors {

/// The connection to a client by two file descriptors, usually standard input and output. Does not close them.
class BytePipe {
 public:
  BytePipe(int in, int out) : in_(in), out_(out) {}

  struct Got {
    std::string bytes;   ///< Empty after a timeout.
    bool ended = false;  ///< The client has closed its end.
  };
  /// Waits at most `most_ms` milliseconds for bytes; without a limit if it is negative. A signal can end the wait.
  Got Read(int most_ms);
  /// Writes all bytes. If that fails, is_broken() becomes true, and later calls write nothing.
  void Write(std::string_view bytes);
  bool is_broken() const { return broken_; }

 private:
  int in_, out_;
  bool broken_ = false;
};

}  // namespace soarbox::editors
