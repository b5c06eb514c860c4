// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/locomotion.h"
#include "world/animation/rig.h"
#include "world/animation/soldier_clips.h"
#include "world/animation/soldier_skeleton.h"

namespace soarbox::world {
namespace {

GaitTable MakeGaits(const Rig& rig) {
  GaitTable table;
  const auto clip = [&rig](const char* name) { return rig.FindClip(name); };
  table.styles[static_cast<std::size_t>(LocomotionStyle::kReady)] = {
      .idle = clip("stand_idle"),
      .forward = {clip("stand_walk_forward"), clip("stand_run_forward"), clip("stand_sprint_forward")},
      .backward = {clip("stand_walk_backward"), clip("stand_run_backward_aim")},
      .left = clip("stand_walk_left_aim"),
      .right = clip("stand_walk_right_aim"),
      .turn_left = clip("stand_turn_left"),
      .turn_right = clip("stand_turn_right")};
  table.styles[static_cast<std::size_t>(LocomotionStyle::kAim)] = {
      .idle = clip("stand_idle_aim"),
      .forward = {clip("stand_walk_forward_aim"), clip("stand_run_forward_aim"), clip("stand_sprint_forward")},
      .backward = {clip("stand_walk_backward_aim"), clip("stand_run_backward_aim")},
      .left = clip("stand_walk_left_aim"),
      .right = clip("stand_walk_right_aim"),
      .turn_left = clip("stand_turn_left_aim"),
      .turn_right = clip("stand_turn_right_aim")};
  table.styles[static_cast<std::size_t>(LocomotionStyle::kCrouch)] = {.idle = clip("crouch_idle_aim"),
                                                                      .forward = {clip("crouch_forward_aim")},
                                                                      .backward = {clip("crouch_backward_aim")}};
  table.styles[static_cast<std::size_t>(LocomotionStyle::kUnarmed)] = {
      .idle = clip("stand_idle_free"),
      .forward = {clip("stand_walk_forward_free"), clip("stand_run_forward_free"), clip("stand_sprint_forward_free")},
      .backward = {clip("stand_walk_backward_free")},
      .left = clip("stand_walk_left_free"),
      .right = clip("stand_walk_right_free"),
      .turn_left = clip("stand_turn_left_free"),
      .turn_right = clip("stand_turn_right_free")};
  table.die = clip("stand_dead_2");
  return table;
}

Rig MakeRig() {
  Rig rig;
  rig.skeleton = SoldierSkeleton();
  AddActions(rig.clips);
  AddGaits(rig.clips);
  rig.is_lower_body.assign(kSoldierBones, false);
  rig.is_lower_body[kHips] = true;
  for (int bone = kLeftThigh; bone <= kRightToe; ++bone) rig.is_lower_body[static_cast<std::size_t>(bone)] = true;
  static const GaitTable gaits = MakeGaits(rig);
  rig.gaits = &gaits;
  return rig;
}

}  // namespace

const Rig& SoldierRig() {
  static const Rig rig = MakeRig();
  return rig;
}

}  // namespace soarbox::world
