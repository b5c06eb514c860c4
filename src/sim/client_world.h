// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::sim {

/// The name of the world in which the agents of recorded clients think again (minds_of_clients.cpp). It comes with the
/// program.
inline constexpr const char* kClientWorld = "soar-client";

/// The parts of a line of a client's log (sml/server/client_log.h describes it), unescaped.
std::vector<std::string> PartsOfClientLine(std::string_view line);
/// A line with these parts, without its end.
std::string ClientLine(std::initializer_list<std::string_view> parts);

}  // namespace soarbox::sim
