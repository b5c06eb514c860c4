// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::app {

/// Ends this process and its children if the server at the other end of the socket has gone and the process has not
/// ended by itself within 10 s. A world that hangs would not notice that its server was killed. Call it once, after the
/// wall is raised. Does nothing if this process is not a process group leader.
void EndWithServer(int socket);

}  // namespace soarbox::app
