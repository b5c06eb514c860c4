// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/memory/preference.h"

namespace soarbox::kernel {

struct Slot;

/// What is known about a slot with very many preferences, so that a change costs what changes: walking all preferences
/// for each new one would take time that grows with the square of their number.
///
/// WorkingMemory keeps it up to date from the moment when the slot turns out to be large until its last acceptable
/// preference has gone.
struct LargeSlot {
  struct Value {
    std::uint32_t acceptable = 0;             ///< Acceptable preferences for it.
    std::uint32_t top_facts = 0;              ///< Of these the o-supported ones of the top state's level.
    PreferenceId only = PreferenceId::kNone;  ///< If there is one; kNone also if it is not known which one is left.
    WmeId wme = WmeId::kNone;                 ///< The element.

    bool IsGone() const { return acceptable == 0 && wme == WmeId::kNone; }
    friend bool operator==(const Value& a, const Value& b) {
      return a.acceptable == b.acceptable && a.top_facts == b.top_facts && a.wme == b.wme;
    }
  };
  std::unordered_map<std::uint32_t, Value> values;  ///< By Symbol::bits().
  std::vector<Symbol> changed;  ///< Values whose acceptable preferences changed since the slot was decided.
  bool all_changed = true;      ///< There are or were preferences of other types, or it has not been decided yet.

  static bool IsTopFact(const Preference& preference) { return preference.o_supported && preference.level == 1; }
  void Insert(PreferenceId id) {
    if (id.record->type != PreferenceType::kAcceptable) {
      all_changed = true;
      return;
    }
    Value& value = values[id.record->value.bits()];
    value.only = ++value.acceptable == 1 ? id : PreferenceId::kNone;
    value.top_facts += IsTopFact(*id.record);
    changed.push_back(id.record->value);
  }
  void Remove(PreferenceId id) {
    if (id.record->type != PreferenceType::kAcceptable) {
      all_changed = true;
      return;
    }
    const auto at = values.find(id.record->value.bits());
    at->second.only = PreferenceId::kNone;
    at->second.top_facts -= IsTopFact(*id.record);
    --at->second.acceptable;
    changed.push_back(id.record->value);
    if (at->second.IsGone()) values.erase(at);
  }
  void SetWme(Symbol value, WmeId wme) {
    const auto at = values.try_emplace(value.bits()).first;
    at->second.wme = wme;
    if (at->second.IsGone()) values.erase(at);
  }
  /// The slot has been decided.
  void Settle(bool has_others) {
    changed.clear();
    all_changed = has_others;
  }
  /// Null if the slot has no acceptable preference for it, and no element.
  const Value* Find(Symbol value) const {
    const auto at = values.find(value.bits());
    return at == values.end() ? nullptr : &at->second;
  }
};

using LargeSlots = std::unordered_map<const Slot*, LargeSlot>;

}  // namespace soarbox::kernel
