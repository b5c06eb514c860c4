// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/longterm/episode_store.h"
#include "kernel/longterm/store_term.h"

namespace soarbox::kernel {

/// The constants in episodes, numbered from 0 without gaps in order of first use; never removed.
class EpisodeTerms {
 public:
  EpisodeTerms() = default;
  EpisodeTerms(const EpisodeTerms&) = delete;
  EpisodeTerms& operator=(const EpisodeTerms&) = delete;

  /// The term of a constant; created if it is new.
  EpisodeTerm Intern(const SymbolTable& symbols, Symbol constant);
  EpisodeTerm Intern(std::string_view text) { return NumberOf(terms_.String(text)); }
  EpisodeTerm Intern(std::int64_t value) { return NumberOf(terms_.Integer(value)); }
  EpisodeTerm Intern(double value) { return NumberOf(terms_.Float(value)); }
  /// Returns kUnknownEpisodeTerm if no episode contains the constant.
  EpisodeTerm Find(const SymbolTable& symbols, Symbol constant) const {
    return NumberOfKnown(FindTerm(terms_, symbols, constant));
  }
  EpisodeTerm Find(std::string_view text) const { return NumberOfKnown(terms_.FindString(text)); }

  std::size_t size() const { return by_number_.size(); }
  TermKind kind(EpisodeTerm term) const { return by_number_[term].kind(); }
  /// Returns the contents; the term must be of the right kind.
  std::string_view Text(EpisodeTerm term) const { return terms_.Text(by_number_[term]); }
  std::int64_t Integer(EpisodeTerm term) const { return terms_.IntegerValue(by_number_[term]); }
  double Float(EpisodeTerm term) const { return terms_.FloatValue(by_number_[term]); }
  Symbol ToSymbol(SymbolTable& symbols, EpisodeTerm term) const { return SymbolOf(terms_, symbols, by_number_[term]); }
  /// The text in which Soar prints constants of episodes: strings unchanged, floats with sixteen decimals.
  std::string Show(EpisodeTerm term) const;

  /// The agent's symbols were swept: their handles may now belong to other constants.
  void ForgetSymbols() { known_.fill({}); }
  void Clear();
  std::size_t MemoryBytes() const { return terms_.MemoryBytes() + by_number_.capacity() * sizeof(StoreTerm); }

 private:
  struct Known {
    std::uint32_t symbol = 0;
    EpisodeTerm term = 0;
  };
  EpisodeTerm NumberOf(StoreTerm term);
  EpisodeTerm NumberOfKnown(StoreTerm term) const { return term ? terms_.Order(term) : kUnknownEpisodeTerm; }

  Terms terms_;
  std::vector<StoreTerm> by_number_;  ///< A term's number is its order in terms_.
  std::array<Known, 1024> known_{};   ///< A cache by the low bits of the symbol.
};

}  // namespace soarbox::kernel
