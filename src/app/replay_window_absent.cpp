// SPDX-License-Identifier: BSD-2-Clause
#include "app/exit_codes.h"
#include "app/replay_window.h"

namespace soarbox::app {

bool CanShowReplay() {
  return false;
}

int ShowReplay(record::Reader&, record::TickRange, const sim::DataFolders&, const RecordingOptions&) {
  return kCannotStart;  // Never asked for where CanShowReplay says no.
}

}  // namespace soarbox::app
