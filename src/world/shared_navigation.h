// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::world {

/// From here on, this process and those that it forks build each navigation mesh once for all of them: a thousand runs
/// of one world need its mesh a thousand times. Nobody can tell whether a mesh was built or found.
void ShareNavigation();

}  // namespace soarbox::world
