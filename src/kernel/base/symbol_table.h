// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

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
/// Every constant has a creation stamp, which grows with first use; the condition reorderer breaks ties by it.
class SymbolTable {
 public:
  SymbolTable();
  ~SymbolTable();
  SymbolTable(SymbolTable&&) noexcept;
  SymbolTable& operator=(SymbolTable&&) noexcept;

  /// Interns; equal contents give the same handle. A symbol interned while `pinning()` is on is pinned.
  Symbol String(std::string_view text);
  Symbol Integer(std::int64_t value);
  Symbol Float(double value);
  /// `name` with its brackets: "<s>".
  Symbol Variable(std::string_view name);
  /// The handle of a string that exists already, else the none symbol. Never interns.
  Symbol FindString(std::string_view text) const;
  Symbol FindVariable(std::string_view name) const;

  /// Contents. The kind must fit.
  std::string_view Text(Symbol string_or_variable) const;
  std::int64_t IntegerValue(Symbol symbol) const;
  double FloatValue(Symbol symbol) const;
  /// The value of an integer or a float as a double.
  double NumberValue(Symbol symbol) const;
  std::uint32_t Stamp(Symbol constant) const;

  /// A new identifier with the next number of its letter (A to Z).
  Symbol NewIdentifier(char letter);
  /// An identifier with a given number; the letter's counter is raised above it.
  Symbol NewIdentifier(char letter, std::uint64_t number);
  void FreeIdentifier(Symbol identifier);
  char Letter(Symbol identifier) const;
  std::uint64_t Number(Symbol identifier) const;
  /// The live identifier with this name, else the none symbol. Not for hot paths.
  Symbol FindIdentifier(char letter, std::uint64_t number) const;
  /// One more than the largest identifier index ever handed out: the size for arrays that run beside this table.
  std::uint32_t IdentifierLimit() const;
  /// Restarts all letters at 1 (init-soar). All identifiers must have been freed.
  void ResetIdentifierCounters();

  /// Soar's ordering for < > <= >=: numbers by value, strings by bytes, identifiers by letter and number; any other
  /// mix is "less".
  std::strong_ordering Compare(Symbol left, Symbol right) const;

  /// Everything interned between PinScope's construction and destruction is pinned.
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
  void Mark(Symbol symbol);
  void Sweep();
  /// How many unpinned constants live; the agent sweeps when this has doubled.
  std::size_t UnpinnedCount() const;

  /// A running digest of everything interned and pinned so far. Equal digests: equal tables (used for sharing).
  std::uint64_t Digest() const;
  /// Moves all own pinned constants into a frozen base that other agents may share.
  std::shared_ptr<const struct FrozenSymbols> Freeze();
  /// Takes over an equal frozen base in place of its own. The handles stay valid.
  void Adopt(std::shared_ptr<const struct FrozenSymbols> base);

  /// Bytes used by this table alone (not the shared base).
  std::size_t MemoryBytes() const;

 private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

/// How symbols look in print. `rereadable` puts bars where the lexer would read something else (as in `print`,
/// rules and traces); without it the raw text is given (as in `write` and `concat`). Floats have six decimals.
std::string ToString(const SymbolTable& symbols, Symbol symbol, bool rereadable = true);
void AppendTo(std::string& out, const SymbolTable& symbols, Symbol symbol, bool rereadable = true);

}  // namespace soarbox::kernel
