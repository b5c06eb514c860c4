// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kernel/base/symbol.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/preference_changes.h"
#include "kernel/imagery/space.h"
#include "kernel/memory/wme_changes.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel::imagery {

/// Reads commands from working memory and writes the results of imagery to it. Its elements are in slots, without a
/// preference. It finds them by their contents and stores no references to them. So rules and the architecture may
/// remove them at any time. It writes nothing on identifiers that are not reachable from a state.
class MemoryWriter {
 public:
  MemoryWriter(SymbolTable& symbols, WorkingMemory& memory, WmeChanges& changes, PreferenceChanges& preferences)
      : symbols_(symbols), memory_(memory), changes_(changes), preferences_(preferences) {}

  bool IsReached(Symbol id) const;
  /// "X12"
  std::string NameOf(Symbol id) const;
  std::string_view TextOf(Symbol string) const { return symbols_.Text(string); }
  /// The value of an integer or float symbol.
  double NumberOf(Symbol number) const;
  std::int64_t IntegerOf(Symbol number) const;

  Symbol Text(std::string_view text) { return symbols_.String(text); }
  /// Infinities are replaced by the largest finite number of the same sign, NaN by 0.
  Symbol Float(double value);
  Symbol Integer(std::int64_t value) { return symbols_.Integer(value); }

  /// Calls visit(attribute, value) for each value of each slot, in the order of `print`.
  template <typename Visit>
  void ForEachValue(Symbol id, Visit&& visit) const {
    for (SlotId slot = memory_.identifier(id).slots; slot != SlotId::kNone; slot = memory_.slot(slot).next) {
      for (WmeId wme = memory_.slot(slot).wmes; wme != WmeId::kNone; wme = memory_.record(wme).next) {
        visit(memory_.slot(slot).attribute, memory_.wme(wme).value);
      }
    }
  }
  /// The first value of an attribute, or the none symbol.
  Symbol ValueOf(Symbol id, std::string_view attribute) const;
  /// The element with these contents; kNone if it does not exist.
  WmeId ElementOf(Symbol id, Symbol attribute, Symbol value) const;
  /// The first value of an attribute, if it is a string.
  std::optional<std::string> TextOf(Symbol id, std::string_view attribute) const;
  /// The numbers ^x, ^y and ^z of the attribute's value; none if one of them is missing.
  std::optional<Vec3> VectorOf(Symbol id, std::string_view attribute) const;

  /// Adds an element unless it exists.
  void Add(Symbol id, std::string_view attribute, Symbol value);
  /// Adds an element with a new identifier and returns the identifier; none if `id` is not reachable from a state.
  Symbol AddObject(Symbol id, std::string_view attribute);
  Symbol AddObject(Symbol id, std::string_view attribute, char letter);
  void Remove(Symbol id, std::string_view attribute, Symbol value);
  /// Removes all elements of an attribute that are not supported by rules.
  void RemoveAll(Symbol id, std::string_view attribute);
  /// Like RemoveAll, then adds one element.
  void Replace(Symbol id, Symbol attribute, Symbol value);

 private:
  SlotId FindSlot(Symbol id, std::string_view attribute) const;
  void Lose(SlotId slot, WmeId wme);

  SymbolTable& symbols_;
  WorkingMemory& memory_;
  WmeChanges& changes_;
  PreferenceChanges& preferences_;
};

}  // namespace soarbox::kernel::imagery
