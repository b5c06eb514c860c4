// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/store_term.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "kernel/base/symbol_table.h"

namespace soarbox::kernel {

Terms::Terms(const Terms* base)
    : base_(base),
      first_string_(static_cast<std::uint32_t>(base->strings_.size())),
      first_integer_(static_cast<std::uint32_t>(base->integers_.size())),
      first_float_(static_cast<std::uint32_t>(base->floats_.size())),
      next_order_(base->next_order_) {}

StoreTerm Terms::String(std::string_view text) {
  if (const StoreTerm known = FindString(text)) return known;
  const auto index = first_string_ + static_cast<std::uint32_t>(strings_.size());
  strings_.emplace_back(text);
  string_orders_.push_back(next_order_++);
  by_text_.emplace(strings_.back(), index);
  bytes_ += 88 + (text.size() > 15 ? text.size() + 1 : 0);
  return StoreTerm(TermKind::kString, index);
}

StoreTerm Terms::Integer(std::int64_t value) {
  if (base_ != nullptr) {
    if (const StoreTerm known = base_->FindInteger(value)) return known;
  }
  const auto next = first_integer_ + static_cast<std::uint32_t>(integers_.size());
  const auto [place, added] = by_integer_.try_emplace(value, next);
  if (added) integers_.push_back({value, next_order_++});
  return StoreTerm(TermKind::kInteger, place->second);
}

StoreTerm Terms::Float(double value) {
  if (base_ != nullptr) {
    if (const StoreTerm known = base_->FindFloat(value)) return known;
  }
  const auto next = first_float_ + static_cast<std::uint32_t>(floats_.size());
  const auto [place, added] = by_bits_.try_emplace(std::bit_cast<std::uint64_t>(value), next);
  if (added) floats_.push_back({value, next_order_++});
  return StoreTerm(TermKind::kFloat, place->second);
}

StoreTerm AddTerm(Terms& terms, const SymbolTable& symbols, Symbol constant) {
  if (constant.IsString()) return terms.String(symbols.Text(constant));
  if (constant.IsInteger()) return terms.Integer(symbols.IntegerValue(constant));
  return terms.Float(symbols.FloatValue(constant));
}

StoreTerm FindTerm(const Terms& terms, const SymbolTable& symbols, Symbol constant) {
  if (constant.IsString()) return terms.FindString(symbols.Text(constant));
  if (constant.IsInteger()) return terms.FindInteger(symbols.IntegerValue(constant));
  return terms.FindFloat(symbols.FloatValue(constant));
}

Symbol SymbolOf(const Terms& terms, SymbolTable& symbols, StoreTerm constant) {
  switch (constant.kind()) {
    case TermKind::kString:
      return symbols.String(terms.Text(constant));
    case TermKind::kInteger:
      return symbols.Integer(terms.IntegerValue(constant));
    case TermKind::kFloat:
      return symbols.Float(terms.FloatValue(constant));
    case TermKind::kObject:
      break;
  }
  return {};
}

StoreTerm Terms::FindString(std::string_view text) const {
  if (const auto found = by_text_.find(text); found != by_text_.end()) {
    return StoreTerm(TermKind::kString, found->second);
  }
  return base_ == nullptr ? StoreTerm() : base_->FindString(text);
}

StoreTerm Terms::FindInteger(std::int64_t value) const {
  if (const auto found = by_integer_.find(value); found != by_integer_.end()) {
    return StoreTerm(TermKind::kInteger, found->second);
  }
  return base_ == nullptr ? StoreTerm() : base_->FindInteger(value);
}

StoreTerm Terms::FindFloat(double value) const {
  if (const auto found = by_bits_.find(std::bit_cast<std::uint64_t>(value)); found != by_bits_.end()) {
    return StoreTerm(TermKind::kFloat, found->second);
  }
  return base_ == nullptr ? StoreTerm() : base_->FindFloat(value);
}

void Terms::Append(std::string& out, StoreTerm constant, bool short_floats) const {
  switch (constant.kind()) {
    case TermKind::kString: {
      const std::string_view text = Text(constant);
      if (ReadsAsPlainString(text)) {
        out += text;
        return;
      }
      out += '|';
      for (const char c : text) {
        if (c == '|' || c == '\\') out += '\\';
        out += c;
      }
      out += '|';
      return;
    }
    case TermKind::kInteger:
      out += std::to_string(IntegerValue(constant));
      return;
    case TermKind::kFloat: {
      char digits[400];
      std::snprintf(digits, sizeof(digits), short_floats ? "%.16g" : "%.16f", FloatValue(constant));
      out += digits;
      return;
    }
    case TermKind::kObject:
      return;
  }
}

}  // namespace soarbox::kernel
