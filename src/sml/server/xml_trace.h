// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "kernel/agent.h"
#include "kernel/observer.h"
#include "sml/wire/element.h"

namespace soarbox::server {

class HostedAgent;

/// Builds the structured trace of an agent: what the command line's trace settings show, as elements. Switched on only
/// while a client listens. The pieces are sent at the start of every output phase and at the end of runs.
class XmlTracer : public kernel::Observer {
 public:
  explicit XmlTracer(HostedAgent& hosted) : hosted_(hosted) {}
  ~XmlTracer() override;

  void SetOn(bool on);
  /// Subscribes to what the trace settings need now; call after they may have changed.
  void Refresh();
  /// What has gathered, as <trace>; null if nothing has.
  std::shared_ptr<const wire::Element> Take();

  void OnPhaseBegin(const kernel::Agent& agent, kernel::Phase phase) override;
  void OnPhaseEnd(const kernel::Agent& agent, kernel::Phase phase) override;
  void OnPreferencePhase(const kernel::Agent& agent, kernel::FiringType type, kernel::GoalLevel level) override;
  void OnWorkingMemoryPhase(const kernel::Agent& agent, kernel::FiringType type) override;
  void OnFiring(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnRetracting(const kernel::Agent& agent, const kernel::FiringInfo& info) override;
  void OnWmeAdded(const kernel::Agent& agent, const kernel::WmeInfo& wme) override;
  void OnWmeRemoved(const kernel::Agent& agent, const kernel::WmeInfo& wme) override;
  void OnPreferenceAdded(const kernel::Agent& agent, kernel::PreferenceId id) override;
  void OnPreferenceRemoved(const kernel::Agent& agent, kernel::PreferenceId id) override;
  void OnDecision(const kernel::Agent& agent, const kernel::GoalInfo& goal, std::uint64_t decision) override;
  void OnOperatorRemoved(const kernel::Agent& agent, const kernel::GoalInfo& goal, kernel::OperatorRemoval why,
                         const kernel::WmeInfo& wme) override;
  void OnPrint(const kernel::Agent& agent, std::string_view text) override;
  void OnWarning(const kernel::Agent& agent, kernel::WarningKind kind, std::string_view text) override;
  void OnInterrupt(const kernel::Agent& agent, std::string_view reason) override;
  void OnHalt(const kernel::Agent& agent) override;
  void OnCandidate(const kernel::Agent& agent, kernel::Symbol candidate, double value, double probability) override;

 private:
  bool ShowsFiring(const kernel::FiringInfo& info) const;
  void AddRule(const char* tag, const kernel::Agent& agent, const kernel::FiringInfo& info);
  void AddPreference(const kernel::Agent& agent, kernel::PreferenceId id);

  HostedAgent& hosted_;
  bool on_ = false;
  bool subscribed_ = false;
  std::shared_ptr<wire::Element> trace_ = std::make_shared<wire::Element>("trace");
};

/// <wme attr id [preference] [tag] valtype value> as traces and answers show it.
wire::Element WmeElement(const kernel::Agent& agent, const kernel::WmeInfo& wme, bool with_tag = true);
/// "string", "int", "double" or "id".
const char* ValueTypeName(kernel::Symbol symbol);

}  // namespace soarbox::server
