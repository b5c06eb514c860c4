// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "cli/backtrace_printer.h"
#include "cli/trace_settings.h"
#include "kernel/agent.h"

namespace soarbox::cli {

class Session;

/// The flag that shows the firings of a rule. Justifications have a separate flag.
TraceFlag FlagOf(const kernel::FiringInfo& info);

/// Prints what an agent does as Soar's trace, according to the session's settings. Subscribes only to the events that
/// the settings need. Owned by the session.
class TracePrinter : public kernel::Observer {
 public:
  explicit TracePrinter(Session& session) : session_(session), backtrace_(session) {}
  ~TracePrinter() override;

  /// Subscribes to the events that the settings need now.
  void Update();

  void OnPhaseBegin(const kernel::Agent&, kernel::Phase phase) override;
  void OnPhaseEnd(const kernel::Agent&, kernel::Phase phase) override;
  void OnPreferencePhase(const kernel::Agent&, kernel::FiringType type, kernel::GoalLevel level) override;
  void OnInnerElaboration(const kernel::Agent& agent, kernel::GoalLevel level, kernel::Symbol goal) override;
  void OnWorkingMemoryPhase(const kernel::Agent&, kernel::FiringType type) override;
  void OnFiring(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnFired(const kernel::Agent& agent, const kernel::FiringInfo& info,
               std::span<const kernel::PreferenceId> preferences) override;
  void OnInhibited(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnRetracting(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnRetracted(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnWmeAdded(const kernel::Agent& agent, const kernel::WmeInfo& wme) override;
  void OnWmeRemoved(const kernel::Agent& agent, const kernel::WmeInfo& wme) override;
  void OnPreferenceAdded(const kernel::Agent& agent, kernel::PreferenceId id) override;
  void OnPreferenceIgnored(const kernel::Agent& agent, kernel::PreferenceId id) override;
  void OnPreferenceRemoved(const kernel::Agent& agent, kernel::PreferenceId id) override;
  void OnDecision(const kernel::Agent& agent, const kernel::GoalInfo& goal, std::uint64_t decision) override;
  void OnStateRemoved(const kernel::Agent& agent, const kernel::GoalInfo& goal, kernel::GoalRemoval why) override;
  void OnOperatorRemoved(const kernel::Agent& agent, const kernel::GoalInfo& goal, kernel::OperatorRemoval why,
                         const kernel::WmeInfo& wme) override;
  void OnInconsistentDecision(const kernel::Agent& agent, const kernel::GoalInfo& goal) override;
  void OnGdsAdded(const kernel::Agent& agent, const kernel::GoalInfo& goal, const kernel::WmeInfo& wme) override;
  void OnGdsViolation(const kernel::Agent& agent, const kernel::GoalInfo& goal, const kernel::WmeInfo& wme) override;
  void OnPrint(const kernel::Agent&, std::string_view text) override;
  void OnError(const kernel::Agent&, std::string_view text) override;
  void OnLog(const kernel::Agent&, int channel, std::string_view text) override;
  void OnTraceText(const kernel::Agent&, int level, std::string_view text) override;
  void OnWarning(const kernel::Agent&, kernel::WarningKind kind, std::string_view text) override;
  void OnRuleInterrupt(const kernel::Agent&, kernel::ProductionId rule, std::uint32_t count) override;
  void OnInterrupt(const kernel::Agent&, std::string_view reason) override;
  void OnHalt(const kernel::Agent&) override;
  void OnInstantiationMade(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnInstantiationAsserted(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnLearning(const kernel::Agent& agent, std::string_view name) override;
  void OnLearned(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnDuplicateLearned(const kernel::Agent& agent, std::string_view name, std::string_view original) override;
  void OnFollowed(const kernel::Agent& agent, kernel::WmeId wme) override;
  void OnFollowedGone(const kernel::Agent& agent, std::uint64_t timetag) override;
  void OnUses(const kernel::Agent& agent, std::uint64_t timetag, std::uint64_t uses) override;
  void OnNotLearned(const kernel::Agent& agent, kernel::NotLearned why, const kernel::FiringInfo& info) override;
  void OnLocalNegation(const kernel::Agent& agent, const kernel::Production& negation) override;
  void OnRlUpdate(const kernel::Agent& agent, const kernel::RlUpdate& update) override;
  void OnRewardGap(const kernel::Agent& agent, kernel::Symbol state, bool begins) override;
  void OnCandidate(const kernel::Agent& agent, kernel::Symbol candidate, double value, double probability) override;

 private:
  bool ShowsFiring(const kernel::FiringInfo& info) const;
  bool PassesFilters(const kernel::Agent& agent, const kernel::WmeInfo& wme, bool added) const;
  void Print(const std::string& text);
  void PrintMatched(const kernel::Agent& agent, const kernel::FiringInfo& info);
  void PrintPreference(const kernel::Agent& agent, kernel::PreferenceId id);
  void PrintPreferenceChange(const kernel::Agent& agent, kernel::PreferenceId id, char sign,
                             std::string_view remark = {});

  Session& session_;
  BacktracePrinter backtrace_;
  bool retracting_ = false;  ///< The preferences that leave now belong to a firing that is shown in detail.
};

/// "(S1 ^operator O1 > O2)"; with `support`, "  :O " is added for o-support, as in traces.
std::string PreferenceText(const kernel::Agent& agent, const kernel::Preference& preference, bool support = true);

}  // namespace soarbox::cli
