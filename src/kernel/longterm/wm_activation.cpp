// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/wm_activation.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "kernel/decide/agent_counters.h"
#include "kernel/decide/elaboration.h"
#include "kernel/decide/goal_changes.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/observers.h"
#include "kernel/decide/preference_changes.h"
#include "kernel/learn/justification.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/semantic_memory.h"
#include "kernel/match/rete.h"
#include "kernel/memory/wme_changes.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

namespace {
/// The strength of an element without a history in the mean for a new element: activation 1.
constexpr double kWithoutHistory = 2.718281828459045;
/// The activation of an element whose uses have not been added yet.
constexpr double kUnused = -1e9;
}  // namespace

WmActivation& WmActivation::Of(LongTerm& long_term) {
  if (Module* const known = long_term.module(LongTerm::ModuleKind::kActivation)) {
    return static_cast<WmActivation&>(*known);
  }
  auto made = std::make_unique<WmActivation>(long_term);
  WmActivation& module = *made;
  long_term.Attach(LongTerm::ModuleKind::kActivation, std::move(made));
  return module;
}

const WmActivation* WmActivation::Find(const LongTerm& long_term) {
  return static_cast<const WmActivation*>(long_term.module(LongTerm::ModuleKind::kActivation));
}

WmActivation::WmActivation(LongTerm& long_term) : long_term_(long_term), uses_(long_term.parts()) {}

void WmActivation::SettingsChanged() {
  if (!settings_.activation) {
    histories_.clear();
    used_.clear();
    due_.clear();
    ReleaseGrounds();
    long_term_.SetHooks(LongTerm::ModuleKind::kActivation, 0);
    return;
  }
  long_term_.SetHooks(LongTerm::ModuleKind::kActivation, ModuleHook::kRulesFire | ModuleHook::kFlush |
                                                             ModuleHook::kAsserted | ModuleHook::kOutput |
                                                             ModuleHook::kOutputEnd);
}

std::uint64_t WmActivation::now() const {
  const std::uint64_t cycle = uses_.counters.decision_phases;
  return entered_ == cycle ? cycle + 1 : cycle;
}

// Activation ----------------------------------------------------------------------------------------------------------

double WmActivation::ActivationAt(const History& history, std::uint64_t cycle) const {
  return history.count == 0 ? 1 : std::log(StrengthAt(history, cycle));
}

double WmActivation::StrengthAt(const History& history, std::uint64_t cycle) const {
  const double d = settings_.decay_rate;
  const auto age = [&](std::uint64_t then) { return then >= cycle ? 1.0 : static_cast<double>(cycle - then); };
  double sum = 0;
  std::uint64_t kept = 0;
  for (std::size_t n = 0; n < history.count; ++n) {
    sum += static_cast<double>(history.uses[n]) * std::pow(age(history.cycles[n]), d);
    kept += history.uses[n];
  }
  if (settings_.petrov_approx && history.total > kept) {
    // The older uses are assumed to be evenly distributed between the first one and the oldest stored one.
    const double first = age(history.first), recent = age(history.cycles[history.count - 1u]);
    if (first > recent && d != -1) {
      sum += static_cast<double>(history.total - kept) * (std::pow(first, 1 + d) - std::pow(recent, 1 + d)) /
             ((1 + d) * (first - recent));
    }
  }
  return sum;
}

double WmActivation::Of(WmeId wme) const {
  const auto found = histories_.find(Index(wme));
  if (found == histories_.end() || found->second.timetag != uses_.memory.wme(wme).timetag) return 1;
  return found->second.count == 0 ? kUnused : ActivationAt(found->second, now());
}

bool WmActivation::IsForHistory(WmeId wme) const {
  const WmeRecord& record = uses_.memory.record(wme);
  return record.kind == WmeKind::kSlot && record.preference != PreferenceId::kNone &&
         uses_.memory.preference(record.preference).o_supported && !uses_.memory.slot(record.slot()).is_operator;
}

double WmActivation::OfNew(WmeId wme) const {
  return IsForHistory(wme) ? kUnused : 1;
}

const WmActivation::History* WmActivation::HistoryOf(WmeId wme) const {
  const auto found = histories_.find(Index(wme));
  if (found == histories_.end() || found->second.count == 0) return nullptr;
  return found->second.timetag == uses_.memory.wme(wme).timetag ? &found->second : nullptr;
}

// Uses ----------------------------------------------------------------------------------------------------------------

