// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/skin_mesh.h"

#include <algorithm>
#include <cmath>

#include "viewer/cloth_image.h"
#include "viewer/half_turn.h"

namespace soarbox::viewer {
namespace {

using world::Vec3;

constexpr float kFar = 0.31f;  ///< Below this fineness the mesh is only seen from a distance.

/// A power with the sign of `value`.
float Power(float value, float exponent) {
  return std::copysign(std::pow(std::abs(value), exponent), value);
}

}  // namespace

int SkinBuilder::Count(int segments) const {
  return std::max(4, static_cast<int>(std::lround(static_cast<float>(segments) * fineness_)));
}

void SkinBuilder::AddVertex(Vec3 at, Vec3 normal, const SkinVertex& skin, float light_here) {
  MeshVertex vertex;
  vertex.position = at;
  vertex.normal = normal;
  const ClothPlace on = PlaceOnCloth(cloth, at);
  vertex.u = on.u;
  vertex.v = on.v;
  vertex.tint = cloth == Cloth::kTeam ? 0.0f : 1.0f;
  vertex.light = light * light_here;
  vertex.gloss = GlossOf(cloth);
  made_.mesh.vertices.push_back(vertex);
  made_.skin.push_back(skin);
}

void SkinBuilder::AddGrid(const std::vector<std::vector<Vec3>>& rows, const std::vector<SkinVertex>& skins,
                          const std::vector<float>& lights) {
  const std::size_t count = rows.size(), around = rows[0].size();
  const auto base = static_cast<std::uint32_t>(made_.mesh.vertices.size());
  for (std::size_t r = 0; r < count; ++r) {
    for (std::size_t s = 0; s <= around; ++s) {
      const std::size_t here = s % around, next = (here + 1) % around, last = (here + around - 1) % around;
      Vec3 across = rows[r][next] - rows[r][last];
      const std::size_t above = std::min(r + 1, count - 1), below = r > 0 ? r - 1 : 0;
      const Vec3 up = rows[above][here] - rows[below][here];
      if (world::LengthSquared(across) < 1e-10f) {
        // A pole: the neighbouring ring defines the orientation.
        const std::size_t near = r == 0 ? 1 : r - 1;
        across = rows[near][next] - rows[near][last];
      }
      Vec3 normal = world::Normalized(Cross(across, up));
      // A closed end faces along the row of rings.
      const bool first_pole = r == 0 && world::LengthSquared(rows[0][0] - rows[0][around / 2]) < 1e-8f;
      const bool last_pole = r + 1 == count && world::LengthSquared(rows[r][0] - rows[r][around / 2]) < 1e-8f;
      if (first_pole || last_pole) {
        Vec3 middle;
        const auto& ring = rows[first_pole ? 1 : r - 1];
        for (const Vec3 p : ring) middle += p / static_cast<float>(around);
        const Vec3 away = rows[r][0] - middle;
        // A flat end has no direction of its own: use that of the rings behind it.
        normal = world::LengthSquared(away) > 1e-8f
                     ? world::Normalized(away)
                     : world::Normalized(rows[r][0] - rows[first_pole ? count - 1 : 0][0]);
      }
      AddVertex(place.Apply(rows[r][here]), Rotate(place.orientation, normal), skins[r], lights[r]);
    }
  }
  const auto row = static_cast<std::uint32_t>(around) + 1;
  for (std::uint32_t r = 0; r + 1 < count; ++r) {
    for (std::uint32_t s = 0; s + 1 < row; ++s) {
      const std::uint32_t a = base + r * row + s;
      made_.mesh.AddQuad(a, a + 1, a + row + 1, a + row);
    }
  }
}

void SkinBuilder::Loft(const std::vector<Ring>& given, int segments, Vec3 ahead, bool closed_ends) {
  const int around = Count(segments);
  // For distant bodies every other ring is enough; the ends are kept.
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == given.size();
    if (is_end || fineness_ >= kFar || given.size() < 5 || i % 2 == 0) rings.push_back(given[i]);
  }
  std::vector<std::vector<Vec3>> rows;
  std::vector<SkinVertex> skins;
  std::vector<float> lights;
  const auto add_point = [&](const Ring& ring) {
    rows.emplace_back(static_cast<std::size_t>(around), ring.centre);
    skins.push_back(ring.skin);
    lights.push_back(ring.light);
  };
  if (closed_ends) add_point(rings.front());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Ring& ring = rings[i];
    const Vec3 way = rings[std::min(i + 1, rings.size() - 1)].centre - rings[i > 0 ? i - 1 : 0].centre;
    const Vec3 along = world::Normalized(way);
    const Vec3 right = world::Normalized(Cross(along, ahead));
    const Vec3 front = Cross(right, along);
    const float exponent = 1 - 0.72f * ring.square;
    std::vector<Vec3> row;
    for (int s = 0; s < around; ++s) {
      const float angle = 2 * kPi * (static_cast<float>(s) + 0.5f) / static_cast<float>(around);
      row.push_back(ring.centre + right * (ring.right * Power(std::cos(angle), exponent)) -
                    front * (ring.ahead * Power(std::sin(angle), exponent)));
    }
    rows.push_back(std::move(row));
    skins.push_back(ring.skin);
    lights.push_back(ring.light);
  }
  if (closed_ends) add_point(rings.back());
  AddGrid(rows, skins, lights);
}

