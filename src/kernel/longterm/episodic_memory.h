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

/// Episodic memory of an agent: records episodes of working memory, and retrieves them for commands of rules.
///
/// In the output phase (or, by setting, at the end of the decide phase) it records an episode if the trigger requires
/// one. Then it executes commands, so that a query can find the new episode.
///
/// Episodes are in memory and are removed by init-soar. To keep them in a file, set an Opener. It is called at the
/// first use of the memory, and again after the memory was closed.
class EpisodicMemory final : public Module {
 public:
  explicit EpisodicMemory(const AgentParts& parts);
  ~EpisodicMemory() override;

  /// The agent's episodic memory; null if it was not created.
  static EpisodicMemory* Find(LongTerm& long_term);
  static const EpisodicMemory* Find(const LongTerm& long_term);
  /// The agent's episodic memory; created if it does not exist.
  static EpisodicMemory& Of(LongTerm& long_term);

  const EpisodicSettings& settings() const { return settings_; }
  /// For all settings but `learning`.
  EpisodicSettings& mutable_settings() { return settings_; }
  void SetLearning(bool on);
  /// Adds the attribute to the exclusions, or removes it if it was there.
  void ToggleExclusion(std::string_view attribute);

  const EpisodeStore& store() const { return store_; }
  const EpisodeTerms& terms() const { return terms_; }
  const EpisodicCounters& counters() const { return counters_; }
  /// The decision in which an episode was recorded; 0 if it was loaded. The episode must exist.
  std::uint64_t DecisionOf(EpisodeNumber episode) const { return decisions_[episode - 1]; }
  /// The number that the next episode will have.
  EpisodeNumber time() const { return store_.last() + 1; }
  /// Enables `trace --epmem`.
  void SetTrace(bool on) { commands_.SetTrace(on); }
  /// Closes the file, if any, which keeps its contents, and continues without episodes.
  void Close();

  // The journal -----------------------------------------------------------------------------------------------------

  /// Opens the file: loads its contents (Load), and gives the memory its journal (SetJournal). `continues`: new
  /// episodes follow those in the file (append), so init-soar opens the file again at once. Null: episodes are only in
  /// memory.
  using Opener = std::function<Result<void>(EpisodicMemory&)>;
  void SetOpener(Opener opener, bool continues);
  /// Calls the opener if the memory was not used yet. An error is printed, and the memory works without a file.
  void EnsureOpen();
  /// Like EnsureOpen, but returns the error.
  Result<void> TryOpen();
  bool opened() const { return opened_; }
  /// From now on all episodes are written to the journal, which must contain the existing ones. Null: none.
  void SetJournal(std::unique_ptr<Journal> journal);
  Journal* journal() const { return journal_.get(); }
  /// All episodes as a record for a journal, and the inverse. Load returns false if the records are invalid; then there
  /// are no episodes.
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
  bool warned_ = false;              ///< A warning about an unwritable journal was printed.
  std::uint64_t newest_output_ = 0;  ///< Time tag of the newest element on the output link at the last check.
};

}  // namespace soarbox::kernel
