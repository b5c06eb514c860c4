// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace soarbox::picture {

/// A Huffman table of a JPEG file.
class JpegCodes {
 public:
  /// `counts`: the number of codes of each length, from 1 bit; `values`: the values in the order of their codes. False
  /// if the lengths contradict each other.
  bool Set(const std::array<std::uint8_t, 16>& counts, std::vector<std::uint8_t> values);
  bool is_set() const { return !values_.empty(); }

 private:
  friend class JpegBits;
  std::vector<std::uint8_t> values_;
  std::array<int, 17> first_code_{}, first_value_{}, counts_{};  ///< By length.
};

/// The bits of a scan. After the end of its data, it returns zeros.
class JpegBits {
 public:
  JpegBits(std::string_view file, std::size_t at) : file_(file), at_(at) {}

  int Bit();
  int Bits(int count);
  /// A value of `count` bits with its sign, as JPEG codes coefficients.
  int Signed(int count);
  /// The next value of this table; 0 if there is no such code.
  int Value(const JpegCodes& codes);
  /// Skips the rest of a byte and a marker RST.
  void Restart();
  /// The position at which the data of the scan end.
  std::size_t at() const { return at_; }
  /// Whether many more bytes were read than exist.
  bool IsOver() const { return missing_ > kMostMissing; }

 private:
  static constexpr int kMostMissing = 256;

  std::string_view file_;
  std::size_t at_;
  int byte_ = 0, left_ = 0;  ///< The current byte, and how many of its bits are left.
  int missing_ = 0;          ///< Bytes that were read beyond the end.
};

}  // namespace soarbox::picture
