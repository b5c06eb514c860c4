// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "kernel/agent.h"
#include "sml/wire/element.h"

namespace soarbox::server {

/// Adds the elements of a message about output to its <command>: the output link itself, what came, what went. `first`:
/// the first message about an agent states the link once more at the end.
void AddOutput(wire::Element& command, const kernel::Agent& agent, std::span<const kernel::OutputChange> changes,
               bool first);
/// <wme action="add" ...> with values as clients read them: texts without bars, numbers with six decimals.
wire::Element AddedWme(const kernel::Agent& agent, long long tag, kernel::Symbol id, kernel::Symbol attribute,
                       kernel::Symbol value);

}  // namespace soarbox::server
