// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace soarbox {

/// Appends values to a byte string, little-endian. Integers are stored in groups of seven bits, the lowest first. All
/// bytes that Soarbox stores or sends are written this way: recordings, streams, images of rules, long-term memories.
class ByteWriter {
 public:
  explicit ByteWriter(std::string& out) : out_(out) {}

  void Byte(std::uint8_t value) { out_.push_back(static_cast<char>(value)); }
  void Number(std::uint64_t value) {
    if (value < 0x80) return Byte(static_cast<std::uint8_t>(value));
    char groups[10];
    std::size_t count = 0;
    for (; value >= 0x80; value >>= 7) groups[count++] = static_cast<char>(value | 0x80);
    groups[count++] = static_cast<char>(value);
    Append({groups, count});
  }
  void Fixed32(std::uint32_t value) { Fixed(value, 4); }
  void Fixed64(std::uint64_t value) { Fixed(value, 8); }
  void Float(float value) { Fixed32(std::bit_cast<std::uint32_t>(value)); }
  void Double(double value) { Fixed64(std::bit_cast<std::uint64_t>(value)); }
  /// Writes several floats at once, which are most of a recording.
  template <typename... Floats>
  void ManyFloats(Floats... values) {
    char bytes[4 * sizeof...(Floats)];
    std::size_t at = 0;
    ((Place(bytes + at, std::bit_cast<std::uint32_t>(values), 4), at += 4), ...);
    out_.append(bytes, sizeof bytes);
  }
  void Text(std::string_view text) {
    Number(text.size());
    Append(text);
  }
  /// Appends bytes unchanged.
  void Append(std::string_view bytes) { out_.append(bytes); }

 private:
  static void Place(char* at, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) at[i] = static_cast<char>(value >> (8 * i));
  }
  void Fixed(std::uint64_t value, int bytes) {
    char placed[8];
    Place(placed, value, bytes);
    out_.append(placed, static_cast<std::size_t>(bytes));
  }

  std::string& out_;
};

/// The same for a few values. They are collected here, because appending them one by one to a string costs much more.
/// The caller makes sure that they fit.
template <std::size_t kMost>
class ShortWriterOf {
 public:
  void Byte(std::uint8_t value) { bytes_[size_++] = static_cast<char>(value); }
  void Number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) Byte(static_cast<std::uint8_t>(value | 0x80));
    Byte(static_cast<std::uint8_t>(value));
  }
  void Fixed32(std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) Byte(static_cast<std::uint8_t>(value >> shift));
  }
  std::string_view bytes() const { return {bytes_, size_}; }

 private:
  char bytes_[kMost];
  std::size_t size_ = 0;
};
using ShortWriter = ShortWriterOf<48>;

/// Reads the output of ByteWriter. Accepts any input. After the first error, failed() stays true, and all further
/// values are zero or empty.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  bool failed() const { return failed_; }
  bool AtEnd() const { return bytes_.empty(); }
  std::size_t left() const { return bytes_.size(); }
  void Fail() {
    failed_ = true;
    bytes_ = {};
  }

  std::uint8_t Byte() {
    if (bytes_.empty()) {
      Fail();
      return 0;
    }
    const auto value = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return value;
  }
  std::uint64_t Number() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const std::uint8_t byte = Byte();
      value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if ((byte & 0x80) == 0) return value;
    }
    Fail();
    return 0;
  }
  /// Reads a value of an enumeration whose last value is `last`.
  template <typename Enum>
  Enum Kind(Enum last) {
    const std::uint8_t value = Byte();
    if (value <= static_cast<std::uint8_t>(last)) return static_cast<Enum>(value);
    Fail();
    return Enum{};
  }
  /// Reads the number of items that use at least `least_bytes` each. Fails if so many cannot follow, so that a damaged
  /// number never causes a large allocation.
  std::size_t Count(std::size_t least_bytes = 1) {
    const std::uint64_t count = Number();
    if (count <= bytes_.size() / least_bytes) return static_cast<std::size_t>(count);
    Fail();
    return 0;
  }
  /// Records that decoding allocates `bytes` of memory. Fails when the total exceeds the budget, because few bytes of
  /// input can request many empty items.
  void Charge(std::uint64_t bytes) {
    if (bytes > budget_) return Fail();
    budget_ -= bytes;
  }
  void SetBudget(std::uint64_t bytes) { budget_ = bytes; }
  std::uint64_t budget() const { return budget_; }
  /// Count, with a charge for the items.
  std::size_t CountOf(std::size_t bytes_each, std::size_t least_bytes = 1) {
    const std::size_t count = Count(least_bytes);
    Charge(static_cast<std::uint64_t>(count) * bytes_each);
    return failed_ ? 0 : count;
  }
  std::uint32_t Fixed32() { return static_cast<std::uint32_t>(Fixed(4)); }
  std::uint64_t Fixed64() { return Fixed(8); }
  float Float() { return std::bit_cast<float>(Fixed32()); }
  double Double() { return std::bit_cast<double>(Fixed64()); }
  std::string_view Text() {
    const std::size_t size = Count();
    const std::string_view text = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return text;
  }

 private:
  std::uint64_t Fixed(std::size_t bytes) {
    if (bytes_.size() < bytes) {
      Fail();
      return 0;
    }
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i)
      value |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(bytes_[i])) << (8 * i);
    bytes_.remove_prefix(bytes);
    return value;
  }

  std::string_view bytes_;
  std::uint64_t budget_ = ~std::uint64_t{0};
  bool failed_ = false;
};

}  // namespace soarbox
