// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/origins.h"

#include <algorithm>
#include <array>
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
  if (!is_module_) uses_.modules.Attach(*this, kPlace);
  is_module_ = on_ = true;
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
  if (installed_.empty() && origins_.size() < next_collection_) return;
  Guarded([&] {
    if (origins_.size() >= next_collection_) Collect();
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
    pending_.clear();
  });
}

void Origins::Flushed(std::span<const WmeId>, std::span<const WmeId> removed) {
  for (const WmeId wme : removed) {
    const std::uint32_t origin = Of(wme);
    if (origin == kNone) continue;
    of_[Index(wme)] = kNone;
    const Wme& content = uses_.memory.wme(wme);
    if (!IsOutput(content.id)) continue;
    Guarded([&] {
      if (past_.size() == kMostPast) past_.erase(past_.begin());
      past_.push_back({content.attribute, content.timetag, origin});
    });
  }
}

void Origins::StateRemoved(GoalLevel level) {
  ForgetSelected(level);
}

void Origins::BeforeInit() {
  Clear();
}

void Origins::Mark(const std::function<void(Symbol)>& mark) {
  if (origins_.empty()) return;
  Guarded([&] { Collect(); });
  for (const Origin& origin : origins_)
    for (const Symbol symbol : {origin.state, origin.op, origin.op_name})
      if (symbol) mark(symbol);
  for (const OriginElement& element : elements_)
    for (const Symbol symbol : {element.id, element.attribute, element.value}) mark(symbol);
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

/// The origin of the elements that a firing created: one for all of them in this elaboration.
std::uint32_t Origins::OriginOfFiring(const Preference& preference, std::uint32_t depth) {
  if (preference.instantiation == InstantiationId::kNone) return kNone;
  const Instantiation& firing = uses_.instantiations[preference.instantiation];
  if (firing.production == ProductionId::kNone) return kNone;
  if (depth == 0 && firing.serial == last_serial_ && last_origin_ != kNone) return last_origin_;

  // The origins of the matched elements come first. Recording one may change traced_.
  const std::span<const WmeId> all = MatchedBy(preference.instantiation);
  const std::size_t count = std::min(all.size(), kMostMatched);
  std::array<WmeId, kMostMatched> matched;
  std::array<std::uint32_t, kMostMatched> origins;
  std::copy_n(all.begin(), count, matched.begin());
  Origin made;
  made.left_out = static_cast<std::uint32_t>(all.size() - count);
  for (std::size_t i = 0; i < count; ++i) {
    const WmeKind kind = uses_.memory.record(matched[i]).kind;
    const bool is_by_rule = kind != WmeKind::kInput && kind != WmeKind::kArchitecture;
    origins[i] = is_by_rule && uses_.memory.wme(matched[i]).live ? OriginOfElement(matched[i], depth + 1) : kNone;
  }

  made.rule = Hold(firing.production);
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
      break;
    }
  }
  const std::uint32_t place = AddFiring(made, {matched.data(), count}, {origins.data(), count});
  if (depth == 0) {
    last_serial_ = firing.serial;
    last_origin_ = place;
  }
  return place;
}

std::uint32_t Origins::AddFiring(const Origin& made, std::span<const WmeId> matched,
                                 std::span<const std::uint32_t> origins) {
  const auto first = static_cast<std::uint32_t>(elements_.size());
  for (std::size_t i = 0; i < matched.size(); ++i) {
    const Wme& content = uses_.memory.wme(matched[i]);
    const WmeKind kind = uses_.memory.record(matched[i]).kind;
    using enum OriginElement::Source;
    const OriginElement::Source source = kind == WmeKind::kInput          ? kInput
                                         : kind == WmeKind::kArchitecture ? kArchitecture
                                                                          : kRule;
    elements_.push_back(
        {content.id, content.attribute, content.value, content.timetag, content.acceptable, source, origins[i]});
  }
  const auto place = static_cast<std::uint32_t>(origins_.size());
  Origin& added = origins_.emplace_back(made);
  added.first = first;
  added.count = static_cast<std::uint32_t>(matched.size());
  return place;
}

