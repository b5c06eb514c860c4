// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/recording_commands.h"
#include "record/export.h"

namespace soarbox::app {

/// Draws moments of a recording with the software renderer, as PNG files into `options.pictures` and as an animation
/// into `options.video`: a GIF, or with ffmpeg for other extensions. Returns an ExitCode.
int DrawPictures(record::Reader& recording, record::TickRange range, const RecordingOptions& options);

}  // namespace soarbox::app
