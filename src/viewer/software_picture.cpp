// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/software_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "picture/stroke_font.h"
#include "viewer/backdrop_meshes.h"
#include "viewer/body_mesh.h"
#include "viewer/cloth_image.h"
#include "viewer/drawable_mesh.h"
#include "viewer/palette.h"
#include "world/body_meshes.h"

namespace soarbox::viewer {
namespace {

using picture::Ink;
using world::DrawableSnapshot;
using world::Vec3;

constexpr int kSunPixels = 2048, kClothCell = 32;
constexpr float kAmbient = 0.58f, kSunlight = 0.46f, kShadow = 0.70f;
const Vec3 kToSun = world::Normalized(Vec3{0.45f, 0.85f, 0.35f});

Ink InkOf(world::Color color, float light = 1) {
  return {color.r * light, color.g * light, color.b * light, color.a};
}

world::Color Mean(world::Color a, world::Color b, float share_of_b) {
  const auto mix = [share_of_b](float x, float y) { return x + (y - x) * share_of_b; };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), a.a};
}

Look LookNamed(std::string_view name) {
  Look look;
  if (!FindLook(name, look)) FindLook("White", look);
  // Grass covers about half of a ground that has grass.
  if (look.paint == Look::Paint::kGround && look.trim.a > 0) look.base = Mean(look.base, look.trim, 0.55f);
  return look;
}

Look LookOfBody(const world::AgentSnapshot& agent) {
  Look look;
  look.base = AgentColor(agent.kind);
  if (!agent.alive || agent.failed) look.base = Mean(look.base, {0.25f, 0.25f, 0.25f, 1}, 0.7f);
  return look;
}

world::Color ColorOnCloth(const Image& cloths, float u, float v) {
  const auto within = [](float share, int most) {
    return std::clamp(static_cast<int>(share * static_cast<float>(most)), 0, most - 1);
  };
  const auto pixel = 4 * (static_cast<std::size_t>(within(v, cloths.height)) * static_cast<std::size_t>(cloths.width) +
                          static_cast<std::size_t>(within(u, cloths.width)));
  const auto channel = [&](std::size_t i) { return static_cast<float>(cloths.pixels[pixel + i]) / 255; };
  return {channel(0), channel(1), channel(2), 1};
}

/// The sky without clouds: blue above, pale at the horizon, and haze below it.
Ink SkyAt(Vec3 ray) {
  constexpr world::Color kHorizon{0.80f, 0.87f, 0.92f, 1}, kZenith{0.30f, 0.52f, 0.80f, 1},
      kHaze{0.45f, 0.50f, 0.46f, 1};
  const world::Color sky = Mean(kHorizon, kZenith, std::sqrt(std::clamp(ray.y, 0.0f, 1.0f)));
  return InkOf(ray.y < 0 ? Mean(sky, kHaze, std::min(1.0f, -6 * ray.y)) : sky);
}

}  // namespace

SoftwarePictures::SoftwarePictures(int width_px, int height_px)
    : raster_(2 * width_px, 2 * height_px), sun_(kSunPixels, kSunPixels), cloths_(ClothImage(kClothCell)) {}

const SoftwarePictures::Shape& SoftwarePictures::ShapeOf(const DrawableSnapshot& drawable, bool agent_body) {
  const world::BodyMesh* const body =
      drawable.shape == world::ShapeKind::kMesh ? world::FindBodyMesh(drawable.mesh.value()) : nullptr;
  const world::BodyLook look = body != nullptr ? LookOf(*body, drawable) : world::BodyLook::kSoldier;
  std::string key = body != nullptr ? "body " + std::to_string(static_cast<int>(look)) : drawable.mesh.value();
  if (body == nullptr) {
    for (const float size : {drawable.size.x, drawable.size.y, drawable.size.z}) key += " " + std::to_string(size);
    key += (agent_body ? " agent " : " thing ") + std::to_string(static_cast<int>(drawable.shape)) +
           drawable.material.value();
  }
  const auto [at, is_new] = shapes_.try_emplace(std::move(key));
  if (!is_new) return at->second;
  if (body == nullptr) {
    at->second.mesh.mesh = MeshOf(drawable, agent_body).data;
  } else {
    at->second.mesh = MakeBodyMesh(look, BodyDetail::kMiddle);
    at->second.to_bind = ToBind((look == world::BodyLook::kRifle ? world::RifleRig() : world::SoldierRig()).skeleton);
  }
  return at->second;
}

