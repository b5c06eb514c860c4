// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/module.h"
#include "kernel/longterm/agent_parts.h"
#include "kernel/longterm/episode_commands.h"
#include "kernel/longterm/episode_recorder.h"
#include "kernel/longterm/episode_records.h"
#include "kernel/longterm/episode_store.h"
#include "kernel/longterm/episode_terms.h"
#include "kernel/longterm/episodic_settings.h"

namespace soarbox::kernel {

class Journal;
class LongTerm;

/// Episodic memory of an agent: takes episodes of working memory, and brings them back when rules ask.
///
/// In the output phase (or at the end of the decide phase, by setting) an episode is taken if the trigger says so, and
/// then commands are answered, so that a query finds the episode just taken.
///
/// Episodes live in memory and go with init-soar. Who wants them to outlive the process gives an Opener: it is called
/// when the memory is used first, and again after it was closed.
class EpisodicMemory final : public Module {
 public:
  explicit EpisodicMemory(const AgentParts& parts);
  ~EpisodicMemory() override;

  /// The agent's; null while nobody has asked for it.
  static EpisodicMemory* Find(LongTerm& long_term);
  static const EpisodicMemory* Find(const LongTerm& long_term);
  /// The same, made if it is not there.
  static EpisodicMemory& Of(LongTerm& long_term);

  const EpisodicSettings& settings() const { return settings_; }
  /// For all but `learning`.
  EpisodicSettings& mutable_settings() { return settings_; }
  void SetLearning(bool on);
  /// On the list of exclusions, or off it if it was there.
  void ToggleExclusion(std::string_view attribute);

  const EpisodeStore& store() const { return store_; }
  const EpisodeTerms& terms() const { return terms_; }
  const EpisodicCounters& counters() const { return counters_; }
  /// The decision in which an episode, which exists, was taken; 0: in an earlier run.
  std::uint64_t DecisionOf(EpisodeNumber episode) const { return decisions_[episode - 1]; }
  /// The number that the next episode will have.
  EpisodeNumber time() const { return store_.last() + 1; }
  /// `trace --epmem`.
  void SetTrace(bool on) { commands_.SetTrace(on); }
  /// Closes the file, if there is one, which keeps what it has, and begins anew without episodes.
  void Close();

  // The journal -----------------------------------------------------------------------------------------------------

  /// Opens the file: takes over what it holds (Load), and gives the memory its journal (SetJournal). `continues`: what
  /// it holds goes on (append) and is to be opened as soon as a run begins anew. Null: episodes stay in memory.
  using Opener = std::function<Result<void>(EpisodicMemory&)>;
  void SetOpener(Opener opener, bool continues);
  /// Calls the opener if the memory was not used yet. A failure is printed, and the memory goes on without a file.
  void EnsureOpen();
  /// The same; a failure is the caller's to tell.
  Result<void> TryOpen();
  bool opened() const { return opened_; }
  /// From now on all episodes go to the journal, which holds those that there are. Null: none.
  void SetJournal(std::unique_ptr<Journal> journal);
  Journal* journal() const { return journal_.get(); }
  /// All episodes as a record for a journal; and the way back. False if the records make no sense: there are no
  /// episodes then.
  std::string Image() const;
  bool Load(std::string_view image, std::span<const std::string> records);

  void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) override;
  void AfterDecision() override;
  void Output(bool output_changed) override;
  void StateMade(GoalLevel level) override;
  void StateRemoved(GoalLevel level) override;
  void BeforeInit() override;
  void AfterInit() override;
  void Mark(const std::function<void(Symbol)>& mark) override;
  void IdentifierFreed(Symbol id) override;
  void ForEachHeld(const std::function<void(PreferenceId)>& visit) const override;
  void LinkChanged(Symbol id) override;
  std::size_t MemoryBytes() const override;

 private:
  void Respond();
  bool IsDue();
  void ShowTime();
  void Forget();
  void Keep();

  AgentParts uses_;
  EpisodicSettings settings_;
  EpisodicCounters counters_;
  EpisodeStore store_;
  EpisodeTerms terms_;
  EpisodeRecorder recorder_;
  EpisodeCommands commands_;
  std::vector<std::uint32_t> decisions_;  ///< By episode, from 0.
  EpisodeWriter writer_;
  std::unique_ptr<Journal> journal_;
  Opener opener_;
  bool continues_ = false, opened_ = false;
  bool warned_ = false;              ///< Of a journal that cannot be written.
  std::uint64_t newest_output_ = 0;  ///< Time tag of the newest element on the output link when last looked at.
};

}  // namespace soarbox::kernel
