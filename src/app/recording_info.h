// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "record/reader.h"

namespace soarbox::app {

/// Prints the origin and the contents of a recording: its scenario, seed, length and level, and its manifest, as text
/// or as one line of JSON.
void PrintRecordingInfo(const record::Reader& recording, bool as_json);

}  // namespace soarbox::app
