// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sim/actor.h"
#include "sim/input_mirror.h"
#include "vocabulary/percept.h"

namespace soarbox::sim {

/// Reports what an actor perceives of its own body, of events that affect it, and of its order. Read in each tick.
void SenseOwnBody(const Actor& actor, InputMirror& mirror);
/// Updates the mirror with the messages from others that are recent enough. It reads only messages after number `last`,
/// the last one of the previous call. Older messages stay unchanged until they are too old.
void HearMessages(const Actor& actor, std::uint32_t& last, InputMirror& heard);
/// Updates the actor's contacts and things by sight and hearing. Noise is drawn from the agent's own random stream.
void Notice(Actor& actor);
/// Reports what the actor perceives of its surroundings: others (from its contacts), things, places. Read at the rate
/// of its senses.
void SenseSurroundings(const Actor& actor, InputMirror& mirror);
/// All its percepts, for display to users.
vocabulary::PerceptList AllPercepts(const Actor& actor);
/// Whether the surroundings are read in this tick. Different actors read them in different ticks, to distribute the
/// cost.
bool IsSenseTick(const Actor& actor);
/// Receives messages since the last tick. Keeps an order until the next one arrives.
void HearOrders(Actor& actor);

}  // namespace soarbox::sim
