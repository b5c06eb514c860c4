// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "viewer/body_mesh.h"
#include "world/animation/rifle_rig.h"
#include "world/animation/soldier_skeleton.h"

// The rifle, along +x: receiver, stock, handguard, barrel, magazine, sights.
namespace soarbox::viewer {
namespace {

using world::RifleSize;
using world::Vec3;
using Ring = SkinBuilder::Ring;

class RifleBuilder {
 public:
  explicit RifleBuilder(BodyDetail detail)
      : b_(detail == BodyDetail::kFine     ? 1.0f
           : detail == BodyDetail::kMiddle ? 0.6f
                                           : 0.3f),
        coarse_(detail == BodyDetail::kCoarse) {
    b_.place.position = world::HoldOfRifle().grip;
  }

  SkinMesh Build() {
    Body();
    Stock();
    Barrel();
    if (!coarse_) Sights();
    SkinMesh mesh = b_.Take();
    mesh.mesh.material = "Soarbox/Soldier";
    return mesh;
  }

 private:
  void Use(Cloth cloth, int bone, float light = 1) {
    b_.cloth = cloth;
    b_.bone = {static_cast<std::uint8_t>(bone), 0, 1};
    b_.light = light;
  }
  /// A rod along x through rings of (x, radius).
  void Rod(const std::vector<std::pair<float, float>>& rings, float y, int segments, float square = 0, float tall = 1) {
    std::vector<Ring> made;
    for (const auto& [x, radius] : rings) made.push_back({{x, y, 0}, radius, radius * tall, b_.bone, square});
    b_.Loft(made, segments, {0, 1, 0});
  }

  void Body() {
    Use(Cloth::kMetal, world::kRifleBody);
    b_.Round({0.055f, 0.062f, 0}, {0.135f, 0.036f, 0.021f}, 0.28f, 14);
    b_.Round({0.055f, 0.098f, 0}, {0.125f, 0.014f, 0.016f}, 0.28f, 12);
    // The grip leans backwards.
    Use(Cloth::kRubber, world::kRifleBody);
    b_.Round({-0.002f, -0.006f, 0}, {0.021f, 0.056f, 0.016f}, 0.4f, 12, -1, 1, [](Vec3 p) {
      p.x += 0.28f * p.y;
      return p;
    });
    if (!coarse_) {
      b_.Tube({{0.022f, 0.022f, 0}, {0.055f, 0.012f, 0}, {0.082f, 0.026f, 0}}, 0.0045f, 6);
      Use(Cloth::kSteel, world::kRifleBody);
      b_.Tube({{0.046f, 0.036f, 0}, {0.052f, 0.018f, 0}}, 0.0035f, 5);
    }
    Use(Cloth::kMetal, world::kRifleMagazine, 0.85f);
    b_.Round({0.132f, -0.040f, 0}, {0.030f, 0.088f, 0.0125f}, 0.3f, 12, -1, 1, [](Vec3 p) {
      const float down = std::max(0.0f, 0.03f - p.y);
      p.x += 1.6f * down * down;
      return p;
    });
    Use(Cloth::kSteel, world::kRifleBolt);
    b_.Tube({{0.040f, 0.080f, 0.020f}, {0.036f, 0.082f, 0.044f}}, 0.0055f, 8);
    b_.Round({0.036f, 0.083f, 0.048f}, {0.009f, 0.009f, 0.009f}, 0.8f, 8);
  }

  void Stock() {
    Use(Cloth::kMetal, world::kRifleBody);
    Rod({{-0.16f, 0.014f}, {-0.07f, 0.016f}}, 0.070f, 10);
    Use(Cloth::kRubber, world::kRifleStock);
    b_.Round({-0.195f, 0.055f, 0}, {0.070f, 0.040f, 0.017f}, 0.3f, 14, -1, 1, [](Vec3 p) {
      // Deeper towards the butt.
      if (p.y < 0.055f) p.y -= 0.35f * std::max(0.0f, -0.15f - p.x);
      return p;
    });
    Use(Cloth::kRubber, world::kRifleStock, 0.7f);
    b_.Round({-0.262f, 0.040f, 0}, {0.009f, 0.064f, 0.019f}, 0.35f, 10);
  }

  void Barrel() {
    Use(Cloth::kRubber, world::kRifleBody);
    Rod({{0.185f, 0.026f}, {0.190f, 0.030f}, {0.365f, 0.028f}, {0.372f, 0.023f}}, 0.072f, 12, 0.45f, 1.08f);
    Use(Cloth::kMetal, world::kRifleBody);
    b_.Round({0.28f, 0.108f, 0}, {0.095f, 0.005f, 0.011f}, 0.25f, 8);
    Use(Cloth::kMetal, world::kRifleBarrel);
    Rod({{0.30f, 0.0125f}, {0.56f, 0.0105f}}, RifleSize::kBore, 10);
    Use(Cloth::kRubber, world::kRifleBarrel);
    Rod({{0.555f, 0.0120f}, {0.560f, 0.0185f}, {RifleSize::kMuzzle - 0.004f, 0.0185f}, {RifleSize::kMuzzle, 0.0140f}},
        RifleSize::kBore, 12);
  }

  void Sights() {
    Use(Cloth::kMetal, world::kRifleBody);
    for (const float x : {0.02f, 0.11f}) b_.Round({x, 0.118f, 0}, {0.011f, 0.016f, 0.013f}, 0.35f, 8);
    Use(Cloth::kRubber, world::kRifleBody);
    Rod({{-0.045f, 0.017f},
         {-0.040f, 0.021f},
         {0.005f, 0.020f},
         {0.015f, 0.0155f},
         {0.115f, 0.0155f},
         {0.130f, 0.022f},
         {0.175f, 0.024f},
         {0.178f, 0.020f}},
        0.142f, 14);
    Use(Cloth::kGlass, world::kRifleBody);
    b_.Round({0.176f, 0.142f, 0}, {0.004f, 0.020f, 0.020f}, 0.8f, 12);
    b_.Round({-0.044f, 0.142f, 0}, {0.004f, 0.016f, 0.016f}, 0.8f, 12);
    Use(Cloth::kRubber, world::kRifleBody);
    Rod({{0.058f, 0.011f}, {0.076f, 0.011f}}, 0.162f, 8);
  }

  SkinBuilder b_;
  bool coarse_;
};

}  // namespace

SkinMesh MakeRifleMesh(BodyDetail detail) {
  return RifleBuilder(detail).Build();
}

}  // namespace soarbox::viewer
