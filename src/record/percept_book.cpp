// SPDX-License-Identifier: BSD-2-Clause
#include "record/percept_book.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "mind/field_writer.h"

namespace soarbox::record {
namespace {

constexpr std::uint64_t kMix = 0x9e3779b97f4a7c15ull;
constexpr std::size_t kLeastTable = 64;

}  // namespace

void TextBook::Clear() {
  texts_.clear();
  ends_.clear();
  std::fill(table_.begin(), table_.end(), Entry{});
}

std::string_view TextBook::At(std::uint32_t number) const {
  const std::size_t begin = number == 0 ? 0 : ends_[number - 1];
  return std::string_view(texts_).substr(begin, ends_[number] - begin);
}

std::uint32_t TextBook::Add(std::string_view text) {
  texts_ += text;
  ends_.push_back(texts_.size());
  return static_cast<std::uint32_t>(ends_.size() - 1);
}

std::uint32_t TextBook::Hash(std::string_view text) {
  std::uint64_t hash = text.size();
  const auto mix = [&](std::size_t at, std::size_t size) {
    std::uint64_t word = 0;
    std::memcpy(&word, text.data() + at, size);
    hash = (hash ^ word) * kMix;
    hash ^= hash >> 29;
  };
  if (text.size() < 8) {
    if (!text.empty()) mix(0, text.size());
  } else {
    for (std::size_t at = 0; at + 8 < text.size(); at += 8) mix(at, 8);
    mix(text.size() - 8, 8);
  }
  return static_cast<std::uint32_t>(hash ^ hash >> 32);
}

std::optional<std::uint32_t> TextBook::Find(std::string_view text, std::uint32_t hash) const {
  if (table_.empty()) return std::nullopt;
  const std::size_t mask = table_.size() - 1;
  for (std::size_t at = hash & mask; table_[at].number != 0; at = (at + 1) & mask)
    if (table_[at].hash == hash && At(table_[at].number - 1) == text) return table_[at].number - 1;
  return std::nullopt;
}

void TextBook::Enter(Entry entry) {
  const std::size_t mask = table_.size() - 1;
  std::size_t at = entry.hash & mask;
  while (table_[at].number != 0) at = (at + 1) & mask;
  table_[at] = entry;
}

std::uint32_t TextBook::AddFindable(std::string_view text, std::uint32_t hash) {
  const std::uint32_t number = Add(text);
  if (2 * size() > table_.size()) {
    std::vector<Entry> earlier(std::max(kLeastTable, 2 * table_.size()));
    earlier.swap(table_);
    for (const Entry& entry : earlier)
      if (entry.number != 0) Enter(entry);
  }
  Enter({number + 1, hash});
  return number;
}

void PairTable::Clear() {
  std::fill(entries_.begin(), entries_.end(), Entry{});
  used_ = 0;
}

/// Where the key is, or would be.
std::size_t PairTable::PlaceOf(std::uint64_t key) const {
  const std::size_t mask = entries_.size() - 1;
  std::size_t at = (key * kMix >> 32) & mask;
  while (entries_[at].is_used && entries_[at].key != key) at = (at + 1) & mask;
  return at;
}

std::optional<std::uint32_t> PairTable::Find(std::uint32_t first, std::uint32_t second) const {
  if (entries_.empty()) return std::nullopt;
  const Entry& entry = entries_[PlaceOf(KeyOf(first, second))];
  return entry.is_used ? std::optional(entry.value) : std::nullopt;
}

void PairTable::Add(std::uint32_t first, std::uint32_t second, std::uint32_t value) {
  if (2 * (used_ + 1) > entries_.size()) {
    std::vector<Entry> earlier(std::max(kLeastTable, 2 * entries_.size()));
    earlier.swap(entries_);
    for (const Entry& entry : earlier)
      if (entry.is_used) entries_[PlaceOf(entry.key)] = entry;
  }
  const std::uint64_t key = KeyOf(first, second);
  entries_[PlaceOf(key)] = {key, value, true};
  ++used_;
}

namespace {

// A value is a number. 0: its bytes follow. 1: a byte scale and the number (zigzag). Otherwise 2 plus the difference
// from the last number, in the last scale.
constexpr std::uint64_t kBytes = 0, kScaled = 1, kDifference = 2;
constexpr std::uint8_t kInteger = 1, kFirstDecimal = 2, kFloatBits = 6, kDoubleBits = 7, kScales = 8;
constexpr double kDivisors[] = {1, 10, 100, 1000};
static_assert(kFirstDecimal + std::size(kDivisors) == kFloatBits);
/// Integers up to this size are exact as doubles.
constexpr std::int64_t kMostNumber = std::int64_t{1} << 52;

/// Number of bytes of a number in groups of seven bits.
std::size_t Groups(std::uint64_t number) {
  std::size_t groups = 1;
  for (; number >= 0x80; number >>= 7) ++groups;
  return groups;
}

std::uint64_t FixedAt(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  return value;
}

bool IsDecimal(double value, std::uint8_t scale, std::int64_t& number) {
  const double divisor = kDivisors[scale - kFirstDecimal], times = value * divisor;
  if (!(std::abs(times) < static_cast<double>(kMostNumber))) return false;
  number = static_cast<std::int64_t>(times < 0 ? times - 0.5 : times + 0.5);
  return std::bit_cast<std::uint64_t>(static_cast<double>(number) / divisor) == std::bit_cast<std::uint64_t>(value);
}

/// The number of a float as an integer, preferably in the scale of the last one. Logs store it as a float if that is
/// exact, else as a double; others are stored by their bits.
LastValue NumberFromBits(double value, bool is_float, std::uint64_t bits, const LastValue& last) {
  const LastValue by_bits{is_float ? kFloatBits : kDoubleBits, static_cast<std::int64_t>(bits)};
  if (last.scale == by_bits.scale) return by_bits;  // The next values are seldom decimal numbers.
  if (!is_float && static_cast<double>(static_cast<float>(value)) == value) return by_bits;
  std::int64_t number = 0;
  const bool was_decimal = last.scale >= kFirstDecimal && last.scale < kFloatBits;
  if (was_decimal && IsDecimal(value, last.scale, number)) return {last.scale, number};
  for (std::uint8_t scale = kFirstDecimal; scale < kFloatBits; ++scale)
    if (scale != last.scale && IsDecimal(value, scale, number)) return {scale, number};
  return by_bits;
}

/// The difference of two numbers, modulo 2^64.
std::uint64_t DifferenceOfPercepts(const LastValue& a, const LastValue& b) {
  return Zigzag(static_cast<std::int64_t>(static_cast<std::uint64_t>(a.number) - static_cast<std::uint64_t>(b.number)));
}

Stored WriteText(ShortWriter& out, std::string_view content, LastValue& last) {
  ByteReader in(content);
  const std::string_view text = in.Text();
  if (in.failed() || !in.AtEnd() || Groups(text.size()) + text.size() != content.size()) return Stored::kNot;
  out.Number(kBytes);
  last = {};
  return Stored::kNotItsBytes;
}

}  // namespace

Stored WriteValue(ShortWriter& out, std::string_view bytes, LastValue& last) {
  if (bytes.empty()) return Stored::kNot;
  const std::string_view content = bytes.substr(1);
  LastValue value;
  switch (bytes.front()) {
    case 0:
      return WriteText(out, content, last);
    case 1: {
      ByteReader in(content);
      const std::uint64_t number = in.Number();
      if (in.failed() || !in.AtEnd() || Groups(number) != content.size()) return Stored::kNot;
      value = {kInteger, Unzigzag(number)};
      break;
    }
    case 2: {
      if (content.size() != 4) return Stored::kNot;
      const std::uint64_t bits = FixedAt(content);
      value =
          NumberFromBits(static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits))), true, bits, last);
      break;
    }
    case 3: {
      if (content.size() != 8) return Stored::kNot;
      const std::uint64_t bits = FixedAt(content);
      value = NumberFromBits(std::bit_cast<double>(bits), false, bits, last);
      break;
    }
    default:
      return Stored::kNot;
  }
  const std::uint64_t difference = DifferenceOfPercepts(value, last);
  if (value.scale == last.scale && difference < ~std::uint64_t{0} - kDifference) {
    out.Number(kDifference + difference);
  } else {
    out.Number(kScaled);
    out.Byte(value.scale);
    out.Number(Zigzag(value.number));
  }
  last = value;
  return Stored::kCompletely;
}

