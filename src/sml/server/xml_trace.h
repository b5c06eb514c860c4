// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "kernel/agent.h"
#include "kernel/observer.h"
#include "sml/wire/xml_writer.h"

namespace soarbox::server {

class HostedAgent;

/// Builds the structured trace of an agent: the trace selected by the command line's settings, as elements. Enabled
/// only while a client listens. The parts are sent at the start of every output phase and at the end of runs. They have
/// the form of the text for remote clients.
class XmlTracer : public kernel::Observer {
 public:
  explicit XmlTracer(HostedAgent& hosted) : hosted_(hosted) {}
  ~XmlTracer() override;

  void SetOn(bool on);
  /// Subscribes to the events that the trace settings require now. Call it after they may have changed.
  void Refresh();
  /// Moves the collected trace (children of <trace>) into `pieces`. Returns false if there is none.
  bool Take(std::string& pieces);

  void OnPhaseBegin(const kernel::Agent& agent, kernel::Phase phase) override;
  void OnPhaseEnd(const kernel::Agent& agent, kernel::Phase phase) override;
  void OnPreferencePhase(const kernel::Agent& agent, kernel::FiringType type, kernel::GoalLevel level) override;
  void OnWorkingMemoryPhase(const kernel::Agent& agent, kernel::FiringType type) override;
  void OnFiring(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnFired(const kernel::Agent& agent, const kernel::FiringInfo& info,
               std::span<const kernel::PreferenceId> preferences) override;
  void OnRetracting(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnRetracted(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnWmeAdded(const kernel::Agent& agent, const kernel::WmeInfo& wme) override;
  void OnWmeRemoved(const kernel::Agent& agent, const kernel::WmeInfo& wme) override;
  void OnPreferenceAdded(const kernel::Agent& agent, kernel::PreferenceId id) override;
  void OnPreferenceIgnored(const kernel::Agent& agent, kernel::PreferenceId id) override;
  void OnPreferenceRemoved(const kernel::Agent& agent, kernel::PreferenceId id) override;
  void OnDecision(const kernel::Agent& agent, const kernel::GoalInfo& goal, std::uint64_t decision) override;
  void OnOperatorRemoved(const kernel::Agent& agent, const kernel::GoalInfo& goal, kernel::OperatorRemoval why,
                         const kernel::WmeInfo& wme) override;
  void OnPrint(const kernel::Agent& agent, std::string_view text) override;
  void OnWarning(const kernel::Agent& agent, kernel::WarningKind kind, std::string_view text) override;
  void OnInterrupt(const kernel::Agent& agent, std::string_view reason) override;
  void OnHalt(const kernel::Agent& agent) override;
  void OnRlUpdate(const kernel::Agent& agent, const kernel::RlUpdate& update) override;
  void OnRewardGap(const kernel::Agent& agent, kernel::Symbol state, bool begins) override;
  void OnCandidate(const kernel::Agent& agent, kernel::Symbol candidate, double value, double probability) override;

 private:
  bool ShowsFiring(const kernel::FiringInfo& info) const;
  /// Whether firings are shown with the matched elements and the created preferences.
  bool Detailed() const;
  void AddRule(std::string_view tag, const kernel::Agent& agent, const kernel::FiringInfo& info);
  void AddPreference(const kernel::Agent& agent, kernel::PreferenceId id);
  void AddWme(const kernel::Agent& agent, const kernel::WmeInfo& wme);
  void AddText(std::string_view tag, std::string_view text);
  /// Sets an attribute to the text of a symbol.
  void Set(const kernel::Agent& agent, std::string_view name, kernel::Symbol symbol);

  HostedAgent& hosted_;
  bool on_ = false;
  bool subscribed_ = false;
  bool retracting_ = false;  ///< The preferences being removed belong to a firing that is shown in detail.
  std::string pieces_;
  std::string symbol_;  ///< Buffer for the text of a symbol.
  wire::XmlPen pen_{pieces_};
};

}  // namespace soarbox::server
