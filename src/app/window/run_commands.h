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
/// Steps of the selected agent's mind are those of mind_steps.h. An error means that the run cannot go on.
struct RunCommands {
  bool has_begun_again = false, has_ticked = false;

  Result<bool> Obey(viewer::ViewerCommand command, RunSession& session, viewer::Viewer& viewer,
                    const world::SceneSnapshot& scene);
};

}  // namespace soarbox::app
