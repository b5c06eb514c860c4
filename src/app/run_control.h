// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/run_session.h"
#include "viewer/viewer.h"

namespace soarbox::app {

/// Carries out those commands of a window that change the run itself rather than its pace; false for others.
///
/// Reset and the next seed make the simulation anew: what pointed into the old one is dead when this returns, and
/// `has_begun_again` is set. A step of a decision or a phase lets the selected agent's mind go on alone, between two
/// ticks: it sees what it saw in the last one, and what it decides reaches the world in the next. An error means that
/// the run cannot go on.
struct RunControl {
  bool has_begun_again = false;

  Result<bool> Obey(viewer::ViewerCommand command, RunSession& session, viewer::Viewer& viewer,
                    const world::SceneSnapshot& scene);
};

}  // namespace soarbox::app
