// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::server {

class HostedAgent;

/// What clients say to the scene of an agent's top state, and ask of it (kernel/imagery).
/// Lines of the scene graph edit language; false if the spatial visual system is off.
bool SendScene(HostedAgent& hosted, std::string_view lines);
/// The lines that were refused since somebody asked last, with reasons, one a line.
std::string TakeRefusedScene(HostedAgent& hosted);
/// The answers to queries, one a line; empty if the spatial visual system is off.
std::string QueryScene(HostedAgent& hosted, std::string_view queries);

}  // namespace soarbox::server
