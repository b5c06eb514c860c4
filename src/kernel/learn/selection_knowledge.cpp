// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/selection_knowledge.h"

#include <algorithm>
#include <utility>

#include "kernel/decide/goal_stack.h"
#include "kernel/decide/preference_changes.h"
#include "kernel/learn/draft_tests.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

void SelectionKnowledge::OperatorSelected(GoalLevel level, Symbol winner, bool forced) {
  GoalRemoved(level);
  const SlotId slot = uses_.goals.at(level).operator_slot;
  if (forced || uses_.memory.slot(slot).others == PreferenceId::kNone) return;
  collected_.clear();
  Collect(slot, winner);
  if (collected_.empty()) return;
  const std::uint32_t index = Make(collected_);
  if (of_goal_.size() <= level) of_goal_.resize(level + 1u, kNone);
  of_goal_[level] = index;
}

std::uint32_t SelectionKnowledge::Make(std::vector<PreferenceId> preferences) {
  std::uint32_t index;
  if (!free_.empty()) {
    index = free_.back();
    free_.pop_back();
  } else {
    index = static_cast<std::uint32_t>(sets_.size());
    sets_.emplace_back();
  }
  sets_[index].references = 1;
  for (const PreferenceId p : preferences) uses_.preferences.AddReference(p);
  sets_[index].preferences = std::move(preferences);
  return index;
}

void SelectionKnowledge::CollectProhibits(WmeId wme, std::vector<PreferenceId>& out) const {
  const WorkingMemory& memory = uses_.memory;
  const WmeRecord& record = memory.record(wme);
  if (record.removing || record.preference == PreferenceId::kNone) return;
  const SlotId slot = memory.preference(record.preference).slot;
  if (slot == SlotId::kNone) return;
  const std::size_t known = out.size();
  for (PreferenceId p = memory.slot(slot).others; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    if (memory.preference(p).type != PreferenceType::kProhibit) continue;
    if (std::ranges::find(out, p) == out.end()) out.push_back(p);
  }
  std::reverse(out.begin() + static_cast<std::ptrdiff_t>(known), out.end());
}

std::uint32_t SelectionKnowledge::With(std::vector<PreferenceId> preferences, std::uint32_t selection) {
  if (selection != kNone) {
    for (const PreferenceId p : sets_[selection].preferences) {
      if (std::ranges::find(preferences, p) == preferences.end()) preferences.push_back(p);
    }
  }
  return Make(std::move(preferences));
}

void SelectionKnowledge::GoalRemoved(GoalLevel level) {
  if (level >= of_goal_.size() || of_goal_[level] == kNone) return;
  const std::uint32_t selection = of_goal_[level];
  of_goal_[level] = kNone;
  DropReference(selection, false);
}

bool SelectionKnowledge::SaysTheSame(PreferenceId a, PreferenceId b) const {
  const Preference& x = uses_.memory.preference(a);
  const Preference& y = uses_.memory.preference(b);
  if (x.type == y.type) return x.value == y.value && x.referent == y.referent;
  const auto compares = [](const Preference& p) {
    return p.type == PreferenceType::kBetter || p.type == PreferenceType::kWorse;
  };
  return compares(x) && compares(y) && x.value == y.referent && x.referent == y.value;
}

/// If several preferences have equal contents, the first is sufficient. But numeric preferences are summed up, so all
/// of them count. All prohibit preferences count, too, as in Soar 9.6.3.
void SelectionKnowledge::Add(PreferenceId preference) {
  const PreferenceType type = uses_.memory.preference(preference).type;
  if (type != PreferenceType::kNumericIndifferent && type != PreferenceType::kProhibit &&
      std::ranges::any_of(collected_, [&](PreferenceId known) { return SaysTheSame(known, preference); })) {
    return;
  }
  collected_.push_back(preference);
}

