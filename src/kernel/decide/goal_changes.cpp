// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/goal_changes.h"

#include <algorithm>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/agent_core.h"
#include "kernel/decide/observers.h"

namespace soarbox::kernel {
namespace {

bool HasItems(ImpasseType impasse) {
  return impasse != ImpasseType::kNoChange && impasse != ImpasseType::kNone;
}

Symbol ImpasseName(ImpasseType impasse) {
  switch (impasse) {
    case ImpasseType::kTie:
      return words::kTie;
    case ImpasseType::kConflict:
      return words::kConflict;
    case ImpasseType::kConstraintFailure:
      return words::kConstraintFailure;
    case ImpasseType::kNoChange:
      return words::kNoChange;
    case ImpasseType::kNone:
      break;
  }
  return words::kNone;
}

}  // namespace

// Creating states -----------------------------------------------------------------------------------------------------

WmeId GoalChanges::AddSlotWme(Symbol id, Symbol attribute, Symbol value) {
  const SlotId slot = core_.memory.FindOrMakeSlot(id, attribute, false);
  return core_.changes.Add(WmeKind::kSlot, id, attribute, value, slot);
}

WmeId GoalChanges::AddArchitecture(Symbol id, Symbol attribute, Symbol value) {
  return core_.changes.Add(WmeKind::kArchitecture, id, attribute, value);
}

Symbol GoalChanges::AddModule(Symbol owner, Symbol attribute, char letter) {
  const Symbol module = core_.memory.NewIdentifier(letter, core_.memory.level(owner));
  AddSlotWme(owner, attribute, module);
  return module;
}

MemoryLink GoalChanges::AddMemoryLink(Symbol state, Symbol attribute, char letter) {
  MemoryLink memory;
  memory.link = AddModule(state, attribute, letter);
  memory.command = AddModule(memory.link, words::kCommand, 'C');
  memory.result = AddModule(memory.link, words::kResult, 'R');
  return memory;
}

Goal& GoalChanges::PushGoal() {
  Goal& goal = core_.goals.Push();
  goal.id = core_.memory.NewIdentifier('S', goal.level);
  core_.memory.SetGoal(goal.id, goal.level);
  goal.created_in_decision = core_.counters.decision_phases;
  return goal;
}

void GoalChanges::AddMemoryLinks(Goal& goal) {
  goal.reward_link = AddModule(goal.id, words::kRewardLink, 'R');
  goal.epmem = AddMemoryLink(goal.id, words::kEpmem, 'E');
  goal.epmem.present_id = AddSlotWme(goal.epmem.link, words::kPresentId, core_.symbols.Integer(present_id_));
  goal.smem = AddMemoryLink(goal.id, words::kSmem, 'L');
  // Created after the others, because an object's slots are shown newest first.
  goal.operator_slot = core_.memory.FindOrMakeSlot(goal.id, words::kOperator, true);
  if (core_.modules.Wants(ModuleHook::kStates)) core_.modules.StateMade(goal.level);
}

void GoalChanges::MakeTopState() {
  Goal& goal = PushGoal();
  AddArchitecture(goal.id, words::kType, words::kState);
  AddArchitecture(goal.id, words::kSuperstate, words::kNil);
  AddMemoryLinks(goal);
}

void GoalChanges::MakeIoLinks() {
  const Symbol top = core_.goals.top().id;
  const Symbol io = core_.memory.NewIdentifier('I', 1);
  input_link_ = core_.memory.NewIdentifier('I', 1);
  output_link_ = core_.memory.NewIdentifier('I', 1);
  core_.changes.Add(WmeKind::kInput, top, words::kIo, io);
  core_.changes.Add(WmeKind::kInput, io, words::kInputLink, input_link_);
  core_.changes.Add(WmeKind::kInput, io, words::kOutputLink, output_link_);
  core_.output.SetIdentifier(output_link_);
}

void GoalChanges::MakeSubstate(ImpasseType impasse, bool on_operator, std::span<const Candidate> candidates) {
  const Symbol superstate = core_.goals.bottom().id;
  Goal& goal = PushGoal();
  goal.impasse = impasse;
  goal.impasse_on_operator = on_operator;
  AddArchitecture(goal.id, words::kType, words::kState);
  AddArchitecture(goal.id, words::kSuperstate, superstate);
  AddMemoryLinks(goal);
  AddArchitecture(goal.id, words::kAttribute, on_operator ? words::kOperator : words::kState);
  AddArchitecture(goal.id, words::kImpasse, ImpasseName(impasse));
  const bool multiple = impasse == ImpasseType::kTie || impasse == ImpasseType::kConflict;
  AddArchitecture(goal.id, words::kChoices, multiple ? words::kMultiple : words::kNone);
  AddArchitecture(goal.id, words::kQuiescence, words::kT);
  if (HasItems(impasse)) UpdateItems(static_cast<GoalLevel>(goal.level - 1), candidates);
  if (core_.modules.Wants(ModuleHook::kStates)) core_.modules.StateComplete(core_.goals.bottom().level);
}

/// Visits ^item elements before ^non-numeric ones, each group newest first.
template <typename Visit>
void GoalChanges::ForEachItemInRemovalOrder(const Goal& goal, Visit visit) const {
  for (const bool non_numeric : {false, true}) {
    for (std::size_t n = goal.items.size(); n-- > 0;) {
      const Symbol attribute = core_.memory.wme(goal.items[n]).attribute;
      const bool is_non_numeric = attribute == words::kNonNumeric || attribute == words::kNonNumericCount;
      if (is_non_numeric == non_numeric) visit(goal.items[n]);
    }
  }
}

// Items ---------------------------------------------------------------------------------------------------------------

void GoalChanges::UpdateItems(GoalLevel level, std::span<const Candidate> candidates) {
  Goal& goal = core_.goals.at(static_cast<GoalLevel>(level + 1));
  WorkingMemory& memory = core_.memory;
  std::int64_t non_numeric = 0;
  for (const Candidate& candidate : candidates) non_numeric += candidate.is_numeric ? 0 : 1;
  const Symbol item_count = core_.symbols.Integer(static_cast<std::int64_t>(candidates.size()));
  const Symbol non_numeric_count = core_.symbols.Integer(non_numeric);

  const auto wanted = [&](const Wme& wme) {
    // The counts are always created again, even if they have not changed.
    if (wme.attribute == words::kItemCount || wme.attribute == words::kNonNumericCount) return false;
    return std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
      return candidate.value == wme.value && (wme.attribute == words::kItem || !candidate.is_numeric);
    });
  };
  kept_items_.clear();
  for (const WmeId item : goal.items) {
    if (wanted(memory.wme(item))) kept_items_.push_back(item);
  }
  ForEachItemInRemovalOrder(goal, [&](WmeId item) {
    if (!wanted(memory.wme(item))) core_.changes.Remove(item);
  });
  goal.items = kept_items_;
  // Soar counts a firing for each ^item and each ^non-numeric.
  const std::uint32_t firings = static_cast<std::uint32_t>(candidates.size()) + static_cast<std::uint32_t>(non_numeric);
  const bool told = core_.modules.Wants(ModuleHook::kStates);
  if (told) core_.modules.ItemsMade(firings);
  core_.instantiations.SkipSerials(firings);
  std::uint32_t firing = 0;
  const auto add = [&](Symbol attribute, Symbol value) {
    goal.items.push_back(AddArchitecture(goal.id, attribute, value));
    return goal.items.back();
  };
  const auto add_item = [&](Symbol attribute, Symbol value) {
    const bool present = std::any_of(kept_items_.begin(), kept_items_.end(), [&](WmeId item) {
      return memory.wme(item).attribute == attribute && memory.wme(item).value == value;
    });
    if (!present) {
      const WmeId item = add(attribute, value);
      if (told) core_.modules.ItemMade(item, firing);
    }
    ++firing;
  };
  for (const Candidate& candidate : candidates) add_item(words::kItem, candidate.value);
  add(words::kItemCount, item_count);
  for (const Candidate& candidate : candidates) {
    if (!candidate.is_numeric) add_item(words::kNonNumeric, candidate.value);
  }
  if (non_numeric > 0) add(words::kNonNumericCount, non_numeric_count);
}

