// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/recording_commands.h"
#include "record/export.h"
#include "record/reader.h"
#include "sim/scenario.h"

namespace soarbox::app {

/// Shows a recording in the window, forwards and backwards, with the panels of a run around it. Returns an ExitCode
/// after the window has closed.
int ShowReplay(record::Reader& recording, record::TickRange range, const sim::DataFolders& data,
               const RecordingOptions& options);

}  // namespace soarbox::app
