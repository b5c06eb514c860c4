// SPDX-License-Identifier: BSD-2-Clause
#include "model/gltf_rig.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "diagnostics/plain_text.h"
#include "world/rotation.h"

namespace soarbox::model {
namespace {

using Json = GltfFile::Json;
using world::BonePose;
using world::Quat;
using world::Vec3;

constexpr std::size_t kLongestName = 100;
/// Animations of one pose are at least as long, so that their times can be divided by it.
constexpr float kShortest_s = 1.0f / 30;

const Json& ListOf(const Json& object, const char* member) {
  static const Json kEmpty = Json::array();
  const auto found = object.find(member);
  return found != object.end() && found->is_array() ? *found : kEmpty;
}

std::string NameOf(const Json& object) {
  const auto found = object.find("name");
  if (found == object.end() || !found->is_string()) return {};
  return std::string(Beginning(found->get_ref<const std::string&>(), kLongestName));
}

std::optional<Quat> QuatOf(const float* numbers) {
  const float length = std::hypot(std::hypot(numbers[0], numbers[1]), std::hypot(numbers[2], numbers[3]));
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  return Quat{numbers[3] / length, numbers[0] / length, numbers[1] / length, numbers[2] / length};
}

/// The property of a node that a channel moves; nothing: one that is ignored.
enum class Property : std::uint8_t { kPosition, kOrientation, kScale };
std::optional<Property> PropertyOf(const Json& target) {
  const auto path = target.find("path");
  if (path == target.end() || !path->is_string()) return std::nullopt;
  if (*path == "translation") return Property::kPosition;
  if (*path == "rotation") return Property::kOrientation;
  return *path == "scale" ? std::optional(Property::kScale) : std::nullopt;
}

/// Nothing if it flattens space.
std::optional<Frame> InverseOf(const Frame& frame) {
  const float volume = frame.Determinant();
  if (!(std::abs(volume) > 1e-20f)) return std::nullopt;
  const Vec3 a = Cross(frame.y, frame.z) / volume, b = Cross(frame.z, frame.x) / volume,
             c = Cross(frame.x, frame.y) / volume;
  Frame inverse{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, {}};
  inverse.place = -inverse.Turned(frame.place);
  const auto is_finite = [](Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  if (!is_finite(inverse.x) || !is_finite(inverse.y) || !is_finite(inverse.z) || !is_finite(inverse.place))
    return std::nullopt;
  return inverse;
}

/// Numbers of a matrix of a file, column by column.
Frame FrameOf(const float* m) {
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

}  // namespace

BonePose PoseOfNode(GltfFile& file, const Json& node) {
  BonePose pose;
  if (const auto m = file.Floats(node, "matrix", 16); m.size() == 16) {
    const Frame frame = FrameOf(m.data());
    pose.position = frame.place;
    pose.scale = {Length(frame.x), Length(frame.y), Length(frame.z)};
    if (frame.Determinant() < 0) pose.scale.x = -pose.scale.x;
    const Vec3 x = Normalized(frame.x) * (pose.scale.x < 0 ? -1.0f : 1.0f), y = Normalized(frame.y);
    if (LengthSquared(Cross(x, y)) > 0) pose.orientation = world::FromAxes(x, y, Cross(x, y));
    return pose;
  }
  if (const auto turn = file.Floats(node, "rotation", 4); turn.size() == 4)
    pose.orientation = QuatOf(turn.data()).value_or(Quat{});
  if (const auto scale = file.Floats(node, "scale", 3); scale.size() == 3) pose.scale = {scale[0], scale[1], scale[2]};
  if (const auto place = file.Floats(node, "translation", 3); place.size() == 3)
    pose.position = {place[0], place[1], place[2]};
  return pose;
}

Frame FrameOfNode(GltfFile& file, const Json& node) {
  if (const auto m = file.Floats(node, "matrix", 16); m.size() == 16) return FrameOf(m.data());
  return FrameOf(PoseOfNode(file, node));
}

void GltfRig::FindMovingNodes() {
  for (const Json& skin : ListOf(file_.root(), "skins")) {
    if (!skin.is_object()) continue;
    for (const Json& joint : ListOf(skin, "joints"))
      if (joint.is_number_unsigned()) moving_.insert(joint.get<std::uint64_t>());
  }
  for (const Json& animation : ListOf(file_.root(), "animations")) {
    if (!animation.is_object()) continue;
    for (const Json& channel : ListOf(animation, "channels")) {
      if (!channel.is_object() || !channel.contains("target") || !channel["target"].is_object()) continue;
      const Json& target = channel["target"];
      const auto node = file_.Number(target, "node");
      if (node && PropertyOf(target)) moving_.insert(*node);
    }
  }
}

bool GltfRig::MarkBones(std::uint64_t node) {
  bool is_bone = moving_.contains(node);
  for (const Json& child : ListOf(file_.At("nodes", node), "children"))
    if (child.is_number_unsigned() && MarkBones(child.get<std::uint64_t>())) is_bone = true;
  if (is_bone) moving_.insert(node);
  return is_bone;
}

void GltfRig::AddBones(std::uint64_t node, int parent) {
  if (!file_.ok() || !moving_.contains(node)) return;
  const std::string what = "nodes[" + std::to_string(node) + "]";
  if (bones_.contains(node)) return file_.Fail(what + " is below two nodes, but a bone has one parent");
  if (bones_.size() >= kMostBones)
    return file_.Fail("it has more than " + std::to_string(kMostBones) + " bones: make it simpler");
  const Json& from = file_.At("nodes", node);
  const std::string name = NameOf(from);
  const int bone = model_.rig.skeleton.AddToParent(name.empty() ? "node " + std::to_string(node) : name, parent,
                                                   PoseOfNode(file_, from));
  bones_[node] = static_cast<std::uint16_t>(bone);
  for (const Json& child : ListOf(from, "children"))
    if (child.is_number_unsigned()) AddBones(child.get<std::uint64_t>(), bone);
}

void GltfRig::Read(const std::vector<std::uint64_t>& roots) {
  FindMovingNodes();
  if (moving_.empty() || !file_.ok()) return;
  for (const std::uint64_t root : roots) MarkBones(root);
  for (const std::uint64_t root : roots) AddBones(root, -1);
  if (!moves()) return;
  const Json& animations = ListOf(file_.root(), "animations");
  if (animations.size() > kMostClips)
    return file_.Fail("it has more than " + std::to_string(kMostClips) + " animations: leave some out");
  for (std::size_t i = 0; i < animations.size() && file_.ok(); ++i) ReadAnimation(i);
}

std::optional<std::uint16_t> GltfRig::BoneOf(std::uint64_t node) const {
  const auto found = bones_.find(node);
  return found == bones_.end() ? std::nullopt : std::optional(found->second);
}

/// Scripts find animations by their names, so that no two may be equal.
std::string GltfRig::FreeName(const Json& animation, std::size_t index) const {
  std::string name = NameOf(animation);
  if (name.empty()) name = "animation " + std::to_string(index);
  std::string free = name;
  for (int number = 2; model_.rig.FindClip(free) >= 0; ++number) free = name + " " + std::to_string(number);
  return free;
}

void GltfRig::ReadAnimation(std::size_t index) {
  const Json& animation = file_.At("animations", index);
  const Json& channels = ListOf(animation, "channels");
  const Json& samplers = ListOf(animation, "samplers");
  std::vector<world::BoneMovement> movements;
  for (const world::Skeleton::Bone& bone : model_.rig.skeleton.bones()) movements.push_back({bone.bind, {}, {}, {}});
  float length_s = 0;
  bool moves = false;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::string what = "animations[" + std::to_string(index) + "].channels[" + std::to_string(i) + "]";
    const Json& channel = channels[i];
    const Json* const target = channel.is_object() && channel.contains("target") ? &channel["target"] : nullptr;
    if (target == nullptr || !target->is_object()) return file_.Fail(what + " has no \"target\"");
    const auto node = file_.Number(*target, "node");
    const auto property = PropertyOf(*target);
    const auto bone = node ? BoneOf(*node) : std::nullopt;
    if (!property || !bone) continue;
    const auto sampler = file_.Number(channel, "sampler");
    if (!sampler || *sampler >= samplers.size() || !samplers[*sampler].is_object())
      return file_.Fail(what + " has no sampler");
    world::BoneMovement& movement = movements[*bone];
    switch (*property) {
      case Property::kPosition:
        ReadTrack(samplers[*sampler], what, movement.position, length_s);
        break;
      case Property::kOrientation:
        ReadTrack(samplers[*sampler], what, movement.orientation, length_s);
        break;
      case Property::kScale:
        ReadTrack(samplers[*sampler], what, movement.scale, length_s);
        break;
    }
    if (!file_.ok()) return;
    moves = true;
  }
  if (!moves) return;
  model_.rig.clips.emplace_back(
      world::Clip::Settings{.name = FreeName(animation, index), .length_s = std::max(length_s, kShortest_s)},
      std::move(movements));
}

template <typename T>
void GltfRig::ReadTrack(const Json& sampler, const std::string& what, world::BoneTrack<T>& track, float& length_s) {
  constexpr std::size_t kWidth = std::is_same_v<T, Quat> ? 4 : 3;
  const auto input = file_.Number(sampler, "input"), output = file_.Number(sampler, "output");
  if (!input || !output) return file_.Fail(what + " has no times or no values");
  const auto named = sampler.find("interpolation");
  const std::string kind = named != sampler.end() && named->is_string() ? named->get<std::string>() : "LINEAR";
  if (kind != "LINEAR" && kind != "STEP" && kind != "CUBICSPLINE")
    return file_.Fail(what + " has the interpolation " + kind.substr(0, 40) + ", which is not supported");
  const GltfFile::Values times = file_.FloatsOf(*input), values = file_.FloatsOf(*output);
  if (!file_.ok()) return;
  // Each value of a spline is between two tangents, which are not used.
  const std::size_t parts = kind == "CUBICSPLINE" ? 3 : 1;
  if (times.width != 1 || values.width != kWidth || values.count != times.count * parts)
    return file_.Fail(what + " has " + std::to_string(values.count) + " values of " + std::to_string(values.width) +
                      " numbers for " + std::to_string(times.count) + " times");
  keys_ += times.count;
  if (keys_ > kMostKeys)
    return file_.Fail("its animations have more than " + std::to_string(kMostKeys) + " keys: make them simpler");
  track = {};
  track.holds = kind == "STEP";
  track.times_s = times.numbers;
  for (std::size_t i = 0; i < times.count; ++i) {
    if (times.numbers[i] < 0 || times.numbers[i] > kLongest_s || (i > 0 && times.numbers[i] <= times.numbers[i - 1]))
      return file_.Fail(what + " has times that do not ascend within 0 to 3600 s");
    const float* const numbers = &values.numbers[kWidth * (i * parts + parts / 2)];
    if constexpr (kWidth == 4) {
      track.values.push_back(QuatOf(numbers).value_or(Quat{}));
    } else {
      if (std::max({std::abs(numbers[0]), std::abs(numbers[1]), std::abs(numbers[2])}) > kFarthest_m)
        return file_.Fail(what + " moves or stretches by more than 100,000");
      track.values.push_back({numbers[0], numbers[1], numbers[2]});
    }
  }
  length_s = std::max(length_s, times.numbers.back());
}

std::uint8_t GltfRig::AddJoint(const Joint& joint) {
  if (model_.joints.size() >= kMostJoints) {
    file_.Fail("its skins have more than " + std::to_string(kMostJoints) + " joints together: make it simpler");
    return 0;
  }
  model_.joints.push_back(joint);
  return static_cast<std::uint8_t>(model_.joints.size() - 1);
}

GltfRig::Binding GltfRig::BindBone(std::optional<std::uint16_t> bone, const Frame& in_bone) {
  const auto [found, is_new] = rigid_.try_emplace(bone ? *bone : -1);
  if (is_new) found->second = AddJoint({bone.value_or(Joint::kStill), {}});
  return {{found->second}, {bone ? FrameOf(model_.rig.skeleton.BindInModel(*bone)) : Frame{}}, in_bone};
}

GltfRig::Binding GltfRig::BindSkin(std::uint64_t skin) {
  const auto [found, is_new] = skins_.try_emplace(skin);
  Binding& made = found->second;
  if (!is_new) return made;
  const Json& from = file_.At("skins", skin);
  const std::string what = "skins[" + std::to_string(skin) + "]";
  const Json& joints = ListOf(from, "joints");
  GltfFile::Values inverse;
  if (const auto accessor = file_.Number(from, "inverseBindMatrices")) {
    inverse = file_.FloatsOf(*accessor);
    if (file_.ok() && (inverse.width != 16 || inverse.count < joints.size()))
      file_.Fail(what + " has fewer inverse bind matrices than joints");
  }
  if (file_.ok() && joints.empty()) file_.Fail(what + " has no joints");
  std::vector<Joint> read;
  for (const Json& joint : joints) {
    if (!file_.ok()) return {};
    const auto bone = joint.is_number_unsigned() ? BoneOf(joint.get<std::uint64_t>()) : std::nullopt;
    if (!bone) {
      file_.Fail(what + " has a joint that is not a node of the scene");
      return {};
    }
    read.push_back({*bone, inverse.count > 0 ? FrameOf(&inverse.numbers[16 * read.size()]) : Frame{}});
  }
  if (!file_.ok()) return {};
  // Corners are stored as the first joint places them at rest. They then have the size of the model, whatever the units
  // of the skin are.
  const auto placed = [&](const Joint& joint) {
    return FrameOf(model_.rig.skeleton.BindInModel(joint.bone)) * joint.inverse_bind;
  };
  const Frame to_skin = placed(read.front());
  if (const std::optional<Frame> back = InverseOf(to_skin)) {
    made.to_skin = to_skin;
    for (Joint& joint : read) joint.inverse_bind = joint.inverse_bind * *back;
  }
  for (const Joint& joint : read) {
    made.joints.push_back(AddJoint(joint));
    made.rest.push_back(placed(joint));
  }
  return made;
}

}  // namespace soarbox::model
