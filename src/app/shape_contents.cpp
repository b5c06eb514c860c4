// SPDX-License-Identifier: BSD-2-Clause
#include "app/shape_contents.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <unordered_map>
#include <utility>

#include "bytes/base64.h"
#include "stream/deflate.h"
#include "viewer/backdrop_meshes.h"
#include "viewer/body_mesh.h"
#include "viewer/drawable_mesh.h"
#include "viewer/figure_meshes.h"
#include "viewer/shape_meshes.h"
#include "world/asset_store.h"

namespace soarbox::app {
namespace {

using Json = nlohmann::ordered_json;
using viewer::MeshData;
using viewer::MeshVertex;
using world::DrawableSnapshot;

/// Keys of the shapes of bodies, in the order of world::BodyLook.
constexpr const char* kBodies[] = {"body/soldier", "body/dark", "body/rifle"};

/// Scripts may request sizes that are not finite.
float Finite(float value) {
  return std::isfinite(value) ? value : 0;
}

/// The bytes of a mesh, little endian, with equal components together for better compression
/// (docs/dev/stream.md#shapes).
class MeshBytes {
 public:
  void Number(std::uint32_t value) { Little(value, 4); }
  void Float(float value) { Little(std::bit_cast<std::uint32_t>(value), 4); }
  /// Adds one component of each vertex as 16 bits between the minimum and the maximum, which come first.
  template <typename Of>
  void Scaled(const MeshData& mesh, Of of) {
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (const MeshVertex& vertex : mesh.vertices) {
      low = std::min(low, Finite(of(vertex)));
      high = std::max(high, Finite(of(vertex)));
    }
    if (mesh.vertices.empty()) low = high = 0;
    Float(low);
    Float(high);
    constexpr float kMost = 65535;
    const float scale = high > low ? kMost / (high - low) : 0;
    std::uint32_t before = 0;
    for (const MeshVertex& vertex : mesh.vertices) {
      // Neighbouring vertices are near each other, so differences are small.
      const auto value = static_cast<std::uint32_t>(std::lround((Finite(of(vertex)) - low) * scale));
      Little((value - before) & 0xffff, 2);
      before = value;
    }
  }
  template <typename Of>
  void Bytes(const MeshData& mesh, float scale, Of of) {
    for (const MeshVertex& vertex : mesh.vertices)
      bytes_ +=
          static_cast<char>(static_cast<int>(std::lround(std::clamp(Finite(of(vertex)) * scale, -128.0f, 255.0f))));
  }
  void Byte(std::uint8_t value) { bytes_ += static_cast<char>(value); }
  const std::string& bytes() const { return bytes_; }

 private:
  void Little(std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xff);
  }
  std::string bytes_;
};

/// How bones move the vertices of a mesh.
enum class SkinKind : std::uint32_t { kNone, kTwoBones, kFourJoints };

void AddTriangles(MeshBytes& out, const MeshData& mesh, SkinKind kind) {
  out.Number(static_cast<std::uint32_t>(mesh.vertices.size()));
  out.Number(static_cast<std::uint32_t>(mesh.indices.size()));
  out.Number(static_cast<std::uint32_t>(kind));
  std::uint32_t before = 0;
  for (const std::uint32_t index : mesh.indices) {
    out.Number(index - before);
    before = index;
  }
  out.Scaled(mesh, [](const MeshVertex& v) { return v.position.x; });
  out.Scaled(mesh, [](const MeshVertex& v) { return v.position.y; });
  out.Scaled(mesh, [](const MeshVertex& v) { return v.position.z; });
  out.Scaled(mesh, [](const MeshVertex& v) { return v.u; });
  out.Scaled(mesh, [](const MeshVertex& v) { return v.v; });
  out.Scaled(mesh, [](const MeshVertex& v) { return v.light; });
  constexpr float kNormal = 127, kShare = 255;
  out.Bytes(mesh, kNormal, [](const MeshVertex& v) { return v.normal.x; });
  out.Bytes(mesh, kNormal, [](const MeshVertex& v) { return v.normal.y; });
  out.Bytes(mesh, kNormal, [](const MeshVertex& v) { return v.normal.z; });
  out.Bytes(mesh, kShare, [](const MeshVertex& v) { return v.tint; });
  out.Bytes(mesh, kShare, [](const MeshVertex& v) { return v.gloss; });
}

std::string BytesOf(const MeshData& mesh, const std::vector<viewer::SkinVertex>& skin = {}) {
  MeshBytes out;
  AddTriangles(out, mesh, skin.empty() ? SkinKind::kNone : SkinKind::kTwoBones);
  constexpr float kShare = 255;
  for (const viewer::SkinVertex& by : skin) out.Byte(by.bone);
  for (const viewer::SkinVertex& by : skin) out.Byte(by.other);
  for (const viewer::SkinVertex& by : skin) out.Byte(static_cast<std::uint8_t>(std::lround(by.share * kShare)));
  return out.bytes();
}

std::string BytesOfModel(const model::Model& model) {
  MeshBytes out;
  AddTriangles(out, viewer::ModelMesh(model, true), SkinKind::kFourJoints);
  for (std::size_t k = 0; k < 4; ++k)
    for (const model::CornerSkin& skin : model.skins) out.Byte(skin.joints[k]);
  for (std::size_t k = 0; k < 4; ++k)
    for (const model::CornerSkin& skin : model.skins) out.Byte(viewer::WeightBytes(skin.weights)[k]);
  return out.bytes();
}

/// The bones, joints and animations of a model as numbers of 4 bytes.
class MotionBytes {
 public:
  explicit MotionBytes(const model::Model& model) {
    const std::vector<world::Skeleton::Bone>& bones = model.rig.skeleton.bones();
    out_.Number(static_cast<std::uint32_t>(bones.size()));
    for (const world::Skeleton::Bone& bone : bones) {
      out_.Number(static_cast<std::uint32_t>(bone.parent + 1));
      Add(bone.bind.position);
      Add(bone.bind.orientation);
      Add(bone.bind.scale);
    }
    out_.Number(static_cast<std::uint32_t>(model.joints.size()));
    for (const model::Joint& joint : model.joints) {
      out_.Number(joint.bone == model::Joint::kStill ? 0 : joint.bone + 1u);
      const model::Frame& f = joint.inverse_bind;
      for (const world::Vec3& column : {f.x, f.y, f.z, f.place}) Add(column);
    }
    out_.Number(static_cast<std::uint32_t>(model.rig.clips.size()));
    for (const world::Clip& clip : model.rig.clips) Add(clip);
  }
  const std::string& bytes() const { return out_.bytes(); }

