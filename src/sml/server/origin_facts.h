// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "mind/origin.h"

namespace soarbox::server {

class HostedAgent;

/// Lets the kernel note origins from now on (kernel/longterm/origins.h), with decisions as mind/decision_codec.h packs
/// them.
void NoteOrigins(HostedAgent& agent);
/// The origin of an element, with those that it leads to. A command that has gone is found for a while, too.
mind::OriginFacts OriginOfElement(const HostedAgent& agent, std::uint64_t timetag);
/// The same for the newest element with this attribute on the output link.
mind::OriginFacts OriginOfCommand(const HostedAgent& agent, std::string_view command);

}  // namespace soarbox::server
