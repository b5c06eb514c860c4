// SPDX-License-Identifier: BSD-2-Clause
#include "world/influence_map.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "diagnostics/problem.h"
#include "world/overlay_snapshot.h"
#include "world/rotation.h"
#include "world/state_hash.h"
#include "world/triangle_box.h"

namespace soarbox::world {
namespace {

constexpr int kMaxPasses = 20;
constexpr float kNegligible = 0.01f;
/// Maximum number of tests of a triangle against a cell.
constexpr double kMaxTests = 20e6;
constexpr Color kOutline{0, 0, 0, 0.08f};  // Drawn twice, by both neighbours.
constexpr float kLift_m = 0.03f;
constexpr float kBelow_cells = 0.001f;

Diagnostic Fault(std::string message, std::string hint) {
  return NewProblem(std::move(message), std::move(hint));
}

/// The number of complete cells, plus the rest in metres, rounded up. The first sandbox counted in this way.
double CellCount(float extent, float size) {
  const double whole = std::floor(double{extent} / size);
  return std::max(1.0, whole + std::ceil(extent - whole * size));
}

Color Mix(Color from, Color to, float share) {
  return {from.r + (to.r - from.r) * share, from.g + (to.g - from.g) * share, from.b + (to.b - from.b) * share,
          from.a + (to.a - from.a) * share};
}

}  // namespace

Result<InfluenceMap> InfluenceMap::Create(const NavigationMesh& mesh, const InfluenceConfig& config) {
  const auto is_size = [](float size) { return size >= 0.01f && size <= 1000; };
  if (!is_size(config.cell_width_m) || !is_size(config.cell_height_m)) {
    return Fault("CellWidth and CellHeight must be from 0.01 to 1000 m", "give both: {CellWidth = 2, CellHeight = 1}");
  }
  if (!IsFinite(config.min_offset) || !IsFinite(config.max_offset))
    return Fault("an offset of the boundary is not finite", "give vectors of a few metres");
  InfluenceMap map;
  map.width_m_ = config.cell_width_m;
  map.height_m_ = config.cell_height_m;
  // Slightly lower, so that floors are not on the border between two cells and use both.
  map.min_ = mesh.min() + config.min_offset - Vec3{0, kBelow_cells * map.height_m_, 0};
  const Vec3 extent = mesh.max() + config.max_offset + Vec3{map.width_m_, map.height_m_, map.width_m_} - map.min_;
  const double counts[3] = {CellCount(extent.x, map.width_m_), CellCount(extent.y, map.height_m_),
                            CellCount(extent.z, map.width_m_)};
  if (!(counts[0] * counts[1] * counts[2] <= kMaxCells))
    return Fault("the influence map would have more than 1 million cells", "make the cells larger");
  for (std::size_t axis = 0; axis < 3; ++axis) map.size_[axis] = static_cast<int>(counts[axis]);

  std::vector<bool> used(map.Index(0, 0, map.size_[2]), false);
  double tests = 0;
  for (const auto& triangle : mesh.triangles()) {
    tests += map.MarkTriangle(triangle, used);
    if (tests > kMaxTests)
      return Fault("the influence map is too fine for this navigation mesh", "make the cells larger");
  }
  map.cells_.assign(used.size(), -1);
  for (int z = 0; z < map.size_[2]; ++z) {
    for (int y = 0; y < map.size_[1]; ++y) {
      for (int x = 0; x < map.size_[0]; ++x) {
        if (!used[map.Index(x, y, z)]) continue;
        map.cells_[map.Index(x, y, z)] = map.used_cells();
        map.corners_.push_back(map.min_ + Vec3{static_cast<float>(x) * map.width_m_,
                                               static_cast<float>(y) * map.height_m_,
                                               static_cast<float>(z) * map.width_m_});
      }
    }
  }
  if (map.used_cells() > kMaxUsedCells)
    return Fault("the influence map would have more than 100000 cells in use", "make the cells larger");
  map.FindNeighbors();
  return map;
}

std::size_t InfluenceMap::Index(int x, int y, int z) const {
  return static_cast<std::size_t>(x) +
         static_cast<std::size_t>(size_[0]) *
             (static_cast<std::size_t>(y) + static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(z));
}

double InfluenceMap::MarkTriangle(const std::array<Vec3, 3>& triangle, std::vector<bool>& used) const {
  const auto range = [](float a, float b, float c, float origin, float size, int count) {
    const auto cell = [&](float v) {
      return static_cast<int>(std::clamp(std::floor((v - origin) / size), 0.0f, static_cast<float>(count - 1)));
    };
    return std::pair(cell(std::min({a, b, c}) - size), cell(std::max({a, b, c}) + size));
  };
  const auto& [a, b, c] = triangle;
  const auto [x0, x1] = range(a.x, b.x, c.x, min_.x, width_m_, size_[0]);
  const auto [y0, y1] = range(a.y, b.y, c.y, min_.y, height_m_, size_[1]);
  const auto [z0, z1] = range(a.z, b.z, c.z, min_.z, width_m_, size_[2]);
  const Vec3 half{width_m_ / 2, height_m_ / 2, width_m_ / 2};
  for (int z = z0; z <= z1; ++z) {
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const Vec3 center =
            min_ + half +
            Vec3{static_cast<float>(x) * width_m_, static_cast<float>(y) * height_m_, static_cast<float>(z) * width_m_};
        if (TriangleTouchesBox(triangle, center, half)) used[Index(x, y, z)] = true;
      }
    }
  }
  return double{x1 - x0 + 1.0} * (y1 - y0 + 1) * (z1 - z0 + 1);
}

