// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

struct FrozenSymbols;

/// The symbols of one agent: interned constants and variables, and the names of its identifiers.
///
/// Constants have two layers: a frozen base, shared by agents that run the same rules, and the agent's own. Interning
/// looks in the base first, so one text never has two handles. Single-threaded but for the frozen base, which never
/// changes.
///
/// Lifetime: a symbol that a rule mentions is pinned and stays. Other constants are swept by the agent between
/// phases (BeginMark, Mark..., Sweep), never in the middle of one; there are no reference counts. Identifiers are
/// freed one by one by working memory.
///
/// Every constant has a creation stamp, which grows with first use; the condition reorderer breaks ties by it. The
/// words of known_symbols.h exist from the start.
class SymbolTable {
 public:
  SymbolTable();
  ~SymbolTable();
  SymbolTable(SymbolTable&&) noexcept;
  SymbolTable& operator=(SymbolTable&&) noexcept;

  /// Interns; equal contents give the same handle. A symbol interned while `pinning()` is on is pinned.
  Symbol String(std::string_view text);
  Symbol Integer(std::int64_t value) {
    return Symbol::FitsInHandle(value) && !pinning_ ? Symbol::SmallInteger(value) : InternInteger(value);
  }
  Symbol Float(double value);
  /// `name` with its brackets: "<s>". Variables are always pinned.
  Symbol Variable(std::string_view name);
  /// The handle of a string that exists already, else the none symbol. Never interns.
  Symbol FindString(std::string_view text) const;

  /// False for what has been freed, or never was: a handle that must not be used. For checks.
  bool IsLive(Symbol symbol) const;

  /// Contents. The kind must fit. A text is valid until its symbol is swept or this table freezes or adopts a base.
  std::string_view Text(Symbol string_or_variable) const;
  std::int64_t IntegerValue(Symbol symbol) const {
    return symbol.IsSmallInteger() ? symbol.SmallValue() : LargeIntegerValue(symbol);
  }
  double FloatValue(Symbol symbol) const;
  /// The value of an integer or a float as a double.
  double NumberValue(Symbol symbol) const {
    return symbol.IsFloat() ? FloatValue(symbol) : static_cast<double>(IntegerValue(symbol));
  }
  /// When the constant was created; 0 for variables, identifiers and integers that no rule mentions.
  std::uint32_t Stamp(Symbol constant) const;

  /// A new identifier with the next number of its letter (A to Z).
  Symbol NewIdentifier(char letter) {
    return PlaceIdentifier(letter, next_number_[static_cast<std::size_t>(letter - 'A')]++);
  }
  /// An identifier with a given number; the letter's counter is raised above it.
  Symbol NewIdentifier(char letter, std::uint64_t number);
  void FreeIdentifier(Symbol identifier) {
    identifiers_[identifier.index()] = {};
    free_identifiers_.push_back(identifier.index());
  }
  char Letter(Symbol identifier) const { return identifiers_[identifier.index()].letter; }
  std::uint64_t Number(Symbol identifier) const { return identifiers_[identifier.index()].number; }
  /// The live identifier with this name, else the none symbol. Not for hot paths.
  Symbol FindIdentifier(char letter, std::uint64_t number) const;
  /// One more than the largest identifier index ever handed out: the size for arrays that run beside this table.
  std::uint32_t IdentifierLimit() const { return static_cast<std::uint32_t>(identifiers_.size()); }
  /// Restarts all letters at 1 (init-soar). All identifiers must have been freed.
  void ResetIdentifierCounters();

  /// Soar's ordering for < > <= >=: numbers by value, strings by bytes, identifiers by letter and number; any other
  /// mix, and anything compared with a float that is not a number, is "less".
  std::strong_ordering Compare(Symbol left, Symbol right) const;

  /// Everything interned between PinScope's construction and destruction is pinned. Scopes nest.
  class PinScope {
   public:
    explicit PinScope(SymbolTable& table);
    ~PinScope();
    PinScope(const PinScope&) = delete;
    PinScope& operator=(const PinScope&) = delete;

   private:
    SymbolTable& table_;
    bool before_;
  };

  /// Sweeping: mark what is in use, then free the unpinned rest.
  void BeginMark();
  void Mark(Symbol symbol) {
    if (symbol.index() >= sweepable_from_[static_cast<std::size_t>(symbol.tag())]) MarkOwn(symbol);
  }
  void Sweep();
  /// How many unpinned constants live; the agent sweeps when this has doubled.
  std::size_t UnpinnedCount() const;

  /// A digest of what has been pinned so far and under which handles. Tables with equal digests pinned the same.
  std::uint64_t Digest() const;
  /// Moves own pinned constants into a frozen base that other tables may adopt: of each kind all that precede the
  /// first constant that is not pinned. Handles stay valid; views that Text() gave do not. A table that has only
  /// read rules so far freezes all of them.
  std::shared_ptr<const FrozenSymbols> Freeze();
  /// Takes over a frozen base in place of its own constants, if they are the same under the same handles (or if this
  /// table has none of its own yet). Handles stay valid; views that Text() gave do not. False if the two differ;
  /// nothing has changed then.
  bool Adopt(std::shared_ptr<const FrozenSymbols> base);

  /// How many bytes the texts of its own may take together; a long text beyond that throws std::bad_alloc.
  void LimitTexts(std::size_t bytes);
  /// Bytes used by this table alone (not the shared base).
  std::size_t MemoryBytes() const;

 private:
  struct Contents;
  struct IdentifierEntry {
    std::uint64_t number = 0;
    char letter = 0;  ///< 0: free.
  };

  Symbol PlaceIdentifier(char letter, std::uint64_t number) {
    if (free_identifiers_.empty()) {
      identifiers_.push_back({number, letter});
      return Symbol(Symbol::Tag::kIdentifier, static_cast<std::uint32_t>(identifiers_.size() - 1));
    }
    const std::uint32_t index = free_identifiers_.back();
    free_identifiers_.pop_back();
    identifiers_[index] = {number, letter};
    return Symbol(Symbol::Tag::kIdentifier, index);
  }
  Symbol InternInteger(std::int64_t value);
  std::int64_t LargeIntegerValue(Symbol symbol) const;
  void MarkOwn(Symbol symbol);

  std::unique_ptr<Contents> contents_;
  bool pinning_ = false;
  std::vector<IdentifierEntry> identifiers_;
  std::vector<std::uint32_t> free_identifiers_;
  std::array<std::uint64_t, 26> next_number_;  ///< By letter.
  /// By tag, since BeginMark: the first index that a sweep may free. Those before it are in the base.
  std::array<std::uint32_t, 8> sweepable_from_{};
};

/// True if Soar's lexer reads `text`, written without bars, as this very string.
bool ReadsAsPlainString(std::string_view text);

/// The letter of an identifier that is named after a variable or an attribute: its capital, but I for names that begin
/// with no letter of ASCII, and for S, which is for states.
inline char LetterOfIdentifier(std::string_view name) {
  if (!name.empty() && name.front() == '<') name.remove_prefix(1);
  if (name.empty()) return 'I';
  const char letter = static_cast<char>(name.front() & ~0x20);
  return letter < 'A' || letter > 'Z' || letter == 'S' ? 'I' : letter;
}

/// How symbols look in print. `rereadable` puts bars where the lexer would read something else (as in `print`,
/// rules and traces); without it the raw text is given (as in `write` and `concat`). Floats have six decimals.
std::string ToString(const SymbolTable& symbols, Symbol symbol, bool rereadable = true);
void AppendTo(std::string& out, const SymbolTable& symbols, Symbol symbol, bool rereadable = true);

}  // namespace soarbox::kernel
