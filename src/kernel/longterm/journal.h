// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "diagnostics/result.h"

namespace soarbox::kernel {

/// What a memory keeps beyond the process: an image, and the records of later changes. Both are opaque to the journal;
/// a memory writes and reads them (bytes/byte_stream.h). The kernel does no I/O: cli/ provides a journal that keeps
/// them in a file.
class Journal {
 public:
  virtual ~Journal() = default;
  /// Appends to a buffer: cannot fail, does not wait.
  virtual void Append(std::string_view record) = 0;
  /// Makes everything appended survive the process. After a failure it stays in the buffer; call again later.
  virtual Result<void> Commit() = 0;
  /// Replaces image and records by a new image, or changes nothing.
  virtual Result<void> Replace(std::string_view image) = 0;
  /// Whether the records have grown so large compared with the image that a new image pays off.
  virtual bool WantsImage() const = 0;
};

}  // namespace soarbox::kernel
