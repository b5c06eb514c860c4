// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/origins.h"

#include <algorithm>
#include <new>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/agent_counters.h"
#include "kernel/decide/goal_changes.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/modules.h"
#include "kernel/longterm/agent_parts.h"
#include "kernel/match/rete.h"

namespace soarbox::kernel {

Origins::Origins(const AgentParts& parts)
    : uses_{parts.memory,   parts.goals,        parts.instantiations, parts.rete,
            parts.counters, parts.goal_changes, parts.modules} {}

/// If memory runs out, recording ends. The agent continues.
template <typename Work>
void Origins::Guarded(Work work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    Clear();
    on_ = false;
    uses_.modules.SetHooks(*this, 0);
  }
}

void Origins::Begin(Describe describe) {
  describe_ = std::move(describe);
  if (on_) return;
  if (!attached_) uses_.modules.Attach(*this, kPlace);
  attached_ = on_ = true;
  uses_.modules.SetHooks(*this, ModuleHook::kRulesFire | ModuleHook::kAsserted | ModuleHook::kAfterElaboration |
                                    ModuleHook::kFlush | ModuleHook::kChoices | ModuleHook::kStates);
  for (GoalLevel level = 1; level <= uses_.goals.depth(); ++level) installed_.push_back(level);
}

// Events --------------------------------------------------------------------------------------------------------------

void Origins::OperatorInstalled(GoalLevel level, Symbol) {
  Guarded([&] {
    ForgetSelected(level);
    installed_.push_back(level);
  });
}

/// No rule has fired since the operators were installed. So the preferences in their slots are those of the decision.
void Origins::RulesFire() {
  if (installed_.empty()) return;
  Guarded([&] {
    for (const GoalLevel level : installed_)
      if (level <= uses_.goals.depth()) NoteSelected(level);
    installed_.clear();
  });
}

void Origins::Asserted(PreferenceId id) {
  const Preference& preference = uses_.memory.preference(id);
  if (preference.type != PreferenceType::kAcceptable && preference.type != PreferenceType::kRequire) return;
  if (!preference.o_supported && !GivesCommand(preference)) return;
  Guarded([&] {
    const std::uint32_t origin = OriginOfFiring(MadeBy(preference), 0);
    if (origin == kNone) return;
    Hold(origin);
    pending_.push_back({preference.id, preference.attribute, preference.value, origin});
  });
}

void Origins::AfterElaboration() {
  last_serial_ = asked_serial_ = 0;
  last_origin_ = kNone;
  if (pending_.empty()) return;
  Guarded([&] {
    for (const Pending& pending : pending_) {
      const WmeId wme = ElementOf(pending);
      if (wme == WmeId::kNone) continue;
      // An existing element keeps its origin.
      const std::uint32_t old = Of(wme);
      if (old == kNone || !origins_[old].o_supported) Attach(wme, pending.origin);
    }
    for (const Pending& pending : pending_) CutBehind(pending.origin);
    for (const Pending& pending : pending_) Drop(pending.origin);
    pending_.clear();
  });
}

void Origins::Flushed(std::span<const WmeId>, std::span<const WmeId> removed) {
  Guarded([&] {
    for (const WmeId wme : removed) Detach(wme);
  });
}

void Origins::StateRemoved(GoalLevel level) {
  Guarded([&] { ForgetSelected(level); });
}

void Origins::BeforeInit() {
  Clear();
}

void Origins::Mark(const std::function<void(Symbol)>& mark) {
  for (const Origin& origin : origins_) {
    if (origin.references == 0) continue;
    for (const Symbol symbol : {origin.state, origin.op, origin.op_name})
      if (symbol) mark(symbol);
    for (const OriginElement& element : origin.matched)
      for (const Symbol symbol : {element.id, element.attribute, element.value}) mark(symbol);
  }
  for (const Past& past : past_) mark(past.attribute);
  for (const Pending& pending : pending_)
    for (const Symbol symbol : {pending.id, pending.attribute, pending.value}) mark(symbol);
}

// Recording -----------------------------------------------------------------------------------------------------------

bool Origins::IsOutput(Symbol id) const {
  return id == uses_.goal_changes.output_link();
}