SoftwarePictures::Placed SoftwarePictures::Place(const DrawableSnapshot& drawable, const world::AgentSnapshot* agent) {
  const bool agent_body = LooksLikeABody(drawable, agent);
  const Shape& shape = ShapeOf(drawable, agent_body);
  const MeshData& mesh = shape.mesh.mesh;
  const bool has_bones = !shape.mesh.skin.empty();
  const auto model = drawable.bones.empty() ? nullptr : MovingModelOf(drawable);
  const std::string& material = drawable.material.value();
  const bool own_color = agent_body && !IsAgentColorMaterial(material);
  const bool from_mesh = WearsItsOwn(drawable, mesh.material);
  Look look = own_color ? LookOfBody(*agent) : LookNamed(from_mesh ? mesh.material : material);
  if (has_bones) look.trim = TeamColor(agent != nullptr ? agent->team : std::string());
  Placed placed;
  placed.mesh = &mesh;
  placed.glow = std::min(look.glow, 0.6f);
  placed.is_clear = look.base.a < 0.99f;
  std::vector<float> rows;
  if (has_bones) {
    std::vector<world::BonePose> bones =
        drawable.bones.empty() ? std::vector<world::BonePose>() : drawable.bones.value();
    // Bones without a given pose have the bind pose.
    for (std::size_t i = bones.size(); i < shape.to_bind.size(); ++i) bones.push_back(world::Inverse(shape.to_bind[i]));
    rows.resize(12 * shape.to_bind.size());
    BoneRows(shape.to_bind, bones, {{drawable.position, drawable.orientation}, drawable.scale}, rows.data());
  }
  if (model != nullptr)
    rows = JointRows(*model, drawable.bones, {{drawable.position, drawable.orientation}, drawable.scale});
  const auto by_bone = [&](std::uint8_t bone, Vec3 v, float w) {
    if (12 * (static_cast<std::size_t>(bone) + 1) > rows.size()) return Vec3{};
    const float* const row = &rows[12 * static_cast<std::size_t>(bone)];
    const auto part = [&](int i) { return row[i] * v.x + row[i + 1] * v.y + row[i + 2] * v.z + row[i + 3] * w; };
    return Vec3{part(0), part(4), part(8)};
  };
  const auto moved = [&](std::size_t i, Vec3 v, float w) {
    if (has_bones) {
      const SkinVertex& skin = shape.mesh.skin[i];
      return skin.share * by_bone(skin.bone, v, w) + (1 - skin.share) * by_bone(skin.other, v, w);
    }
    if (model != nullptr) {
      const model::CornerSkin& skin = model->skins[i];
      Vec3 sum;
      for (std::size_t k = 0; k < skin.joints.size(); ++k) {
        if (skin.weights[k] <= 0) continue;
        if (w > 0) {
          sum += skin.weights[k] * by_bone(skin.joints[k], skin.position, 1);
          continue;
        }
        // Under uneven scales, normals require the cofactors.
        const Vec3 x = by_bone(skin.joints[k], {1, 0, 0}, 0), y = by_bone(skin.joints[k], {0, 1, 0}, 0),
                   z = by_bone(skin.joints[k], {0, 0, 1}, 0);
        const Vec3 turned = Cross(y, z) * skin.normal.x + Cross(z, x) * skin.normal.y + Cross(x, y) * skin.normal.z;
        sum += skin.weights[k] * world::Normalized(turned);
      }
      return sum;
    }
    const Vec3 s = drawable.scale;
    // Normals are scaled inversely to the mesh.
    const auto part = [&](float value, float scale) {
      return w > 0 ? value * scale : scale != 0 ? value / scale : value;
    };
    const Vec3 turned = Rotate(drawable.orientation, {part(v.x, s.x), part(v.y, s.y), part(v.z, s.z)});
    return w > 0 ? drawable.position + turned : turned;
  };
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const MeshVertex& vertex = mesh.vertices[i];
    placed.at.push_back(moved(i, vertex.position, 1));
    placed.normal.push_back(world::Normalized(moved(i, vertex.normal, 0)));
    const bool brings_color = look.paint == Look::Paint::kCorners;
    const world::Color base = has_bones      ? ColorOnCloth(cloths_, vertex.u, vertex.v)
                              : brings_color ? world::Color{vertex.u, vertex.v, vertex.light, 1}
                                             : look.base;
    Ink ink = InkOf(Mean(look.trim, base, vertex.tint), brings_color ? 1 : vertex.light);
    ink.a = look.base.a;
    placed.ink.push_back(ink);
  }
  return placed;
}