WmeId GoalChanges::ProposalOfItem(WmeId item) const {
  const WorkingMemory& memory = core_.memory;
  const Wme& wme = memory.wme(item);
  if (wme.attribute != words::kItem && wme.attribute != words::kNonNumeric) return WmeId::kNone;
  const GoalLevel level = memory.goal_levels()[wme.id.index()];
  // The item may have been removed because its operator was dropped. It depends on the proposal nevertheless.
  const WmeKind kind = memory.record(item).kind;
  if (level < 2 || (kind != WmeKind::kArchitecture && kind != WmeKind::kFree)) return WmeId::kNone;
  const SlotId slot = core_.goals.at(static_cast<GoalLevel>(level - 1)).operator_slot;
  for (WmeId p = memory.slot(slot).acceptable_wmes; p != WmeId::kNone; p = memory.record(p).next) {
    if (memory.wme(p).value == wme.value) return p;
  }
  return WmeId::kNone;
}

// Removing states -----------------------------------------------------------------------------------------------------

void GoalChanges::RemoveFrom(GoalLevel level, GoalRemoval reason) {
  if (core_.goals.depth() < level) return;
  const auto tell = [&](GoalLevel gone, GoalRemoval why) {
    if (!core_.observers.Wants(Event::kDecision)) return;
    const GoalInfo info = core_.descriptions.Describe(core_.goals.at(gone));
    core_.observers.Notify(Event::kDecision, [&](Observer& o) { o.OnStateRemoved(core_.agent, info, why); });
  };
  tell(level, reason);
  while (core_.goals.depth() >= level) {
    const GoalLevel bottom = static_cast<GoalLevel>(core_.goals.depth());
    if (bottom > level) tell(bottom, GoalRemoval::kWithSuperstate);
    RemoveBottom();
  }
}

