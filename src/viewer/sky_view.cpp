// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/sky_view.h"

namespace soarbox::viewer {
namespace {

struct NamedSky {
  const char* name;  ///< Without the ending "SkyBox".
  SkyStyle style;
};

const std::vector<NamedSky>& Skies() {
  static const std::vector<NamedSky> skies{
      {"ThickCloudsWater", {}},
      {"CloudyLightRays",
       {{0.30f, 0.45f, 0.66f},
        {0.88f, 0.86f, 0.80f},
        {1.0f, 0.97f, 0.90f},
        {0.50f, 0.54f, 0.60f},
        {0.14f, 0.27f, 0.32f},
        0.68f,
        0}},
      {"TropicalSunnyDay",
       {{0.10f, 0.40f, 0.80f},
        {0.72f, 0.88f, 0.95f},
        {1, 1, 1},
        {0.78f, 0.84f, 0.90f},
        {0.02f, 0.46f, 0.52f},
        0.27f,
        0}},
      {"SunSet",
       {{0.20f, 0.22f, 0.44f},
        {0.98f, 0.60f, 0.34f},
        {1.0f, 0.72f, 0.50f},
        {0.38f, 0.26f, 0.36f},
        {0.22f, 0.16f, 0.22f},
        0.46f,
        0}},
      {"DarkStormy",
       {{0.18f, 0.21f, 0.26f},
        {0.44f, 0.47f, 0.50f},
        {0.58f, 0.60f, 0.62f},
        {0.20f, 0.22f, 0.26f},
        {0.07f, 0.12f, 0.15f},
        0.85f,
        0}},
      {"FullMoon",
       {{0.02f, 0.03f, 0.09f},
        {0.12f, 0.16f, 0.26f},
        {0.30f, 0.34f, 0.44f},
        {0.08f, 0.10f, 0.16f},
        {0.02f, 0.05f, 0.09f},
        0.34f,
        1}},
  };
  return skies;
}

SkyStyle PlainSky() {
  SkyStyle style;
  style.cloud_cover = 0;
  return style;
}

}  // namespace

SkyView::SkyView(Ogre::SceneManager& scene, Materials& materials) : materials_(materials) {
  materials_.SetSkyPicture(SkyImages(PlainSky(), 16));
  Ogre::ManualObject* box = scene.createManualObject("Soarbox/SkyBox");
  materials_.SkyMaterial();
  box->begin("Soarbox/Sky", Ogre::RenderOperation::OT_TRIANGLE_LIST, kGroup);
  for (int i = 0; i < 8; ++i)
    box->position((i & 1) != 0 ? 50.f : -50.f, (i & 2) != 0 ? 50.f : -50.f, (i & 4) != 0 ? 50.f : -50.f);
  box->quad(0, 2, 3, 1);
  box->quad(4, 5, 7, 6);
  box->quad(0, 1, 5, 4);
  box->quad(2, 6, 7, 3);
  box->quad(0, 4, 6, 2);
  box->quad(1, 3, 7, 5);
  box->end();
  // Behind opaque things, before transparent ones.
  box->setRenderQueueGroup(kSkyQueue);
  box->setCastShadows(false);
  box->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
  node_ = scene.getRootSceneNode()->createChildSceneNode();
  node_->attachObject(box);
}

bool SkyView::Show(const std::string& name) {
  if (name == shown_) return known_;
  shown_ = name;
  known_ = true;
  SkyStyle style = PlainSky();
  if (!name.empty()) {
    const NamedSky* found = nullptr;
    for (const NamedSky& sky : Skies()) {
      if (name == sky.name || name == std::string(sky.name) + "SkyBox") found = &sky;
    }
    known_ = found != nullptr;
    style = found != nullptr ? found->style : SkyStyle{};
  }
  materials_.SetSkyPicture(SkyImages(style, materials_.sky_face_size()));
  return known_;
}

}  // namespace soarbox::viewer