std::vector<SoftwarePictures::Placed> SoftwarePictures::PlaceAll(const world::SceneSnapshot& scene) {
  std::unordered_map<std::uint32_t, const world::AgentSnapshot*> agents;
  for (const world::AgentSnapshot& agent : scene.agents) agents[agent.id] = &agent;
  std::vector<Placed> all;
  for (const DrawableSnapshot& drawable : scene.drawables) {
    if (!drawable.visible) continue;
    const auto agent = drawable.belongs_to_agent ? agents.find(drawable.owner_id) : agents.end();
    all.push_back(Place(drawable, agent == agents.end() ? nullptr : agent->second));
    if (IsPlain(drawable)) AddBackdrop(all);
  }
  return all;
}

void SoftwarePictures::AddBackdrop(std::vector<Placed>& all) {
  for (const auto& [key, make] :
       {std::pair{"backdrop hills", &HillsMesh}, {"backdrop trees", &TreesMesh}, {"backdrop fence", &FenceMesh}}) {
    const auto [at, is_new] = shapes_.try_emplace(key);
    if (is_new) at->second.mesh.mesh = make();
    const MeshData& mesh = at->second.mesh.mesh;
    const Look look = LookNamed(mesh.material);
    Placed placed;
    placed.mesh = &mesh;
    for (const MeshVertex& vertex : mesh.vertices) {
      placed.at.push_back(vertex.position);
      placed.normal.push_back(vertex.normal);
      placed.ink.push_back(InkOf(Mean(look.trim, look.base, vertex.tint), vertex.light));
    }
    all.push_back(std::move(placed));
  }
}

void SoftwarePictures::DrawPlaced(const Placed& placed) {
  const auto corner = [&](std::uint32_t index) {
    Ink ink = placed.ink[index];
    const float light =
        std::max(kAmbient + kSunlight * std::max(0.0f, Dot(placed.normal[index], kToSun)), placed.glow) +
        placed.glow / 2;
    return SoftwareRaster::Corner{placed.at[index], {ink.r * light, ink.g * light, ink.b * light, ink.a}};
  };
  const std::vector<std::uint32_t>& indices = placed.mesh->indices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    raster_.Triangle(corner(indices[i]), corner(indices[i + 1]), corner(indices[i + 2]));
}

