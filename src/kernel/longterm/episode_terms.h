// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "kernel/base/symbol_table.h"
#include "kernel/longterm/episode_store.h"

namespace soarbox::kernel {

/// The constants in episodes. They have their own numbers, because an agent's symbols are swept, but episodes stay.
/// Numbered from 0 without gaps; never removed.
class EpisodeTerms {
 public:
  EpisodeTerms() = default;
  EpisodeTerms(const EpisodeTerms&) = delete;
  EpisodeTerms& operator=(const EpisodeTerms&) = delete;

  /// The term of a constant symbol; created if it is new.
  EpisodeTerm Intern(const SymbolTable& symbols, Symbol constant);
  EpisodeTerm Intern(std::string_view text);
  EpisodeTerm Intern(std::int64_t value);
  EpisodeTerm Intern(double value);
  /// Returns kUnknownEpisodeTerm if no episode contains the constant.
  EpisodeTerm Find(const SymbolTable& symbols, Symbol constant) const;
  EpisodeTerm Find(std::string_view text) const;

  std::size_t size() const { return terms_.size(); }
  SymbolKind kind(EpisodeTerm term) const { return terms_[term].kind; }
  /// Returns the contents; the term must be of the right kind.
  std::string_view Text(EpisodeTerm term) const { return *terms_[term].text; }
  std::int64_t Integer(EpisodeTerm term) const { return terms_[term].integer; }
  double Float(EpisodeTerm term) const { return terms_[term].real; }
  Symbol ToSymbol(SymbolTable& symbols, EpisodeTerm term) const;
  /// The text in which Soar prints constants of episodes: strings unchanged, floats with sixteen decimals.
  std::string Show(EpisodeTerm term) const;

  /// The agent's symbols were swept: their handles may now belong to other constants.
  void ForgetSymbols() { known_.fill({}); }
  void Clear();
  std::size_t MemoryBytes() const;

 private:
  struct Term {
    SymbolKind kind = SymbolKind::kNone;
    union {
      std::int64_t integer;
      double real;
      const std::string* text;
    };
  };
  struct Known {
    std::uint32_t symbol = 0;
    EpisodeTerm term = 0;
  };

  std::vector<Term> terms_;
  std::deque<std::string> texts_;
  std::unordered_map<std::string_view, EpisodeTerm> by_text_;
  std::unordered_map<std::int64_t, EpisodeTerm> by_integer_;
  std::unordered_map<std::uint64_t, EpisodeTerm> by_float_;  ///< By the bits of the number.
  std::array<Known, 1024> known_{};                          ///< A cache by the low bits of the symbol.
};

}  // namespace soarbox::kernel
