// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/invariants.h"

#include <algorithm>
#include <vector>

#include "kernel/decide/agent_core.h"

namespace soarbox::kernel {
namespace {

std::string Name(const AgentCore& core, WmeId wme) {
  const Wme& content = core.memory.wme(wme);
  return "(" + std::to_string(content.timetag) + ": " + ToString(core.symbols, content.id) + " ^" +
         ToString(core.symbols, content.attribute) + " " + ToString(core.symbols, content.value) + ")";
}

/// The values of a slot. Reused for all slots, so that memory is allocated once.
struct SlotValues {
  std::vector<std::uint32_t> accepted, rejected, elements;
};

std::string CheckSlot(const AgentCore& core, SlotId id, SlotValues& found) {
  const WorkingMemory& memory = core.memory;
  const Slot& slot = memory.slot(id);
  if (memory.FindSlot(slot.id, slot.attribute) != id) return "a slot is not found by its identifier and attribute";
  auto& [accepted, rejected, values] = found;
  for (std::vector<std::uint32_t>* some : {&accepted, &rejected, &values}) some->clear();
  std::uint32_t count = 0;
  for (PreferenceId p = slot.acceptable; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot, ++count) {
    if (!memory.preference(p).live || !memory.preference(p).in_slot) return "a slot holds a preference that is gone";
    accepted.push_back(memory.preference(p).value.bits());
  }
  if (count != slot.acceptable_count) return "a slot miscounts its acceptable preferences";
  for (PreferenceId p = slot.others; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    if (!memory.preference(p).live || !memory.preference(p).in_slot) return "a slot holds a preference that is gone";
    const PreferenceType type = memory.preference(p).type;
    if (type == PreferenceType::kReject || type == PreferenceType::kProhibit) {
      rejected.push_back(memory.preference(p).value.bits());
    }
  }
  for (WmeId wme = slot.wmes; wme != WmeId::kNone; wme = memory.record(wme).next) {
    if (!memory.wme(wme).live) return "a slot holds an element that is gone";
    values.push_back(memory.wme(wme).value.bits());
    const PreferenceId preference = memory.record(wme).preference;
    if (preference == PreferenceId::kNone || slot.is_operator || slot.changed) continue;
    if (!memory.preference(preference).in_slot) return "no preference supports " + Name(core, wme);
  }
  if (slot.is_operator || slot.changed || slot.lost_by_hand) return {};
  for (std::vector<std::uint32_t>* some : {&rejected, &values}) std::sort(some->begin(), some->end());
  for (const std::uint32_t value : accepted) {
    const auto is_among = [value](const std::vector<std::uint32_t>& sorted) {
      return std::binary_search(sorted.begin(), sorted.end(), value);
    };
    if (!is_among(rejected) && !is_among(values)) {
      return "an accepted value of " + ToString(core.symbols, slot.id) + " ^" + ToString(core.symbols, slot.attribute) +
             " has no element";
    }
  }
  return {};
}

}  // namespace

std::string FindViolation(const AgentCore& core) {
  if (core.run.broken()) return {};  // It stopped in the middle of a change and has no matches.
  if (!core.memory.LargeSlotsAreRight()) return "a large slot miscounts its facts";
  const WorkingMemory& memory = core.memory;
  std::string violation;
  SlotValues values;
  memory.ForEachSlot([&](SlotId slot) {
    if (violation.empty()) violation = CheckSlot(core, slot, values);
  });
  if (!violation.empty()) return violation;
  std::uint32_t live = 0;
  for (std::uint32_t index = 0; index < memory.wmes().size(); ++index) {
    const WmeId wme = static_cast<WmeId>(index);
    if (!memory.wme(wme).live) continue;
    ++live;
    if (!memory.record(wme).in_match && core.changes.empty()) return Name(core, wme) + " is not in the match";
    const GoalLevel gds = memory.record(wme).gds;
    if (gds > core.goals.depth() && gds != kGoalOfGdsGone)
      return Name(core, wme) + " is in the dependency set of a goal that is gone";
  }
  if (live != memory.wme_count()) return "the number of elements is wrong";
  for (GoalLevel level = 1; level <= core.goals.depth(); ++level) {
    const Goal& goal = core.goals.at(level);
    if (memory.level(goal.id) != level || !memory.identifier(goal.id).is_goal) return "a goal has the wrong level";
  }
  violation = core.links.CheckInvariants(core.symbols);
  if (!violation.empty()) return violation;
  return core.rete.CheckInvariants();
}

}  // namespace soarbox::kernel
