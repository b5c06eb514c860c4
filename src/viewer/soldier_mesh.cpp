// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>

#include "viewer/body_mesh.h"
#include "world/animation/soldier_skeleton.h"

// The soldier: a body of lofts (trunk, limbs, neck, head) and gear of rounded pieces over it.
namespace soarbox::viewer {
namespace {

using world::BonePose;
using world::Vec3;
using Size = world::SoldierSize;
using Ring = SkinBuilder::Ring;
using namespace world;  // NOLINT: the bones' names.

SkinVertex By(int bone) {
  return {static_cast<std::uint8_t>(bone), 0, 1};
}
SkinVertex By(int bone, int other, float share) {
  return {static_cast<std::uint8_t>(bone), static_cast<std::uint8_t>(other), share};
}

class SoldierBuilder {
 public:
  SoldierBuilder(BodyDetail detail, bool dark)
      : b_(detail == BodyDetail::kFine     ? 1.0f
           : detail == BodyDetail::kMiddle ? 0.55f
                                           : 0.26f),
        dark_(dark),
        coarse_(detail == BodyDetail::kCoarse) {}

  SkinMesh Build() {
    Trunk();
    Head();
    for (const float side : {1.0f, -1.0f}) {
      Arm(side);
      Leg(side);
      Boot(side);
    }
    Hands();
    Vest();
    Belt();
    Pack();
    SkinMesh mesh = b_.Take();
    mesh.mesh.material = "Soarbox/Soldier";
    return mesh;
  }

 private:
  void Wear(Cloth cloth, SkinVertex bone, float light = 1) {
    b_.cloth = cloth;
    if (dark_) {
      if (cloth == Cloth::kCamouflage) b_.cloth = Cloth::kDarkCamouflage;
      if (cloth == Cloth::kWebbing) b_.cloth = Cloth::kDarkWebbing;
      if (cloth == Cloth::kHelmet) b_.cloth = Cloth::kDarkHelmet;
    }
    b_.bone = bone;
    b_.light = light;
  }

  void Trunk() {
    Wear(Cloth::kCamouflage, By(kHips));
    b_.Loft({{{0, 0.80f, -0.005f}, 0.120f, 0.085f, By(kHips), 0.1f, 0.6f},
             {{0, 0.84f, -0.010f}, 0.156f, 0.108f, By(kHips), 0.15f, 0.8f},
             {{0, 0.90f, -0.014f}, 0.168f, 0.118f, By(kHips), 0.2f},
             {{0, 0.96f, -0.010f}, 0.160f, 0.114f, By(kHips), 0.2f},
             {{0, 1.02f, -0.004f}, 0.150f, 0.108f, By(kHips, kSpine, 0.4f), 0.2f},
             {{0, 1.10f, 0.000f}, 0.152f, 0.108f, By(kSpine), 0.2f},
             {{0, 1.18f, 0.000f}, 0.162f, 0.114f, By(kSpine, kChest, 0.4f), 0.2f},
             {{0, 1.28f, -0.002f}, 0.172f, 0.120f, By(kChest), 0.2f},
             {{0, 1.35f, -0.006f}, 0.172f, 0.110f, By(kChest), 0.2f},
             {{0, 1.395f, -0.010f}, 0.140f, 0.088f, By(kChest), 0.1f},
             {{0, 1.425f, -0.012f}, 0.090f, 0.070f, By(kChest), 0, 0.85f},
             {{0, 1.445f, -0.012f}, 0.066f, 0.064f, By(kChest, kNeck, 0.6f), 0, 0.7f}},
            24, {0, 0, 1});
    Wear(Cloth::kSkin, By(kNeck), 0.8f);
    b_.Loft({{{0, 1.41f, -0.012f}, 0.056f, 0.058f, By(kNeck)},
             {{0, 1.50f, -0.004f}, 0.053f, 0.056f, By(kNeck)},
             {{0, 1.55f, 0.004f}, 0.054f, 0.060f, By(kNeck, kHead, 0.4f)}},
            14, {0, 0, 1});
    // A scarf between collar and chin.
    Wear(Cloth::kWebbing, By(kNeck, kChest, 0.5f), 0.9f);
    b_.Loft({{{0, 1.425f, -0.004f}, 0.082f, 0.080f, By(kChest)},
             {{0, 1.455f, 0.004f}, 0.079f, 0.084f, By(kNeck, kChest, 0.5f)},
             {{0, 1.485f, 0.002f}, 0.066f, 0.070f, By(kNeck)}},
            16, {0, 0, 1});
  }