void SkinBuilder::Round(Vec3 centre, Vec3 half, float round, int segments, float from, float to) {
  Round(centre, half, round, segments, from, to, [](Vec3 p) { return p; });
}

void SkinBuilder::Round(Vec3 centre, Vec3 half, float round, int segments, float from, float to,
                        const std::function<Vec3(Vec3)>& bend) {
  const int around = Count(segments), up = std::max(fineness_ < kFar ? 3 : 4, around / 2);
  std::vector<std::vector<Vec3>> rows;
  for (int r = 0; r <= up; ++r) {
    const float t = from + (to - from) * static_cast<float>(r) / static_cast<float>(up);
    const float high = Power(std::sin(t * kPi / 2), round);
    const float wide = r == 0 && from <= -1 ? 0.0f : r == up && to >= 1 ? 0.0f : Power(std::cos(t * kPi / 2), round);
    std::vector<Vec3> row;
    for (int s = 0; s < around; ++s) {
      const float angle = 2 * kPi * (static_cast<float>(s) + 0.5f) / static_cast<float>(around);
      row.push_back(bend(centre + Vec3{half.x * wide * Power(std::cos(angle), round), half.y * high,
                                       -half.z * wide * Power(std::sin(angle), round)}));
    }
    rows.push_back(std::move(row));
  }
  AddGrid(rows, std::vector<SkinVertex>(rows.size(), bone), std::vector<float>(rows.size(), 1.0f));
}

void SkinBuilder::Tube(const std::vector<Vec3>& points, float radius, int segments) {
  std::vector<Ring> rings;
  const auto add = [&](Vec3 at, float r) { rings.push_back({at, r, r, bone}); };
  const Vec3 start = world::Normalized(points[1] - points[0]),
             end = world::Normalized(points.back() - points[points.size() - 2]);
  add(points.front() - start * (0.7f * radius), 0.65f * radius);
  for (const Vec3 point : points) add(point, radius);
  add(points.back() + end * (0.7f * radius), 0.65f * radius);
  const Vec3 whole = points.back() - points.front();
  const Vec3 ahead = std::abs(whole.y) < 0.7f * world::Length(whole) ? Vec3{0, 1, 0.13f} : Vec3{0.13f, 0.1f, 1};
  Loft(rings, segments, ahead);
}

std::vector<world::BonePose> ToBind(const world::Skeleton& skeleton) {
  std::vector<world::BonePose> poses;
  for (int bone = 0; bone < skeleton.count(); ++bone) poses.push_back(Inverse(skeleton.BindInModel(bone)));
  return poses;
}

void BoneRows(const std::vector<world::BonePose>& to_bind, const std::vector<world::BonePose>& bones,
              const SkinPlace& place, float* out) {
  // The rotation and scale of the body as three columns.
  const auto stretched = [&place](Vec3 v) {
    return Rotate(place.at.orientation, Vec3{v.x * place.scale.x, v.y * place.scale.y, v.z * place.scale.z});
  };
  const Vec3 x = stretched({1, 0, 0}), y = stretched({0, 1, 0}), z = stretched({0, 0, 1});
  const auto placed = [&](Vec3 v) { return x * v.x + y * v.y + z * v.z; };
  for (std::size_t i = 0; i < std::min(bones.size(), to_bind.size()); ++i) {
    const world::BonePose move = bones[i] * to_bind[i];
    const Vec3 a = placed(Rotate(move.orientation, {1, 0, 0})), b = placed(Rotate(move.orientation, {0, 1, 0})),
               c = placed(Rotate(move.orientation, {0, 0, 1})), at = place.at.position + placed(move.position);
    for (const float number : {a.x, b.x, c.x, at.x, a.y, b.y, c.y, at.y, a.z, b.z, c.z, at.z}) *out++ = number;
  }
}

}  // namespace soarbox::viewer
