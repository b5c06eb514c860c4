// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/memory/wme_changes.h"

#include <utility>

#include "kernel/base/known_symbols.h"

namespace soarbox::kernel {

WmeId WmeChanges::Add(WmeKind kind, Symbol id, Symbol attribute, Symbol value, SlotId slot, PreferenceId preference) {
  const WmeId wme = memory_.Make(kind, id, attribute, value, false, slot);
  WmeRecord& record = memory_.mutable_record(wme);
  record.preference = preference;
  // If the element has a preference, the preference holds the link.
  if (preference == PreferenceId::kNone && kind != WmeKind::kArchitecture && value.IsIdentifier()) {
    record.link = links_.Add(id, value);
  }
  Record(wme, kind, id, attribute, value);
  return wme;
}

WmeId WmeChanges::AddInput(Symbol id, Symbol attribute, Symbol value, bool acceptable) {
  const WmeId wme = memory_.Make(WmeKind::kInput, id, attribute, value, acceptable, SlotId::kNone);
  if (value.IsIdentifier()) memory_.mutable_record(wme).link = links_.Add(id, value);
  Record(wme, WmeKind::kInput, id, attribute, value);
  return wme;
}

WmeId WmeChanges::AddAcceptable(SlotId slot, Symbol value, PreferenceId preference) {
  const Symbol id = memory_.slot(slot).id;
  const WmeId wme = memory_.Make(WmeKind::kAcceptable, id, words::kOperator, value, true, slot);
  memory_.mutable_record(wme).preference = preference;
  Record(wme, WmeKind::kAcceptable, id, words::kOperator, value);
  return wme;
}

void WmeChanges::Record(WmeId wme, WmeKind kind, Symbol id, Symbol attribute, Symbol value) {
  if (tells_of_attributes_) [[unlikely]]
    listener_.AttributeUsed(attribute);
  added_.push_back(wme);
  if (value.IsIdentifier() && value != id) links_.ElementAdded(value, kind == WmeKind::kArchitecture);
  // Changes by clients alone do not count as output.
  if (kind != WmeKind::kInput) output_.NoteChange(id);
}

void WmeChanges::Lose(WmeId wme) {
  if (memory_.record(wme).gds != 0) {
    listener_.DependencyLost(wme);
    // If the element belonged to the goal, it was removed with the goal.
    if (!memory_.wme(wme).live) return;
  }
  Remove(wme);
}

void WmeChanges::Remove(WmeId wme) {
  if (memory_.record(wme).gds != 0) listener_.DependencyForgotten(wme);
  WmeRecord& record = memory_.mutable_record(wme);
  if (record.link != LinkId::kNone) {
    links_.Remove(record.link);
    record.link = LinkId::kNone;
  }
  const Wme& content = memory_.wme(wme);
  if (content.value.IsIdentifier() && content.value != content.id) {
    links_.ElementRemoved(content.value, record.kind == WmeKind::kArchitecture);
  }
  if (record.input_element() != WmeRecord::kNoInput) {
    listener_.InputElementRemoved(record.input_element());
  }
  if (record.kind != WmeKind::kInput) output_.NoteChange(content.id);
  memory_.Unlink(wme);
  removed_.push_back(wme);
}

bool WmeChanges::Renew(WmeId wme, Symbol value) {
  WmeRecord& record = memory_.mutable_record(wme);
  if (!record.in_match || record.renewed || record.references != 0 || record.gds != 0 ||
      memory_.wme(wme).value.IsIdentifier() || !IsUntested(rete_, wme, value)) {
    return false;
  }
  memory_.Make(wme, value);
  record.renewed = true;
  ++renewed_;
  added_.push_back(wme);
  return true;
}

void WmeChanges::Flush() {
  const bool tell = listener_.FlushBegins(added_.size(), removed_.size() + std::exchange(renewed_, 0));
  flushing_added_.swap(added_);
  flushing_removed_.swap(removed_);
  const GoalView goals = memory_.goal_view();
  if (tell && !flushing_added_.empty() && !memory_.wme(flushing_added_.back()).live) {
    listener_.FirstWasLost(flushing_added_.back());
  }
  for (std::size_t n = flushing_added_.size(); n-- > 0;) {
    const WmeId wme = flushing_added_[n];
    // An element that was added and removed within the phase never enters the match.
    if (memory_.wme(wme).live) {
      WmeRecord& record = memory_.mutable_record(wme);
      if (record.renewed) {
        record.renewed = false;
        kernel::Renew(rete_, wme);
        continue;
      }
      record.in_match = true;
      rete_.AddWme(wme, goals);
      if (rete_.matches().HasInterrupting()) [[unlikely]]
        listener_.RuleInterrupts();
    }
    if (tell) listener_.Entered(wme);
  }
  for (std::size_t n = flushing_removed_.size(); n-- > 0;) {
    const WmeId wme = flushing_removed_[n];
    WmeRecord& record = memory_.mutable_record(wme);
    if (record.in_match) {
      rete_.RemoveWme(wme, goals);
      if (rete_.matches().HasInterrupting()) [[unlikely]]
        listener_.RuleInterrupts();
    }
    record.in_match = false;
    record.removing = true;
    if (tell) listener_.Left(wme);
    if (record.references == 0) dead_.push_back(wme);
  }
  listener_.Flushed(flushing_added_, flushing_removed_);
  flushing_added_.clear();
  flushing_removed_.clear();
}

void WmeChanges::AddReference(WmeId wme) {
  ++memory_.mutable_record(wme).references;
}

void WmeChanges::DropReference(WmeId wme) {
  WmeRecord& record = memory_.mutable_record(wme);
  if (--record.references == 0 && record.removing) dead_.push_back(wme);
}

void WmeChanges::Bury() {
  memory_.Free(dead_);
  dead_.clear();
}

void WmeChanges::Clear() {
  added_.clear();
  removed_.clear();
  dead_.clear();
  renewed_ = 0;
}

}  // namespace soarbox::kernel
