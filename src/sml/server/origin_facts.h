// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "mind/origin.h"

namespace soarbox::server {

class HostedAgent;

/// Makes the kernel record origins from now on (kernel/longterm/origins.h), with decisions packed by
/// mind/decision_codec.h.
void NoteOrigins(HostedAgent& agent);
/// The origin of an element, and the origins that it refers to. Also available for a while for removed commands.
mind::OriginFacts OriginOfElement(const HostedAgent& agent, std::uint64_t timetag);
/// The origin of the newest element with this attribute on the output link.
mind::OriginFacts OriginOfCommand(const HostedAgent& agent, std::string_view command);

}  // namespace soarbox::server
