// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/singletons.h"

#include <algorithm>

#include "kernel/base/known_symbols.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

void Singletons::NoteAll() {
  for (std::uint32_t index = 0; index < uses_.memory.wmes().size(); ++index) {
    const Wme& wme = uses_.memory.wmes()[index];
    if (wme.live) Note(wme.attribute);
  }
}

bool Singletons::IsArchitecture(Symbol attribute) {
  return attribute == words::kSuperstate || attribute == words::kOperator || attribute == words::kType ||
         attribute == words::kImpasse || attribute == words::kSmem || attribute == words::kEpmem;
}

bool Singletons::HasType(Symbol symbol, SingletonType type) const {
  const WorkingMemory& memory = uses_.memory;
  switch (type) {
    case SingletonType::kAny:
      return true;
    case SingletonType::kConstant:
      return !symbol.IsIdentifier();
    case SingletonType::kIdentifier:
      return symbol.IsIdentifier();
    case SingletonType::kState:
      return symbol.IsIdentifier() && memory.identifier(symbol).is_goal;
    case SingletonType::kOperator:
      if (!symbol.IsIdentifier()) return false;
      for (GoalLevel level = 1; level <= uses_.goals.depth(); ++level) {
        const Slot& slot = memory.slot(uses_.goals.at(level).operator_slot);
        for (PreferenceId p = slot.acceptable; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
          if (memory.preference(p).value == symbol) return true;
        }
      }
      return false;
  }
  return false;
}

bool Singletons::Fits(WmeId id) const {
  const Wme& wme = uses_.memory.wme(id);
  if (!wme.acceptable && (IsArchitecture(wme.attribute) || wme.attribute == words::kAttribute) &&
      uses_.memory.identifier(wme.id).is_goal) {
    return true;
  }
  if (!wme.attribute.IsString() || wme.attribute.index() >= codes_.size()) return false;
  const std::uint8_t code = codes_[wme.attribute.index()];
  if (code == 0) return false;
  return HasType(wme.id, static_cast<SingletonType>((code - 1) / 5)) &&
         HasType(wme.value, static_cast<SingletonType>((code - 1) % 5));
}

void Singletons::Put(const Pattern& pattern) {
  const std::uint32_t index = pattern.attribute.index();
  if (codes_.size() <= index) codes_.resize(index + 1u, 0);
  codes_[index] = static_cast<std::uint8_t>(1 + 5 * static_cast<int>(pattern.id) + static_cast<int>(pattern.value));
}

bool Singletons::Set(const Pattern& pattern) {
  const bool known = Remove(pattern.attribute);
  Put(pattern);
  return known;
}

bool Singletons::Remove(Symbol attribute) {
  if (!attribute.IsString() || attribute.index() >= codes_.size() || codes_[attribute.index()] == 0) return false;
  codes_[attribute.index()] = 0;
  return true;
}

std::vector<Singletons::Pattern> Singletons::Patterns() const {
  std::vector<Pattern> patterns;
  for (std::uint32_t index = 0; index < codes_.size(); ++index) {
    if (codes_[index] == 0) continue;
    const int code = codes_[index] - 1;
    patterns.push_back({Symbol(Symbol::Tag::kString, index), static_cast<SingletonType>(code / 5),
                        static_cast<SingletonType>(code % 5)});
  }
  std::ranges::stable_sort(patterns, [&](const Pattern& a, const Pattern& b) {
    return uses_.symbols.Stamp(a.attribute) < uses_.symbols.Stamp(b.attribute);
  });
  return patterns;
}

}  // namespace soarbox::kernel