  void Head() {
    Wear(Cloth::kSkin, By(kHead));
    // The jaw is narrower than the forehead, and the chin protrudes.
    b_.Round({0, 1.595f, 0.016f}, {0.074f, 0.115f, 0.092f}, 0.88f, 20, -1, 1, [](Vec3 p) {
      const float down = std::max(0.0f, (1.60f - p.y) / 0.115f);
      p.x *= 1 - 0.26f * down * down;
      if (p.z > 0) p.z += 0.006f * down;
      return p;
    });
    if (!coarse_) {
      b_.Round({0, 1.585f, 0.112f}, {0.014f, 0.024f, 0.016f}, 0.9f, 8);
      b_.Round({0, 1.573f, 0.117f}, {0.018f, 0.012f, 0.014f}, 0.9f, 8);
      Wear(Cloth::kSkin, By(kHead), 0.72f);
      b_.Round({0, 1.545f, 0.104f}, {0.026f, 0.006f, 0.010f}, 0.9f, 8);
    }
    // Goggles: a dark band of glass in a frame.
    Wear(Cloth::kRubber, By(kHead));
    b_.Loft({{{0, 1.597f, 0.016f}, 0.080f, 0.093f, By(kHead), 0.15f},
             {{0, 1.605f, 0.016f}, 0.084f, 0.102f, By(kHead), 0.2f},
             {{0, 1.640f, 0.016f}, 0.085f, 0.102f, By(kHead), 0.2f},
             {{0, 1.648f, 0.016f}, 0.081f, 0.093f, By(kHead), 0.15f}},
            20, {0, 0, 1});
    Wear(Cloth::kGlass, By(kHead));
    b_.Round({0, 1.622f, 0.088f}, {0.066f, 0.021f, 0.036f}, 0.45f, 16, -1, 1, [](Vec3 p) {
      p.z -= 3.2f * p.x * p.x;
      return p;
    });
    // Helmet: a shell that is lower at the back and the sides, its rim, and its attachments.
    Wear(Cloth::kHelmet, By(kHead));
    const auto shell = [](Vec3 p) {
      const float low = std::max(0.0f, (1.66f - p.y) / 0.05f);
      if (p.z < 0.03f) p.y -= 0.040f * low * std::min(1.0f, (0.03f - p.z) / 0.06f);
      return p;
    };
    b_.Round({0, 1.640f, 0.002f}, {0.116f, 0.126f, 0.138f}, 0.92f, 26, 0.04f, 1, shell);
    Wear(Cloth::kRubber, By(kHead));
    b_.Round({0, 1.640f, 0.002f}, {0.118f, 0.030f, 0.140f}, 0.92f, 26, -0.10f, 0.28f, shell);
    // The band is on the shell, so it is part of a slightly larger ellipsoid.
    Wear(Cloth::kTeam, By(kHead));
    b_.Round({0, 1.640f, 0.002f}, {0.1185f, 0.1285f, 0.1405f}, 0.92f, 26, 0.22f, 0.36f, shell);
    if (coarse_) return;
    Wear(Cloth::kRubber, By(kHead));
    b_.Round({0, 1.700f, 0.128f}, {0.020f, 0.024f, 0.012f}, 0.4f, 8);
    for (const float side : {1.0f, -1.0f}) {
      b_.Round({side * 0.114f, 1.660f, 0.010f}, {0.007f, 0.012f, 0.062f}, 0.35f, 8);
      // Ear cups, and the strap to the chin.
      b_.Round({side * 0.088f, 1.592f, 0.006f}, {0.022f, 0.037f, 0.029f}, 0.6f, 12);
      b_.Tube({{side * 0.086f, 1.60f, 0.045f}, {side * 0.064f, 1.53f, 0.075f}, {side * 0.014f, 1.493f, 0.094f}},
              0.0055f, 6);
    }
  }

