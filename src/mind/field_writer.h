// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "mind/event.h"

namespace soarbox::mind {

/// Writes fields of events and decisions one after the other. The caller provides sufficient memory.
class FieldWriter {
 public:
  static constexpr std::size_t kMostOfNumber = 10;  ///< Maximum size of a number or a double, in bytes.

  explicit FieldWriter(char* at) : at_(at) {}
  char* at() const { return at_; }

  void operator()(const char*, std::string_view text) {
    Number(text.size());
    if (!text.empty()) std::memcpy(at_, text.data(), text.size());
    at_ += text.size();
  }
  void operator()(const char*, const Value& value) {
    if (const auto* word = std::get_if<std::string_view>(&value)) {
      Byte(0);
      (*this)("", *word);
    } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
      Byte(1);
      // Zigzag encoding, so that small negative numbers are short.
      const auto bits = static_cast<std::uint64_t>(*integer);
      Number((bits << 1) ^ (*integer < 0 ? ~std::uint64_t{0} : 0));
    } else {
      const double number = std::get<double>(value);
      const auto single = static_cast<float>(number);
      const bool is_single = static_cast<double>(single) == number;
      Byte(is_single ? 2 : 3);
      is_single ? Fixed(std::bit_cast<std::uint32_t>(single), 4) : Fixed(std::bit_cast<std::uint64_t>(number), 8);
    }
  }
  void operator()(const char*, const std::vector<Parameter>& parameters) {
    Number(parameters.size());
    for (const Parameter& parameter : parameters) {
      Number((std::uint64_t{parameter.depth} << 1) | (parameter.is_object ? 1 : 0));
      (*this)("", parameter.attribute);
      if (!parameter.is_object) (*this)("", parameter.value);
    }
  }
  void operator()(const char*, bool flag) { Byte(flag ? 1 : 0); }
  void operator()(const char*, int number) { Number(static_cast<std::uint64_t>(number < 0 ? 0 : number)); }
  void operator()(const char*, std::uint32_t number) { Number(number); }
  void operator()(const char*, std::uint64_t number) { Number(number); }
  void operator()(const char*, double number) { Fixed(std::bit_cast<std::uint64_t>(number), 8); }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void operator()(const char*, Enum value) { Byte(static_cast<std::uint8_t>(value)); }

  void Byte(std::uint8_t value) { *at_++ = static_cast<char>(value); }
  void Number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) Byte(static_cast<std::uint8_t>(value | 0x80));
    Byte(static_cast<std::uint8_t>(value));
  }

 private:
  void Fixed(std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) Byte(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  char* at_;
};

}  // namespace soarbox::mind