bool Origins::GivesCommand(const Preference& preference) {
  const Instantiation& firing = uses_.instantiations[preference.instantiation];
  if (firing.serial == asked_serial_) return gives_command_;
  asked_serial_ = firing.serial;
  gives_command_ = false;
  for (PreferenceId p = firing.preferences; p != PreferenceId::kNone && !gives_command_;
       p = uses_.memory.preference(p).next_of_instantiation)
    gives_command_ = IsOutput(uses_.memory.preference(p).id);
  return gives_command_;
}

/// The preference for the same result in the lowest substate. Higher levels got the result from it by a justification
/// or a chunk.
const Preference& Origins::MadeBy(const Preference& preference) const {
  const Preference* made = &preference;
  const auto look = [&](PreferenceId p) {
    const Preference& clone = uses_.memory.preference(p);
    if (clone.level > made->level) made = &clone;
    return &clone;
  };
  const Preference* at = &preference;
  while (at->next_clone != PreferenceId::kNone) at = look(at->next_clone);
  at = &preference;
  while (at->previous_clone != PreferenceId::kNone) at = look(at->previous_clone);
  return *made;
}

std::span<const WmeId> Origins::MatchedBy(InstantiationId id) {
  const Instantiation& firing = uses_.instantiations[id];
  if (firing.match != MatchId::kNone) return uses_.rete.Wmes(firing.match);
  traced_.clear();
  for (const ConditionTrace& trace : uses_.instantiations.Trace(id)) traced_.push_back(trace.wme);
  return traced_;
}

/// The origin of the elements that a firing created: one for all of them in this elaboration. A new one has no
/// references yet.
std::uint32_t Origins::OriginOfFiring(const Preference& preference, std::uint32_t depth) {
  if (preference.instantiation == InstantiationId::kNone) return kNone;
  const Instantiation& firing = uses_.instantiations[preference.instantiation];
  if (firing.production == ProductionId::kNone) return kNone;
  if (depth == 0 && firing.serial == last_serial_ && last_origin_ != kNone) return last_origin_;
  const std::span<const WmeId> span = MatchedBy(preference.instantiation);
  const std::vector<WmeId> matched(span.begin(), span.end());

  const std::uint32_t place = Take();
  Hold(place);  // While it is being built.
  Origin made;
  made.rule = uses_.rete.production(firing.production);
  made.serial = firing.serial;
  made.o_supported = preference.o_supported;
  made.level = firing.level;
  made.state = firing.goal;
  if (depth == 0) {
    made.decision = uses_.counters.decision_phases;
    for (GoalLevel level = std::min(firing.level, static_cast<GoalLevel>(uses_.goals.depth())); level >= 1; --level) {
      const SlotId slot = uses_.goals.at(level).operator_slot;
      if (slot == SlotId::kNone || uses_.memory.slot(slot).wmes == WmeId::kNone) continue;
      made.op = uses_.memory.wme(uses_.memory.slot(slot).wmes).value;
      made.op_name = NameOf(made.op);
      made.op_origin = OfOperator(level);
      if (made.op_origin != kNone) Hold(made.op_origin);
      break;
    }
  }
  made.references = origins_[place].references;
  made.seen = origins_[place].seen;
  origins_[place] = std::move(made);
  std::vector<OriginElement> elements;
  for (const WmeId wme : matched) {
    if (elements.size() >= kMostMatched) {
      ++origins_[place].left_out;
      continue;
    }
    const Wme& content = uses_.memory.wme(wme);
    OriginElement element{
        content.id, content.attribute, content.value, content.timetag, content.acceptable, OriginElement::Source::kRule,
        kNone};
    const WmeKind kind = uses_.memory.record(wme).kind;
    if (kind == WmeKind::kInput) element.source = OriginElement::Source::kInput;
    if (kind == WmeKind::kArchitecture) element.source = OriginElement::Source::kArchitecture;
    if (content.live && element.source == OriginElement::Source::kRule) {
      element.origin = OriginOfElement(wme, depth + 1);
      if (element.origin != kNone) Hold(element.origin);
    }
    elements.push_back(element);
  }
  Origin& origin = origins_[place];
  origin.matched = std::move(elements);
  --origin.references;
  if (depth == 0) {
    last_serial_ = uses_.instantiations[preference.instantiation].serial;
    last_origin_ = place;
  }
  return place;
}

