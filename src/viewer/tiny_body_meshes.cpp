// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/body_mesh.h"
#include "world/animation/rifle_rig.h"
#include "world/animation/soldier_skeleton.h"

// Soldier and rifle for heights of a few pixels: one loft per limb, in the same colours.
namespace soarbox::viewer {
namespace {

using world::BonePose;
using world::Vec3;
using Size = world::SoldierSize;
using namespace world;  // NOLINT: the bones' names.

/// At this fineness, superquadrics have three rows, and the numbers of segments below are reduced accordingly.
constexpr float kTinyFineness = 0.3f;
constexpr int kFourSides = 13, kFiveSides = 17;

SkinVertex Of(int bone) {
  return {static_cast<std::uint8_t>(bone), 0, 1};
}
SkinVertex Of(int bone, int other, float share) {
  return {static_cast<std::uint8_t>(bone), static_cast<std::uint8_t>(other), share};
}

}  // namespace

SkinMesh MakeTinySoldierMesh(bool dark) {
  SkinBuilder b(kTinyFineness);
  const Cloth cloth = dark ? Cloth::kDarkCamouflage : Cloth::kCamouflage;
  const Cloth webbing = dark ? Cloth::kDarkWebbing : Cloth::kWebbing;
  // Hips in cloth, the vest over the chest.
  b.cloth = cloth;
  b.Loft({{{0, 0.80f, -0.005f}, 0.130f, 0.095f, Of(kHips), 0.2f},
          {{0, 0.92f, -0.014f}, 0.168f, 0.118f, Of(kHips), 0.2f},
          {{0, 1.08f, 0.000f}, 0.158f, 0.112f, Of(kSpine), 0.2f}},
         kFiveSides, {0, 0, 1});
  b.cloth = webbing;
  b.Loft({{{0, 1.07f, 0.004f}, 0.172f, 0.145f, Of(kSpine), 0.4f},
          {{0, 1.27f, 0.006f}, 0.184f, 0.148f, Of(kChest), 0.4f},
          {{0, 1.40f, -0.004f}, 0.135f, 0.100f, Of(kChest), 0.3f}},
         kFiveSides, {0, 0, 1});
  b.bone = Of(kChest);
  b.Round({0, 1.235f, -0.205f}, {0.150f, 0.180f, 0.085f}, 0.45f, kFourSides);
  b.cloth = Cloth::kSkin;
  b.Loft({{{0, 1.42f, -0.010f}, 0.060f, 0.060f, Of(kNeck)},
          {{0, 1.52f, 0.010f}, 0.066f, 0.078f, Of(kHead)},
          {{0, 1.63f, 0.016f}, 0.086f, 0.104f, Of(kHead)}},
         kFiveSides, {0, 0, 1});
  b.cloth = dark ? Cloth::kDarkHelmet : Cloth::kHelmet;
  b.bone = Of(kHead);
  b.Round({0, 1.635f, 0.002f}, {0.124f, 0.131f, 0.146f}, 0.92f, kFiveSides, 0, 1);
  b.cloth = Cloth::kTeam;
  b.Loft({{{0, 1.655f, 0.002f}, 0.130f, 0.152f, Of(kHead)}, {{0, 1.690f, 0.002f}, 0.124f, 0.146f, Of(kHead)}},
         kFiveSides, {0, 0, 1}, false);
  b.cloth = Cloth::kLeather;
  b.Loft({{{0, 0.955f, -0.010f}, 0.174f, 0.130f, Of(kHips), 0.2f},
          {{0, 1.010f, -0.006f}, 0.170f, 0.126f, Of(kHips), 0.2f}},
         kFiveSides, {0, 0, 1}, false);
  for (const float side : {1.0f, -1.0f}) {
    const int clavicle = side > 0 ? kLeftClavicle : kRightClavicle, upper = clavicle + 1, lower = clavicle + 2;
    const Vec3 shoulder{side * Size::kShoulderSide, Size::kShoulder, -0.01f};
    const Vec3 way = BindArmDirection(side);
    const float elbow = Size::kUpperArm, wrist = elbow + Size::kForearm;
    const auto at = [&](float along) { return shoulder + way * along; };
    b.cloth = cloth;
    b.Loft({{at(-0.05f), 0.064f, 0.070f, Of(clavicle, upper, 0.5f)},
            {at(0.09f), 0.064f, 0.068f, Of(upper)},
            {at(elbow), 0.053f, 0.055f, Of(upper, lower, 0.5f)},
            {at(wrist), 0.042f, 0.043f, Of(lower)},
            {at(wrist + 0.09f), 0.036f, 0.040f, Of(clavicle + 3)}},
           kFourSides, {0, 0, 1});
    b.cloth = Cloth::kTeam;
    b.Loft({{at(0.07f), 0.070f, 0.073f, Of(upper)}, {at(0.14f), 0.067f, 0.070f, Of(upper)}}, kFourSides, {0, 0, 1},
           false);
    const int thigh = side > 0 ? kLeftThigh : kRightThigh, shin = thigh + 1, foot = shin + 1, toe = shin + 2;
    const float x = side * Size::kHipSide, knee = Size::kHipHeight - Size::kThigh;
    b.cloth = cloth;
    b.Loft({{{x * 0.94f, 0.90f, -0.010f}, 0.088f, 0.106f, Of(kHips, thigh, 0.5f)},
            {{x, 0.72f, 0.003f}, 0.088f, 0.098f, Of(thigh)},
            {{x, knee, 0.004f}, 0.068f, 0.075f, Of(thigh, shin, 0.5f)},
            {{x, 0.22f, -0.010f}, 0.062f, 0.068f, Of(shin)}},
           kFourSides, {0, 0, 1});
    b.cloth = Cloth::kLeather;
    b.Loft({{{x, 0.25f, -0.010f}, 0.056f, 0.062f, Of(shin)}, {{x, 0, -0.010f}, 0.052f, 0.072f, Of(foot)}}, kFourSides,
           {0, 0, 1});
    b.Loft({{{x, 0.055f, 0.0f}, 0.052f, 0.055f, Of(foot)}, {{x, 0.038f, 0.205f}, 0.050f, 0.038f, Of(toe)}}, kFourSides,
           {0, 1, 0});
  }
  SkinMesh mesh = b.Take();
  mesh.mesh.material = "Soarbox/Soldier";
  return mesh;
}

SkinMesh MakeTinyRifleMesh() {
  SkinBuilder b(kTinyFineness);
  b.place.position = world::HoldOfRifle().grip;
  b.cloth = Cloth::kMetal;
  const SkinVertex body = Of(world::kRifleBody);
  b.Loft({{{-0.26f, 0.050f, 0}, 0.020f, 0.050f, body},
          {{-0.05f, 0.065f, 0}, 0.022f, 0.040f, body},
          {{0.36f, 0.072f, 0}, 0.026f, 0.036f, body}},
         kFourSides, {0, 1, 0});
  b.Loft({{{0.36f, RifleSize::kBore, 0}, 0.014f, 0.014f, Of(world::kRifleBarrel)},
          {{RifleSize::kMuzzle, RifleSize::kBore, 0}, 0.014f, 0.014f, Of(world::kRifleBarrel)}},
         kFourSides, {0, 1, 0});
  b.Loft({{{0.11f, 0.04f, 0}, 0.016f, 0.032f, Of(world::kRifleMagazine)},
          {{0.16f, -0.11f, 0}, 0.014f, 0.030f, Of(world::kRifleMagazine)}},
         kFourSides, {1, 0, 0});
  SkinMesh mesh = b.Take();
  mesh.mesh.material = "Soarbox/Soldier";
  return mesh;
}

}  // namespace soarbox::viewer
