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

/// Values from -1 to 1 in the cells of a grid over a navigation mesh, in ten independent layers, for example of danger
/// or control. Cells that do not touch the mesh are unused.
///
/// It is created once from a mesh; later changes of the mesh have no effect. Calls with invalid layers or positions,
/// and values that are not finite, are ignored. Structure of arrays: only used cells have a number, and each layer is
/// one array indexed by it.
class InfluenceMap {
 public:
  static constexpr int kLayers = 10;
  static constexpr double kMaxCells = 1e6;  ///< Maximum number of cells of the entire grid.
  static constexpr int kMaxUsedCells = 100'000;

  static Result<InfluenceMap> Create(const NavigationMesh& mesh, const InfluenceConfig& config);

  /// Sets the value of the cell at the position, clamped to -1..1. Returns false if no used cell is there.
  bool Set(int layer, Vec3 position, float value);
  /// The value of the cell at the position; 0 if no used cell is there.
  float Get(int layer, Vec3 position) const;
  void Clear(int layer);
  /// Sets how much of an influence is lost per cell, 0..1; initially 0.
  void SetFalloff(int layer, float falloff);
  /// Sets how much of its value a cell keeps in each pass, 0..1; initially 0.
  void SetInertia(int layer, float inertia);
  /// Spreads the influences of a layer to neighbouring cells, in at most 20 passes; fewer if the falloff makes more
  /// useless.
  void Spread(int layer);

  /// Sets the colours of the cells from the present values of a layer. They stay until the next call.
  void Draw(int layer, Color positive, Color neutral, Color negative);
  void SetVisible(bool visible) { visible_ = visible; }
  void FillSnapshot(SceneSnapshot& snapshot) const;
  /// Draws the cells of the first layer that is not empty: blue above 0, orange below.
  void FillOverlay(OverlaySnapshot& overlays) const;

  int used_cells() const { return static_cast<int>(corners_.size()); }
  /// Hash of the values, the falloff and the inertia of all layers.
  std::uint64_t Hash() const;

 private:
  struct Layer {
    std::vector<float> values;  ///< By used cell; empty while all values are 0.
    float falloff = 0;
    float inertia = 0;
  };
  /// A neighbour of a used cell; kind 0 shares a side, 1 an edge, 2 a corner.
  struct Neighbor {
    std::int32_t cell;
    std::int32_t kind;
  };

  InfluenceMap() = default;
  std::int32_t CellAt(Vec3 position) const;
  /// Returns the number of cells that were tested.
  double MarkTriangle(const std::array<Vec3, 3>& triangle, std::vector<bool>& used) const;
  void FindNeighbors();
  std::size_t Index(int x, int y, int z) const;
  static bool IsLayer(int layer) { return layer >= 0 && layer < kLayers; }

  Vec3 min_;
  float width_m_ = 1, height_m_ = 1;
  std::array<int, 3> size_{};
  std::vector<std::int32_t> cells_;           ///< For each cell of the grid: its number among the used cells, or -1.
  std::vector<Vec3> corners_;                 ///< By used cell: its lower corner.
  std::vector<std::int32_t> first_neighbor_;  ///< By used cell: index of its first neighbour; then the end.
  std::vector<Neighbor> neighbors_;
  std::array<Layer, kLayers> layers_;
  std::vector<float> next_;    ///< Values of the next pass.
  std::vector<Color> colors_;  ///< By used cell; empty until Draw.
  bool visible_ = true;
};

}  // namespace soarbox::world