/// The origin of an element that a rule matched. An i-supported element has none, but its creator still matches:
/// records it now.
std::uint32_t Origins::OriginOfElement(WmeId wme, std::uint32_t depth) {
  const WmeRecord& record = uses_.memory.record(wme);
  const std::uint32_t old = Of(wme);
  if (old != kNone && origins_[old].o_supported) return old;
  // Elements ^operator have no origin of their own. OfOperator returns that of the selected operator.
  if (record.slot() == SlotId::kNone) return old;
  const Slot& slot = uses_.memory.slot(record.slot());
  if (slot.is_operator) return kNone;
  const Symbol value = uses_.memory.wme(wme).value;
  for (PreferenceId p = slot.acceptable; p != PreferenceId::kNone; p = uses_.memory.preference(p).next_in_slot) {
    const Preference& preference = uses_.memory.preference(p);
    if (preference.value != value) continue;
    if (old != kNone && origins_[old].serial == uses_.instantiations[preference.instantiation].serial) return old;
    if (depth > kDeepest || slot.acceptable_count > kMostMatched) return kNone;
    const std::uint32_t made = OriginOfFiring(MadeBy(preference), depth);
    if (made != kNone) Attach(wme, made);
    return made;
  }
  return old;
}

Symbol Origins::NameOf(Symbol op) const {
  return uses_.memory.ValueOf(op, words::kName);
}

void Origins::NoteSelected(GoalLevel level) {
  ForgetSelected(level);
  const Goal& goal = uses_.goals.at(level);
  if (goal.operator_slot == SlotId::kNone) return;
  const Slot& slot = uses_.memory.slot(goal.operator_slot);
  if (slot.wmes == WmeId::kNone) return;
  const Symbol op = uses_.memory.wme(slot.wmes).value;
  std::vector<PreferenceId> proposals;
  for (const PreferenceId first : {slot.acceptable, slot.others}) {
    for (PreferenceId p = first; p != PreferenceId::kNone; p = uses_.memory.preference(p).next_in_slot) {
      const Preference& preference = uses_.memory.preference(p);
      const bool proposes =
          preference.type == PreferenceType::kAcceptable || preference.type == PreferenceType::kRequire;
      if (proposes && preference.value == op && proposals.size() < kMostMatched) proposals.push_back(p);
    }
  }
  const std::uint32_t place = Take();
  Hold(place);  // For selected_ at this level.
  {
    Origin& origin = origins_[place];
    origin.is_operator = true;
    origin.decision = uses_.counters.decision_phases;
    origin.level = level;
    origin.state = goal.id;
    origin.op = op;
    origin.op_name = NameOf(op);
    if (describe_) origin.decided = describe_(goal);
    origin.attached = 1;
  }
  for (const PreferenceId p : proposals) {
    const std::uint32_t proposal = OriginOfFiring(MadeBy(uses_.memory.preference(p)), 1);
    if (proposal == kNone) continue;
    Hold(proposal);
    origins_[place].proposals.push_back(proposal);
  }
  if (selected_.size() <= level) selected_.resize(level + 1u, kNone);
  selected_[level] = place;
  CutBehind(place);
}

WmeId Origins::ElementOf(const Pending& pending) const {
  const SlotId id = uses_.memory.FindSlot(pending.id, pending.attribute);
  if (id == SlotId::kNone) return WmeId::kNone;
  const Slot& slot = uses_.memory.slot(id);
  if (slot.is_large) {
    const LargeSlot::Value* const known = uses_.memory.Large(id)->Find(pending.value);
    return known == nullptr ? WmeId::kNone : known->wme;
  }
  if (slot.is_operator) return WmeId::kNone;
  for (WmeId wme = slot.wmes; wme != WmeId::kNone; wme = uses_.memory.record(wme).next)
    if (uses_.memory.wme(wme).value == pending.value) return wme;
  return WmeId::kNone;
}

// References and freeing ----------------------------------------------------------------------------------------------

void Origins::Attach(WmeId wme, std::uint32_t origin) {
  if (of_.size() <= Index(wme)) of_.resize(Index(wme) + 1u, kNone);
  const std::uint32_t old = of_[Index(wme)];
  if (old == origin) return;
  Hold(origin);
  ++origins_[origin].attached;
  of_[Index(wme)] = origin;
  if (old != kNone) {
    --origins_[old].attached;
    Drop(old);
  }
}

