// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "kernel/agent.h"
#include "sml/wire/element.h"

namespace soarbox::server {

/// Adds the elements of an output message to its <command>: the output link itself, additions, removals. `first`: the
/// first message about an agent repeats the link at the end.
void AddOutput(wire::Element& command, const kernel::Agent& agent, std::span<const kernel::OutputChange> changes,
               bool first);
/// <wme action="add" ...> with values in the form that clients expect: texts without bars, numbers with six decimals.
wire::Element AddedWme(const kernel::Agent& agent, long long tag, kernel::Symbol id, kernel::Symbol attribute,
                       kernel::Symbol value);

}  // namespace soarbox::server
