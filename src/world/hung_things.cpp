// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/pose.h"
#include "world/animation/rig.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {
namespace {

/// The pose of one bone in its mesh. Nothing but the bone and its ancestors is computed if the bones follow from a
/// pose.
BonePose BoneOf(const BodyBones& bones, std::size_t bone) {
  if (const Pose* pose = bones.pose())
    return bone < pose->rig->skeleton.bones().size() ? pose->WorkOut(bone) : BonePose{};
  return bone < bones.size() ? bones[bone] : BonePose{};
}

}  // namespace

void PlaceHung(SharedList<DrawableSnapshot>& drawables) {
  for (auto at = drawables.Find(0); !drawables.IsEnd(at); at = drawables.After(at)) {
    const HungSnapshot hung = drawables.At(at).hung;
    if (hung.on == 0) continue;
    const auto carrier_at = drawables.Find(hung.on);
    if (drawables.IsEnd(carrier_at)) continue;
    const DrawableSnapshot& carrier = drawables.At(carrier_at);
    if (carrier.id != hung.on || carrier.hung.on != 0) continue;
    const BonePose pose = BoneOf(carrier.bones, hung.bone) * BonePose{hung.position, hung.orientation};
    const Vec3 position = carrier.position + Rotate(carrier.orientation, {pose.position.x * carrier.scale.x,
                                                                          pose.position.y * carrier.scale.y,
                                                                          pose.position.z * carrier.scale.z});
    const Quat orientation = carrier.orientation * pose.orientation;
    DrawableSnapshot& drawable = drawables.Edit(at);
    drawable.position = position;
    drawable.orientation = orientation;
  }
}

}  // namespace soarbox::world
