// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episode_terms.h"

#include <bit>
#include <cstdio>

namespace soarbox::kernel {

EpisodeTerm EpisodeTerms::Intern(std::string_view text) {
  if (const auto found = by_text_.find(text); found != by_text_.end()) return found->second;
  const EpisodeTerm made = static_cast<EpisodeTerm>(terms_.size());
  texts_.emplace_back(text);
  Term& term = terms_.emplace_back();
  term.kind = SymbolKind::kString;
  term.text = &texts_.back();
  by_text_.emplace(texts_.back(), made);
  return made;
}

EpisodeTerm EpisodeTerms::Intern(std::int64_t value) {
  const auto [found, is_new] = by_integer_.try_emplace(value, static_cast<EpisodeTerm>(terms_.size()));
  if (is_new) {
    Term& term = terms_.emplace_back();
    term.kind = SymbolKind::kInteger;
    term.integer = value;
  }
  return found->second;
}

EpisodeTerm EpisodeTerms::Intern(double value) {
  const auto [found, is_new] =
      by_float_.try_emplace(std::bit_cast<std::uint64_t>(value), static_cast<EpisodeTerm>(terms_.size()));
  if (is_new) {
    Term& term = terms_.emplace_back();
    term.kind = SymbolKind::kFloat;
    term.real = value;
  }
  return found->second;
}

EpisodeTerm EpisodeTerms::Intern(const SymbolTable& symbols, Symbol constant) {
  Known& known = known_[constant.bits() % known_.size()];
  if (known.symbol == constant.bits()) return known.term;
  known.symbol = constant.bits();
  if (constant.IsString()) {
    known.term = Intern(symbols.Text(constant));
  } else if (constant.IsFloat()) {
    known.term = Intern(symbols.FloatValue(constant));
  } else {
    known.term = Intern(symbols.IntegerValue(constant));
  }
  return known.term;
}

EpisodeTerm EpisodeTerms::Find(std::string_view text) const {
  const auto found = by_text_.find(text);
  return found == by_text_.end() ? kUnknownEpisodeTerm : found->second;
}

EpisodeTerm EpisodeTerms::Find(const SymbolTable& symbols, Symbol constant) const {
  if (constant.IsString()) return Find(symbols.Text(constant));
  if (constant.IsFloat()) {
    const auto found = by_float_.find(std::bit_cast<std::uint64_t>(symbols.FloatValue(constant)));
    return found == by_float_.end() ? kUnknownEpisodeTerm : found->second;
  }
  const auto found = by_integer_.find(symbols.IntegerValue(constant));
  return found == by_integer_.end() ? kUnknownEpisodeTerm : found->second;
}

Symbol EpisodeTerms::ToSymbol(SymbolTable& symbols, EpisodeTerm term) const {
  switch (kind(term)) {
    case SymbolKind::kInteger:
      return symbols.Integer(Integer(term));
    case SymbolKind::kFloat:
      return symbols.Float(Float(term));
    default:
      return symbols.String(Text(term));
  }
}

std::string EpisodeTerms::Show(EpisodeTerm term) const {
  switch (kind(term)) {
    case SymbolKind::kInteger:
      return std::to_string(Integer(term));
    case SymbolKind::kFloat: {
      char text[400];
      const int length = std::snprintf(text, sizeof(text), "%.16f", Float(term));
      return std::string(text, static_cast<std::size_t>(length));
    }
    default:
      return std::string(Text(term));
  }
}

void EpisodeTerms::Clear() {
  terms_.clear();
  by_text_.clear();
  texts_.clear();
  by_integer_.clear();
  by_float_.clear();
  ForgetSymbols();
}

std::size_t EpisodeTerms::MemoryBytes() const {
  std::size_t bytes = terms_.capacity() * sizeof(Term);
  for (const std::string& text : texts_) bytes += sizeof(std::string) + text.capacity() + 48;
  return bytes + (by_integer_.size() + by_float_.size()) * 32;
}

}  // namespace soarbox::kernel
