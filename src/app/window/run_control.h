// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/run_session.h"
#include "viewer/viewer.h"

namespace soarbox::app {

/// Carries out those commands of a window that change the run itself rather than its pace; false for others.
///
/// Reset and the next seed make the simulation anew: what pointed into the old one is dead when this returns, and
/// `has_begun_again` is set.
///
/// A step of a decision is a tick in which the selected agent decides once: it perceives what is new, makes one
/// decision, and the world goes on with what it said; `has_ticked` is set. A step of a phase lets its mind go on alone,
/// between two ticks. Both come in through the run's door, so that a recording repeats them. An error means that the
/// run cannot go on.
struct RunControl {
  bool has_begun_again = false, has_ticked = false;

  Result<bool> Obey(viewer::ViewerCommand command, RunSession& session, viewer::Viewer& viewer,
                    const world::SceneSnapshot& scene);
};

/// Lets a tick pass in which this agent decides once; tells what it decided.
std::string StepDecision(RunSession& session, const std::string& agent);

}  // namespace soarbox::app
