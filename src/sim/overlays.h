// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sim/arena.h"
#include "sim/minds.h"
#include "world/overlay_snapshot.h"

namespace soarbox::sim {

/// What the agents of a world perceive, intend and say now, for overlays. Changes nothing.
world::OverlaySnapshot TakeOverlays(const Arena& arena, Minds& minds, const world::OverlayWants& wants);

}  // namespace soarbox::sim
