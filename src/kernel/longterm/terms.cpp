// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/terms.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "kernel/base/symbol_table.h"

namespace soarbox::kernel {

StoreTerm Terms::String(std::string_view text) {
  if (const StoreTerm known = FindString(text)) return known;
  const auto index = static_cast<std::uint32_t>(strings_.size());
  strings_.emplace_back(text);
  by_text_.emplace(strings_.back(), index);
  bytes_ += 80 + (text.size() > 15 ? text.size() + 1 : 0);
  return StoreTerm(TermKind::kString, index);
}

StoreTerm Terms::Integer(std::int64_t value) {
  const auto [place, added] = by_integer_.try_emplace(value, static_cast<std::uint32_t>(integers_.size()));
  if (added) integers_.push_back(value);
  return StoreTerm(TermKind::kInteger, place->second);
}

StoreTerm Terms::Float(double value) {
  const auto [place, added] =
      by_bits_.try_emplace(std::bit_cast<std::uint64_t>(value), static_cast<std::uint32_t>(floats_.size()));
  if (added) floats_.push_back(value);
  return StoreTerm(TermKind::kFloat, place->second);
}

StoreTerm Terms::FindString(std::string_view text) const {
  const auto found = by_text_.find(text);
  return found == by_text_.end() ? StoreTerm() : StoreTerm(TermKind::kString, found->second);
}

StoreTerm Terms::FindInteger(std::int64_t value) const {
  const auto found = by_integer_.find(value);
  return found == by_integer_.end() ? StoreTerm() : StoreTerm(TermKind::kInteger, found->second);
}

StoreTerm Terms::FindFloat(double value) const {
  const auto found = by_bits_.find(std::bit_cast<std::uint64_t>(value));
  return found == by_bits_.end() ? StoreTerm() : StoreTerm(TermKind::kFloat, found->second);
}

Terms Terms::Copy() const {
  Terms copy;
  for (const std::string& text : strings_) copy.String(text);
  copy.integers_ = integers_;
  copy.floats_ = floats_;
  copy.by_integer_ = by_integer_;
  copy.by_bits_ = by_bits_;
  return copy;
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