/// Draws the world as seen from the sun, around the camera's view: a hidden point is in shadow.
void SoftwarePictures::SeeFromSun(const std::vector<Placed>& all, const SoftwareCamera& camera) {
  // The point in the middle of the picture, and the extent of the picture there.
  const float down = std::max(0.05f, -camera.ahead.y), away = std::clamp(camera.eye.y / down, 5.0f, 150.0f);
  const Vec3 middle = camera.eye + away * camera.ahead;
  from_sun_.high_m = std::clamp(camera.high_m > 0 ? 2 * camera.high_m : 1.8f * away, 20.0f, 220.0f);
  from_sun_.ahead = -kToSun;
  from_sun_.up = {0, 0, 1};
  constexpr float kHigh_m = 150;
  from_sun_.eye = middle + kHigh_m * kToSun;
  sun_.Begin(from_sun_);
  for (const Placed& placed : all) {
    if (placed.is_clear) continue;
    const std::vector<std::uint32_t>& indices = placed.mesh->indices;
    const auto corner = [&](std::uint32_t index) { return SoftwareRaster::Corner{placed.at[index], {}}; };
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
      sun_.Triangle(corner(indices[i]), corner(indices[i + 1]), corner(indices[i + 2]));
  }
}

bool SoftwarePictures::IsShadowed(Vec3 point) const {
  const std::optional<Projected> seen = sun_.Project(point);
  if (!seen) return false;
  const float depth = sun_.DepthAt(static_cast<int>(std::floor(seen->x)), static_cast<int>(std::floor(seen->y)));
  const float bias = 0.06f + 1.5f / seen->size_px;
  return seen->depth > depth + bias;
}

/// Draws the sky, darkens shadows, and adds squares of 2 m to the ground, which show distances.
void SoftwarePictures::Shade(float ground_m) {
  picture::Image& image = raster_.image();
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::optional<Vec3> at = raster_.WorldAt(x, y);
      if (!at) {
        image.Mix(x, y, SkyAt(raster_.RayOf(x, y)), 1);
        continue;
      }
      float light = IsShadowed(*at) ? kShadow : 1;
      if (std::abs(at->y - ground_m) < 0.02f) {
        const int square = static_cast<int>(std::floor(at->x / 2)) + static_cast<int>(std::floor(at->z / 2));
        light *= (square & 1) != 0 ? 1.02f : 0.97f;
      }
      std::uint8_t* const pixel = image.At(x, y);
      for (int i = 0; i < 3; ++i)
        pixel[i] = static_cast<std::uint8_t>(std::min(255.0f, static_cast<float>(pixel[i]) * light));
    }
  }
}

void SoftwarePictures::DrawLines(const world::SceneSnapshot& scene) {
  std::vector<world::LineSnapshot> lines = scene.lines;
  world::AppendLines(scene.circles, lines);
  for (const world::LineSnapshot& line : lines) {
    const std::optional<Projected> from = raster_.Project(line.from), to = raster_.Project(line.to);
    if (from && to) raster_.image().Line(from->x, from->y, to->x, to->y, 3, InkOf(line.color));
  }
}

void SoftwarePictures::WriteNames(const world::SceneSnapshot& scene, picture::Image& image) const {
  constexpr float kOver_m = 0.35f, kHigh_px = 9, kPadding_px = 5, kBox_px = kHigh_px + 2 * kPadding_px;
  struct Label {
    const world::AgentSnapshot* agent;
    float x, y, width;  ///< Of its box; y is the lower edge.
  };
  std::vector<Label> labels;
  for (const world::AgentSnapshot& agent : scene.agents) {
    const std::optional<Projected> head = raster_.Project(agent.position + Vec3{0, agent.height_m / 2 + kOver_m, 0});
    const float width = picture::TextWidth(agent.name, kHigh_px) + 2 * kPadding_px;
    if (head) labels.push_back({&agent, head->x / 2 - width / 2, head->y / 2, width});
  }
  // From the lowest up: a label that would cover another one moves above it.
  std::ranges::stable_sort(labels, [](const Label& a, const Label& b) { return a.y > b.y; });
  for (std::size_t i = 0; i < labels.size(); ++i) {
    Label& label = labels[i];
    constexpr int kMostMoves = 40;
    const auto covers = [&label](const Label& other) {
      return label.x < other.x + other.width && other.x < label.x + label.width &&
             std::abs(label.y - other.y) < kBox_px;
    };
    for (int move = 0; move < kMostMoves; ++move) {
      const auto there = std::ranges::find_if(labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(i), covers);
      if (there == labels.begin() + static_cast<std::ptrdiff_t>(i)) break;
      label.y = there->y - kBox_px - 1;
    }
    const world::AgentSnapshot& agent = *label.agent;
    const world::Color color = agent.team.empty() ? AgentColor(agent.kind) : TeamColor(agent.team);
    image.Box(label.x, label.y - kBox_px, label.width, kBox_px, {1, 1, 1, agent.alive ? 0.82f : 0.55f});
    image.Box(label.x, label.y - kBox_px, 3, kBox_px, InkOf(color));
    picture::WriteText(image, label.x + kPadding_px + 1, label.y - kPadding_px, kHigh_px, agent.name,
                       {0.08f, 0.09f, 0.10f, agent.alive ? 1 : 0.6f}, 1.4f);
  }
}

