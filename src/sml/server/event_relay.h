// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/agent.h"
#include "kernel/observer.h"
#include "sml/server/event_set.h"

namespace soarbox::server {

class HostedAgent;

/// Converts events inside a phase (elaborations, firings, rules added and removed) to events for clients. Subscribes to
/// the kernel's events only if a client listens to them.
class EventRelay : public kernel::Observer {
 public:
  explicit EventRelay(HostedAgent& hosted) : hosted_(hosted) {}
  ~EventRelay() override;

  /// Call when the set of events that clients listen to has changed.
  void Update(EventSet listened);

  void OnElaborationBegin(const kernel::Agent& agent) override;
  void OnElaborationEnd(const kernel::Agent& agent) override;
  void OnFired(const kernel::Agent& agent, const kernel::FiringInfo& firing,
               std::span<const kernel::PreferenceId> preferences) override;
  void OnRetracted(const kernel::Agent& agent, const kernel::FiringInfo& firing) override;
  void OnProductionAdded(const kernel::Agent& agent, kernel::ProductionId production) override;
  void OnProductionExcised(const kernel::Agent& agent, kernel::ProductionId production) override;

 private:
  HostedAgent& hosted_;
  kernel::EventMask mask_ = 0;
};

}  // namespace soarbox::server
