// SPDX-License-Identifier: BSD-2-Clause
#include "world/ui.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "world/refill.h"

namespace soarbox::world {
namespace {

constexpr int kLayers = 16;
constexpr std::array<std::string_view, 6> kFontNames{"small",       "small_mono", "medium",
                                                     "medium_mono", "large",      "large_mono"};

// The palette before a script sets another (lua_api.md 10), 0..255.
constexpr std::array<std::array<int, 3>, 10> kPalette{{{255, 255, 255},
                                                       {0, 0, 0},
                                                       {204, 204, 204},
                                                       {254, 220, 129},
                                                       {254, 138, 129},
                                                       {123, 236, 110},
                                                       {44, 192, 171},
                                                       {199, 93, 142},
                                                       {254, 254, 254},
                                                       {13, 13, 13}}};

float Channel(float value) {
  return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0.0f;
}
Color Clamped(Color c) {
  return {Channel(c.r), Channel(c.g), Channel(c.b), Channel(c.a)};
}

}  // namespace

Ui::Ui() {
  for (std::size_t i = 0; i < palette_.size(); ++i) {
    const auto& [r, g, b] = kPalette[i];
    palette_[i] = {static_cast<float>(r) / 255, static_cast<float>(g) / 255, static_cast<float>(b) / 255, 1};
  }
}

const UiComponent* Ui::Find(UiId id) const {
  const auto found = components_.find(id);
  return found == components_.end() ? nullptr : &found->second;
}

UiComponent* Ui::Edit(UiId id) {
  ++changes_;
  return const_cast<UiComponent*>(Find(id));
}

UiId Ui::Add(UiComponent component) {
  const UiId id{next_++};
  component.view.id = Number(id);
  component.view.width = 100;
  component.view.height = 100;
  components_.emplace(id, std::move(component));
  ++changes_;
  return id;
}

UiId Ui::Create(int layer) {
  if (layer < 0 || layer >= kLayers) return UiId::kNone;
  UiComponent component;
  component.view.layer = layer;
  return Add(std::move(component));
}

UiId Ui::CreateInWorld(Vec3 position) {
  if (!IsFinite(position)) return UiId::kNone;
  UiComponent component;
  component.view.in_world = true;
  component.view.world_position = position;
  return Add(std::move(component));
}

UiId Ui::CreateChild(UiId parent) {
  const UiComponent* above = Find(parent);
  if (!above) return UiId::kNone;
  UiComponent component;
  component.view.parent_id = Number(parent);
  component.view.layer = above->view.layer;
  component.view.in_world = above->view.in_world;
  return Add(std::move(component));
}

bool Ui::Remove(UiId id) {
  if (components_.erase(id) == 0) return false;
  ++changes_;
  // Ids ascend from parents to children, so one pass finds all descendants.
  for (auto next = components_.begin(); next != components_.end();) {
    const UiId parent{next->second.view.parent_id};
    next = parent != UiId::kNone && !Find(parent) ? components_.erase(next) : std::next(next);
  }
  return true;
}

UiPoint Ui::OffsetPosition(UiId id) const {
  const UiComponent* found = Find(id);
  return found && found->view.parent_id != 0 ? ScreenPosition(UiId{found->view.parent_id}) : UiPoint{};
}

UiPoint Ui::ScreenPosition(UiId id) const {
  UiPoint sum;
  // Parents are older than their children, so this terminates.
  for (const UiComponent* at = Find(id); at; at = Find(UiId{at->view.parent_id})) {
    sum.x += at->view.x;
    sum.y += at->view.y;
  }
  return sum;
}

bool Ui::SetButton(UiId id, std::string_view name) {
  UiComponent* found = Edit(id);
  if (!found) return false;
  const UiId other = name.empty() ? UiId::kNone : FindButton(name);
  if (other != UiId::kNone && other != id) return false;
  found->view.button = name;
  return true;
}

UiId Ui::FindButton(std::string_view name) const {
  for (const auto& [id, component] : components_)
    if (!name.empty() && component.view.button == name) return id;
  return UiId::kNone;
}

std::vector<std::string> Ui::ButtonNames() const {
  std::vector<std::string> names;
  for (const auto& [id, component] : components_)
    if (!component.view.button.empty()) names.push_back(component.view.button);
  return names;
}

void Ui::SetMarkupColor(int index, Color color) {
  if (index >= 0 && index < static_cast<int>(palette_.size()))
    palette_[static_cast<std::size_t>(index)] = Clamped(color);
  ++changes_;
}

Color Ui::MarkupColor(int index) const {
  return index >= 0 && index < static_cast<int>(palette_.size()) ? palette_[static_cast<std::size_t>(index)] : Color{};
}

std::optional<UiFont> Ui::FontByName(std::string_view name) {
  const auto found = std::find(kFontNames.begin(), kFontNames.end(), name);
  if (found == kFontNames.end()) return std::nullopt;
  return static_cast<UiFont>(found - kFontNames.begin());
}

std::string_view Ui::FontName(UiFont font) {
  return kFontNames[static_cast<std::size_t>(font)];
}

void Ui::FillSnapshot(SceneSnapshot& snapshot, bool is_known) const {
  if (is_known && snapshot.kept.ui == changes_) return;
  snapshot.kept.ui = changes_;
  snapshot.markup_palette = palette_;
  Refill<UiSnapshot> panels(snapshot.ui, components_.size());
  for (const auto& [id, component] : components_) {
    UiSnapshot& view = panels.Next();
    view = component.view;
    view.is_markup = !component.markup.empty();
    view.text = view.is_markup ? component.markup : component.caption;
    if (view.is_markup) view.caption = component.caption;
  }
}

}  // namespace soarbox::world
