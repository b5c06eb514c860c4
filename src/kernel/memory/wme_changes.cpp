// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/memory/wme_changes.h"

#include <string>

#include "kernel/base/words.h"
#include "kernel/decide/engine.h"

namespace soarbox::kernel {

WmeId WmeChanges::Add(WmeKind kind, Symbol id, Symbol attribute, Symbol value, SlotId slot, PreferenceId preference) {
  const WmeId wme = engine_.memory.Make(kind, id, attribute, value, false, slot);
  WmeRecord& record = engine_.memory.mutable_record(wme);
  record.preference = preference;
  // Elements with a preference are linked through it.
  if (preference == PreferenceId::kNone && kind != WmeKind::kArchitecture && value.IsIdentifier()) {
    record.link = engine_.links.Add(id, value);
  }
  engine_.chunker.NoteElement(attribute);
  Record(wme, kind, id, value);
  return wme;
}

WmeId WmeChanges::AddInput(Symbol id, Symbol attribute, Symbol value, bool acceptable) {
  const WmeId wme = engine_.memory.Make(WmeKind::kInput, id, attribute, value, acceptable, SlotId::kNone);
  if (value.IsIdentifier()) engine_.memory.mutable_record(wme).link = engine_.links.Add(id, value);
  engine_.chunker.NoteElement(attribute);
  Record(wme, WmeKind::kInput, id, value);
  return wme;
}

WmeId WmeChanges::AddAcceptable(SlotId slot, Symbol value, PreferenceId preference) {
  const Symbol id = engine_.memory.slot(slot).id;
  const WmeId wme = engine_.memory.Make(WmeKind::kAcceptable, id, words::kOperator, value, true, slot);
  engine_.memory.mutable_record(wme).preference = preference;
  engine_.chunker.NoteElement(words::kOperator);
  Record(wme, WmeKind::kAcceptable, id, value);
  return wme;
}

void WmeChanges::Record(WmeId wme, WmeKind kind, Symbol id, Symbol value) {
  added_.push_back(wme);
  if (value.IsIdentifier() && value != id) engine_.links.ElementAdded(value, kind == WmeKind::kArchitecture);
  // What comes from outside is no output by itself.
  if (kind != WmeKind::kInput) engine_.output.NoteChange(id);
}

void WmeChanges::Lose(WmeId wme) {
  if (engine_.memory.record(wme).gds != 0) engine_.gds.MemberLeaves(wme);
  Remove(wme);
}

void WmeChanges::Remove(WmeId wme) {
  if (engine_.memory.record(wme).gds != 0) engine_.gds.Forget(wme);
  WmeRecord& record = engine_.memory.mutable_record(wme);
  if (record.link != LinkId::kNone) {
    engine_.links.Remove(record.link);
    record.link = LinkId::kNone;
  }
  const Wme& content = engine_.memory.wme(wme);
  if (content.value.IsIdentifier() && content.value != content.id) {
    engine_.links.ElementRemoved(content.value, record.kind == WmeKind::kArchitecture);
  }
  if (record.kind == WmeKind::kInput && record.input_element != 0xFFFFFFFFu) engine_.input.Forget(record.input_element);
  if (record.kind != WmeKind::kInput) engine_.output.NoteChange(content.id);
  engine_.memory.Unlink(wme);
  removed_.push_back(wme);
}

void WmeChanges::WarnOfLost() {
  const Wme& wme = engine_.memory.wme(flushing_added_.back());
  const auto text = [&](Symbol symbol) { return ToString(engine_.symbols, symbol); };
  engine_.Warn(WarningKind::kAddedAndRemoved, "(" + std::to_string(wme.timetag) + ": " + text(wme.id) + " ^" +
                                                  text(wme.attribute) + " " + text(wme.value) +
                                                  (wme.acceptable ? " +)" : ")"));
}

void WmeChanges::Flush() {
  engine_.StopIfBroken();
  flushing_added_.swap(added_);
  flushing_removed_.swap(removed_);
  const bool tell = engine_.observers.Wants(Event::kWme);
  const GoalView goals = engine_.goal_view();
  engine_.counters.wme_additions += flushing_added_.size();
  engine_.counters.wme_removals += flushing_removed_.size();
  if (tell && !flushing_added_.empty() && !engine_.memory.wme(flushing_added_.back()).live) WarnOfLost();
  for (std::size_t n = flushing_added_.size(); n-- > 0;) {
    const WmeId wme = flushing_added_[n];
    // An element that came and went within the phase never enters the match.
    if (engine_.memory.wme(wme).live) {
      WmeRecord& record = engine_.memory.mutable_record(wme);
      record.in_match = true;
      record.entered = ++last_entered_;
      engine_.rete.AddWme(wme, goals);
      if (engine_.rete.matches().HasInterrupting()) [[unlikely]]
        engine_.run.TellInterrupts();
    }
    if (tell) {
      const WmeInfo info = engine_.Describe(wme);
      engine_.observers.Notify(Event::kWme, [&](Observer& o) { o.OnWmeAdded(engine_.agent, info); });
    }
  }
  for (std::size_t n = flushing_removed_.size(); n-- > 0;) {
    const WmeId wme = flushing_removed_[n];
    WmeRecord& record = engine_.memory.mutable_record(wme);
    if (record.in_match) {
      engine_.rete.RemoveWme(wme, goals);
      if (engine_.rete.matches().HasInterrupting()) [[unlikely]]
        engine_.run.TellInterrupts();
    }
    record.in_match = false;
    record.removing = true;
    if (tell) {
      const WmeInfo info = engine_.Describe(wme);
      engine_.observers.Notify(Event::kWme, [&](Observer& o) { o.OnWmeRemoved(engine_.agent, info); });
    }
    if (record.references == 0) dead_.push_back(wme);
  }
  if (engine_.long_term.Wants(ModuleHook::kFlush)) engine_.long_term.Flushed(flushing_added_, flushing_removed_);
  flushing_added_.clear();
  flushing_removed_.clear();
}

void WmeChanges::AddReference(WmeId wme) {
  ++engine_.memory.mutable_record(wme).references;
}

void WmeChanges::DropReference(WmeId wme) {
  WmeRecord& record = engine_.memory.mutable_record(wme);
  if (--record.references == 0 && record.removing) dead_.push_back(wme);
}

void WmeChanges::Bury() {
  engine_.memory.Free(dead_);
  dead_.clear();
}

void WmeChanges::Clear() {
  added_.clear();
  removed_.clear();
  dead_.clear();
}

}  // namespace soarbox::kernel
