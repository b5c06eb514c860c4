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
/// Constants are in two layers: a frozen base, which agents with the same rules share, and the agent's own. Interning
/// searches the base first, so a text never has two handles. Single-threaded, except that threads may share a frozen
/// base, which never changes.
///
/// Lifetime: a symbol that a rule mentions is pinned and is never freed. The agent frees other unused constants by a
/// sweep between phases (BeginMark, Mark..., Sweep). There are no reference counts. Working memory frees identifiers
/// one by one.
///
/// Every constant has a stamp that grows in the order of creation; the condition reorderer breaks ties by it. The words
/// of known_symbols.h exist from the start.
class SymbolTable {
 public:
  SymbolTable();
  ~SymbolTable();
  SymbolTable(SymbolTable&&) noexcept;
  SymbolTable& operator=(SymbolTable&&) noexcept;

  /// Interns a constant. Equal contents give the same handle. Symbols interned while a PinScope exists are pinned.
  Symbol String(std::string_view text);
  Symbol Integer(std::int64_t value) {
    return Symbol::FitsInHandle(value) && !pinning_ ? Symbol::SmallInteger(value) : InternInteger(value);
  }
  Symbol Float(double value);
  /// `name` includes the brackets: "<s>". Variables are always pinned.
  Symbol Variable(std::string_view name);
  /// The handle of an interned string, or the none symbol. Never interns.
  Symbol FindString(std::string_view text) const;

  /// False for handles that were freed or never existed, which must not be used. For checks.
  bool IsLive(Symbol symbol) const;

  /// Returns the contents; the symbol must be of the right kind. The text is valid until its symbol is swept, or until
  /// this table freezes or adopts a base.
  std::string_view Text(Symbol string_or_variable) const;
  std::int64_t IntegerValue(Symbol symbol) const {
    return symbol.IsSmallInteger() ? symbol.SmallValue() : LargeIntegerValue(symbol);
  }
  double FloatValue(Symbol symbol) const;
  /// The value of an integer or a float as a double.
  double NumberValue(Symbol symbol) const {
    return symbol.IsFloat() ? FloatValue(symbol) : static_cast<double>(IntegerValue(symbol));
  }
  /// The creation stamp of the constant. 0 for variables, identifiers, and small integers that are not predefined and
  /// that no rule mentions.
  std::uint32_t Stamp(Symbol constant) const;

  /// Creates an identifier with the next number of its letter (A to Z).
  Symbol NewIdentifier(char letter) {
    return PlaceIdentifier(letter, next_number_[static_cast<std::size_t>(letter - 'A')]++);
  }
  /// Creates an identifier with a given number. If necessary, raises the letter's counter above it.
  Symbol NewIdentifier(char letter, std::uint64_t number);
  void FreeIdentifier(Symbol identifier) {
    identifiers_[identifier.index()] = {};
    free_identifiers_.push_back(identifier.index());
  }
  char Letter(Symbol identifier) const { return identifiers_[identifier.index()].letter; }
  std::uint64_t Number(Symbol identifier) const { return identifiers_[identifier.index()].number; }
  /// The live identifier of this name, or the none symbol. Slow: not for hot paths.
  Symbol FindIdentifier(char letter, std::uint64_t number) const;
  /// One more than the largest identifier index ever used: the size of arrays that are indexed by identifier.
  std::uint32_t IdentifierLimit() const { return static_cast<std::uint32_t>(identifiers_.size()); }
  /// Restarts the numbers of all letters at 1 (init-soar). All identifiers must have been freed.
  void ResetIdentifierCounters();

  /// Soar's order for < > <= >=. Numbers are compared by value, strings by bytes, identifiers by letter and number.
  /// Symbols of different kinds, and anything compared with NaN, give "less".
  std::strong_ordering Compare(Symbol left, Symbol right) const;

  /// Symbols interned during the lifetime of a PinScope are pinned. Scopes nest.
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

  /// A sweep: call BeginMark, Mark each symbol in use, then Sweep, which frees all other unpinned constants.
  void BeginMark();
  void Mark(Symbol symbol) {
    if (symbol.index() >= sweepable_from_[static_cast<std::size_t>(symbol.tag())]) MarkOwn(symbol);
  }
  void Sweep();
  /// Number of unpinned constants that are live. The agent sweeps when it has doubled.
  std::size_t UnpinnedCount() const;

  /// A digest of all pinned symbols and their handles. Tables with equal digests pinned the same symbols under the same
  /// handles.
  std::uint64_t Digest() const;
  /// Moves pinned constants of this table into a frozen base that other tables may adopt: of each kind, all that
  /// precede the first unpinned constant. If the table has only read rules so far, this is all of them. Handles stay
  /// valid; views returned by Text() become invalid.
  std::shared_ptr<const FrozenSymbols> Freeze();
  /// Replaces this table's own constants by a frozen base. They must be equal, with equal handles, or this table must
  /// have none of its own. Handles stay valid; views returned by Text() become invalid. Returns false, and changes
  /// nothing, if the two differ.
  bool Adopt(std::shared_ptr<const FrozenSymbols> base);

  /// Limits the memory of this table's own texts. A long text that exceeds the limit throws std::bad_alloc.
  void LimitTexts(std::size_t bytes);
  /// Bytes used by this table, without the shared base.
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
  /// By tag, set by BeginMark: the first index that a sweep may free. Smaller indices belong to the base.
  std::array<std::uint32_t, 8> sweepable_from_{};
};

/// True if Soar's lexer reads `text`, written without bars, as exactly this string.
bool ReadsAsPlainString(std::string_view text);

/// The letter of an identifier that is named after a variable or an attribute: the first letter of the name, as a
/// capital. Returns I if the name does not begin with an ASCII letter. Also returns I instead of S, which is reserved
/// for states.
inline char LetterOfIdentifier(std::string_view name) {
  if (!name.empty() && name.front() == '<') name.remove_prefix(1);
  if (name.empty()) return 'I';
  const char letter = static_cast<char>(name.front() & ~0x20);
  return letter < 'A' || letter > 'Z' || letter == 'S' ? 'I' : letter;
}

/// The printed form of a symbol. With `rereadable`, bars are added if the lexer would read the text differently (as in
/// `print`, rules and traces). Without it, the text is unchanged (as in `write` and `concat`). Floats have six
/// decimals.
std::string ToString(const SymbolTable& symbols, Symbol symbol, bool rereadable = true);
void AppendTo(std::string& out, const SymbolTable& symbols, Symbol symbol, bool rereadable = true);

}  // namespace soarbox::kernel
