// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bytes/byte_stream.h"

namespace soarbox::record {

/// A list of texts, each of which is stored once and has a number, from 0 in the order in which they were added.
class TextBook {
 public:
  void Clear();
  std::size_t size() const { return ends_.size(); }
  /// Valid until the next Add.
  std::string_view At(std::uint32_t number) const;
  /// Adds a text, which need not be new.
  std::uint32_t Add(std::string_view text);
  static std::uint32_t Hash(std::string_view text);
  /// Finds a text by its bytes and their hash. Call it only if all texts were added with AddFindable.
  std::optional<std::uint32_t> Find(std::string_view text, std::uint32_t hash) const;
  std::uint32_t AddFindable(std::string_view text, std::uint32_t hash);

 private:
  std::string texts_;
  std::vector<std::size_t> ends_;
  struct Entry {
    std::uint32_t number = 0;  ///< Plus 1; 0: there is none.
    std::uint32_t hash = 0;
  };
  void Enter(Entry entry);

  std::vector<Entry> table_;  ///< Open addressing. Its size is a power of 2.
};

/// Numbers that are found by pairs of numbers.
class PairTable {
 public:
  void Clear();
  std::optional<std::uint32_t> Find(std::uint32_t first, std::uint32_t second) const;
  /// The pair must be new.
  void Add(std::uint32_t first, std::uint32_t second, std::uint32_t value);

 private:
  struct Entry {
    std::uint64_t key = 0;
    std::uint32_t value = 0;
    bool is_used = false;
  };
  static std::uint64_t KeyOf(std::uint32_t first, std::uint32_t second) { return std::uint64_t{first} << 32 | second; }
  std::size_t PlaceOf(std::uint64_t key) const;

  std::vector<Entry> entries_;  ///< Open addressing; its size is a power of 2.
  std::size_t used_ = 0;
};

/// The last value of a percept, from which the next one is stored as a difference.
struct LastValue {
  /// 0: not a number; 1: an integer; 2 to 5: a float that is an integer divided by 1, 10, 100 or 1000; 6 and 7: the
  /// bits of a float and of a double.
  std::uint8_t scale = 0;
  std::int64_t number = 0;
};

/// How WriteValue has stored a value.
enum class Stored : std::uint8_t {
  kNot,  ///< The bytes are not a value in the form in which logs store it.
  kCompletely,
  kNotItsBytes  ///< The caller must append the bytes of the value.
};
/// Writes the bytes of a value (as in mind/event_log.h) as the difference from the last one. `out` needs
/// kMostOfValue bytes.
Stored WriteValue(ShortWriter& out, std::string_view value, LastValue& last);
inline constexpr std::size_t kMostOfValue = 12;
/// Appends the bytes of a value.
void ReadValue(ByteReader& in, LastValue& last, std::string& value);

/// Small numbers for small differences of either sign.
inline std::uint64_t Zigzag(std::int64_t number) {
  return (static_cast<std::uint64_t>(number) << 1) ^ (number < 0 ? ~std::uint64_t{0} : 0);
}
inline std::int64_t Unzigzag(std::uint64_t number) {
  return static_cast<std::int64_t>((number >> 1) ^ ((number & 1) != 0 ? ~std::uint64_t{0} : 0));
}

}  // namespace soarbox::record