void WmActivation::Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) {
  const WorkingMemory& memory = uses_.memory;
  for (const WmeId wme : added) {
    if (!memory.wme(wme).live || !IsForHistory(wme)) continue;
    const Slot& slot = memory.slot(memory.record(wme).slot());
    std::uint64_t makers = 0;
    for (PreferenceId p : {slot.acceptable, slot.others}) {
      for (; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
        if (memory.preference(p).value == memory.wme(wme).value) ++makers;
      }
    }
    Follow(wme, makers);
  }
  for (const WmeId wme : removed) {
    ReleaseGroundsOf(wme);
    const auto known = histories_.find(Index(wme));
    const std::uint64_t timetag = memory.wme(wme).timetag;
    if (known == histories_.end() || known->second.timetag != timetag || known->second.gone) continue;
    known->second.gone = true;
    uses_.observers.Notify(Event::kActivation, [&](Observer& o) { o.OnFollowedGone(uses_.agent, timetag); });
  }
}

void WmActivation::Asserted(PreferenceId id) {
  const WorkingMemory& memory = uses_.memory;
  const Preference& preference = memory.preference(id);
  if (preference.type != PreferenceType::kAcceptable) return;
  for (WmeId wme = memory.slot(preference.slot).wmes; wme != WmeId::kNone; wme = memory.record(wme).next) {
    if (memory.wme(wme).value != preference.value) continue;
    Use(wme);
    // Traces and justifications store the elements on which they depend; matches of the top state do not.
    const Instantiation& maker = uses_.instantiations[preference.instantiation];
    if (!preference.o_supported || maker.level > 1 || maker.match == MatchId::kNone ||
        maker.justification != Instantiation::kNoJustification || HistoryOf(wme) != nullptr) {
      continue;
    }
    const std::span<const WmeId> grounds = uses_.rete.matches().Wmes(maker.match);
    for (const WmeId ground : grounds) uses_.changes.AddReference(ground);
    grounds_[Index(wme)].push_back({id, {grounds.begin(), grounds.end()}});
  }
}

void WmActivation::ReleaseGroundsOf(WmeId wme) {
  const auto known = grounds_.find(Index(wme));
  if (known == grounds_.end()) return;
  for (const Grounds& grounds : known->second) {
    for (const WmeId ground : grounds.elements) uses_.changes.DropReference(ground);
  }
  grounds_.erase(known);
}

void WmActivation::ReleaseGrounds() {
  while (!grounds_.empty()) ReleaseGroundsOf(static_cast<WmeId>(grounds_.begin()->first));
}

/// Starts the history of an element. The element counts as created now, even if it existed before without o-support.
void WmActivation::Follow(WmeId wme, std::uint64_t uses) {
  History history;
  history.pending = uses + MeanStrength(wme);
  history.timetag = uses_.memory.wme(wme).timetag;
  ReleaseGroundsOf(wme);
  histories_.insert_or_assign(Index(wme), history);
  used_.push_back(Index(wme));
  TellOfLink(wme);
  uses_.observers.Notify(Event::kActivation, [&](Observer& o) { o.OnFollowed(uses_.agent, wme); });
}

void WmActivation::Use(WmeId wme) {
  const WmeRecord& record = uses_.memory.record(wme);
  if (record.preference == PreferenceId::kNone) {
    const WmeId proposal = uses_.goal_changes.ProposalOfItem(wme);
    if (proposal != WmeId::kNone) Use(proposal);
    return;
  }
  if (!uses_.memory.preference(record.preference).o_supported) {
    UseWhatHolds(wme);
    return;
  }
  if (!uses_.memory.slot(record.slot()).is_operator) AddUse(wme);
}

void WmActivation::AddUse(WmeId wme) {
  const auto known = histories_.find(Index(wme));
  if (known == histories_.end() || known->second.timetag != uses_.memory.wme(wme).timetag) {
    Follow(wme, 1);
    return;
  }
  if (known->second.pending++ == 0) used_.push_back(Index(wme));
  TellOfLink(wme);
}

/// If the element links instances of stored objects, semantic memory is informed.
void WmActivation::TellOfLink(WmeId wme) {
  const Wme& element = uses_.memory.wme(wme);
  const std::span<const std::uint64_t> linked = uses_.memory.long_term_identifiers();
  if (!element.value.IsIdentifier() || linked[element.id.index()] == 0 || linked[element.value.index()] == 0) return;
  Module* const semantic = long_term_.module(LongTerm::ModuleKind::kSemantic);
  if (semantic == nullptr) return;
  static_cast<SemanticMemory&>(*semantic).LinkUsed(linked[element.id.index()], linked[element.value.index()],
                                                   uses_.counters.decision_phases);
}

