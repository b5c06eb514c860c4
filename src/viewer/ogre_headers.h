// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// All that we use of Ogre, for the few files that draw. CMakeLists.txt precompiles the large ones.
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
inline world::Vec3 FromOgre(const Ogre::Vector3& v) {
  return {v.x, v.y, v.z};
}

/// The order of drawing: solid things (Ogre's main group), the ground below and the sky behind them, of which only what
/// shows is painted then, and what is see-through; fills and lines come after (groups 7 and 8).
inline constexpr std::uint8_t kSolidQueue = 50, kGroundQueue = 52, kSkyQueue = 55, kClearQueue = 60;
static_assert(kSolidQueue == Ogre::RENDER_QUEUE_MAIN);

/// The one resource group that everything of ours lives in.
inline const char* const kGroup = "General";

}  // namespace soarbox::viewer
