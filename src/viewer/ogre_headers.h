// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// The parts of Ogre that we use, for the few files that draw. CMakeLists.txt precompiles the large headers.
#include <Ogre.h>
#include <OgreGpuProgramManager.h>
#include <OgreHardwareBufferManager.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreImGuiOverlay.h>
#include <OgreLodStrategy.h>
#include <OgreOverlayManager.h>
#include <OgreOverlaySystem.h>
#include <OgreShadowCameraSetup.h>
#include <OgreSimpleRenderable.h>
#include <imgui.h>

#include <cstdint>

#include "world/math.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

inline Ogre::Vector3 ToOgre(world::Vec3 v) {
  return {v.x, v.y, v.z};
}
inline Ogre::Quaternion ToOgre(world::Quat q) {
  return {q.w, q.x, q.y, q.z};
}

/// Order of drawing: solid things (Ogre's main group), then the ground and the sky, so that only their visible pixels
/// are shaded, then transparent things. Fills and lines come last (groups 7 and 8).
inline constexpr std::uint8_t kSolidQueue = 50, kGroundQueue = 52, kSkyQueue = 55, kClearQueue = 60;
static_assert(kSolidQueue == Ogre::RENDER_QUEUE_MAIN);

/// The resource group of all our resources.
inline const char* const kGroup = "General";

}  // namespace soarbox::viewer