void ReadValue(ByteReader& in, LastValue& last, std::string& value) {
  ByteWriter out(value);
  const std::uint64_t head = in.Number();
  if (head == kBytes) {
    last = {};
    if (in.Byte() != 0) return in.Fail();
    out.Byte(0);
    return out.Text(in.Text());
  }
  if (head == kScaled) {
    last.scale = in.Byte();
    last.number = Unzigzag(in.Number());
  } else {
    const auto difference = static_cast<std::uint64_t>(Unzigzag(head - kDifference));
    last.number = static_cast<std::int64_t>(static_cast<std::uint64_t>(last.number) + difference);
  }
  if (in.failed() || last.scale == 0 || last.scale >= kScales) {
    last = {};
    return in.Fail();
  }
  if (last.scale >= kFloatBits) {
    const bool is_float = last.scale == kFloatBits;
    out.Byte(is_float ? 2 : 3);
    is_float ? out.Fixed32(static_cast<std::uint32_t>(last.number))
             : out.Fixed64(static_cast<std::uint64_t>(last.number));
    return;
  }
  char printed[1 + mind::FieldWriter::kMostOfNumber];
  mind::FieldWriter fields(printed);
  fields("", last.scale == kInteger
                 ? mind::Value(last.number)
                 : mind::Value(static_cast<double>(last.number) / kDivisors[last.scale - kFirstDecimal]));
  out.Append({printed, static_cast<std::size_t>(fields.at() - printed)});
}

}  // namespace soarbox::record
