// SPDX-License-Identifier: BSD-2-Clause
#include "sim/client_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "world/agent.h"
#include "world/debug_draw.h"
#include "world/ui.h"
#include "world/world.h"

namespace soarbox::sim {
namespace {

constexpr float kLineHeight_m = 0.02f, kTextHeight_m = 0.6f;
constexpr double kMost_m = 1e5;

struct NamedColor {
  std::string_view name;
  world::Vec3 color;
};
constexpr std::array kColors = {
    NamedColor{"white", {1, 1, 1}},           NamedColor{"black", {0.05f, 0.05f, 0.05f}},
    NamedColor{"gray", {0.5f, 0.5f, 0.5f}},   NamedColor{"red", {0.85f, 0.2f, 0.2f}},
    NamedColor{"green", {0.2f, 0.65f, 0.3f}}, NamedColor{"blue", {0.2f, 0.4f, 0.85f}},
    NamedColor{"yellow", {0.9f, 0.8f, 0.2f}}, NamedColor{"orange", {0.95f, 0.55f, 0.15f}},
};

world::Agent* FindNamed(world::World& world, std::string_view name) {
  for (const world::EntityId id : world.AgentIds())
    if (world::Agent* const agent = world.FindAgent(id); agent->name() == name) return agent;
  return nullptr;
}

world::Vec3 Forward(double heading_deg) {
  const double angle = heading_deg * std::numbers::pi / 180;
  return {static_cast<float>(std::cos(angle)), 0, static_cast<float>(-std::sin(angle))};
}

}  // namespace

double ClientScene::Shape::Number(std::string_view attribute, double otherwise) const {
  const auto found = values.find(attribute);
  if (found == values.end() || !found->second.is_number || !std::isfinite(found->second.number)) return otherwise;
  return std::clamp(found->second.number, -kMost_m, kMost_m);
}

std::string ClientScene::Shape::Text(std::string_view attribute) const {
  const auto found = values.find(attribute);
  return found == values.end() ? std::string() : found->second.text;
}

world::Vec3 ClientScene::Shape::At(std::string_view x, std::string_view y, float height_m) const {
  return {static_cast<float>(Number(x, 0)), height_m, static_cast<float>(-Number(y, 0))};
}

world::Vec3 ClientScene::Shape::Color() const {
  const std::string name = Text("color");
  const auto* const found = std::ranges::find(kColors, name, &NamedColor::name);
  return found == kColors.end() ? world::Vec3{0.9f, 0.9f, 0.9f} : found->color;
}

void ClientScene::Set(const Element& element, std::string_view type) {
  const bool is_id = type == "id";
  if (const auto shape = shapes_.find(element.id); shape != shapes_.end() && !is_id) {
    const bool is_number = type == "int" || type == "double";
    shape->second.values[element.attribute] = {element.value,
                                               is_number ? std::strtod(element.value.c_str(), nullptr) : 0, is_number};
  } else if (element.id == scene_ && is_id) {
    shapes_.try_emplace(element.value).first->second.kind = element.attribute;
  } else if (element.id == root_ && is_id && element.attribute == "scene") {
    scene_ = element.value;
  }
}

void ClientScene::Note(const std::vector<std::string>& parts, std::string_view input_link) {
  constexpr std::size_t kPartsOfAdd = 8, kPartsOfSet = 6;
  const std::string& kind = parts.front();
  if (kind == "add" && parts.size() >= kPartsOfAdd) {
    const std::string &id = parts[4], &attribute = parts[5], &value = parts[7];
    if (id == input_link && attribute == "soarbox" && parts[6] == "id") root_ = value;
    const bool is_mine = !root_.empty() && (value == root_ || id == root_ || id == scene_ || shapes_.contains(id));
    if (!is_mine) return;
    Set(elements_[parts[2]] = {id, attribute, value}, parts[6]);
    return;
  }
  if (parts.size() < 3) return;
  const auto found = elements_.find(parts[2]);
  if (found == elements_.end()) return;
  Element& element = found->second;
  if (kind == "set" && parts.size() >= kPartsOfSet) {
    element.value = parts[5];
    Set(element, parts[4]);
  } else if (kind == "remove") {
    if (const auto shape = shapes_.find(element.id); shape != shapes_.end())
      shape->second.values.erase(element.attribute);
    if (element.id == scene_) shapes_.erase(element.value);
    if (element.attribute == "scene" && element.id == root_) {
      shapes_.clear();
      scene_.clear();
    }
    if (element.attribute == "soarbox" && element.value == root_) return Clear();
    elements_.erase(found);
  }
}

void ClientScene::Clear() {
  root_.clear();
  scene_.clear();
  shapes_.clear();
  elements_.clear();
}

void ClientScene::ShowBody(const Shape& shape, world::World& world) const {
  const world::Vec3 forward = Forward(shape.Number("heading", 0));
  if (world::Agent* const agent = FindNamed(world, shape.Text("name"))) {
    agent->SetPosition(shape.At("x", "y", agent->Height() / 2));
    agent->SetForward(forward);
    return;
  }
  const auto radius_m = static_cast<float>(std::max(0.05, shape.Number("size", 0.5) / 2));
  const world::Vec3 at = shape.At("x", "y", radius_m);
  world.debug().Sphere(at, radius_m, shape.Color(), true);
  world.debug().Line(at, at + forward * (radius_m * 2), shape.Color());
}

void ClientScene::ShowText(const Shape& shape, world::World& world) {
  world::Ui& ui = world.ui();
  if (texts_shown_ == texts_.size()) texts_.push_back(ui.CreateInWorld({}));
  const world::UiId text = texts_[texts_shown_++];
  constexpr float kLetter_px = 14, kHeight_px = 34, kPixel_m = 0.005f;
  const std::string said = shape.Text("text");
  const float width_px = kLetter_px * (static_cast<float>(said.size()) + 2);
  world::UiComponent& panel = *ui.Edit(text);
  panel.caption = said;
  panel.view.width = width_px;
  panel.view.height = kHeight_px;
  panel.view.font = world::UiFont::kMedium;
  panel.view.visible = true;
  const world::Vec3 color = shape.Color();
  panel.view.text_color = {color.x, color.y, color.z, 1};
  // The position is that of the panel's left corner, so half of the width is subtracted to centre the text.
  const world::Vec3 place = shape.At("x", "y", kTextHeight_m) - world::Vec3{width_px * kPixel_m / 2, 0, 0};
  if (world::IsFinite(place)) panel.view.world_position = place;
}

void ClientScene::Show(world::World& world) {
  texts_shown_ = 0;
  std::size_t left = kMost;
  for (const auto& [id, shape] : shapes_) {
    if (left-- == 0) break;
    if (shape.kind == "body")
      ShowBody(shape, world);
    else if (shape.kind == "line")
      world.debug().Line(shape.At("x", "y", kLineHeight_m), shape.At("to-x", "to-y", kLineHeight_m), shape.Color());
    else if (shape.kind == "text")
      ShowText(shape, world);
  }
  for (std::size_t i = texts_shown_; i < texts_.size(); ++i) world.ui().Edit(texts_[i])->view.visible = false;
}

}  // namespace soarbox::sim
