// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "vocabulary/vocabulary.h"

namespace soarbox::debugger {

/// Returns the row of the table of percepts for a path from the input link. Keys in the path ("waypoint#east.distance")
/// are ignored. Null for percepts that scripts and scenarios add.
const vocabulary::PerceptRow* PerceptOf(std::string_view path);

/// Describes a percept: "How far it is away, in m, 0 to 100". Empty if the table does not contain it.
std::string DescribePercept(std::string_view path);

}  // namespace soarbox::debugger
