// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::sim {

/// Name of the world in which the agents of recorded clients run again (minds_of_clients.cpp). It comes with the
/// program.
inline constexpr const char* kClientWorld = "soar-client";

/// Splits a line of a client's log (sml/server/client_log.h) into its parts and unescapes them.
std::vector<std::string> PartsOfClientLine(std::string_view line);
/// Joins parts to a line, without a line end.
std::string ClientLine(std::initializer_list<std::string_view> parts);

}  // namespace soarbox::sim
