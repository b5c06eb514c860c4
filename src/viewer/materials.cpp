// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/materials.h"

#include <cmath>
#include <cstdio>

#include "viewer/cloth_image.h"

namespace soarbox::viewer {
namespace {

constexpr const char* kSkyTexture = "Soarbox/SkyPicture";

Ogre::Vector4 ColorVector(world::Color c) {
  return {c.r, c.g, c.b, c.a};
}

Ogre::PixelBox Box(const Image& image) {
  // Ogre only reads from this box.
  return Ogre::PixelBox(static_cast<unsigned>(image.width), static_cast<unsigned>(image.height), 1, Ogre::PF_BYTE_RGBA,
                        const_cast<std::uint8_t*>(image.pixels.data()));
}

/// The mean of some rows of a picture in linear light.
Ogre::Vector4 MeanLight(const Image& image, int first_row, int end_row) {
  double sum[3] = {0, 0, 0};
  int count = 0;
  for (int y = first_row; y < end_row; y += 2) {
    for (int x = 0; x < image.width; x += 4, ++count) {
      const auto at =
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
      for (std::size_t c = 0; c < 3; ++c) sum[c] += std::pow(image.pixels[at + c] / 255.0, 2.2);
    }
  }
  const double scale = 1.0 / std::max(count, 1);
  return {static_cast<float>(sum[0] * scale), static_cast<float>(sum[1] * scale), static_cast<float>(sum[2] * scale),
          0};
}

const std::vector<std::string> kSurfaceSamplers{"paint", "shadow_near", "shadow_far", "sky", "bones"};

/// The suffix that distinguishes the variants of a material.
const char* EndingOf(Placing placing) {
  return placing == Placing::kOne ? "" : placing == Placing::kMany ? "/many" : "/bones";
}

Ogre::TexturePtr MakeTexture(const char* name, const Image& image) {
  auto texture = Ogre::TextureManager::getSingleton().createManual(
      name, kGroup, Ogre::TEX_TYPE_2D, static_cast<unsigned>(image.width), static_cast<unsigned>(image.height),
      Ogre::MIP_UNLIMITED, Ogre::PF_BYTE_RGBA, Ogre::TU_AUTOMIPMAP);
  texture->getBuffer()->blitFromMemory(Box(image));
  return texture;
}

Ogre::Pass& NewPass(const std::string& name, Ogre::MaterialPtr& material) {
  material = Ogre::MaterialManager::getSingleton().create(name, kGroup);
  return *material->getTechnique(0)->getPass(0);
}

void AddTexture(Ogre::Pass& pass, const char* texture, bool repeats) {
  Ogre::TextureUnitState* unit = pass.createTextureUnitState();
  unit->setTextureName(texture, std::string_view(texture) == kSkyTexture ? Ogre::TEX_TYPE_CUBE_MAP : Ogre::TEX_TYPE_2D);
  unit->setTextureFiltering(Ogre::TFO_TRILINEAR);
  unit->setTextureAddressingMode(repeats ? Ogre::TextureUnitState::TAM_WRAP : Ogre::TextureUnitState::TAM_CLAMP);
}

void AddBones(Ogre::Pass& pass) {
  Ogre::TextureUnitState* unit = pass.createTextureUnitState();
  unit->setTextureName(kBonesTexture);
  unit->setTextureFiltering(Ogre::TFO_NONE);
}

void AddShadowMap(Ogre::Pass& pass) {
  Ogre::TextureUnitState* unit = pass.createTextureUnitState();
  unit->setContentType(Ogre::TextureUnitState::CONTENT_SHADOW);
  unit->setTextureAddressingMode(Ogre::TextureUnitState::TAM_BORDER);
  unit->setTextureBorderColour(Ogre::ColourValue::White);
  unit->setTextureFiltering(Ogre::FO_LINEAR, Ogre::FO_LINEAR, Ogre::FO_NONE);
  unit->setTextureCompareEnabled(true);
  unit->setTextureCompareFunction(Ogre::CMPF_LESS_EQUAL);
}

}  // namespace

Materials::Materials(const Shaders& shaders, bool low_detail) : shaders_(shaders), low_detail_(low_detail) {}

const char* Materials::PaintTexture(Look::Paint paint) {
  const auto once = [](const char* name, const auto& picture) {
    if (!Ogre::TextureManager::getSingleton().resourceExists(name, kGroup)) MakeTexture(name, picture());
    return name;
  };
  switch (paint) {
    case Look::Paint::kGround:
      return once("Soarbox/Grain", GrainImage);
    case Look::Paint::kConcrete:
      return once("Soarbox/ConcretePicture", ConcreteImage);
    case Look::Paint::kBrick:
      return once("Soarbox/BrickPicture", BrickImage);
    case Look::Paint::kCrate:
      return once("Soarbox/CratePicture", CrateImage);
    case Look::Paint::kCloth:
      return once("Soarbox/ClothPicture", [this] { return ClothImage(low_detail_ ? 128 : 256); });
    case Look::Paint::kLeaves:
      return once("Soarbox/LeafPicture", LeafImage);
    case Look::Paint::kStone:
      return once("Soarbox/StonePicture", StoneImage);
    case Look::Paint::kMissing:
      return once("Soarbox/Checker", CheckerImage);
    case Look::Paint::kPlain:
    case Look::Paint::kCorners:
      break;
  }
  return once("Soarbox/WhitePicture", WhiteImage);
}

Materials::Found Materials::Make(const std::string& name, const Look& look, Placing placing) {
  Found found;
  Ogre::Pass& pass = NewPass("Soarbox/Look/" + name, found.material);
  AddTexture(pass, PaintTexture(look.paint), true);
  AddShadowMap(pass);
  AddShadowMap(pass);
  AddTexture(pass, kSkyTexture, false);
  if (placing == Placing::kBones) AddBones(pass);
  if (placing != Placing::kOne) found.material->getTechnique(0)->setShadowCasterMaterial(ShadowCaster(placing));
  const bool ground = look.paint == Look::Paint::kGround;
  const std::string fragment = ground ? "ground.frag" : "surface.frag";
  shaders_.Use(pass, Shaders::Placed("surface.vert", placing),
               further_lights_ ? Shaders::WithLights(fragment) : fragment, kSurfaceSamplers);
  pass.getVertexProgramParameters()->setNamedConstant("paint_trim", ColorVector(look.trim));
  found.trim = look.trim;
  const auto params = pass.getFragmentProgramParameters();
  params->setNamedConstant("base_colour", ColorVector(look.base));
  params->setNamedConstant("trim_colour", ColorVector(look.trim));
  params->setNamedConstant(
      "finish", Ogre::Vector4(look.gloss, look.glow, look.repeats, look.paint == Look::Paint::kCorners ? 1 : 0));
  found.is_opaque = look.base.a >= 1;
  if (!found.is_opaque) {
    pass.setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
    pass.setDepthWriteEnabled(false);
  }
  return found;
}

void Materials::UseFurtherLights() {
  if (further_lights_) return;
  further_lights_ = true;
  for (const auto& [name, found] : materials_) {
    Ogre::Pass& pass = *found.material->getTechnique(0)->getPass(0);
    const std::string fragment = pass.getFragmentProgramName();
    if (fragment != "surface.frag" && fragment != "ground.frag") continue;
    const Ogre::GpuProgramParametersSharedPtr before = pass.getFragmentProgramParameters();
    shaders_.UseFragment(pass, Shaders::WithLights(fragment), kSurfaceSamplers);
    for (const char* value : {"base_colour", "trim_colour", "finish"}) {
      const auto* held = before->_findNamedConstantDefinition(value);
      if (held == nullptr) continue;
      pass.getFragmentProgramParameters()->setNamedConstant(
          value, Ogre::Vector4(before->getFloatPointer(held->physicalIndex)));
    }
  }
}

const Materials::Found& Materials::Named(const std::string& name, Placing placing) {
  const std::string key = name + EndingOf(placing);
  const auto known = materials_.find(key);
  if (known != materials_.end()) return known->second;
  Look look;
  const bool exists = FindLook(name, look);
  if (!exists) FindLook("Soarbox/Missing", look);
  Found found = Make(key, look, placing);
  found.is_stand_in = !exists;
  return materials_.emplace(key, std::move(found)).first->second;
}

const Materials::Found& Materials::AgentBody(std::string_view kind, bool alive, bool failed, Placing placing) {
  std::string name =
      "agent/" + std::string(kind) + (alive ? "" : "/dead") + (failed ? "/failed" : "") + EndingOf(placing);
  const auto known = materials_.find(name);
  if (known != materials_.end()) return known->second;
  Look look;
  look.base = AgentColor(kind);
  look.gloss = 0.42f;
  const auto dull = [&look](float keep, float grey) {
    for (float* channel : {&look.base.r, &look.base.g, &look.base.b}) *channel = *channel * keep + grey * (1 - keep);
  };
  if (failed) dull(0.35f, 0.25f);
  if (!alive) dull(0.0f, 0.30f);
  return materials_.emplace(name, Make(name, look, placing)).first->second;
}

const Materials::Found& Materials::Soldier() {
  const std::string name = "soldier/";
  const auto known = materials_.find(name);
  if (known != materials_.end()) return known->second;
  Look look;
  look.paint = Look::Paint::kCloth;
  look.base = {1, 1, 1, 1};
  look.gloss = 0.02f;
  return materials_.emplace(name, Make(name, look, Placing::kBones)).first->second;
}

void Materials::SetSkyPicture(const std::array<Image, 6>& faces) {
  auto& textures = Ogre::TextureManager::getSingleton();
  Ogre::TexturePtr texture = textures.getByName(kSkyTexture, kGroup);
  if (!texture) {
    const auto size = static_cast<unsigned>(sky_face_size());
    texture = textures.createManual(kSkyTexture, kGroup, Ogre::TEX_TYPE_CUBE_MAP, size, size, Ogre::MIP_UNLIMITED,
                                    Ogre::PF_BYTE_RGBA, Ogre::TU_AUTOMIPMAP);
  }
  // Values of the sky for the shaders: the light from above, and the haze at the horizon.
  shaders_.scene_values().setNamedConstant("sky_mean", MeanLight(faces[2], 0, faces[2].height));
  shaders_.scene_values().setNamedConstant("haze_colour",
                                           MeanLight(faces[4], faces[4].height * 46 / 100, faces[4].height / 2));
  for (std::size_t face = 0; face < faces.size(); ++face) texture->getBuffer(face)->blitFromMemory(Box(faces[face]));
}

Ogre::MaterialPtr Materials::SkyMaterial() {
  Ogre::MaterialPtr material;
  Ogre::Pass& pass = NewPass("Soarbox/Sky", material);
  AddTexture(pass, kSkyTexture, false);
  shaders_.Use(pass, "sky.vert", "sky.frag", {"sky"});
  pass.setDepthWriteEnabled(false);
  pass.setCullingMode(Ogre::CULL_NONE);
  return material;
}

Ogre::MaterialPtr Materials::LineMaterial(float width_px, bool on_top) {
  Ogre::MaterialPtr material;
  Ogre::Pass& pass = NewPass("Soarbox/Lines/" + std::to_string(width_px) + (on_top ? "/on top" : ""), material);
  pass.setDepthCheckEnabled(!on_top);
  shaders_.Use(pass, "line.vert", "line.frag", {});
  pass.getVertexProgramParameters()->setNamedConstant("width_px", Ogre::Vector4(width_px, 0, 0, 0));
  pass.getFragmentProgramParameters()->setNamedConstant("width_px", Ogre::Vector4(width_px, 0, 0, 0));
  pass.setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  pass.setDepthWriteEnabled(false);
  pass.setCullingMode(Ogre::CULL_NONE);
  return material;
}

Ogre::MaterialPtr Materials::FillMaterial() {
  Ogre::MaterialPtr material;
  Ogre::Pass& pass = NewPass("Soarbox/Fills", material);
  shaders_.Use(pass, "fill.vert", "fill.frag", {});
  pass.setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  pass.setDepthWriteEnabled(false);
  pass.setCullingMode(Ogre::CULL_NONE);
  return material;
}

void Materials::AdoptPanelMaterial(const Ogre::MaterialPtr& material) {
  shaders_.Use(*material->getTechnique(0)->getPass(0), "panel.vert", "panel.frag", {"paint"});
  material->load();
}

const Ogre::MaterialPtr& Materials::Ghost(world::Color color, Placing placing) {
  char name[64];
  std::snprintf(name, sizeof name, "ghost/%.2f %.2f %.2f %.2f%s", static_cast<double>(color.r),
                static_cast<double>(color.g), static_cast<double>(color.b), static_cast<double>(color.a),
                EndingOf(placing));
  const auto [found, is_new] = materials_.try_emplace(name);
  if (!is_new) return found->second.material;
  found->second.is_opaque = false;
  Ogre::Pass& pass = NewPass(std::string("Soarbox/Look/") + name, found->second.material);
  if (placing == Placing::kBones) AddBones(pass);
  shaders_.Use(pass, Shaders::Placed("surface.vert", placing), "ghost.frag", {"bones"});
  pass.getFragmentProgramParameters()->setNamedConstant("base_colour", ColorVector(color));
  pass.setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  pass.setDepthWriteEnabled(false);
  return found->second.material;
}

Ogre::MaterialPtr Materials::Enlarged() {
  Ogre::MaterialPtr material;
  Ogre::Pass& pass = NewPass("Soarbox/Enlarged", material);
  Ogre::TextureUnitState* unit = pass.createTextureUnitState();
  unit->setTextureFiltering(Ogre::FO_LINEAR, Ogre::FO_LINEAR, Ogre::FO_NONE);
  unit->setTextureAddressingMode(Ogre::TextureUnitState::TAM_CLAMP);
  shaders_.Use(pass, "enlarge.vert", "enlarge.frag", {"picture"});
  pass.setDepthCheckEnabled(false);
  pass.setDepthWriteEnabled(false);
  pass.setCullingMode(Ogre::CULL_NONE);
  return material;
}

Ogre::MaterialPtr Materials::ShadowCaster(Placing placing) {
  const std::string name = std::string("Soarbox/ShadowCaster") + EndingOf(placing);
  Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().getByName(name, kGroup);
  if (material) return material;
  Ogre::Pass& pass = NewPass(name, material);
  if (placing == Placing::kBones) AddBones(pass);
  shaders_.Use(pass, Shaders::Placed("shadow.vert", placing), "shadow.frag", {"bones"});
  return material;
}

}  // namespace soarbox::viewer
