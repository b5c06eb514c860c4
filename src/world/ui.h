// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "world/entity_ids.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {

/// In pixels; origin at the top left, y down.
struct UiPoint {
  float x = 0, y = 0;
};

/// A user-interface component: a box with a background, a plain caption and a markup text. Only data; renderers lay out
/// the text.
struct UiComponent {
  UiSnapshot view;  ///< Except for its texts.
  std::string caption;
  std::string markup;
};

/// The user-interface components of scripts (lua_api.md 10).
class Ui {
 public:
  Ui();

  /// Layers are 0 (lowest) to 15; other values return UiId::kNone.
  UiId Create(int layer);
  /// A panel in the world: 1 px = 0.005 m, facing +z of its rotation.
  UiId CreateInWorld(Vec3 position);
  /// A component on the same layer, positioned relative to the parent. It does not share the parent's visibility.
  UiId CreateChild(UiId parent);
  /// Removes the component and all its children. False if there is no such component.
  bool Remove(UiId id);
  std::size_t size() const { return components_.size(); }

  /// Null for unknown components.
  const UiComponent* Find(UiId id) const;
  /// The same, to change the component. The caller passes finite numbers, and channels of colours in 0..1.
  UiComponent* Edit(UiId id);
  /// The parent's screen position; (0, 0) at the top level.
  UiPoint OffsetPosition(UiId id) const;
  UiPoint ScreenPosition(UiId id) const;

  /// Makes it a button with this name; an empty name makes it a plain component again. Returns false if another
  /// component has the name.
  bool SetButton(UiId id, std::string_view name);
  /// The button with this name; kNone if there is none.
  UiId FindButton(std::string_view name) const;
  std::vector<std::string> ButtonNames() const;

  /// The palette of the markup's colours 0..9. Setting another index is ignored; reading one returns white.
  void SetMarkupColor(int index, Color color);
  Color MarkupColor(int index) const;

  /// "small", "small_mono", "medium", "medium_mono", "large", "large_mono"; nothing for other names.
  static std::optional<UiFont> FontByName(std::string_view name);
  static std::string_view FontName(UiFont font);

  /// `is_known`: this snapshot, or the one that it was copied from, was filled from this Ui before.
  void FillSnapshot(SceneSnapshot& snapshot, bool is_known) const;

 private:
  UiId Add(UiComponent component);

  std::map<UiId, UiComponent> components_;
  std::uint64_t changes_ = 0;
  std::array<Color, 10> palette_;
  std::uint32_t next_ = 1;
};

}  // namespace soarbox::world
