// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "record/reader.h"

namespace soarbox::app {

/// Prints what a recording was made from and with, and what it holds: its scenario, seed, length and level, and its
/// manifest, as text or as one line of JSON.
void PrintRecordingInfo(const record::Reader& recording, bool as_json);

}  // namespace soarbox::app
