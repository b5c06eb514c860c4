// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "vocabulary/vocabulary.h"

namespace soarbox::debugger {

/// The row of the table of percepts for a path from the input link; keys in it ("waypoint#east.distance") do not count.
/// Null for what scripts and scenarios add.
const vocabulary::PerceptRow* PerceptOf(std::string_view path);

/// What a percept means, "How far it is away, in m, 0 to 100"; empty if the table does not have it.
std::string DescribePercept(std::string_view path);

}  // namespace soarbox::debugger
