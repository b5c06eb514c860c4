// SPDX-License-Identifier: BSD-2-Clause
// For systems without processes (WebAssembly).
#include "app/engine/engine_watch.h"

namespace soarbox::app {

void EndWithServer(int) {}

}  // namespace soarbox::app
