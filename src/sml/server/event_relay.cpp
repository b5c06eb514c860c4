// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/event_relay.h"

#include "sml/server/hosted_agent.h"

namespace soarbox::server {

using namespace ::sml;

EventRelay::~EventRelay() {
  if (mask_ != 0) hosted_.agent().RemoveObserver(*this);
}

void EventRelay::Update(EventSet listened) {
  kernel::EventMask mask = 0;
  if (listened.HasAnyOf(smlEVENT_BEFORE_SMALLEST_STEP, smlEVENT_AFTER_ELABORATION_CYCLE)) {
    mask = mask | kernel::Event::kElaboration;
  }
  if (listened.Has(smlEVENT_AFTER_PRODUCTION_FIRED) || listened.Has(smlEVENT_BEFORE_PRODUCTION_RETRACTED)) {
    mask = mask | kernel::Event::kFiring;
  }
  if (listened.Has(smlEVENT_AFTER_PRODUCTION_ADDED) || listened.Has(smlEVENT_BEFORE_PRODUCTION_REMOVED)) {
    mask = mask | kernel::Event::kProduction;
  }
  if (mask == mask_) return;
  if (mask == 0) {
    hosted_.agent().RemoveObserver(*this);
  } else {
    hosted_.agent().AddObserver(*this, mask);
  }
  mask_ = mask;
}

void EventRelay::OnElaborationBegin(const kernel::Agent&) {
  hosted_.FirePhase(smlEVENT_BEFORE_ELABORATION_CYCLE, smlEVENT_BEFORE_SMALLEST_STEP, 0);
}

void EventRelay::OnElaborationEnd(const kernel::Agent&) {
  hosted_.FirePhase(smlEVENT_AFTER_ELABORATION_CYCLE, smlEVENT_AFTER_SMALLEST_STEP, 0);
}

void EventRelay::OnFired(const kernel::Agent&, const kernel::FiringInfo& firing,
                         std::span<const kernel::PreferenceId>) {
  if (firing.rule) hosted_.FireProduction(smlEVENT_AFTER_PRODUCTION_FIRED, firing.name);
}

void EventRelay::OnRetracted(const kernel::Agent&, const kernel::FiringInfo& firing) {
  if (firing.rule) hosted_.FireProduction(smlEVENT_BEFORE_PRODUCTION_RETRACTED, firing.name);
}

void EventRelay::OnProductionAdded(const kernel::Agent& agent, kernel::ProductionId production) {
  hosted_.FireProduction(smlEVENT_AFTER_PRODUCTION_ADDED, agent.production(production).name);
}

void EventRelay::OnProductionExcised(const kernel::Agent& agent, kernel::ProductionId production) {
  hosted_.FireProduction(smlEVENT_BEFORE_PRODUCTION_REMOVED, agent.production(production).name);
}

}  // namespace soarbox::server