  void Arm(float side) {
    const int clavicle = side > 0 ? kLeftClavicle : kRightClavicle, upper = clavicle + 1, lower = clavicle + 2;
    const Vec3 shoulder{side * Size::kShoulderSide, Size::kShoulder, -0.01f};
    const Vec3 way = BindArmDirection(side);
    const auto at = [&](float along, float out = 0) { return shoulder + way * along + Vec3{side * out, 0, 0}; };
    const float elbow = Size::kUpperArm, wrist = elbow + Size::kForearm;
    Wear(Cloth::kCamouflage, By(upper));
    std::vector<Ring> rings{
        {at(-0.085f) + Vec3{-side * 0.030f, -0.045f, 0}, 0.050f, 0.062f, By(kChest)},
        {at(-0.055f) + Vec3{-side * 0.008f, -0.026f, 0}, 0.058f, 0.068f, By(kChest, clavicle, 0.5f)},
        {at(-0.02f) + Vec3{0, -0.008f, 0}, 0.063f, 0.069f, By(clavicle, upper, 0.5f)},
        {at(0.035f), 0.063f, 0.067f, By(upper)},
        {at(0.09f), 0.061f, 0.064f, By(upper)},
        {at(0.17f), 0.055f, 0.058f, By(upper), 0, 0.95f},
        {at(elbow - 0.045f), 0.051f, 0.053f, By(upper)},
        {at(elbow), 0.050f, 0.051f, By(upper, lower, 0.5f)},
        {at(elbow + 0.045f), 0.051f, 0.053f, By(lower)},
        {at(elbow + 0.10f), 0.049f, 0.051f, By(lower)},
        {at(elbow + 0.17f), 0.042f, 0.043f, By(lower)},
        {at(wrist - 0.025f), 0.039f, 0.040f, By(lower)},
        {at(wrist - 0.012f), 0.034f, 0.035f, By(lower), 0, 0.7f}};
    b_.Loft(rings, 16, {0, 0, 1});
    // The glove's cuff, the elbow's pad, and the team's band.
    Wear(Cloth::kLeather, By(lower));
    b_.Loft({{at(wrist - 0.035f), 0.033f, 0.034f, By(lower)},
             {at(wrist - 0.01f), 0.034f, 0.034f, By(lower)},
             {at(wrist + 0.02f), 0.031f, 0.030f, By(clavicle + 3)}},
            12, {0, 0, 1});
    Wear(Cloth::kTeam, By(upper));
    b_.Loft({{at(0.085f), 0.0645f, 0.0675f, By(upper)}, {at(0.135f), 0.0605f, 0.0635f, By(upper)}}, 16, {0, 0, 1},
            false);
    if (coarse_) return;
    Wear(Cloth::kRubber, By(upper, lower, 0.5f));
    b_.Round(at(elbow) + Vec3{0, 0, -0.040f}, {0.034f, 0.046f, 0.022f}, 0.6f, 12);
  }

  /// Moves what was built in the rifle's space to the hand that holds the rifle, in the bind pose.
  void PlaceInHand(int hand, const BonePose& hand_in_rifle) {
    Wear(Cloth::kLeather, By(hand));
    b_.place = SoldierSkeleton().BindInModel(hand) * Inverse(hand_in_rifle);
  }

  void Hands() {
    const RifleHold& hold = HoldOfRifle();
    const Vec3 g = hold.grip;
    PlaceInHand(kRightHand, {hold.right_wrist, hold.right_hand});
    b_.Round(g + Vec3{-0.040f, 0.012f, 0.016f}, {0.046f, 0.040f, 0.021f}, 0.62f, 14);
    if (coarse_) {
      b_.Round(g + Vec3{0.012f, -0.004f, 0.002f}, {0.034f, 0.042f, 0.036f}, 0.7f, 8);
    } else {
      for (int finger = 0; finger < 3; ++finger) {
        const float y = 0.014f - 0.023f * static_cast<float>(finger);
        b_.Tube({g + Vec3{-0.012f, y, 0.030f}, g + Vec3{0.024f, y, 0.029f}, g + Vec3{0.038f, y, 0.004f},
                 g + Vec3{0.020f, y, -0.026f}, g + Vec3{-0.002f, y, -0.026f}},
                0.0115f);
      }
      b_.Tube({g + Vec3{-0.012f, 0.037f, 0.030f}, g + Vec3{0.036f, 0.040f, 0.029f}, g + Vec3{0.062f, 0.040f, 0.010f}},
              0.0105f);
      b_.Tube(
          {g + Vec3{-0.048f, 0.030f, -0.004f}, g + Vec3{-0.020f, 0.034f, -0.030f}, g + Vec3{0.018f, 0.030f, -0.030f}},
          0.0125f);
    }
    PlaceInHand(kLeftHand, {hold.left_wrist, hold.left_hand});
    const Vec3 way = Normalized(Vec3{0.62f, 0.30f, 0.72f}), palm = hold.left_wrist + way * 0.05f;
    b_.Loft({{hold.left_wrist, 0.030f, 0.024f, By(kLeftHand), 0.3f},
             {hold.left_wrist + way * 0.03f, 0.042f, 0.022f, By(kLeftHand), 0.4f},
             {hold.left_wrist + way * 0.07f, 0.045f, 0.019f, By(kLeftHand), 0.5f},
             {hold.left_wrist + way * 0.095f, 0.038f, 0.015f, By(kLeftHand), 0.5f}},
            14, {0, 0.95f, 0.3f});
    if (coarse_) {
      b_.place = {};
      return;
    }
    // Fingers go under the handguard and up its right side, the thumb up its left side.
    for (int finger = 0; finger < 4; ++finger) {
      const Vec3 start =
          palm + Vec3{0.012f, 0.0f, 0.0f} + Vec3{0.023f * static_cast<float>(finger) - 0.008f, 0.010f, 0.012f};
      b_.Tube({start, start + Vec3{0.008f, 0.006f, 0.030f}, start + Vec3{0.006f, 0.032f, 0.046f},
               start + Vec3{0.004f, 0.054f, 0.040f}},
              0.0110f);
    }
    b_.Tube({hold.left_wrist + way * 0.025f + Vec3{0.0f, 0.012f, -0.012f},
             hold.left_wrist + way * 0.05f + Vec3{0.022f, 0.034f, -0.032f},
             hold.left_wrist + way * 0.06f + Vec3{0.042f, 0.058f, -0.036f}},
            0.0125f);
    b_.place = {};
  }

