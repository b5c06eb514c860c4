// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "diagnostics/result.h"

namespace soarbox::kernel {

/// What a memory keeps beyond the process: an image and the records of what changed since. Both are opaque to the
/// journal; a memory writes and reads them (bytes/byte_stream.h). The kernel does no I/O: cli/ gives a journal
/// that keeps them in a file.
class Journal {
 public:
  virtual ~Journal() = default;
  /// Into a buffer: cannot fail, does not wait.
  virtual void Append(std::string_view record) = 0;
  /// What was appended survives the process from now on. On a failure it stays in the buffer; call again later.
  virtual Result<void> Commit() = 0;
  /// A new image in place of image and records, or neither.
  virtual Result<void> Replace(std::string_view image) = 0;
  /// Whether the records have grown so large beside the image that a new one is worth its price.
  virtual bool WantsImage() const = 0;
};

}  // namespace soarbox::kernel