/// Visits the elements on which the elements of open_ depend. Calls `held` with each that is or was o-supported, and
/// `other` with each that no rule created. Visits each element once.
template <class Held, class Other>
void WmActivation::ForWhatHolds(const Held& held, const Other& other) {
  const WorkingMemory& memory = uses_.memory;
  seen_.resize(memory.wmes().size(), 0);
  ++pass_;
  std::erase_if(open_, [&](WmeId wme) { return std::exchange(seen_[Index(wme)], pass_) == pass_; });
  while (!open_.empty()) {
    const WmeId next = open_.back();
    open_.pop_back();
    const WmeRecord& record = memory.record(next);
    if (record.preference == PreferenceId::kNone) {
      const WmeId proposal = uses_.goal_changes.ProposalOfItem(next);
      if (proposal == WmeId::kNone) {
        other(next);
      } else if (std::exchange(seen_[Index(proposal)], pass_) != pass_) {
        open_.push_back(proposal);
      }
      continue;
    }
    if (!memory.wme(next).live) {
      // A removed element has no creator any more, but it has its history.
      if (HistoryOf(next) != nullptr) held(next);
      continue;
    }
    const Preference& maker = memory.preference(record.preference);
    if (maker.o_supported) {
      if (!memory.slot(record.slot()).is_operator) held(next);
      continue;
    }
    const Instantiation& instantiation = uses_.instantiations[maker.instantiation];
    if (instantiation.match == MatchId::kNone) continue;
    for (const WmeId ground : uses_.rete.matches().Wmes(instantiation.match)) {
      if (seen_[Index(ground)] == pass_) continue;
      seen_[Index(ground)] = pass_;
      open_.push_back(ground);
    }
  }
}

/// Adds a use to each o-supported element on which an i-supported one depends.
void WmActivation::UseWhatHolds(WmeId wme) {
  open_.assign(1, wme);
  held_.clear();
  ForWhatHolds([&](WmeId held) { held_.push_back(held); }, [](WmeId) {});
  for (const WmeId held : held_) AddUse(held);
}

std::uint64_t WmActivation::OpenGrounds(WmeId wme, PreferenceId preference) {
  const InstantiationId maker = uses_.memory.preference(preference).instantiation;
  const auto open = [&](std::span<const WmeId> elements) {
    open_.insert(open_.end(), elements.begin(), elements.end());
  };
  // (Searches from the end, because the id of an instantiation without results may have been reused.)
  for (std::size_t n = answers_.size(); n-- > 0;) {
    if (answers_[n].instantiation != maker) continue;
    open(answers_[n].grounds);
    constexpr std::uint64_t kLinks = 3;  // Those that lead to the command and to the result.
    return kLinks;
  }
  if (const auto known = grounds_.find(Index(wme)); known != grounds_.end()) {
    for (const Grounds& grounds : known->second) {
      if (grounds.preference != preference) continue;
      open(grounds.elements);
      return 0;
    }
  }
  const Instantiation& instantiation = uses_.instantiations[maker];
  if (instantiation.justification != Instantiation::kNoJustification) {
    open(uses_.justifier.record(instantiation.justification).grounds);
  } else if (instantiation.match != MatchId::kNone) {
    open(uses_.rete.matches().Wmes(instantiation.match));
  } else {
    for (const ConditionTrace& trace : uses_.instantiations.Trace(maker)) {
      if (trace.wme != WmeId::kNone) open_.push_back(trace.wme);
    }
  }
  return 0;
}

std::uint64_t WmActivation::MeanStrength(WmeId wme) {
  const WorkingMemory& memory = uses_.memory;
  const Slot& slot = memory.slot(memory.record(wme).slot());
  const Symbol value = memory.wme(wme).value;
  open_.clear();
  std::uint64_t count = 0;
  for (PreferenceId p = slot.acceptable; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    const Preference& preference = memory.preference(p);
    if (preference.value == value && preference.o_supported) count = std::max(count, OpenGrounds(wme, p));
  }
  double sum = kWithoutHistory * static_cast<double>(count);
  const auto add = [&](WmeId ground) {
    const auto known = histories_.find(Index(ground));
    const bool is_known = known != histories_.end() && known->second.timetag == memory.wme(ground).timetag;
    if (is_known && known->second.count == 0) return;
    sum += is_known ? StrengthAt(known->second, now()) : kWithoutHistory;
    ++count;
  };
  ForWhatHolds(add, add);
  return count == 0 ? 0 : static_cast<std::uint64_t>(sum / static_cast<double>(count));
}

void WmActivation::NoteAnswer(InstantiationId answer, std::span<const WmeId> command) {
  if (!settings_.activation) return;
  Answer noted{answer, {}};
  for (const WmeId wme : command) {
    const WmeRecord& record = uses_.memory.record(wme);
    const bool is_link = record.kind != WmeKind::kInput && record.preference == PreferenceId::kNone;
    if (!is_link) noted.grounds.push_back(wme);
  }
  answers_.push_back(std::move(noted));
}