  void Leg(float side) {
    const int thigh = side > 0 ? kLeftThigh : kRightThigh, shin = thigh + 1;
    const float x = side * Size::kHipSide;
    const float knee = Size::kHipHeight - Size::kThigh;
    Wear(Cloth::kCamouflage, By(thigh));
    b_.Loft({{{x * 0.92f, 0.935f, -0.012f}, 0.074f, 0.098f, By(kHips), 0.1f},
             {{x * 0.94f, 0.875f, -0.008f}, 0.085f, 0.104f, By(kHips, thigh, 0.5f), 0.1f, 0.9f},
             {{x, 0.81f, -0.002f}, 0.089f, 0.100f, By(thigh), 0, 0.9f},
             {{x, 0.70f, 0.004f}, 0.083f, 0.092f, By(thigh)},
             {{x, 0.60f, 0.006f}, 0.073f, 0.082f, By(thigh)},
             {{x, knee + 0.055f, 0.006f}, 0.066f, 0.072f, By(thigh)},
             {{x, knee, 0.004f}, 0.063f, 0.069f, By(thigh, shin, 0.5f)},
             {{x, knee - 0.055f, -0.004f}, 0.062f, 0.066f, By(shin)},
             {{x, 0.36f, -0.014f}, 0.063f, 0.070f, By(shin)},
             {{x, 0.28f, -0.014f}, 0.059f, 0.066f, By(shin)},
             {{x, 0.235f, -0.010f}, 0.062f, 0.069f, By(shin)},
             {{x, 0.215f, -0.008f}, 0.052f, 0.058f, By(shin), 0, 0.6f}},
            18, {0, 0, 1});
    Wear(Cloth::kRubber, By(thigh, shin, 0.4f));
    b_.Round({x, knee - 0.005f, 0.060f}, {0.048f, 0.068f, 0.026f}, 0.55f, 14);
    if (coarse_) return;
    // A pocket on the thigh.
    Wear(Cloth::kCamouflage, By(thigh), 0.93f);
    b_.Round({x + side * 0.080f, 0.66f, 0.004f}, {0.020f, 0.075f, 0.060f}, 0.35f, 12);
    if (side > 0) return;
    // A pistol in its holster on the right.
    Wear(Cloth::kWebbing, By(thigh));
    b_.Round({x - 0.092f, 0.755f, 0.012f}, {0.021f, 0.078f, 0.036f}, 0.4f, 12);
    Wear(Cloth::kMetal, By(thigh));
    b_.Round({x - 0.094f, 0.835f, -0.002f}, {0.013f, 0.036f, 0.020f}, 0.4f, 10);
  }