void Origins::Detach(WmeId wme) {
  const std::uint32_t origin = Of(wme);
  if (origin == kNone) return;
  of_[Index(wme)] = kNone;
  --origins_[origin].attached;
  const Wme& content = uses_.memory.wme(wme);
  if (content.id == uses_.goal_changes.output_link()) {
    past_.push_back({content.attribute, content.timetag, origin});
    if (past_.size() <= kMostPast) return;
    const std::uint32_t oldest = past_.front().origin;
    past_.erase(past_.begin());
    Drop(oldest);
    return;
  }
  Drop(origin);
}

void Origins::ForgetSelected(GoalLevel level) {
  const std::uint32_t origin = OfOperator(level);
  if (origin == kNone) return;
  selected_[level] = kNone;
  --origins_[origin].attached;
  Drop(origin);
}

std::uint32_t Origins::Take() {
  if (free_.empty()) {
    origins_.emplace_back();
    free_.reserve(origins_.capacity());
    return static_cast<std::uint32_t>(origins_.size() - 1);
  }
  const std::uint32_t place = free_.back();
  free_.pop_back();
  return place;
}

void Origins::ReleaseLinks(std::uint32_t place, std::vector<std::uint32_t>& work) {
  Origin& origin = origins_[place];
  for (OriginElement& element : origin.matched)
    if (element.origin != kNone) work.push_back(std::exchange(element.origin, kNone));
  if (origin.op_origin != kNone) work.push_back(std::exchange(origin.op_origin, kNone));
  for (const std::uint32_t proposal : origin.proposals) work.push_back(proposal);
  origin.proposals.clear();
}

/// Chains of origins may be as long as the reasoning was, so this is a loop instead of a recursion.
void Origins::Drop(std::uint32_t dropped) {
  std::vector<std::uint32_t> work = std::exchange(work_, {});
  work.assign(1, dropped);
  while (!work.empty()) {
    const std::uint32_t place = work.back();
    work.pop_back();
    if (--origins_[place].references != 0) continue;
    ReleaseLinks(place, work);
    if (place == last_origin_) last_origin_ = kNone;
    const std::uint32_t seen = origins_[place].seen;
    origins_[place] = Origin{};
    origins_[place].seen = seen;
    free_.push_back(place);
  }
  work_ = std::move(work);
}

/// Limits the origins that can be reached from `first`. Visits them breadth first. If an origin is beyond the limits
/// and its elements were all removed, its own references to other origins are dropped.
void Origins::CutBehind(std::uint32_t first) {
  ++seen_;
  queue_.assign(1, {first, 0});
  origins_[first].seen = seen_;
  std::vector<std::uint32_t> dropped;
  for (std::size_t n = 0; n < queue_.size(); ++n) {
    const auto [place, distance] = queue_[n];
    if (distance >= kDeepest || n >= kMostBehind) {
      if (origins_[place].attached == 0) ReleaseLinks(place, dropped);
      continue;
    }
    const auto visit = [&, next = distance + 1](std::uint32_t to) {
      if (to == kNone || origins_[to].seen == seen_) return;
      origins_[to].seen = seen_;
      queue_.emplace_back(to, next);
    };
    for (const OriginElement& element : origins_[place].matched) visit(element.origin);
    visit(origins_[place].op_origin);
    for (const std::uint32_t proposal : origins_[place].proposals) visit(proposal);
  }
  for (const std::uint32_t origin : dropped) Drop(origin);
}

void Origins::Clear() {
  origins_.clear();
  free_.clear();
  of_.clear();
  selected_.clear();
  pending_.clear();
  past_.clear();
  installed_.clear();
  last_serial_ = asked_serial_ = 0;
  last_origin_ = kNone;
}

std::size_t Origins::Bytes() const {
  std::size_t bytes = origins_.capacity() * sizeof(Origin) +
                      (free_.capacity() + of_.capacity() + selected_.capacity()) * sizeof(std::uint32_t);
  for (const Origin& origin : origins_)
    bytes += origin.matched.capacity() * sizeof(OriginElement) + origin.decided.capacity() +
             origin.proposals.capacity() * sizeof(std::uint32_t);
  return bytes;
}

}  // namespace soarbox::kernel
