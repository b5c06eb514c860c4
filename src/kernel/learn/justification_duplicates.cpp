// SPDX-License-Identifier: BSD-2-Clause
// A justification with the same contents as a live one is not created. If a rule causes too many duplicates in a
// decision, nothing more is learned from it in that decision.
#include <algorithm>
#include <utility>

#include "kernel/decide/agent_counters.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/learn/justification.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

std::uint32_t Justifier::Digest(const Explanation& explanation) const {
  const WorkingMemory& memory = uses_.memory;
  std::uint32_t digest = static_cast<std::uint32_t>(explanation.negations.size());
  const auto mix = [&](Symbol symbol) {
    digest = (digest ^ symbol.bits()) * 0x85EBCA6Bu;
    digest ^= digest >> 15;
  };
  for (const Explanation::Ground& ground : explanation.grounds) {
    mix(memory.wme(ground.wme).id);
    mix(memory.wme(ground.wme).attribute);
    mix(memory.wme(ground.wme).value);
  }
  for (const PreferenceId result : explanation.results) {
    mix(memory.preference(result).id);
    mix(memory.preference(result).attribute);
    mix(memory.preference(result).value);
  }
  return digest;
}

Justifier::Record::Result Justifier::ResultOf(PreferenceId id) const {
  const Preference& p = uses_.memory.preference(id);
  return {p.id, p.attribute, p.value, p.referent, p.type};
}

bool Justifier::SaysTheSame(const Record& record, const Explanation& explanation) const {
  const WorkingMemory& memory = uses_.memory;
  const auto same_element = [&](WmeId a, const Explanation::Ground& b) {
    const Wme &x = memory.wme(a), &y = memory.wme(b.wme);
    return x.id == y.id && x.attribute == y.attribute && x.value == y.value && x.acceptable == y.acceptable;
  };
  if (!std::ranges::equal(record.grounds, explanation.grounds, same_element)) return false;
  const std::size_t negated = record.negations == nullptr ? 0 : record.negations->conditions.size();
  if (negated != explanation.negations.size()) return false;
  if (negated > 0) {
    RuleDraft mine;
    std::vector<ConditionDraft> copies;
    for (const Explanation::Negation& negation : explanation.negations) copies.push_back(negation.literal);
    for (ConditionDraft& negation : copies) mine.conditions.Add(&negation);
    if (!std::ranges::equal(record.negations->conditions, Production::Make(mine)->conditions)) return false;
  }
  return std::ranges::equal(record.results, explanation.results, [&](const Record::Result& known, PreferenceId result) {
    return known == ResultOf(result);
  });
}

std::uint32_t Justifier::OriginalOf(const Explanation& explanation, std::uint32_t digest) const {
  if (alike_.empty()) return 0xFFFFFFFFu;
  for (std::uint32_t index = alike_[digest & (alike_.size() - 1)]; index != 0xFFFFFFFFu;
       index = records_[index].next_alike) {
    if (records_[index].digest == digest && SaysTheSame(records_[index], explanation)) return index;
  }
  return 0xFFFFFFFFu;
}

void Justifier::NoteAlike(std::uint32_t index) {
  const auto insert = [&](std::uint32_t record) {
    std::uint32_t& head = alike_[records_[record].digest & (alike_.size() - 1)];
    records_[record].next_alike = head;
    head = record;
  };
  if (++alike_count_ > alike_.size()) {
    std::vector<std::uint32_t> old(std::max<std::size_t>(16, 2 * alike_.size()), 0xFFFFFFFFu);
    old.swap(alike_);
    for (std::uint32_t record : old) {
      while (record != 0xFFFFFFFFu) insert(std::exchange(record, records_[record].next_alike));
    }
  }
  insert(index);
}

void Justifier::ForgetAlike(std::uint32_t index) {
  std::uint32_t* place = &alike_[records_[index].digest & (alike_.size() - 1)];
  while (*place != index) place = &records_[*place].next_alike;
  *place = records_[index].next_alike;
  --alike_count_;
}

bool Justifier::HasTooManyDuplicates(InstantiationId base, std::uint32_t most) const {
  if (duplicates_.empty()) return false;
  const auto found = duplicates_.find(uses_.instantiations[base].production);
  return found != duplicates_.end() && found->second.cycle == uses_.counters.decision_cycles &&
         found->second.count >= most;
}

void Justifier::CountDuplicate(InstantiationId base) {
  const ProductionId rule = uses_.instantiations[base].production;
  if (rule == ProductionId::kNone) return;
  Duplicates& known = duplicates_[rule];
  if (known.cycle != uses_.counters.decision_cycles) known = {uses_.counters.decision_cycles, 0};
  ++known.count;
}

}  // namespace soarbox::kernel