void GoalChanges::RemoveBottom() {
  const Goal& goal = core_.goals.bottom();
  if (core_.modules.Wants(ModuleHook::kStates)) core_.modules.StateEnds(goal.level);
  core_.run.GoalRemoved(goal.id);
  TakeBottomApart();
}

namespace {

/// Suppresses all events during its lifetime.
class Silence {
 public:
  Silence(Observers& observers, Agent& agent) : observers_(observers), kept_(agent) { std::swap(observers_, kept_); }
  ~Silence() { std::swap(observers_, kept_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  Observers& observers_;
  Observers kept_;
};

}  // namespace

void GoalChanges::TakeAllApart() {
  const Silence silence(core_.observers, core_.agent);
  while (!core_.goals.empty()) {
    // Substates end as in a running agent: their rewards count.
    const GoalLevel level = core_.goals.bottom().level;
    if (level > 1 && core_.modules.Wants(ModuleHook::kStates)) core_.modules.StateEnds(level);
    TakeBottomApart();
  }
  core_.elaboration.ApplyBufferedChanges();
}

void GoalChanges::TakeBottomApart() {
  WorkingMemory& memory = core_.memory;
  Goal& goal = core_.goals.at(static_cast<GoalLevel>(core_.goals.depth()));
  core_.selections.GoalRemoved(goal.level);
  // Before the removals below, because the set may contain elements of the goal itself.
  core_.gds.GoalRemoved(goal.level);
  while (goal.oldest_preference != PreferenceId::kNone) core_.preferences.LeaveGoal(goal.oldest_preference);
  if (core_.modules.Wants(ModuleHook::kStates)) core_.modules.StateRemoved(goal.level);
  const SlotId slot = goal.operator_slot;
  core_.preferences.RemoveSelected(slot);
  ForEachItemInRemovalOrder(goal, [&](WmeId item) { core_.changes.Remove(item); });
  goal.items.clear();
  while (memory.identifier(goal.id).architecture_wmes != WmeId::kNone) {
    core_.changes.Remove(memory.identifier(goal.id).architecture_wmes);
  }
  core_.decision.GoalRemoved(goal.level);
  core_.rete.matches().GoalRemoved(goal.level);
  memory.ClearGoal(goal.id);
  // UpdateAcceptables removes its elements of acceptable preferences, like those of other changed slots.
  core_.preferences.MarkChanged(slot);
  core_.links.Discard(goal.id);
  core_.goals.Pop();
}

void GoalChanges::CollectGarbage(Symbol id) {
  WorkingMemory& memory = core_.memory;
  core_.input.IdentifierGone(id);
  while (memory.identifier(id).input_wmes != WmeId::kNone) core_.changes.Remove(memory.identifier(id).input_wmes);
  for (SlotId slot = memory.identifier(id).slots; slot != SlotId::kNone; slot = memory.slot(slot).next) {
    while (memory.slot(slot).wmes != WmeId::kNone) core_.changes.Remove(memory.slot(slot).wmes);
    while (memory.slot(slot).acceptable != PreferenceId::kNone) core_.preferences.Retract(memory.slot(slot).acceptable);
    while (memory.slot(slot).others != PreferenceId::kNone) core_.preferences.Retract(memory.slot(slot).others);
    core_.preferences.empty_slots().push_back(slot);
  }
}

}  // namespace soarbox::kernel
