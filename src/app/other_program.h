// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::app {

/// Goes on as the program of this name in the same folder, with the same arguments. Returns only if it cannot be
/// started.
void GoOnAs(const char* name, char** argv);

}  // namespace soarbox::app