/// Repeats the steps of the decision (PreferenceSemantics) and collects the preferences that made a difference in each.
void SelectionKnowledge::Collect(SlotId slot, Symbol winner) {
  const WorkingMemory& memory = uses_.memory;
  const Slot& record = memory.slot(slot);
  const auto for_each = [&](PreferenceType type, auto&& visit) {
    for (PreferenceId p = record.others; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
      if (memory.preference(p).type == type) visit(p, memory.preference(p));
    }
  };
  bool required = false;
  for_each(PreferenceType::kRequire, [&](PreferenceId, const Preference&) { required = true; });
  if (required) return;
  candidates_.clear();
  for (PreferenceId p = record.acceptable; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    if (!Contains(candidates_, memory.preference(p).value)) candidates_.push_back(memory.preference(p).value);
  }
  for (const PreferenceType type : {PreferenceType::kProhibit, PreferenceType::kReject}) {
    for_each(type, [&](PreferenceId id, const Preference& p) {
      std::erase(candidates_, p.value);
      Add(id);
    });
  }
  if (candidates_.size() < 2) return;

  left_ = candidates_;
  const auto both_run = [&](const Preference& p) {
    return Contains(candidates_, p.value) && Contains(candidates_, p.referent);
  };
  for_each(PreferenceType::kBetter, [&](PreferenceId, const Preference& p) {
    if (both_run(p)) std::erase(left_, p.referent);
  });
  for_each(PreferenceType::kWorse, [&](PreferenceId, const Preference& p) {
    if (both_run(p)) std::erase(left_, p.value);
  });
  for_each(PreferenceType::kBetter, [&](PreferenceId id, const Preference& p) {
    if (both_run(p) && Contains(left_, p.value)) Add(id);
  });
  for_each(PreferenceType::kWorse, [&](PreferenceId id, const Preference& p) {
    if (both_run(p) && Contains(left_, p.referent)) Add(id);
  });
  if (left_.size() < 2) return;

  candidates_ = left_;
  left_.clear();
  for_each(PreferenceType::kBest, [&](PreferenceId id, const Preference& p) {
    if (!Contains(candidates_, p.value)) return;
    if (!Contains(left_, p.value)) left_.push_back(p.value);
    Add(id);
  });
  if (left_.empty()) left_ = candidates_;
  if (left_.size() < 2) return;

  candidates_ = left_;
  for_each(PreferenceType::kWorst, [&](PreferenceId, const Preference& p) { std::erase(left_, p.value); });
  if (left_.empty()) {
    left_ = candidates_;  // All of them are worst, so none is dropped.
  } else {
    for_each(PreferenceType::kWorst, [&](PreferenceId id, const Preference& p) {
      if (Contains(candidates_, p.value)) Add(id);
    });
  }
  if (left_.size() < 2) return;

  // A choice among indifferent candidates.
  std::vector<Symbol>& with_number = candidates_;
  with_number.clear();
  for_each(PreferenceType::kNumericIndifferent, [&](PreferenceId id, const Preference& p) {
    with_number.push_back(p.value);
    if (p.value == winner) Add(id);
  });
  const bool has_number = Contains(with_number, winner);
  for_each(PreferenceType::kBinaryIndifferent, [&](PreferenceId id, const Preference& p) {
    if (p.value != winner && p.referent != winner) return;
    const Symbol other = p.value == winner ? p.referent : p.value;
    if (!Contains(left_, other) || (has_number && Contains(with_number, other))) return;
    Add(id);
  });
}

void SelectionKnowledge::DropReference(std::uint32_t selection, bool later) {
  if (--sets_[selection].references > 0) return;
  std::vector<PreferenceId> preferences = std::move(sets_[selection].preferences);
  sets_[selection].preferences.clear();
  free_.push_back(selection);
  for (const PreferenceId p : preferences) {
    if (later) {
      uses_.preferences.DropReferenceLater(p);
    } else {
      uses_.preferences.DropReference(p);
    }
  }
}

void SelectionKnowledge::Clear() {
  sets_.clear();
  free_.clear();
  of_goal_.clear();
}

}  // namespace soarbox::kernel
