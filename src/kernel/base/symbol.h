// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::kernel {

/// The kind of a symbol. Integers that fit into 29 bits are stored in the handle itself; users do not notice this.
enum class SymbolKind : std::uint8_t { kNone, kVariable, kIdentifier, kString, kInteger, kFloat };

/// A handle of an interned symbol of one agent: four bytes, compared by value. Two symbols of one agent are equal
/// exactly if their handles are equal (so 5 and 5.0 differ, as in Soar).
/// Layout: the tag is in the top three bits; the other 29 are an index or a small integer.
class Symbol {
 public:
  enum class Tag : std::uint32_t { kNone, kVariable, kIdentifier, kString, kSmallInteger, kLargeInteger, kFloat };
  static constexpr int kIndexBits = 29;
  static constexpr std::uint32_t kIndexMask = (1u << kIndexBits) - 1;

  constexpr Symbol() = default;
  constexpr Symbol(Tag tag, std::uint32_t index)
      : bits_((static_cast<std::uint32_t>(tag) << kIndexBits) | (index & kIndexMask)) {}
  static constexpr Symbol FromBits(std::uint32_t bits) {
    Symbol symbol;
    symbol.bits_ = bits;
    return symbol;
  }

  constexpr Tag tag() const { return static_cast<Tag>(bits_ >> kIndexBits); }
  constexpr std::uint32_t index() const { return bits_ & kIndexMask; }
  constexpr std::uint32_t bits() const { return bits_; }
  constexpr bool IsNone() const { return bits_ == 0; }
  explicit constexpr operator bool() const { return bits_ != 0; }
  constexpr bool IsVariable() const { return tag() == Tag::kVariable; }
  constexpr bool IsIdentifier() const { return tag() == Tag::kIdentifier; }
  constexpr bool IsString() const { return tag() == Tag::kString; }
  constexpr bool IsInteger() const { return tag() == Tag::kSmallInteger || tag() == Tag::kLargeInteger; }
  /// An integer whose value is in the handle. Reading it needs no table.
  constexpr bool IsSmallInteger() const { return tag() == Tag::kSmallInteger; }
  constexpr std::int64_t SmallValue() const {
    constexpr std::uint32_t kSign = 1u << (kIndexBits - 1);
    return static_cast<std::int64_t>(index() ^ kSign) - static_cast<std::int64_t>(kSign);
  }
  static constexpr bool FitsInHandle(std::int64_t value) {
    constexpr std::int64_t kLimit = std::int64_t{1} << (kIndexBits - 1);
    return value >= -kLimit && value < kLimit;
  }
  static constexpr Symbol SmallInteger(std::int64_t value) {
    return Symbol(Tag::kSmallInteger, static_cast<std::uint32_t>(value));
  }
  constexpr bool IsFloat() const { return tag() == Tag::kFloat; }
  constexpr bool IsNumber() const { return IsInteger() || IsFloat(); }
  constexpr bool IsConstant() const { return tag() >= Tag::kString; }
  constexpr SymbolKind kind() const {
    constexpr SymbolKind kKinds[] = {SymbolKind::kNone,   SymbolKind::kVariable, SymbolKind::kIdentifier,
                                     SymbolKind::kString, SymbolKind::kInteger,  SymbolKind::kInteger,
                                     SymbolKind::kFloat,  SymbolKind::kNone};
    return kKinds[bits_ >> kIndexBits];
  }

  friend constexpr bool operator==(Symbol a, Symbol b) = default;

 private:
  std::uint32_t bits_ = 0;
};

}  // namespace soarbox::kernel
