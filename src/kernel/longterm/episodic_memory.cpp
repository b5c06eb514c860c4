// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episodic_memory.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/agent_counters.h"
#include "kernel/decide/elaboration.h"
#include "kernel/decide/goal_changes.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/observers.h"
#include "kernel/io/output_link.h"
#include "kernel/longterm/journal.h"
#include "kernel/longterm/long_term.h"
#include "kernel/memory/wme_changes.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

EpisodicMemory::EpisodicMemory(const AgentParts& parts)
    : uses_(parts),
      recorder_({parts.memory, parts.goals, parts.symbols}, store_, terms_),
      commands_(parts, store_, terms_, settings_, counters_),
      writer_(store_, terms_) {}

EpisodicMemory::~EpisodicMemory() = default;

EpisodicMemory* EpisodicMemory::Find(LongTerm& long_term) {
  return static_cast<EpisodicMemory*>(long_term.module(LongTerm::ModuleKind::kEpisodic));
}

const EpisodicMemory* EpisodicMemory::Find(const LongTerm& long_term) {
  return static_cast<const EpisodicMemory*>(long_term.module(LongTerm::ModuleKind::kEpisodic));
}

EpisodicMemory& EpisodicMemory::Of(LongTerm& long_term) {
  if (Find(long_term) == nullptr) {
    long_term.Attach(LongTerm::ModuleKind::kEpisodic, std::make_unique<EpisodicMemory>(long_term.parts()));
  }
  return *Find(long_term);
}

// Settings ------------------------------------------------------------------------------------------------------------

void EpisodicMemory::SetLearning(bool on) {
  if (settings_.learning == on) return;
  settings_.learning = on;
  if (!on) return;
  // From now on changes are recorded, even while learning is disabled again, because episodes are stored as changes.
  uses_.long_term.SetHooks(LongTerm::ModuleKind::kEpisodic,
                           ModuleHook::kFlush | ModuleHook::kAfterDecision | ModuleHook::kOutput | ModuleHook::kStates);
  commands_.watch().Touch();
}

void EpisodicMemory::ToggleExclusion(std::string_view attribute) {
  const auto found = std::find(settings_.exclusions.begin(), settings_.exclusions.end(), attribute);
  if (found != settings_.exclusions.end()) {
    settings_.exclusions.erase(found);
  } else {
    settings_.exclusions.emplace_back(attribute);
  }
}

void EpisodicMemory::Forget() {
  store_.Clear();
  terms_.Clear();
  decisions_.clear();
  writer_.Restart();
  recorder_.Restart();
  commands_.ForgetRetrieved();
}

void EpisodicMemory::Close() {
  SetJournal(nullptr);  // Its destructor writes what was not written yet.
  Forget();
  counters_ = {};
  opened_ = false;
}

// The journal ---------------------------------------------------------------------------------------------------------

void EpisodicMemory::SetOpener(Opener opener, bool continues) {
  opener_ = std::move(opener);
  continues_ = continues;
}

Result<void> EpisodicMemory::TryOpen() {
  if (opened_ || !opener_) {
    opened_ = true;
    return {};
  }
  Result<void> result = opener_(*this);
  opened_ = result.ok();
  if (opened_) uses_.goal_changes.SetPresentId(store_.last() + std::int64_t{1});
  return result;
}

void EpisodicMemory::EnsureOpen() {
  if (opened_) return;
  const Result<void> result = TryOpen();
  opened_ = true;
  if (!result) uses_.observers.Print("Episodic memory continues without a file: " + Format(result.error()));
}

void EpisodicMemory::SetJournal(std::unique_ptr<Journal> journal) {
  journal_ = std::move(journal);
  warned_ = false;
}

/// Writes new episodes to the journal. After an error the journal tries again later; one warning is printed.
void EpisodicMemory::Keep() {
  if (journal_ == nullptr) return;
  journal_->Append(writer_.Write());
  const Result<void> kept = journal_->Commit();
  if (!kept && !warned_) uses_.observers.Print("Episodic memory: " + Format(kept.error()));
  warned_ = !kept;
}

std::string EpisodicMemory::Image() const {
  return EpisodeWriter(store_, terms_).Write();
}