/// Keeps the rule until no origin refers to it.
const Production* Origins::Hold(ProductionId id) {
  const ProductionPtr& rule = uses_.rete.production(id);
  if (rule_places_.size() <= Index(id)) rule_places_.resize(Index(id) + 1u, kNone);
  std::uint32_t& place = rule_places_[Index(id)];
  // The number may belong to another rule now.
  if (place == kNone || rules_[place] != rule) {
    place = static_cast<std::uint32_t>(rules_.size());
    rules_.push_back(rule);
  }
  return rule.get();
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
  std::array<std::uint32_t, kMostMatched> proposals;
  std::uint32_t count = 0, left = kMostMatched;
  for (const PreferenceId first : {slot.acceptable, slot.others}) {
    for (PreferenceId p = first; p != PreferenceId::kNone && left > 0; p = uses_.memory.preference(p).next_in_slot) {
      const Preference& preference = uses_.memory.preference(p);
      const bool proposes =
          preference.type == PreferenceType::kAcceptable || preference.type == PreferenceType::kRequire;
      if (!proposes || preference.value != op) continue;
      --left;
      proposals[count] = OriginOfFiring(MadeBy(preference), 1);
      if (proposals[count] != kNone) ++count;
    }
  }
  Origin made;
  made.is_operator = true;
  made.decision = uses_.counters.decision_phases;
  made.level = level;
  made.state = goal.id;
  made.op = op;
  made.op_name = NameOf(op);
  made.first = static_cast<std::uint32_t>(proposals_.size());
  made.count = count;
  made.text = static_cast<std::uint32_t>(texts_.size());
  if (describe_) texts_ += describe_(goal);
  made.text_size = static_cast<std::uint32_t>(texts_.size()) - made.text;
  proposals_.insert(proposals_.end(), proposals.begin(), proposals.begin() + count);
  origins_.push_back(made);
  if (selected_.size() <= level) selected_.resize(level + 1u, kNone);
  selected_[level] = static_cast<std::uint32_t>(origins_.size() - 1);
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
  if (of_[Index(wme)] == origin) return;
  of_[Index(wme)] = origin;
  attached_.push_back({wme, origin});
}

/// Whether a live element or a selected operator has this origin.
bool Origins::IsAttached(std::uint32_t origin) const {
  return std::ranges::find(selected_, origin) != selected_.end() ||
         std::ranges::any_of(attached_,
                             [&](const Attached& it) { return it.origin == origin && Of(it.wme) == origin; });
}

void Origins::ForgetSelected(GoalLevel level) {
  if (level < selected_.size()) selected_[level] = kNone;
}

/// Removes the origins that are no longer needed. Changes the indices of the others.
void Origins::Collect() {
  FindNeeded();
  KeepNeeded();
  next_collection_ = std::max(kLeastRoom, 3 * origins_.size());
  if (rules_.size() >= next_rules_) ForgetUnusedRules();
}

void Origins::FindNeeded() {
  std::erase_if(attached_, [&](const Attached& it) { return Of(it.wme) != it.origin; });
  needs_.assign(origins_.size(), Need::kNone);
  seen_.assign(origins_.size(), kNone);
  const auto add_root = [&](std::uint32_t origin) {
    if (origin != kNone) needs_[origin] = Need::kRoot;
  };
  for (const Attached& attached : attached_) add_root(attached.origin);
  for (const std::uint32_t origin : selected_) add_root(origin);
  for (const Pending& pending : pending_) add_root(pending.origin);
  for (const Past& past : past_) add_root(past.origin);
  for (std::uint32_t origin = 0; origin < needs_.size(); ++origin)
    if (needs_[origin] == Need::kRoot) FindBehind(origin);
}

