// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sim/actor.h"
#include "sim/percept.h"

namespace soarbox::sim {

/// What an actor perceives of its own body and of what is said and done to it: read in each tick.
PerceptList SenseOwnBody(const Actor& actor);
/// Looks and listens: brings the actor's contacts up to date. Draws noise from the agent's own stream, in agent order.
void NoticeOthers(Actor& actor);
/// What it perceives of its surroundings: others (from its contacts), things, places. Read at the rate of its senses.
PerceptList SenseSurroundings(const Actor& actor);
/// Whether the surroundings are read in this tick. Actors take turns, so that no tick reads them all.
bool IsSenseTick(const Actor& actor);
/// Takes messages that came since the last tick: an order is kept until the next one.
void HearOrders(Actor& actor);

}  // namespace soarbox::sim