 private:
  void Add(world::Vec3 v) {
    for (const float part : {v.x, v.y, v.z}) out_.Float(part);
  }
  void Add(world::Quat q) {
    for (const float part : {q.x, q.y, q.z, q.w}) out_.Float(part);
  }
  template <typename T>
  void Add(const world::BoneTrack<T>& track) {
    out_.Number(static_cast<std::uint32_t>(track.values.size()));
    out_.Number(track.holds ? 1 : 0);
    for (const float time_s : track.times_s) out_.Float(time_s);
    for (const T& value : track.values) Add(value);
  }
  void Add(const world::Clip& clip) {
    out_.Float(clip.length_s());
    const auto moves = [](const world::BoneMovement& by) {
      return !by.position.values.empty() || !by.orientation.values.empty() || !by.scale.values.empty();
    };
    const std::vector<world::BoneMovement>& movements = clip.movements();
    out_.Number(static_cast<std::uint32_t>(std::ranges::count_if(movements, moves)));
    for (std::size_t bone = 0; bone < movements.size(); ++bone) {
      if (!moves(movements[bone])) continue;
      out_.Number(static_cast<std::uint32_t>(bone));
      Add(movements[bone].position);
      Add(movements[bone].orientation);
      Add(movements[bone].scale);
    }
  }

  MeshBytes out_;
};

Json Packed(const std::string& bytes) {
  return ToBase64(stream::Deflate(bytes));
}

/// A shape with two levels of detail; if they are equal, only one is sent.
Json LevelsOf(const MeshData& fine, const std::string& fine_bytes, const std::string& coarse_bytes) {
  Json content;
  content["material"] = fine.material;
  content["fine"] = Packed(fine_bytes);
  if (coarse_bytes != fine_bytes) content["coarse"] = Packed(coarse_bytes);
  return content;
}

Json PoseJson(const world::BonePose& pose) {
  return Json::array({pose.position.x, pose.position.y, pose.position.z, pose.orientation.x, pose.orientation.y,
                      pose.orientation.z, pose.orientation.w});
}

Json BodyContent(world::BodyLook look) {
  const viewer::SkinMesh fine = viewer::MakeBodyMesh(look, viewer::BodyDetail::kMiddle),
                         coarse = viewer::MakeBodyMesh(look, viewer::BodyDetail::kCoarse);
  Json content = LevelsOf(fine.mesh, BytesOf(fine.mesh, fine.skin), BytesOf(coarse.mesh, coarse.skin));
  const viewer::SkinMesh tiny = viewer::MakeBodyMesh(look, viewer::BodyDetail::kTiny);
  content["tiny"] = Packed(BytesOf(tiny.mesh, tiny.skin));
  const world::Skeleton& skeleton =
      (look == world::BodyLook::kRifle ? world::RifleRig() : world::SoldierRig()).skeleton;
  content["bones"] = Json::array();
  for (int bone = 0; bone < skeleton.count(); ++bone) {
    const world::Skeleton::Bone& at = skeleton.bones()[static_cast<std::size_t>(bone)];
    content["bones"].push_back(
        {{"parent", at.parent}, {"bind", PoseJson(at.bind)}, {"in_model", PoseJson(skeleton.BindInModel(bone))}});
  }
  return content;
}

Json ModelContent(const model::Model& model) {
  return {{"material", viewer::kModelMaterial},
          {"fine", Packed(BytesOfModel(model))},
          {"motion", Packed(MotionBytes(model).bytes())}};
}

Json ThingContent(const DrawableSnapshot& drawable, bool agent_body) {
  const viewer::DrawableMesh fine = viewer::MeshOf(drawable, agent_body);
  const viewer::CoarseShapes while_it_lives;
  const viewer::DrawableMesh coarse = viewer::MeshOf(drawable, agent_body);
  Json content = LevelsOf(fine.data, BytesOf(fine.data), BytesOf(coarse.data));
  if (viewer::IsFigure(drawable.material.value())) content["is_figure"] = true;
  return content;
}

Json PlainContent(const MeshData& mesh) {
  const std::string bytes = BytesOf(mesh);
  return LevelsOf(mesh, bytes, bytes);
}

}  // namespace

