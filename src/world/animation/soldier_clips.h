// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <vector>

#include "world/animation/clip.h"
#include "world/animation/soldier_pose.h"

namespace soarbox::world {

/// The poses with which animations begin and end.
SoldierPose StandAiming();
SoldierPose StandReady();
SoldierPose CrouchAiming();
/// With empty hands.
SoldierPose StandFree();

/// Lets an arm hang and swing: `forward` rotates it at the shoulder, `bend` at the elbow, in rad.
void SwingArm(SoldierPose& pose, bool is_left, float forward, float bend);

/// A clip whose pose at each moment (0..1 of its length) is computed by `pose_at`.
Clip MakeClip(const Clip::Settings& settings, const std::function<SoldierPose(float)>& pose_at);

/// Walking and running (soldier_gaits.cpp).
void AddGaits(std::vector<Clip>& clips);
/// Standing, shooting, reloading, falling (soldier_actions.cpp).
void AddActions(std::vector<Clip>& clips);

}  // namespace soarbox::world