picture::Image SoftwarePictures::Draw(const world::SceneSnapshot& scene, const SoftwareCamera& camera) {
  const std::vector<Placed> all = PlaceAll(scene);
  SeeFromSun(all, camera);
  raster_.Begin(camera);
  float ground_m = std::numeric_limits<float>::infinity();
  for (const DrawableSnapshot& drawable : scene.drawables)
    if (drawable.visible && drawable.shape == world::ShapeKind::kPlane)
      ground_m = std::min(ground_m, drawable.position.y);
  for (const Placed& placed : all)
    if (!placed.is_clear) DrawPlaced(placed);
  Shade(ground_m);
  for (const Placed& placed : all)
    if (placed.is_clear) DrawPlaced(placed);
  DrawLines(scene);
  picture::Image image = picture::Halved(raster_.image());
  WriteNames(scene, image);
  return image;
}

SoftwareCamera CameraOver(const std::vector<Vec3>& places, float aspect, bool is_plan) {
  constexpr float kFar = std::numeric_limits<float>::max();
  Vec3 low{kFar, kFar, kFar}, high = -low;
  for (const Vec3 place : places) {
    low = {std::min(low.x, place.x), std::min(low.y, place.y), std::min(low.z, place.z)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y), std::max(high.z, place.z)};
  }
  if (places.empty()) low = high = {};
  const Vec3 middle = (low + high) / 2;
  constexpr float kMargin_m = 3, kLeast_m = 10;
  const float wide = std::max(high.x - low.x + 2 * kMargin_m, kLeast_m),
              deep = std::max(high.z - low.z + 2 * kMargin_m, kLeast_m);
  SoftwareCamera camera;
  if (is_plan) {
    camera.ahead = {0, -1, 0};
    camera.up = {0, 0, -1};
    camera.eye = {middle.x, high.y + 60, middle.z};
    camera.high_m = std::max(deep, wide / aspect);
    return camera;
  }
  constexpr float kDown_deg = 38, kUsed = 0.85f, kNearest_m = 9;
  const float down = kDown_deg * std::numbers::pi_v<float> / 180;
  camera.ahead = {0, -std::sin(down), -std::cos(down)};
  camera.up = {0, 1, 0};
  const Vec3 up = Cross(Vec3{1, 0, 0}, camera.ahead);
  const float half = kUsed * std::tan(camera.vertical_fov_deg / 2 * std::numbers::pi_v<float> / 180);
  // Each place is within this fraction of the picture.
  float away = kNearest_m;
  for (const Vec3 place : places) {
    const Vec3 from = place - middle;
    away =
        std::max(away, std::max(std::abs(from.x) / aspect, std::abs(Dot(from, up))) / half - Dot(from, camera.ahead));
  }
  camera.eye = middle - away * camera.ahead;
  return camera;
}

}  // namespace soarbox::viewer