std::string ShapeKey(const DrawableSnapshot& drawable, bool agent_body) {
  if (drawable.shape == world::ShapeKind::kMesh) return "mesh/" + drawable.mesh.value();
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  char text[80];
  std::snprintf(text, sizeof text, "%d.%d.%x.%x.%x.%x.%x.", static_cast<int>(drawable.shape), agent_body ? 1 : 0,
                bits(drawable.size.x), bits(drawable.size.y), bits(drawable.size.z), bits(drawable.texture_repeats.x),
                bits(drawable.texture_repeats.y));
  // If the material is a thing or a creature, it has its own shape.
  const std::string& material = drawable.material.value();
  return text + (material.starts_with("Soarbox/") ? material : std::string());
}

void ShapeContents::AddAssets(const world::SceneSnapshot& scene, std::vector<Told>& found) {
  const auto add = [&](const std::string& key) {
    if (world::AssetName(key).empty() || told_.size() >= kMost || !told_.insert(key).second) return;
    const auto file = world::FindAsset(key);
    // The file is missing if it was too large for a recording. Then nothing is shown or played.
    if (file != nullptr) found.push_back({"assets:" + key, Json{{"bytes", ToBase64(*file)}}});
  };
  for (const world::UiSnapshot& panel : scene.ui) add(panel.material);
  for (const world::SoundSnapshot& sound : scene.sounds) add(sound.file);
}

std::vector<ShapeContents::Told> ShapeContents::New(const world::SceneSnapshot& scene) {
  std::vector<Told> found;
  const auto is_new = [&](const std::string& key) { return told_.size() < kMost && told_.insert(key).second; };
  const auto tell = [&](const std::string& key, Json content) {
    found.push_back({"shapes:" + key, std::move(content)});
  };
  std::unordered_map<std::uint32_t, const world::AgentSnapshot*> agents;
  for (const world::AgentSnapshot& agent : scene.agents) agents[agent.id] = &agent;
  for (const DrawableSnapshot& drawable : scene.drawables) {
    const world::BodyMesh* const body =
        drawable.shape == world::ShapeKind::kMesh ? world::FindBodyMesh(drawable.mesh.value()) : nullptr;
    if (body != nullptr) {
      const world::BodyLook look = viewer::LookOf(*body, drawable);
      const std::string name = kBodies[static_cast<std::size_t>(look)];
      if (const std::string key = ShapeKey(drawable, false); is_new(key))
        tell(key, {{"body", kBodies[static_cast<std::size_t>(body->look)]}});
      if (is_new(name)) tell(name, BodyContent(look));
      continue;
    }
    const auto agent = drawable.belongs_to_agent ? agents.find(drawable.owner_id) : agents.end();
    const bool agent_body = viewer::LooksLikeABody(drawable, agent == agents.end() ? nullptr : agent->second);
    if (const std::string key = ShapeKey(drawable, agent_body); is_new(key)) {
      const auto model = viewer::MovingModelOf(drawable);
      tell(key, model != nullptr ? ModelContent(*model) : ThingContent(drawable, agent_body));
    }
    if (viewer::IsPlain(drawable) && is_new("backdrop/hills")) {
      tell("backdrop/hills", PlainContent(viewer::HillsMesh()));
      tell("backdrop/trees", PlainContent(viewer::TreesMesh()));
      tell("backdrop/fence", PlainContent(viewer::FenceMesh()));
    }
  }
  AddAssets(scene, found);
  return found;
}

}  // namespace soarbox::app
