// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::kernel {
class Agent;
}

namespace soarbox::cli {

/// Everything that an agent imagines, for code that draws or explains it: `version N`, then a line for each node and
/// each extract command, `STATE node NAME OBJECT` and `STATE extract NAME OBJECT`. The object is JSON:
///
///   node     parent, shape ("group", "hull", "ball"), at [x y z], turn [x y z w], scale [x y z], points [x y z ...]
///            (of a hull, in its frame), radius (of a ball), tags {}
///   extract  command, rule (that gave it), filter, status, problem, hint, count (of records), values: for the first of
///            them record, value, from [{name, value, filter, from}], nodes [names], lines [x y z x y z hidden ...]
///            (metres of the world; hidden is 1 for a sight line that something crosses)
///
/// Contains only the version line if the version is `known`, or if the agent imagines nothing.
std::string SceneFactsText(const kernel::Agent& agent, std::string_view known);

}  // namespace soarbox::cli
