// SPDX-License-Identifier: BSD-2-Clause
#include "picture/jpeg_bits.h"

#include <utility>

namespace soarbox::picture {

bool JpegCodes::Set(const std::array<std::uint8_t, 16>& counts, std::vector<std::uint8_t> values) {
  int code = 0, value = 0;
  for (std::size_t length = 1; length <= 16; ++length) {
    first_code_[length] = code;
    first_value_[length] = value;
    counts_[length] = counts[length - 1];
    code += counts_[length];
    value += counts_[length];
    if (code > 1 << length) return false;
    code <<= 1;
  }
  if (static_cast<std::size_t>(value) != values.size() || values.empty()) return false;
  values_ = std::move(values);
  return true;
}

int JpegBits::Bit() {
  if (left_ == 0) {
    const auto at = [this](std::size_t place) {
      return place < file_.size() ? static_cast<unsigned char>(file_[place]) : -1;
    };
    byte_ = at(at_);
    // 0xff 0x00 encodes the byte 0xff. Any other byte after 0xff is a marker, and the data end there.
    if (byte_ < 0 || (byte_ == 0xff && at(at_ + 1) != 0)) {
      byte_ = 0;
      ++missing_;
    } else {
      at_ += byte_ == 0xff ? 2 : 1;
    }
    left_ = 8;
  }
  return byte_ >> --left_ & 1;
}

int JpegBits::Bits(int count) {
  int bits = 0;
  for (int i = 0; i < count; ++i) bits = bits << 1 | Bit();
  return bits;
}

int JpegBits::Signed(int count) {
  if (count == 0) return 0;
  const int bits = Bits(count);
  return bits < 1 << (count - 1) ? bits - (1 << count) + 1 : bits;
}

int JpegBits::Value(const JpegCodes& codes) {
  int code = 0;
  for (std::size_t length = 1; length <= 16; ++length) {
    code = code << 1 | Bit();
    const int place = code - codes.first_code_[length];
    if (place < codes.counts_[length])
      return place < 0 ? 0 : codes.values_[static_cast<std::size_t>(codes.first_value_[length] + place)];
  }
  return 0;
}

void JpegBits::Restart() {
  left_ = 0;
  const auto is_marker = [this] {
    return at_ + 1 < file_.size() && static_cast<unsigned char>(file_[at_]) == 0xff &&
           (static_cast<unsigned char>(file_[at_ + 1]) & 0xf8) == 0xd0;
  };
  if (is_marker()) at_ += 2;
}

}  // namespace soarbox::picture