/// Visits the origins that a root leads to, breadth first, up to other roots.
void Origins::FindBehind(std::uint32_t root) {
  queue_.assign(1, {root, 0});
  for (std::size_t n = 0; n < queue_.size(); ++n) {
    const auto [place, distance] = queue_[n];
    if (distance >= kDeepest || n >= kMostBehind) break;
    const auto visit = [&, next = distance + 1](std::uint32_t to) {
      if (to == kNone || seen_[to] == root || needs_[to] == Need::kRoot) return;
      seen_[to] = root;
      needs_[to] = Need::kKept;
      queue_.emplace_back(to, next);
    };
    const Origin& origin = origins_[place];
    for (const OriginElement& element : Matched(origin)) visit(element.origin);
    visit(origin.op_origin);
    for (const std::uint32_t proposal : Proposals(origin)) visit(proposal);
  }
}

/// Moves the needed origins to the beginning, in their order.
void Origins::KeepNeeded() {
  places_.assign(origins_.size(), kNone);
  const auto place_of = [&](std::uint32_t origin) { return origin == kNone ? kNone : places_[origin]; };
  std::uint32_t kept = 0, elements = 0, proposals = 0, texts = 0;
  for (std::uint32_t from = 0; from < origins_.size(); ++from) {
    if (needs_[from] == Need::kNone) continue;
    places_[from] = kept;
    Origin& origin = origins_[kept++] = origins_[from];
    const std::uint32_t first = origin.first;
    origin.op_origin = place_of(origin.op_origin);
    if (!origin.is_operator) {
      origin.first = elements;
      for (std::uint32_t i = 0; i < origin.count; ++i) {
        OriginElement& element = elements_[elements++] = elements_[first + i];
        element.origin = place_of(element.origin);
      }
      continue;
    }
    origin.first = proposals;
    for (std::uint32_t i = 0; i < origin.count; ++i)
      if (const std::uint32_t proposal = place_of(proposals_[first + i]); proposal != kNone)
        proposals_[proposals++] = proposal;
    origin.count = proposals - origin.first;
    std::copy_n(texts_.begin() + origin.text, origin.text_size, texts_.begin() + texts);
    origin.text = texts;
    texts += origin.text_size;
  }
  origins_.resize(kept);
  elements_.resize(elements);
  proposals_.resize(proposals);
  texts_.resize(texts);
  for (Attached& attached : attached_) of_[Index(attached.wme)] = attached.origin = place_of(attached.origin);
  for (std::uint32_t& origin : selected_) origin = place_of(origin);
  for (Pending& pending : pending_) pending.origin = place_of(pending.origin);
  for (Past& past : past_) past.origin = place_of(past.origin);
  last_origin_ = place_of(last_origin_);
}

void Origins::ForgetUnusedRules() {
  std::vector<const Production*> used;
  for (const Origin& origin : origins_) used.push_back(origin.rule);
  std::ranges::sort(used);
  std::erase_if(rules_, [&](const ProductionPtr& rule) { return !std::ranges::binary_search(used, rule.get()); });
  std::ranges::fill(rule_places_, kNone);
  next_rules_ = std::max(kLeastRoom, 2 * rules_.size());
}

void Origins::Clear() {
  origins_.clear();
  elements_.clear();
  proposals_.clear();
  texts_.clear();
  of_.clear();
  selected_.clear();
  attached_.clear();
  pending_.clear();
  past_.clear();
  installed_.clear();
  rules_.clear();
  rule_places_.clear();
  next_collection_ = next_rules_ = kLeastRoom;
  last_serial_ = asked_serial_ = 0;
  last_origin_ = kNone;
}

std::size_t Origins::Bytes() const {
  return origins_.capacity() * sizeof(Origin) + elements_.capacity() * sizeof(OriginElement) + texts_.capacity() +
         attached_.capacity() * sizeof(Attached) + rules_.capacity() * sizeof(ProductionPtr) +
         (proposals_.capacity() + of_.capacity() + selected_.capacity() + rule_places_.capacity() + seen_.capacity() +
          places_.capacity()) *
             sizeof(std::uint32_t);
}

}  // namespace soarbox::kernel
