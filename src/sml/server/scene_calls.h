// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::server {

class HostedAgent;

/// Sends lines of the scene graph edit language to the scene of an agent's top state (kernel/imagery). Returns false if
/// the spatial visual system is off.
bool SendScene(HostedAgent& hosted, std::string_view lines);
/// Returns the lines refused since the last call, with reasons, one per line.
std::string TakeRefusedScene(HostedAgent& hosted);
/// Returns the answers to queries, one per line; empty if the spatial visual system is off.
std::string QueryScene(HostedAgent& hosted, std::string_view queries);

}  // namespace soarbox::server
