// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::kernel {

/// What a memory keeps beyond the process: an image and the records of what changed since. Both are opaque to the
/// journal; a memory writes and reads them (RecordWriter, RecordReader). The kernel does no I/O: cli/ gives a journal
/// that keeps them in a file.
class Journal {
 public:
  virtual ~Journal() = default;
  /// Into a buffer: cannot fail, does not wait.
  virtual void Append(std::span<const std::uint8_t> record) = 0;
  /// What was appended survives the process from now on. On a failure it stays in the buffer; call again later.
  virtual Result<void> Commit() = 0;
  /// A new image in place of image and records, or neither.
  virtual Result<void> Replace(std::span<const std::uint8_t> image) = 0;
  /// Whether the records have grown so large beside the image that a new one is worth its price.
  virtual bool WantsImage() const = 0;
};

/// Numbers and texts one after the other, little-endian.
class RecordWriter {
 public:
  void Byte(std::uint8_t value) { bytes_.push_back(value); }
  void Number(std::uint64_t value) {  // Seven bits at a time.
    for (; value >= 0x80; value >>= 7) Byte(static_cast<std::uint8_t>(value | 0x80));
    Byte(static_cast<std::uint8_t>(value));
  }
  void Bits(std::uint64_t value) {
    for (int n = 0; n < 8; ++n) Byte(static_cast<std::uint8_t>(value >> (8 * n)));
  }
  void Real(double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    Bits(bits);
  }
  void Text(std::string_view text) {
    Number(text.size());
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }
  std::span<const std::uint8_t> bytes() const { return bytes_; }
  void Clear() { bytes_.clear(); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Reads what RecordWriter wrote. Bytes that lie give zeros and empty texts, and ok() is false from then on.
class RecordReader {
 public:
  explicit RecordReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint8_t Byte() {
    if (at_ >= bytes_.size()) {
      ok_ = false;
      return 0;
    }
    return bytes_[at_++];
  }
  std::uint64_t Number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const std::uint8_t byte = Byte();
      value |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
      if ((byte & 0x80) == 0) return value;
    }
    ok_ = false;
    return 0;
  }
  std::uint64_t Bits() {
    std::uint64_t value = 0;
    for (int n = 0; n < 8; ++n) value |= static_cast<std::uint64_t>(Byte()) << (8 * n);
    return value;
  }
  double Real() {
    const std::uint64_t bits = Bits();
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }
  std::string_view Text() {
    const std::uint64_t size = Number();
    if (!ok_ || size > bytes_.size() - at_) {
      ok_ = false;
      return {};
    }
    const std::string_view text(reinterpret_cast<const char*>(bytes_.data()) + at_, static_cast<std::size_t>(size));
    at_ += static_cast<std::size_t>(size);
    return text;
  }
  bool AtEnd() const { return at_ >= bytes_.size() || !ok_; }
  bool ok() const { return ok_; }
  void Fail() { ok_ = false; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

}  // namespace soarbox::kernel
