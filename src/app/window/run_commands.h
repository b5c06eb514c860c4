// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/run_session.h"
#include "viewer/viewer.h"

namespace soarbox::app {

/// Executes the commands of a window that change the run itself; returns false for others.
///
/// Reset and the next seed create the simulation again: pointers into the old one are invalid afterwards, and
/// `has_begun_again` is set.
///
/// Steps of the selected agent's mind are those of mind_steps.h. After an error the run cannot continue.
struct RunCommands {
  bool has_begun_again = false, has_ticked = false;

  Result<bool> Obey(viewer::ViewerCommand command, RunSession& session, viewer::Viewer& viewer,
                    const world::SceneSnapshot& scene);
};

}  // namespace soarbox::app
