// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sim/actor.h"
#include "sim/input_mirror.h"
#include "vocabulary/percept_sink.h"

namespace soarbox::sim {

/// What an actor perceives of its own body, of what is done to it and of its order: read in each tick.
void SenseOwnBody(const Actor& actor, vocabulary::PerceptSink& sink);
void SenseOwnBody(const Actor& actor, InputMirror& mirror);
/// What others say to it: messages that are new enough.
void SenseMessages(const Actor& actor, vocabulary::PerceptSink& sink);
/// Makes the mirror show the same; looks only at messages after number `last`, the last one of the previous call, and
/// leaves the others as they are until they are too old.
void HearMessages(const Actor& actor, std::uint32_t& last, InputMirror& heard);
/// Looks and listens: brings the actor's contacts and things up to date. Draws noise from the agent's own stream.
void Notice(Actor& actor);
/// What it perceives of its surroundings: others (from its contacts), things, places. Read at the rate of its senses.
void SenseSurroundings(const Actor& actor, vocabulary::PerceptSink& sink);
void SenseSurroundings(const Actor& actor, InputMirror& mirror);
/// All that it perceives, for people.
vocabulary::PerceptList AllPercepts(const Actor& actor);
/// Whether the surroundings are read in this tick. Actors take turns, so that no tick reads them all.
bool IsSenseTick(const Actor& actor);
/// Takes messages that came since the last tick; keeps an order until the next one comes.
void HearOrders(Actor& actor);

}  // namespace soarbox::sim
