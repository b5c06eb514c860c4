// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::app {

/// Starts a thread that watches the socket. If the other end is closed and this process has not ended within 10 s, the
/// thread ends it and its children. Otherwise a world that hangs would remain after its server was killed. Call it
/// once, after RaiseWall. Does nothing if this process is not a process group leader.
void EndWithServer(int socket);

}  // namespace soarbox::app
