// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "kernel/imagery/scene_feed.h"

namespace soarbox::cli {

/// Connects to a program that shows scenes: a TCP port of this machine, or the path of a socket in the file system. The
/// connection ends with the last copy of the sink, or when the program does not read for 1 s. On failure the sink is
/// null and `why` says what went wrong.
kernel::imagery::ViewerSink ConnectToViewer(const std::string& where, std::string& why);

}  // namespace soarbox::cli