bool EpisodicMemory::Load(std::string_view image, std::span<const std::string> records) {
  Forget();
  bool good = ReadEpisodes(image, store_, terms_);
  for (const std::string& record : records) good = good && ReadEpisodes(record, store_, terms_);
  if (!good) {
    Forget();
    return false;
  }
  writer_.SkipAll();
  decisions_.assign(store_.last(), 0);
  // The nodes of removed objects are reused.
  recorder_.Restart();
  return true;
}

// The cycle -----------------------------------------------------------------------------------------------------------

void EpisodicMemory::Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) {
  recorder_.Flushed(added, removed);
  commands_.watch().Flushed(uses_.memory.wmes(), added, removed);
}

void EpisodicMemory::AfterDecision() {
  if (settings_.learning && settings_.phase == EpisodicSettings::Phase::kSelection) Respond();
}

void EpisodicMemory::Output(bool /*output_changed*/) {
  if (settings_.learning && settings_.phase == EpisodicSettings::Phase::kOutput) Respond();
}

/// Whether an episode is due now.
bool EpisodicMemory::IsDue() {
  using Trigger = EpisodicSettings::Trigger;
  using Force = EpisodicSettings::Force;
  bool due = settings_.trigger == Trigger::kDecision;
  if (settings_.trigger == Trigger::kOutput) {
    const std::uint64_t before = newest_output_;
    for (const WmeId wme : uses_.memory.WmesOf(uses_.output.identifier())) {
      newest_output_ = std::max(newest_output_, uses_.memory.wme(wme).timetag);
    }
    due = newest_output_ > before;
  }
  if (settings_.force != Force::kOff) due = settings_.force == Force::kRemember;
  settings_.force = Force::kOff;
  return due;
}

void EpisodicMemory::Respond() {
  EnsureOpen();
  if (IsDue()) {
    recorder_.Record(settings_.exclusions);
    decisions_.push_back(static_cast<std::uint32_t>(uses_.counters.decision_phases));
    Keep();
    ShowTime();
  }
  // If only the time changed, matching waits for the next change of working memory.
  if (commands_.Process()) uses_.elaboration.ApplyWorkingMemoryChanges();
}

/// Sets the number of the next episode on every state's link.
void EpisodicMemory::ShowTime() {
  const std::int64_t next = store_.last() + std::int64_t{1};
  uses_.goal_changes.SetPresentId(next);
  const Symbol time = uses_.symbols.Integer(next);
  for (std::size_t level = 1; level <= uses_.goals.depth(); ++level) {
    MemoryLink& link = uses_.goals.at(static_cast<GoalLevel>(level)).epmem;
    if (uses_.memory.wme(link.present_id).value == time) continue;
    const SlotId slot = uses_.memory.FindSlot(link.link, words::kPresentId);
    uses_.changes.Remove(link.present_id);
    link.present_id = uses_.changes.Add(WmeKind::kSlot, link.link, words::kPresentId, time, slot);
  }
}

// Creation of states, init-soar ---------------------------------------------------------------------------------------

void EpisodicMemory::StateMade(GoalLevel /*level*/) {
  commands_.StateMade();
}

void EpisodicMemory::StateRemoved(GoalLevel level) {
  commands_.StateRemoved(level);
}

void EpisodicMemory::BeforeInit() {
  Close();
  if (continues_ && settings_.learning) EnsureOpen();
  uses_.goal_changes.SetPresentId(store_.last() + std::int64_t{1});
}

void EpisodicMemory::AfterInit() {
  commands_.Clear();
  recorder_.Restart();
  newest_output_ = 0;
}

void EpisodicMemory::Mark(const std::function<void(Symbol)>& /*mark*/) {
  terms_.ForgetSymbols();
}

void EpisodicMemory::IdentifierFreed(Symbol id) {
  commands_.watch().IdentifierFreed(id);
}

void EpisodicMemory::ForEachHeld(const std::function<void(PreferenceId)>& visit) const {
  commands_.ForEachHeld(visit);
}

void EpisodicMemory::LinkChanged(Symbol id) {
  recorder_.LinkChanged(id);
}

std::size_t EpisodicMemory::MemoryBytes() const {
  return sizeof(*this) + store_.MemoryBytes() + terms_.MemoryBytes();
}

}  // namespace soarbox::kernel
