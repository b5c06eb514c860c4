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

enum class UiGradient : std::uint8_t { kNorthSouth, kWestEast, kDiagonal };

/// The user-interface components of scripts (lua_api.md 10): boxes with a background, a plain caption and a markup
/// text. They are data only; renderers lay out the text. Calls with an unknown component return false or nothing.
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
  bool Contains(UiId id) const { return components_.count(id) != 0; }

  /// Relative to the parent.
  UiPoint Position(UiId id) const;
  /// The parent's screen position; (0, 0) at the top level.
  UiPoint OffsetPosition(UiId id) const;
  std::size_t size() const { return components_.size(); }
  UiPoint ScreenPosition(UiId id) const;
  UiPoint Dimensions(UiId id) const;
  /// x = left, y = top.
  UiPoint TextMargin(UiId id) const;
  const std::string& Text(UiId id) const;
  const std::string& MarkupText(UiId id) const;
  UiFont Font(UiId id) const;
  bool IsVisible(UiId id) const;

  bool SetPosition(UiId id, float x, float y);
  bool SetDimensions(UiId id, float width, float height);
  bool SetTextMargin(UiId id, float top, float left);
  bool SetText(UiId id, std::string_view text);
  bool SetMarkupText(UiId id, std::string_view text);
  bool SetFont(UiId id, UiFont font);
  bool SetFontColor(UiId id, Color color);
  /// Sets a flat background, which replaces a gradient. Channels are clamped to 0..1.
  bool SetBackgroundColor(UiId id, Color color);
  /// Sets a gradient, which replaces a flat background.
  bool SetGradientColor(UiId id, UiGradient direction, Color from, Color to);
  bool SetVisible(UiId id, bool visible);
  /// A bar that fills this fraction of the width, clamped to 0..1.
  bool SetBar(UiId id, float fraction, Color color);
  bool RemoveBar(UiId id);
  /// The fraction of its bar; nothing if it has none.
  std::optional<float> Bar(UiId id) const;
  /// The button's name; empty if this is not a button.
  const std::string& Button(UiId id) const;
  /// The key of an image that fills it (asset_store.h); empty: none.
  bool SetImage(UiId id, std::string_view key);
  /// Makes it a button with this name; an empty name makes it a plain component again. Returns false if another
  /// component has the name.
  bool SetButton(UiId id, std::string_view name);
  /// The button with this name; kNone if there is none.
  UiId FindButton(std::string_view name) const;
  std::vector<std::string> ButtonNames() const;
  /// Only for components in the world; returns false for others.
  bool SetWorldPosition(UiId id, Vec3 position);
  bool SetWorldOrientation(UiId id, Quat orientation);

  /// The palette of the markup's colours 0..9. Setting another index is ignored; reading one returns white.
  void SetMarkupColor(int index, Color color);
  Color MarkupColor(int index) const;

  /// "small", "small_mono", "medium", "medium_mono", "large", "large_mono"; nothing for other names.
  static std::optional<UiFont> FontByName(std::string_view name);
  static std::string_view FontName(UiFont font);

  /// `is_known`: this snapshot, or the one that it was copied from, was filled from this Ui before.
  void FillSnapshot(SceneSnapshot& snapshot, bool is_known) const;

 private:
  struct Component {
    UiSnapshot view;
    std::string caption;
    std::string markup;
  };
  Component* Find(UiId id);
  const Component* Find(UiId id) const;
  UiId Add(Component component);

  std::map<UiId, Component> components_;
  std::uint64_t changes_ = 0;
  std::array<Color, 10> palette_;
  std::uint32_t next_ = 1;
};

}  // namespace soarbox::world
