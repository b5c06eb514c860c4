// SPDX-License-Identifier: BSD-2-Clause
#include "world/ui.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "world/refill.h"
#include "world/rotation.h"

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

const std::string kNoText;

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

/// For changes of the component.
Ui::Component* Ui::Find(UiId id) {
  ++changes_;
  const auto found = components_.find(id);
  return found == components_.end() ? nullptr : &found->second;
}

const Ui::Component* Ui::Find(UiId id) const {
  const auto found = components_.find(id);
  return found == components_.end() ? nullptr : &found->second;
}

UiId Ui::Add(Component component) {
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
  Component component;
  component.view.layer = layer;
  return Add(std::move(component));
}

UiId Ui::CreateInWorld(Vec3 position) {
  if (!IsFinite(position)) return UiId::kNone;
  Component component;
  component.view.in_world = true;
  component.view.world_position = position;
  return Add(std::move(component));
}

UiId Ui::CreateChild(UiId parent) {
  const Component* above = std::as_const(*this).Find(parent);
  if (!above) return UiId::kNone;
  Component component;
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
    next = parent != UiId::kNone && !Contains(parent) ? components_.erase(next) : std::next(next);
  }
  return true;
}

UiPoint Ui::Position(UiId id) const {
  const Component* found = Find(id);
  return found ? UiPoint{found->view.x, found->view.y} : UiPoint{};
}

UiPoint Ui::OffsetPosition(UiId id) const {
  const Component* found = Find(id);
  return found && found->view.parent_id != 0 ? ScreenPosition(UiId{found->view.parent_id}) : UiPoint{};
}

UiPoint Ui::ScreenPosition(UiId id) const {
  UiPoint sum;
  // Parents are older than their children, so this terminates.
  for (const Component* at = Find(id); at; at = Find(UiId{at->view.parent_id})) {
    sum.x += at->view.x;
    sum.y += at->view.y;
  }
  return sum;
}

UiPoint Ui::Dimensions(UiId id) const {
  const Component* found = Find(id);
  return found ? UiPoint{found->view.width, found->view.height} : UiPoint{};
}

UiPoint Ui::TextMargin(UiId id) const {
  const Component* found = Find(id);
  return found ? UiPoint{found->view.margin_left, found->view.margin_top} : UiPoint{};
}

const std::string& Ui::Text(UiId id) const {
  const Component* found = Find(id);
  return found ? found->caption : kNoText;
}

const std::string& Ui::MarkupText(UiId id) const {
  const Component* found = Find(id);
  return found ? found->markup : kNoText;
}

UiFont Ui::Font(UiId id) const {
  const Component* found = Find(id);
  return found ? found->view.font : UiFont::kSmall;
}

bool Ui::IsVisible(UiId id) const {
  const Component* found = Find(id);
  return found && found->view.visible;
}

bool Ui::SetPosition(UiId id, float x, float y) {
  Component* found = Find(id);
  if (!found || !IsFinite(x) || !IsFinite(y)) return false;
  found->view.x = x;
  found->view.y = y;
  return true;
}

bool Ui::SetDimensions(UiId id, float width, float height) {
  Component* found = Find(id);
  if (!found || !IsFinite(width) || !IsFinite(height)) return false;
  found->view.width = std::max(0.0f, width);
  found->view.height = std::max(0.0f, height);
  return true;
}

bool Ui::SetTextMargin(UiId id, float top, float left) {
  Component* found = Find(id);
  if (!found || !IsFinite(top) || !IsFinite(left)) return false;
  found->view.margin_top = top;
  found->view.margin_left = left;
  return true;
}

bool Ui::SetText(UiId id, std::string_view text) {
  Component* found = Find(id);
  if (found) found->caption = text;
  return found != nullptr;
}

bool Ui::SetMarkupText(UiId id, std::string_view text) {
  Component* found = Find(id);
  if (found) found->markup = text;
  return found != nullptr;
}

bool Ui::SetFont(UiId id, UiFont font) {
  Component* found = Find(id);
  if (found) found->view.font = font;
  return found != nullptr;
}

bool Ui::SetFontColor(UiId id, Color color) {
  Component* found = Find(id);
  if (found) found->view.text_color = Clamped(color);
  return found != nullptr;
}

bool Ui::SetBackgroundColor(UiId id, Color color) {
  Component* found = Find(id);
  if (!found) return false;
  found->view.has_gradient = true;
  found->view.gradient_is_vertical = true;
  found->view.gradient_is_diagonal = false;
  found->view.gradient_from = found->view.gradient_to = Clamped(color);
  return true;
}

bool Ui::SetGradientColor(UiId id, UiGradient direction, Color from, Color to) {
  Component* found = Find(id);
  if (!found) return false;
  found->view.has_gradient = true;
  found->view.gradient_is_vertical = direction == UiGradient::kNorthSouth;
  found->view.gradient_is_diagonal = direction == UiGradient::kDiagonal;
  found->view.gradient_from = Clamped(from);
  found->view.gradient_to = Clamped(to);
  return true;
}

bool Ui::SetVisible(UiId id, bool visible) {
  Component* found = Find(id);
  if (found) found->view.visible = visible;
  return found != nullptr;
}

bool Ui::SetBar(UiId id, float fraction, Color color) {
  Component* found = Find(id);
  if (!found || !std::isfinite(fraction)) return false;
  found->view.has_bar = true;
  found->view.bar = std::clamp(fraction, 0.0f, 1.0f);
  found->view.bar_color = Clamped(color);
  return true;
}

bool Ui::RemoveBar(UiId id) {
  Component* found = Find(id);
  if (found) found->view.has_bar = false;
  return found != nullptr;
}

std::optional<float> Ui::Bar(UiId id) const {
  const Component* found = Find(id);
  return found && found->view.has_bar ? std::optional(found->view.bar) : std::nullopt;
}

const std::string& Ui::Button(UiId id) const {
  const Component* found = Find(id);
  return found ? found->view.button : kNoText;
}

bool Ui::SetImage(UiId id, std::string_view key) {
  Component* found = Find(id);
  if (found) found->view.material = key;
  return found != nullptr;
}

bool Ui::SetButton(UiId id, std::string_view name) {
  Component* found = Find(id);
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

bool Ui::SetWorldPosition(UiId id, Vec3 position) {
  Component* found = Find(id);
  if (!found || !found->view.in_world || !IsFinite(position)) return false;
  found->view.world_position = position;
  return true;
}

bool Ui::SetWorldOrientation(UiId id, Quat orientation) {
  Component* found = Find(id);
  if (!found || !found->view.in_world || !IsFinite(orientation)) return false;
  found->view.world_orientation = Normalized(orientation);
  return true;
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
