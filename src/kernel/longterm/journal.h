// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "diagnostics/result.h"

namespace soarbox::kernel {

/// The persistent storage of a memory: an image, and the records of later changes. Both are opaque to the journal; the
/// memory encodes and decodes them (bytes/byte_stream.h). The kernel does no I/O: journal/ provides an implementation
/// with files.
class Journal {
 public:
  virtual ~Journal() = default;
  /// Appends to a buffer: cannot fail, does not wait.
  virtual void Append(std::string_view record) = 0;
  /// Makes everything appended persistent. After an error it stays in the buffer; call Commit again later.
  virtual Result<void> Commit() = 0;
  /// Replaces image and records by a new image; on error changes nothing.
  virtual Result<void> Replace(std::string_view image) = 0;
  /// Whether the records are so large, compared with the image, that a new image is worthwhile.
  virtual bool WantsImage() const = 0;
};

}  // namespace soarbox::kernel
