// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/rifle_rig.h"

#include <cmath>

#include "world/animation/rig.h"
#include "world/animation/soldier_skeleton.h"

namespace soarbox::world {
namespace {

/// The positions of the rifle's parts.
struct RifleForm {
  float shortness = 0;  ///< 1: barrel and stock are retracted.
  float magazine_out = 0;
  float bolt_back = 0;
};

float Ease(float t) {
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  return t * t * (3 - 2 * t);
}

/// Rises from 0 to 1 and falls back within a time span.
float Bump(float t, float up, float top, float down, float end) {
  return Ease((t - up) / (top - up)) - Ease((t - down) / (end - down));
}

std::vector<BonePose> Solve(const Skeleton& skeleton, const RifleForm& form) {
  std::vector<BonePose> local;
  for (const Skeleton::Bone& bone : skeleton.bones()) local.push_back(bone.bind);
  local[kRifleBarrel].position.x -= RifleSize::kRetracts * form.shortness;
  local[kRifleStock].position.x += 0.06f * form.shortness;
  local[kRifleMagazine].position += Vec3{-0.03f, -0.22f, 0} * form.magazine_out;
  local[kRifleBolt].position.x -= 0.07f * form.bolt_back;
  return local;
}

template <class FormAt>
Clip MakeRifleClip(const Skeleton& skeleton, const char* name, float length_s, bool is_cycle, FormAt form_at) {
  constexpr int kSteps = 30;
  std::vector<std::vector<BonePose>> keys;
  for (int i = 0; i <= kSteps; ++i) keys.push_back(Solve(skeleton, form_at(static_cast<float>(i) / kSteps)));
  return Clip({.name = name, .length_s = length_s, .is_cycle = is_cycle}, std::move(keys));
}

Rig MakeRig() {
  Rig rig;
  const Vec3 grip = HoldOfRifle().grip;
  const auto at = [&](float x, float y) { return BonePose{grip + Vec3{x, y, 0}, {}}; };
  rig.skeleton.Add("b_weapon", -1, at(0, 0));
  rig.skeleton.Add("b_barrel", kRifleBody, at(0.30f, RifleSize::kBore));
  rig.skeleton.Add("b_muzzle", kRifleBarrel, at(RifleSize::kMuzzle, RifleSize::kBore));
  rig.skeleton.Add("b_magazine", kRifleBody, at(RifleSize::kMagazine.x, RifleSize::kMagazine.y));
  rig.skeleton.Add("b_bolt", kRifleBody, at(0.04f, RifleSize::kBore));
  rig.skeleton.Add("b_stock", kRifleBody, at(-0.10f, RifleSize::kBore));
  const Skeleton& s = rig.skeleton;
  rig.clips.push_back(MakeRifleClip(s, "sniper_idle", 1.0f, true, [](float) { return RifleForm{}; }));
  // Synchronized with the soldier's stand_reload.
  rig.clips.push_back(MakeRifleClip(s, "sniper_reload", 2.6f, false, [](float t) {
    return RifleForm{0, Bump(t, 0.24f, 0.34f, 0.60f, 0.70f), Bump(t, 0.78f, 0.84f, 0.85f, 0.88f)};
  }));
  rig.clips.push_back(MakeRifleClip(s, "sniper_transform", 1.2f, false, [](float t) {
    return RifleForm{1 - Ease((t - 0.3f) / 0.4f), 0, 0};
  }));
  rig.clips.push_back(MakeRifleClip(s, "smg_idle", 1.0f, true, [](float) { return RifleForm{1, 0, 0}; }));
  rig.clips.push_back(MakeRifleClip(s, "smg_transform", 1.2f, false, [](float t) {
    return RifleForm{Ease((t - 0.3f) / 0.4f), 0, 0};
  }));
  return rig;
}

}  // namespace

const Rig& RifleRig() {
  static const Rig rig = MakeRig();
  return rig;
}

}  // namespace soarbox::world
