// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>

#include "kernel/base/symbol.h"
#include "kernel/longterm/store_term.h"

namespace soarbox::kernel {

/// A cache of recently used attributes: their symbols and their terms. Most agents use few attributes. Valid until a
/// sweep frees symbols or other knowledge is loaded.
class AttributeSymbols {
 public:
  /// Returns none if the attribute is not in the cache.
  Symbol SymbolOf(StoreTerm term) const {
    const Entry& entry = by_term_[term.bits() % kPlaces];
    return entry.term == term ? entry.symbol : Symbol();
  }
  StoreTerm TermOf(Symbol symbol) const {
    const Entry& entry = by_symbol_[symbol.bits() % kPlaces];
    return entry.symbol == symbol ? entry.term : StoreTerm();
  }
  void Note(StoreTerm term, Symbol symbol) {
    by_term_[term.bits() % kPlaces] = by_symbol_[symbol.bits() % kPlaces] = {term, symbol};
  }
  void Forget() { *this = {}; }

 private:
  static constexpr std::size_t kPlaces = 32;
  struct Entry {
    StoreTerm term;
    Symbol symbol;
  };
  std::array<Entry, kPlaces> by_term_, by_symbol_;
};

}  // namespace soarbox::kernel