void WmActivation::RulesFire() {
  const MatchSet& matches = uses_.rete.matches();
  for (const MatchSet::List list : {MatchSet::List::kIAssertions, MatchSet::List::kOAssertions}) {
    for (const PendingMatch& match : matches.Pending(list)) {
      if (uses_.rete.production(match.production)->type == ProductionType::kJustification) continue;
      // Uses do not change the match set.
      for (const WmeId wme : matches.Wmes(match.match)) Use(wme);
    }
  }
}

// The output phase ----------------------------------------------------------------------------------------------------

void WmActivation::Enter(WmeId wme, History& history) {
  if (history.count == 0) history.first = now();
  std::copy_backward(history.cycles.begin(), history.cycles.end() - 1, history.cycles.end());
  std::copy_backward(history.uses.begin(), history.uses.end() - 1, history.uses.end());
  history.cycles[0] = now();
  history.uses[0] = history.pending;
  history.total += history.pending;
  history.pending = 0;
  if (history.count < kHistory) ++history.count;
  if (settings_.forgetting != WmaSettings::Forgetting::kBisection) return;
  // A use only postpones the due cycle: an element that becomes due is evaluated again then.
  const bool waits = history.due != 0;
  history.due = DueOf(history);
  if (!waits) due_[history.due].push_back(Index(wme));
}

void WmActivation::Output(bool) {
  for (const std::uint32_t index : used_) {
    const auto found = histories_.find(index);
    if (found == histories_.end() || found->second.gone || found->second.pending == 0) continue;
    const auto wme = static_cast<WmeId>(index);
    const std::uint64_t uses = found->second.pending;
    Enter(wme, found->second);
    uses_.observers.Notify(Event::kActivation,
                           [&](Observer& o) { o.OnUses(uses_.agent, uses_.memory.wme(wme).timetag, uses); });
  }
  used_.clear();
  entered_ = uses_.counters.decision_phases;
}

std::uint64_t WmActivation::DueOf(const History& history) const {
  std::uint64_t low = now(), step = 1;
  while (ActivationAt(history, low + step) >= settings_.decay_thresh && step < (std::uint64_t{1} << 40)) step *= 2;
  std::uint64_t high = low + step;
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (ActivationAt(history, middle) >= settings_.decay_thresh ? low : high) = middle;
  }
  return high;
}

bool WmActivation::Forget(WmeId wme) {
  const WorkingMemory& memory = uses_.memory;
  const Wme& element = memory.wme(wme);
  if (settings_.forget_linked_only && memory.long_term_identifiers()[element.id.index()] == 0) return false;
  ++forgotten_;
  if (settings_.fake_forgetting) return false;
  PreferenceId next;
  for (PreferenceId p = memory.slot(memory.record(wme).slot()).acceptable; p != PreferenceId::kNone; p = next) {
    next = memory.preference(p).next_in_slot;
    if (memory.preference(p).value == element.value && memory.preference(p).o_supported) uses_.preferences.Retract(p);
  }
  return true;
}

void WmActivation::OutputEnd() {
  if (settings_.forgetting == WmaSettings::Forgetting::kOff) return;
  const std::uint64_t cycle = uses_.counters.decision_phases;
  std::vector<std::uint32_t> low;
  if (settings_.forgetting == WmaSettings::Forgetting::kNaive) {
    for (const auto& [index, history] : histories_) {
      if (!history.gone && history.count > 0 && ActivationAt(history, cycle) < settings_.decay_thresh)
        low.push_back(index);
    }
  } else if (const auto due = due_.find(cycle); due != due_.end()) {
    const std::vector<std::uint32_t> candidates = std::move(due->second);
    due_.erase(due);
    for (const std::uint32_t index : candidates) {
      const auto found = histories_.find(index);
      if (found == histories_.end() || found->second.gone) continue;
      if (found->second.due > cycle) {
        due_[found->second.due].push_back(index);
      } else if (found->second.due == cycle) {
        low.push_back(index);
      }
    }
  }
  // Elements are forgotten in the order of their creation.
  std::ranges::sort(low, {}, [&](std::uint32_t index) { return uses_.memory.wmes()[index].timetag; });
  low.erase(std::unique(low.begin(), low.end()), low.end());
  bool any = false;
  for (const std::uint32_t index : low) any = Forget(static_cast<WmeId>(index)) || any;
  if (any) uses_.elaboration.ApplyWorkingMemoryChanges();
}

void WmActivation::AfterInit() {
  histories_.clear();
  used_.clear();
  entered_ = kNever;
  due_.clear();
  answers_.clear();
  seen_.clear();
  forgotten_ = 0;
}

std::size_t WmActivation::MemoryBytes() const {
  return sizeof(*this) + histories_.size() * (sizeof(History) + 32) + seen_.capacity() * 4 + used_.capacity() * 4;
}

}  // namespace soarbox::kernel