  void Boot(float side) {
    const int shin = side > 0 ? kLeftShin : kRightShin, foot = shin + 1, toe = shin + 2;
    const float x = side * Size::kHipSide, ankle = Size::kAnkle;
    Wear(Cloth::kLeather, By(foot));
    b_.Loft({{{x, 0.245f, -0.010f}, 0.052f, 0.058f, By(shin)},
             {{x, 0.20f, -0.008f}, 0.051f, 0.056f, By(shin)},
             {{x, ankle + 0.045f, -0.004f}, 0.047f, 0.055f, By(shin, foot, 0.6f)},
             {{x, ankle, 0.0f}, 0.045f, 0.060f, By(foot)},
             {{x, 0.05f, 0.01f}, 0.046f, 0.072f, By(foot)},
             {{x, 0.022f, 0.014f}, 0.046f, 0.076f, By(foot)}},
            16, {0, 0, 1});
    // From the instep to the toecap.
    const float out = side * 0.006f;
    b_.Loft({{{x, 0.058f, 0.02f}, 0.044f, 0.048f, By(foot), 0.2f},
             {{x + out, 0.054f, 0.07f}, 0.048f, 0.042f, By(foot), 0.2f},
             {{x + out, 0.048f, Size::kBall - 0.005f}, 0.050f, 0.036f, By(foot, toe, 0.5f), 0.25f},
             {{x + out, 0.046f, 0.165f}, 0.048f, 0.034f, By(toe), 0.2f},
             {{x + out, 0.044f, 0.195f}, 0.040f, 0.030f, By(toe)},
             {{x + out, 0.042f, 0.208f}, 0.026f, 0.020f, By(toe)}},
            16, {0, 1, 0});
    Wear(Cloth::kRubber, By(foot));
    b_.Round({x, 0.018f, -0.028f}, {0.044f, 0.018f, 0.054f}, 0.4f, 14);
    b_.Loft({{{x, 0.015f, 0.005f}, 0.042f, 0.015f, By(foot), 0.6f},
             {{x + out, 0.013f, 0.07f}, 0.048f, 0.013f, By(foot), 0.6f},
             {{x + out, 0.012f, Size::kBall}, 0.052f, 0.012f, By(foot, toe, 0.5f), 0.6f},
             {{x + out, 0.012f, 0.18f}, 0.047f, 0.012f, By(toe), 0.5f},
             {{x + out, 0.013f, 0.212f}, 0.030f, 0.010f, By(toe), 0.2f}},
            12, {0, 1, 0});
  }

  void Vest() {
    Wear(Cloth::kWebbing, By(kChest));
    b_.Loft({{{0, 1.075f, 0.002f}, 0.158f, 0.118f, By(kSpine), 0.35f, 0.75f},
             {{0, 1.085f, 0.003f}, 0.169f, 0.130f, By(kSpine), 0.4f},
             {{0, 1.17f, 0.004f}, 0.177f, 0.136f, By(kSpine, kChest, 0.4f), 0.45f},
             {{0, 1.27f, 0.003f}, 0.180f, 0.139f, By(kChest), 0.45f},
             {{0, 1.325f, 0.002f}, 0.164f, 0.134f, By(kChest), 0.5f},
             {{0, 1.365f, 0.000f}, 0.132f, 0.122f, By(kChest), 0.5f},
             {{0, 1.385f, -0.002f}, 0.118f, 0.105f, By(kChest), 0.4f, 0.8f}},
            24, {0, 0, 1});
    // The plate in front, and the straps over the shoulders.
    b_.Round({0, 1.275f, 0.128f}, {0.118f, 0.105f, 0.022f}, 0.35f, 14);
    for (const float side : {1.0f, -1.0f}) {
      b_.bone = By(kChest);
      b_.Round({side * 0.100f, 1.400f, -0.004f}, {0.036f, 0.022f, 0.108f}, 0.55f, 12, -1, 1, [](Vec3 p) {
        p.y -= 2.6f * (p.z + 0.004f) * (p.z + 0.004f);
        return p;
      });
    }
    // Magazines across the stomach.
    for (const float place : {-1.0f, 0.0f, 1.0f}) {
      Wear(Cloth::kWebbing, By(kSpine), 0.94f);
      b_.Round({place * 0.088f, 1.130f, 0.152f - 0.012f * std::abs(place)}, {0.038f, 0.066f, 0.026f}, 0.32f, 12);
      if (coarse_) continue;
      Wear(Cloth::kWebbing, By(kSpine), 0.8f);
      b_.Round({place * 0.088f, 1.180f, 0.156f - 0.012f * std::abs(place)}, {0.040f, 0.018f, 0.029f}, 0.35f, 12);
    }
    if (coarse_) return;
    // Radio on the left, a pouch on the right, the team's mark between them.
    Wear(Cloth::kWebbing, By(kChest), 0.9f);
    b_.Round({0.092f, 1.300f, 0.155f}, {0.030f, 0.048f, 0.020f}, 0.35f, 10);
    b_.Round({-0.086f, 1.285f, 0.156f}, {0.036f, 0.030f, 0.020f}, 0.35f, 10);
    Wear(Cloth::kTeam, By(kChest));
    b_.Round({-0.086f, 1.345f, 0.141f}, {0.032f, 0.017f, 0.012f}, 0.3f, 8);
    Wear(Cloth::kRubber, By(kChest));
    b_.Tube({{0.112f, 1.33f, 0.150f}, {0.120f, 1.42f, 0.120f}, {0.128f, 1.51f, 0.085f}}, 0.004f, 5);
    b_.Round({0.092f, 1.352f, 0.156f}, {0.012f, 0.012f, 0.010f}, 0.5f, 8);
  }

