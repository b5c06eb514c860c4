// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::editors {

/// The two ends that a client talks through: standard input and output, as a rule. Does not own them.
class BytePipe {
 public:
  BytePipe(int in, int out) : in_(in), out_(out) {}

  struct Got {
    std::string bytes;   ///< Empty: the time is over.
    bool ended = false;  ///< The client has closed its end.
  };
  /// Waits at most so long for bytes; below 0: until there are some.
  Got Read(int most_ms);
  /// Writes all; whoever does not read any more breaks the pipe.
  void Write(std::string_view bytes);
  bool is_broken() const { return broken_; }

 private:
  int in_, out_;
  bool broken_ = false;
};

}  // namespace soarbox::editors
