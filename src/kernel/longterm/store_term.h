// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

class SymbolTable;

/// The number of a long-term identifier: 12 for @12. 0 means none.
using Lti = std::uint64_t;

enum class TermKind : std::uint32_t { kString, kInteger, kFloat, kObject };

/// The counterpart of a symbol in long-term memory: four bytes, compared by value. The index of an object is its place
/// in the store. (An agent's symbols are swept and its identifiers reused; terms stay.)
class StoreTerm {
 public:
  constexpr StoreTerm() = default;
  constexpr StoreTerm(TermKind kind, std::uint32_t index)
      : bits_((static_cast<std::uint32_t>(kind) << 30) | (index + 1)) {}
  static constexpr StoreTerm Object(std::uint32_t place) { return StoreTerm(TermKind::kObject, place); }

  constexpr TermKind kind() const { return static_cast<TermKind>(bits_ >> 30); }
  constexpr std::uint32_t index() const { return (bits_ & 0x3FFFFFFFu) - 1; }
  constexpr std::uint32_t bits() const { return bits_; }
  explicit constexpr operator bool() const { return bits_ != 0; }
  constexpr bool IsObject() const { return bits_ != 0 && kind() == TermKind::kObject; }
  constexpr bool IsNumber() const { return bits_ != 0 && (kind() == TermKind::kInteger || kind() == TermKind::kFloat); }
  friend constexpr bool operator==(StoreTerm, StoreTerm) = default;

 private:
  std::uint32_t bits_ = 0;
};

/// The constants of a store: equal constants have equal terms (5, 5.0 and |5| are different). Never removed.
///
/// Terms may have a base, which is immutable: they contain its constants and those added since.
class Terms {
 public:
  Terms() = default;
  /// `base` must outlive this object, must not change, and must not have a base itself.
  explicit Terms(const Terms* base);
  Terms(const Terms&) = delete;
  Terms& operator=(const Terms&) = delete;
  Terms(Terms&&) = default;
  Terms& operator=(Terms&&) = default;

  StoreTerm String(std::string_view text);
  StoreTerm Integer(std::int64_t value);
  StoreTerm Float(double value);
  /// The term of an existing constant, or none. Never adds one.
  StoreTerm FindString(std::string_view text) const;
  StoreTerm FindInteger(std::int64_t value) const;
  StoreTerm FindFloat(double value) const;

  std::string_view Text(StoreTerm string) const {
    const std::uint32_t index = string.index();
    return index < first_string_ ? base_->strings_[index] : strings_[index - first_string_];
  }
  std::int64_t IntegerValue(StoreTerm integer) const { return IntegerAt(integer.index()).value; }
  double FloatValue(StoreTerm real) const { return FloatAt(real.index()).value; }
  double NumberValue(StoreTerm number) const {
    return number.kind() == TermKind::kFloat ? FloatValue(number) : static_cast<double>(IntegerValue(number));
  }
  /// The rank of a constant in order of first use, for constants of all kinds. Values are shown in this order.
  std::uint32_t Order(StoreTerm constant) const {
    const std::uint32_t index = constant.index();
    switch (constant.kind()) {
      case TermKind::kString:
        return index < first_string_ ? base_->string_orders_[index] : string_orders_[index - first_string_];
      case TermKind::kInteger:
        return IntegerAt(index).order;
      case TermKind::kFloat:
        return FloatAt(index).order;
      case TermKind::kObject:
        break;
    }
    return 0;
  }
  /// Appends a constant in the notation of `smem --add`: strings between bars if necessary, floats with 16 decimals or,
  /// if `short_floats`, 16 digits.
  void Append(std::string& out, StoreTerm constant, bool short_floats = false) const;

  bool empty() const { return next_order_ == 0; }
  /// Number of constants, including those of the base.
  std::uint32_t count() const { return next_order_; }
  /// Without the terms of the base.
  std::size_t MemoryBytes() const { return bytes_ + (integers_.size() + floats_.size()) * 64; }

 private:
  template <class Value>
  struct Constant {
    Value value;
    std::uint32_t order;
  };
  const Constant<std::int64_t>& IntegerAt(std::uint32_t index) const {
    return index < first_integer_ ? base_->integers_[index] : integers_[index - first_integer_];
  }
  const Constant<double>& FloatAt(std::uint32_t index) const {
    return index < first_float_ ? base_->floats_[index] : floats_[index - first_float_];
  }

  const Terms* base_ = nullptr;
  std::uint32_t first_string_ = 0, first_integer_ = 0, first_float_ = 0;  ///< The number of terms in `base_`.
  std::uint32_t next_order_ = 0;
  std::deque<std::string> strings_;
  std::vector<std::uint32_t> string_orders_;
  std::vector<Constant<std::int64_t>> integers_;
  std::vector<Constant<double>> floats_;
  std::unordered_map<std::string_view, std::uint32_t> by_text_;
  std::unordered_map<std::int64_t, std::uint32_t> by_integer_;
  std::unordered_map<std::uint64_t, std::uint32_t> by_bits_;
  std::size_t bytes_ = 0;
};

/// The term of a constant symbol; added if it is new.
StoreTerm AddTerm(Terms& terms, const SymbolTable& symbols, Symbol constant);
/// The term of a constant symbol, or none.
StoreTerm FindTerm(const Terms& terms, const SymbolTable& symbols, Symbol constant);
/// The symbol of a constant; none for an object.
Symbol SymbolOf(const Terms& terms, SymbolTable& symbols, StoreTerm constant);

}  // namespace soarbox::kernel
