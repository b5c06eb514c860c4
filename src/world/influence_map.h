// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "diagnostics/result.h"
#include "world/math.h"
#include "world/navigation_mesh.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {

struct OverlaySnapshot;

struct InfluenceConfig {
  float cell_width_m = 0;   ///< Along x and z; above 0.
  float cell_height_m = 0;  ///< Above 0.
  Vec3 min_offset;          ///< Added to the lower corner of the box around the navigation mesh.
  Vec3 max_offset;          ///< Added to its upper corner.
};

/// Values from -1 to 1 in the cells of a grid over a navigation mesh, in ten independent layers: where danger is, who
/// holds what. Cells that no part of the mesh touches hold nothing.
///
/// It is made once from a mesh; later changes of the mesh do not reach it. It ignores layers and cells out of range,
/// and values that are not numbers. Structure of arrays: only cells in use have a number, and each layer is one array
/// by it.
class InfluenceMap {
 public:
  static constexpr int kLayers = 10;
  static constexpr double kMaxCells = 1e6;  ///< Of the whole grid.
  static constexpr int kMaxUsedCells = 100'000;

  static Result<InfluenceMap> Create(const NavigationMesh& mesh, const InfluenceConfig& config);

  /// Overwrites the cell at the position; clamped to -1..1. False if no cell in use is there.
  bool Set(int layer, Vec3 position, float value);
  /// 0 where no cell in use is.
  float Get(int layer, Vec3 position) const;
  void Clear(int layer);
  /// How much of an influence is lost per cell, 0..1; 0 at first.
  void SetFalloff(int layer, float falloff);
  /// How much of its value a cell keeps in each pass, 0..1; 0 at first.
  void SetInertia(int layer, float inertia);
  /// Lets the influences of a layer flow over the cells: at most 20 passes, fewer where the falloff makes more useless.
  void Spread(int layer);

  /// Colours the cells by the values of a layer, as they are now, until it is called again.
  void Draw(int layer, Color positive, Color neutral, Color negative);
  void SetVisible(bool visible) { visible_ = visible; }
  void FillSnapshot(SceneSnapshot& snapshot) const;
  /// Colours the cells of the first layer that holds anything: blue above 0, orange below.
  void FillOverlay(OverlaySnapshot& overlays) const;

  int used_cells() const { return static_cast<int>(corners_.size()); }
  std::array<int, 3> grid_size() const { return size_; }
  /// Of all values and settings.
  std::uint64_t Hash() const;

 private:
  struct Layer {
    std::vector<float> values;  ///< By used cell; empty as long as all are 0.
    float falloff = 0;
    float inertia = 0;
  };
  /// A neighbour of a cell in use; kind 0 shares a side, 1 an edge, 2 a corner.
  struct Neighbor {
    std::int32_t cell;
    std::int32_t kind;
  };

  InfluenceMap() = default;
  std::int32_t CellAt(Vec3 position) const;
  /// Returns how many cells it looked at.
  double MarkTriangle(const std::array<Vec3, 3>& triangle, std::vector<bool>& used) const;
  void FindNeighbors();
  std::size_t Index(int x, int y, int z) const;
  static bool IsLayer(int layer) { return layer >= 0 && layer < kLayers; }

  Vec3 min_;
  float width_m_ = 1, height_m_ = 1;
  std::array<int, 3> size_{};
  std::vector<std::int32_t> cells_;           ///< Of the whole grid: the number among the cells in use, or -1.
  std::vector<Vec3> corners_;                 ///< By used cell: its lower corner.
  std::vector<std::int32_t> first_neighbor_;  ///< By used cell, and one more: where its neighbours start.
  std::vector<Neighbor> neighbors_;
  std::array<Layer, kLayers> layers_;
  std::vector<float> next_;    ///< Of a pass.
  std::vector<Color> colors_;  ///< By used cell; empty until Draw.
  bool visible_ = true;
};

}  // namespace soarbox::world
