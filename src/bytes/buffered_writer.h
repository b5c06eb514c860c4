// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace soarbox {

/// A ByteWriter with a buffer, for many small values: appending each of them to a string costs much more. Call Flush at
/// the end.
class BufferedWriter {
 public:
  explicit BufferedWriter(std::string& out) : out_(out) {}
  BufferedWriter(const BufferedWriter&) = delete;
  BufferedWriter& operator=(const BufferedWriter&) = delete;

  void Flush() {
    out_.append(bytes_, size_);
    size_ = 0;
  }
  void Byte(std::uint8_t value) {
    Reserve(1);
    bytes_[size_++] = static_cast<char>(value);
  }
  void Number(std::uint64_t value) {
    if (value < 0x80) return Byte(static_cast<std::uint8_t>(value));
    LargeNumber(value);
  }
  void Fixed32(std::uint32_t value) { Fixed(value, 4); }
  void Fixed64(std::uint64_t value) { Fixed(value, 8); }
  void Float(float value) { Fixed32(std::bit_cast<std::uint32_t>(value)); }
  void Double(double value) { Fixed64(std::bit_cast<std::uint64_t>(value)); }
  void Text(std::string_view text) {
    Number(text.size());
    Append(text);
  }
  /// Appends bytes unchanged.
  void Append(std::string_view bytes) {
    if (bytes.size() > sizeof bytes_ - size_) [[unlikely]]
      return AppendPastEnd(bytes);
    if (!bytes.empty()) std::memcpy(bytes_ + size_, bytes.data(), bytes.size());
    size_ += bytes.size();
  }
  /// Room for `most` bytes (at most 1024). The caller fills it and then calls Wrote.
  char* Room(std::size_t most) {
    Reserve(most);
    return bytes_ + size_;
  }
  void Wrote(std::size_t size) { size_ += size; }

 private:
  void Reserve(std::size_t most) {
    if (most > sizeof bytes_ - size_) [[unlikely]]
      Flush();
  }
  [[gnu::noinline]] void LargeNumber(std::uint64_t value) {
    Reserve(10);
    char* at = bytes_ + size_;
    for (; value >= 0x80; value >>= 7) *at++ = static_cast<char>(value | 0x80);
    *at++ = static_cast<char>(value);
    size_ = static_cast<std::size_t>(at - bytes_);
  }
  [[gnu::noinline]] void AppendPastEnd(std::string_view bytes) {
    Flush();
    out_.append(bytes);
  }
  void Fixed(std::uint64_t value, int bytes) {
    Reserve(8);
    char* const at = bytes_ + size_;
    for (int i = 0; i < bytes; ++i) at[i] = static_cast<char>(value >> (8 * i));
    size_ += static_cast<std::size_t>(bytes);
  }

  std::string& out_;
  std::size_t size_ = 0;
  char bytes_[1024];
};

}  // namespace soarbox