void InfluenceMap::FindNeighbors() {
  for (int z = 0; z < size_[2]; ++z) {
    for (int y = 0; y < size_[1]; ++y) {
      for (int x = 0; x < size_[0]; ++x) {
        if (cells_[Index(x, y, z)] < 0) continue;
        first_neighbor_.push_back(static_cast<std::int32_t>(neighbors_.size()));
        for (int step = 0; step < 27; ++step) {
          const int dx = step % 3 - 1, dy = step / 3 % 3 - 1, dz = step / 9 - 1;
          const int nx = x + dx, ny = y + dy, nz = z + dz;
          const bool inside = nx >= 0 && ny >= 0 && nz >= 0 && nx < size_[0] && ny < size_[1] && nz < size_[2];
          if (!inside || step == 13) continue;
          const std::int32_t cell = cells_[Index(nx, ny, nz)];
          if (cell >= 0) neighbors_.push_back({cell, dx * dx + dy * dy + dz * dz - 1});
        }
      }
    }
  }
  first_neighbor_.push_back(static_cast<std::int32_t>(neighbors_.size()));
}

std::int32_t InfluenceMap::CellAt(Vec3 position) const {
  const Vec3 offset = position - min_;
  const float cell[3] = {std::floor(offset.x / width_m_), std::floor(offset.y / height_m_),
                         std::floor(offset.z / width_m_)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(cell[axis] >= 0 && cell[axis] < static_cast<float>(size_[axis]))) return -1;
  }
  return cells_[Index(static_cast<int>(cell[0]), static_cast<int>(cell[1]), static_cast<int>(cell[2]))];
}

bool InfluenceMap::Set(int layer, Vec3 position, float value) {
  const std::int32_t cell = CellAt(position);
  if (!IsLayer(layer) || cell < 0 || !IsFinite(value)) return false;
  auto& values = layers_[static_cast<std::size_t>(layer)].values;
  values.resize(corners_.size(), 0);
  values[static_cast<std::size_t>(cell)] = std::clamp(value, -1.0f, 1.0f);
  return true;
}

float InfluenceMap::Get(int layer, Vec3 position) const {
  const std::int32_t cell = CellAt(position);
  if (!IsLayer(layer) || cell < 0) return 0;
  const auto& values = layers_[static_cast<std::size_t>(layer)].values;
  return values.empty() ? 0 : values[static_cast<std::size_t>(cell)];
}

void InfluenceMap::Clear(int layer) {
  if (IsLayer(layer)) layers_[static_cast<std::size_t>(layer)].values.clear();
}
void InfluenceMap::SetFalloff(int layer, float falloff) {
  if (IsLayer(layer) && IsFinite(falloff))
    layers_[static_cast<std::size_t>(layer)].falloff = std::clamp(falloff, 0.0f, 1.0f);
}
void InfluenceMap::SetInertia(int layer, float inertia) {
  if (IsLayer(layer) && IsFinite(inertia))
    layers_[static_cast<std::size_t>(layer)].inertia = std::clamp(inertia, 0.0f, 1.0f);
}

