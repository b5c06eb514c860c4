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

/// An index of a slot with very many preferences. With it, the cost of a change depends only on the size of the change.
/// Without it, walking all preferences for each new one would take quadratic time.
///
/// WorkingMemory maintains it from the moment when the slot becomes large until its last acceptable preference is
/// removed.
struct LargeSlot {
  struct Value {
    std::uint32_t acceptable = 0;  ///< Number of acceptable preferences for the value.
    std::uint32_t top_facts = 0;   ///< Those of them that are o-supported and of the top state's level.
    PreferenceId only =
        PreferenceId::kNone;   ///< The only acceptable preference, or kNone if there are more or it is unknown.
    WmeId wme = WmeId::kNone;  ///< The element with this value.

    bool IsGone() const { return acceptable == 0 && wme == WmeId::kNone; }
    friend bool operator==(const Value& a, const Value& b) {
      return a.acceptable == b.acceptable && a.top_facts == b.top_facts && a.wme == b.wme;
    }
  };
  std::unordered_map<std::uint32_t, Value> values;  ///< By Symbol::bits().
  std::vector<Symbol> changed;  ///< Values whose acceptable preferences changed since the last decision of the slot.
  bool all_changed = true;      ///< The slot has or had preferences of other types, or has not been decided yet.

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
  /// Call when the slot has been decided.
  void Settle(bool has_others) {
    changed.clear();
    all_changed = has_others;
  }
  /// Returns null if the slot has neither an acceptable preference nor an element with this value.
  const Value* Find(Symbol value) const {
    const auto at = values.find(value.bits());
    return at == values.end() ? nullptr : &at->second;
  }
};

using LargeSlots = std::unordered_map<const Slot*, LargeSlot>;

}  // namespace soarbox::kernel
