// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/light_rig.h"

#include <algorithm>
#include <cmath>

namespace soarbox::viewer {
namespace {

constexpr std::uint16_t kShadowMapSize = 2048, kShadowMapSizeLow = 1536;
constexpr std::size_t kFurtherLights = 4;

/// Half the width of the area of each shadow map when the camera is near the ground, in m.
constexpr float kCovered[2] = {20, 95};
/// In low detail only one map is used; the other covers almost nothing, so that almost nothing is drawn into it.
constexpr float kCoveredLow[2] = {42, 0.5f};

/// Covers a square in front of the camera as seen from the sun. The square moves by entire texels, so that the edges of
/// shadows do not flicker when the camera moves.
class SunView : public Ogre::ShadowCameraSetup {
 public:
  SunView(std::uint16_t map_size, bool low_detail) : map_size_(map_size), low_detail_(low_detail) {}

  void getShadowCamera(const Ogre::SceneManager*, const Ogre::Camera* camera, const Ogre::Viewport*,
                       const Ogre::Light* light, Ogre::Camera* sun_eye, std::size_t map) const override {
    const Ogre::Vector3 eye = camera->getDerivedPosition();
    Ogre::Vector3 ahead = camera->getDerivedDirection();
    // Powers of two, so that the maps seldom change their size.
    const float height = std::max(1.0f, std::abs(eye.y) / 14.0f);
    const float* usual = low_detail_ ? kCoveredLow : kCovered;
    const float covered = usual[std::min<std::size_t>(map, 1)] * std::exp2(std::ceil(std::log2(height)));
    float reach = 0.75f * covered;
    if (ahead.y < -0.05f) reach = std::min(reach, eye.y / -ahead.y);
    ahead.y = std::min(ahead.y, 0.0f);
    Ogre::Vector3 centre = eye + ahead * std::max(reach, 0.0f);
    centre.y = std::clamp(centre.y, -20.0f, 40.0f);

    Ogre::Vector3 direction = light->getDerivedDirection();
    const Ogre::Vector3 up = std::abs(direction.y) > 0.99f ? Ogre::Vector3::UNIT_X : Ogre::Vector3::UNIT_Y;
    const Ogre::Vector3 right = direction.crossProduct(up).normalisedCopy();
    const Ogre::Vector3 upright = right.crossProduct(direction);
    const Ogre::Quaternion turn(right, upright, -direction);
    const float texel = 2 * covered / static_cast<float>(map_size_);
    Ogre::Vector3 seen = turn.Inverse() * centre;
    seen.x = std::floor(seen.x / texel) * texel;
    seen.y = std::floor(seen.y / texel) * texel;
    const float range = 1.4f * covered + 60;
    sun_eye->getParentSceneNode()->setPosition(turn * seen - direction * range);
    sun_eye->getParentSceneNode()->setOrientation(turn);
    sun_eye->setProjectionType(Ogre::PT_ORTHOGRAPHIC);
    sun_eye->setOrthoWindow(2 * covered, 2 * covered);
    sun_eye->setNearClipDistance(1);
    sun_eye->setFarClipDistance(2 * range);
  }

 private:
  std::uint16_t map_size_;
  bool low_detail_;
};

Ogre::Vector4 Four(world::Vec3 v, float w) {
  return {v.x, v.y, v.z, w};
}

}  // namespace

LightRig::LightRig(Ogre::SceneManager& scene, const Shaders& shaders, const Ogre::MaterialPtr& caster, bool low_detail)
    : values_(shaders.scene_values()) {
  scene.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
  scene.setShadowTextureCountPerLightType(Ogre::Light::LT_DIRECTIONAL, 2);
  const std::uint16_t map_size = low_detail ? kShadowMapSizeLow : kShadowMapSize;
  scene.setShadowTextureSettings(map_size, 2, Ogre::PF_DEPTH32);
  if (low_detail) scene.setShadowTextureConfig(1, 64, 64, Ogre::PF_DEPTH32);
  scene.setShadowTextureSelfShadow(true);
  scene.setShadowCasterRenderBackFaces(false);
  scene.setShadowTextureCasterMaterial(caster);
  scene.setShadowCameraSetup(std::make_shared<SunView>(map_size, low_detail));
  scene.setShadowFarDistance(2000);
  sun_ = scene.createLight("Soarbox/Sun");
  sun_->setType(Ogre::Light::LT_DIRECTIONAL);
  sun_->setCastShadows(true);
  sun_node_ = scene.getRootSceneNode()->createChildSceneNode();
  sun_node_->attachObject(sun_);
  SetSkyRotation({});
}

bool LightRig::Update(const world::SceneSnapshot& snapshot) {
  const world::LightSnapshot* sun = nullptr;
  Ogre::Vector4 place[kFurtherLights], colour[kFurtherLights], fade[kFurtherLights];
  std::fill(std::begin(place), std::end(place), Ogre::Vector4(0, 1, 0, 0));
  std::fill(std::begin(colour), std::end(colour), Ogre::Vector4(0, 0, 0, 0));
  std::fill(std::begin(fade), std::end(fade), Ogre::Vector4(1, 0, 0, 0));
  std::size_t further = 0;
  for (const world::LightSnapshot& light : snapshot.lights) {
    const bool directional = light.kind == world::LightKind::kDirectional;
    if (directional && sun == nullptr) {
      sun = &light;
      continue;
    }
    if (further == kFurtherLights) break;
    place[further] = directional ? Four(-world::Normalized(light.direction), 0) : Four(light.position, 1);
    colour[further] = Four(light.diffuse, directional ? 0 : light.range_m);
    fade[further] = Ogre::Vector4(light.attenuation[0], light.attenuation[1], light.attenuation[2], 0);
    ++further;
  }

  world::Vec3 direction = sun != nullptr ? world::Normalized(sun->direction) : world::Vec3{0.4f, -0.8f, 0.45f};
  if (world::LengthSquared(direction) < 0.5f) direction = {0, -1, 0};
  const world::Vec3 diffuse = sun != nullptr ? sun->diffuse : world::Vec3{};
  sun_node_->setDirection(ToOgre(direction), Ogre::Node::TS_WORLD);
  values_.setNamedConstant("sun_direction", Four(-direction, 0));
  values_.setNamedConstant("sun_colour", Four(diffuse, sun == nullptr || sun->casts_shadows ? 1.0f : 0.0f));
  values_.setNamedConstant("ambient_colour", Four(snapshot.ambient, 0));
  values_.setNamedConstant("haze", Ogre::Vector4(1.0f / 420.0f, 4.0f, static_cast<float>(further), 0));
  values_.setNamedConstant("light_place", place[0].ptr(), 4 * kFurtherLights);
  values_.setNamedConstant("light_colour", colour[0].ptr(), 4 * kFurtherLights);
  values_.setNamedConstant("light_fade", fade[0].ptr(), 4 * kFurtherLights);
  return further > 0;
}

void LightRig::SetSkyRotation(world::Vec3 degrees) {
  Ogre::Matrix3 turn;
  turn.FromEulerAnglesXYZ(Ogre::Degree(degrees.x), Ogre::Degree(degrees.y), Ogre::Degree(degrees.z));
  values_.setNamedConstant("sky_turn", Ogre::Matrix4(turn.Transpose()));
}

}  // namespace soarbox::viewer