void InfluenceMap::Spread(int layer) {
  if (!IsLayer(layer)) return;
  Layer& spread = layers_[static_cast<std::size_t>(layer)];
  if (spread.values.empty()) return;
  const float kept = 1 - spread.falloff;
  const float weights[3] = {kept, std::pow(kept, std::sqrt(2.0f)), std::pow(kept, std::sqrt(3.0f))};
  next_.resize(spread.values.size());
  float reach = kept;
  for (int pass = 0; pass < kMaxPasses && (pass == 0 || reach > kNegligible); ++pass, reach *= kept) {
    for (std::size_t cell = 0; cell < spread.values.size(); ++cell) {
      const float own = spread.values[cell];
      float positive = std::max(0.0f, own), negative = std::min(0.0f, own);
      const auto end = static_cast<std::size_t>(first_neighbor_[cell + 1]);
      for (auto i = static_cast<std::size_t>(first_neighbor_[cell]); i < end; ++i) {
        const Neighbor neighbor = neighbors_[i];
        const float flow = spread.values[static_cast<std::size_t>(neighbor.cell)] * weights[neighbor.kind];
        positive = std::max(positive, flow);
        negative = std::min(negative, flow);
      }
      next_[cell] = std::clamp(own * spread.inertia + (positive + negative) * (1 - spread.inertia), -1.0f, 1.0f);
    }
    spread.values.swap(next_);
  }
}

void InfluenceMap::Draw(int layer, Color positive, Color neutral, Color negative) {
  if (!IsLayer(layer)) return;
  const auto& values = layers_[static_cast<std::size_t>(layer)].values;
  colors_.assign(corners_.size(), neutral);
  for (std::size_t cell = 0; cell < values.size(); ++cell) {
    colors_[cell] = Mix(neutral, values[cell] > 0 ? positive : negative, std::abs(values[cell]));
  }
}

void InfluenceMap::FillSnapshot(SceneSnapshot& snapshot) const {
  if (!visible_) return;
  for (std::size_t cell = 0; cell < colors_.size(); ++cell) {
    const Vec3 a = corners_[cell] + Vec3{0, kLift_m, 0};
    const Vec3 b = a + Vec3{0, 0, width_m_}, c = a + Vec3{width_m_, 0, width_m_}, d = a + Vec3{width_m_, 0, 0};
    snapshot.triangles.push_back({a, b, c, colors_[cell]});
    snapshot.triangles.push_back({c, d, a, colors_[cell]});
    snapshot.lines.push_back({a, b, kOutline});
    snapshot.lines.push_back({b, c, kOutline});
    snapshot.lines.push_back({c, d, kOutline});
    snapshot.lines.push_back({d, a, kOutline});
  }
}

void InfluenceMap::FillOverlay(OverlaySnapshot& overlays) const {
  overlays.has_influence = true;
  const auto layer = std::find_if(layers_.begin(), layers_.end(), [](const Layer& one) {
    return std::any_of(one.values.begin(), one.values.end(), [](float value) { return value != 0; });
  });
  if (layer == layers_.end()) return;
  for (std::size_t cell = 0; cell < layer->values.size(); ++cell) {
    const float value = layer->values[cell];
    if (std::abs(value) < 0.01f) continue;
    Color color = value > 0 ? Color{0.16f, 0.45f, 0.95f, 1} : Color{0.98f, 0.55f, 0.08f, 1};
    color.a = 0.12f + 0.55f * std::abs(value);
    const Vec3 a = corners_[cell] + Vec3{0, kLift_m, 0};
    const Vec3 b = a + Vec3{0, 0, width_m_}, c = a + Vec3{width_m_, 0, width_m_}, d = a + Vec3{width_m_, 0, 0};
    overlays.triangles.push_back({a, b, c, color});
    overlays.triangles.push_back({c, d, a, color});
  }
}

std::uint64_t InfluenceMap::Hash() const {
  StateHash hash;
  for (const Layer& layer : layers_) {
    hash.Add(layer.falloff);
    hash.Add(layer.inertia);
    hash.Add(static_cast<std::uint64_t>(layer.values.size()));
    for (const float value : layer.values) hash.Add(value);
  }
  return hash.value();
}

}  // namespace soarbox::world