  void Belt() {
    Wear(Cloth::kLeather, By(kHips));
    b_.Loft({{{0, 0.962f, -0.010f}, 0.166f, 0.120f, By(kHips), 0.2f},
             {{0, 0.968f, -0.010f}, 0.171f, 0.125f, By(kHips), 0.2f},
             {{0, 1.005f, -0.006f}, 0.167f, 0.122f, By(kHips), 0.2f},
             {{0, 1.011f, -0.006f}, 0.161f, 0.116f, By(kHips), 0.2f}},
            22, {0, 0, 1});
    Wear(Cloth::kWebbing, By(kHips), 0.92f);
    for (const float side : {1.0f, -1.0f})
      b_.Round({side * 0.158f, 0.955f, -0.02f}, {0.030f, 0.058f, 0.050f}, 0.38f, 12);
    if (coarse_) return;
    b_.Round({0.085f, 0.955f, -0.132f}, {0.046f, 0.060f, 0.032f}, 0.4f, 12);
    b_.Round({-0.085f, 0.955f, -0.132f}, {0.046f, 0.060f, 0.032f}, 0.4f, 12);
    Wear(Cloth::kMetal, By(kHips));
    b_.Round({0, 0.986f, 0.118f}, {0.022f, 0.018f, 0.008f}, 0.35f, 8);
  }

  void Pack() {
    Wear(Cloth::kWebbing, By(kChest));
    b_.Round({0, 1.225f, -0.200f}, {0.140f, 0.170f, 0.078f}, 0.40f, 18, -1, 1, [](Vec3 p) {
      // Heavier below than above.
      p.z -= 0.14f * std::max(0.0f, 1.30f - p.y) * (p.z < -0.2f ? 1.0f : 0.0f);
      return p;
    });
    Wear(Cloth::kWebbing, By(kChest), 0.86f);
    b_.Round({0, 1.372f, -0.200f}, {0.147f, 0.034f, 0.086f}, 0.42f, 18);
    b_.Round({0, 1.170f, -0.285f}, {0.100f, 0.080f, 0.034f}, 0.4f, 14);
    for (const float side : {1.0f, -1.0f})
      b_.Round({side * 0.150f, 1.185f, -0.195f}, {0.030f, 0.085f, 0.052f}, 0.45f, 12);
    Wear(Cloth::kCamouflage, By(kChest), 0.9f);
    b_.Tube({{-0.165f, 1.030f, -0.185f}, {0.165f, 1.030f, -0.185f}}, 0.056f, 14);
    Wear(Cloth::kTeam, By(kChest));
    b_.Round({0, 1.325f, -0.279f}, {0.050f, 0.028f, 0.006f}, 0.3f, 8);
  }

  SkinBuilder b_;
  bool dark_, coarse_;
};

}  // namespace

SkinMesh MakeSoldierMesh(BodyDetail detail, bool dark) {
  return SoldierBuilder(detail, dark).Build();
}

SkinMesh MakeBodyMesh(world::BodyLook look, BodyDetail detail) {
  const bool dark = look == world::BodyLook::kDarkSoldier;
  if (look == world::BodyLook::kRifle) return detail == BodyDetail::kTiny ? MakeTinyRifleMesh() : MakeRifleMesh(detail);
  return detail == BodyDetail::kTiny ? MakeTinySoldierMesh(dark) : MakeSoldierMesh(detail, dark);
}

}  // namespace soarbox::viewer
