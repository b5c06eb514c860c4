// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/labels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "diagnostics/plain_text.h"
#include "sim/agent_words.h"
#include "sim/foreign_kind.h"
#include "viewer/draw_colors.h"
#include "viewer/palette.h"
#include "world/rotation.h"

namespace soarbox::viewer {
namespace {

using Kind = ShownLabel::Kind;

constexpr std::size_t kMostNames = 48, kMostSpeech = 10, kMostSpared = 48, kMostPlaces = 24;
/// Maximum fraction of the view that labels may cover. With kMany labels or more, each stays next to its agent.
constexpr float kMostCovered = 0.08f;
constexpr std::size_t kMany = 24;
constexpr int kPlacesOfMany = 5;
constexpr float kFadeFrom_m = 95, kGone_m = 120;
constexpr float kEdge_px = 4, kGap_px = 3;
constexpr double kSpeechShown_s = 3.5, kSpeechFades_s = 0.6;
constexpr ImU32 kPaper = IM_COL32(12, 17, 24, 200), kSpeechPaper = IM_COL32(250, 249, 242, 238);

/// From red through amber to green. The length of the bar has the same meaning, for people who cannot distinguish the
/// colours.
world::Color HealthColor(float share) {
  return share < 0.5f ? world::Color{0.92f, 0.25f + 0.9f * share, 0.08f, 1}
                      : world::Color{0.92f - 1.6f * (share - 0.5f), 0.70f, 0.08f + 0.8f * (share - 0.5f), 1};
}

world::Color SwatchColor(const world::AgentSnapshot& agent) {
  return agent.team.empty() ? AgentColor(agent.kind) : TeamColor(agent.team);
}

/// The first bytes of a text, cut between characters, with a mark if it was cut.
std::string Shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  return std::string(Beginning(text, most - 1)) + "\xe2\x80\xa6";
}

/// The agent's activity in a word or two.
std::string StateOf(const world::AgentSnapshot& agent, const world::AgentOverlay* overlay) {
  if (agent.failed) return sim::kStoppedByError;
  if (!agent.alive) return "dead";
  const std::string mind = overlay != nullptr ? Shortened(overlay->operator_name, 24) : std::string();
  const std::string body = overlay != nullptr && !overlay->doing.empty() ? overlay->doing : agent.last_command;
  if (mind.empty() && body.empty() && agent.kind == sim::kForeignKind) return "foreign";
  if (mind.empty()) return Shortened(body, 30);
  if (body.empty() || body == mind) return mind;
  return mind + " \xc2\xb7 " + Shortened(body, 24);
}

/// Sizes that depend on the fonts.
struct Metrics {
  ImFont *name, *text;
  float em, pad, swatch, bar;

  Metrics(ImFont* name_font, ImFont* text_font)
      : name(name_font),
        text(text_font),
        em(name_font->FontSize),
        pad(em * 0.27f),
        swatch(em * 0.30f),
        bar(std::max(3.0f, em * 0.25f)) {}
};

/// A label to be placed and painted.
struct Item {
  Kind kind = Kind::kName;
  float rank = 0;  ///< Smaller ranks choose first.
  LabelWish wish;
  const world::AgentSnapshot* agent = nullptr;
  const Ghost* ghost = nullptr;
  const world::PlaceSnapshot* spot = nullptr;
  std::string title, text;
  bool stands_out = false;  ///< Selected or hovered.
  float alpha = 1;
  float body_px = 0;                  ///< Of names: height of the agent in the picture.
  std::vector<ScreenPoint> speakers;  ///< Of speech: the heads to which its arrows point.
  LabelPlace place;
};

/// Width of the symbol before the name of a place.
float PlaceSign(const Metrics& metrics) {
  return metrics.em * 0.62f;
}

std::uint64_t KeyOf(const Item& item) {
  return (static_cast<std::uint64_t>(item.kind) << 32) | (item.agent != nullptr ? item.agent->id : 0);
}

/// Collects the labels; leaves out everything outside of the picture.
class Collector {
 public:
  Collector(const LabelScene& scene, const world::CameraSnapshot& camera, const Projection& projection,
            const Metrics& metrics, ImVec2 screen)
      : scene_(scene), camera_(camera), projection_(projection), metrics_(metrics), screen_(screen) {}

  std::vector<Item> items;
  std::vector<ScreenBox> bodies;                                         ///< The nearest agents in the picture.
  std::vector<std::pair<const world::AgentSnapshot*, ScreenPoint>> far;  ///< Too far away for a name.

  void AddNames() {
    for (const auto& agent : scene_.agents) {
      if (agent.id == scene_.hidden) continue;
      const auto at = In(agent.position + world::Vec3{0, agent.height_m / 2 + 0.22f, 0});
      if (!at) continue;
      const bool stands_out = StandsOut(agent.id);
      const float distance = world::Distance(agent.position, camera_.position);
      if (!(distance < GoneAt_m()) && !stands_out) {
        if (agent.alive) far.emplace_back(&agent, *at);
        continue;
      }
      Item& item = items.emplace_back();
      item.agent = &agent;
      item.stands_out = stands_out;
      item.rank = stands_out ? -1 : distance + (agent.alive ? 0.0f : 1000.0f);
      // A hollow lozenge: another simulation moves it.
      item.title = (agent.kind == sim::kForeignKind ? "\xe2\x97\x87 " : "") + LabelName(agent);
      if (agent.has_score) item.title += "  " + ScoreText(agent.score);
      item.text = StateOf(agent, OverlayOf(scene_.overlays, agent.id));
      item.alpha = stands_out ? 1 : AlphaAt(distance);
      if (!agent.alive) item.alpha *= 0.6f;
      item.wish.at = *at;
      item.wish.must_show = stands_out;
      const auto feet = projection_.Project(agent.position - world::Vec3{0, agent.height_m / 2, 0});
      item.body_px = feet ? std::hypot(feet->y - at->y, feet->x - at->x) : 0;
      const ImVec2 n = SizeOf(metrics_.name, item.title.c_str());
      const ImVec2 s = item.text.empty() ? ImVec2{0, 0} : SizeOf(metrics_.text, item.text.c_str());
      const float frame = 3 * metrics_.pad + metrics_.swatch;
      item.wish.width = std::ceil(std::max(n.x, s.x) + frame);
      item.wish.height = std::ceil(n.y + s.y + metrics_.bar + 2 * metrics_.pad);
      if (item.text.empty()) continue;
      item.wish.short_width = std::ceil(n.x + frame);
      item.wish.short_height = std::ceil(n.y + metrics_.bar + 2 * metrics_.pad);
    }
  }

  /// The latest speech of each agent. Agents next to each other who say the same share a bubble.
  void AddSpeech() {
    std::unordered_map<std::uint32_t, const world::SpeechSnapshot*> last;
    for (const world::SpeechSnapshot& speech : scene_.overlays.speech) {
      if (speech.age_s < kSpeechShown_s) last[speech.from_id] = &speech;
    }
    if (last.empty()) return;
    const std::size_t first = items.size();
    for (const auto& agent : scene_.agents) {
      const auto found = last.find(agent.id);
      if (found == last.end() || agent.id == scene_.hidden) continue;
      const auto head = In(agent.position + world::Vec3{0, agent.height_m * 0.42f, 0});
      if (!head) continue;
      const world::SpeechSnapshot& speech = *found->second;
      std::string text = Shortened(speech.text, 140);
      for (const auto& other : scene_.agents) {
        if (other.id == speech.to_id) text = "to " + LabelName(other) + ": " + text;
      }
      const float alpha = static_cast<float>(std::clamp((kSpeechShown_s - speech.age_s) / kSpeechFades_s, 0.0, 1.0));
      const float rank = StandsOut(agent.id) ? -0.5f : world::Distance(agent.position, camera_.position) + 1;
      const auto same =
          std::find_if(items.begin() + static_cast<std::ptrdiff_t>(first), items.end(), [&](const Item& i) {
            return i.text == text && std::abs(i.wish.at.x - head->x) < 6 * metrics_.em &&
                   std::abs(i.wish.at.y - head->y) < 5 * metrics_.em;
          });
      if (same != items.end()) {
        same->speakers.push_back(*head);
        same->alpha = std::max(same->alpha, alpha);
        same->rank = std::min(same->rank, rank);
        continue;
      }
      Item& item = items.emplace_back();
      item.kind = Kind::kSpeech;
      item.agent = &agent;
      item.rank = rank;
      item.text = std::move(text);
      item.alpha = alpha;
      item.speakers = {*head};
      item.wish.at = *head;
      item.wish.habit = LabelHabit::kBeside;
      const ImVec2 size = SizeOf(metrics_.text, item.text.c_str(), SpeechWrap());
      const ImVec2 dots = SizeOf(metrics_.text, "\xe2\x80\xa6");
      const float pad = SpeechPad();
      item.wish.width = std::ceil(size.x + 2 * pad);
      item.wish.height = std::ceil(size.y + 2 * pad);
      item.wish.short_width = std::ceil(dots.x + 2 * pad);
      item.wish.short_height = std::ceil(dots.y + pad);
    }
  }

  void AddGhosts() {
    float rank = 0;
    for (const Ghost& ghost : scene_.ghosts) {
      if (ghost.name.empty()) continue;
      const auto head = In(ghost.position + world::Vec3{0, ghost.height_m / 2 + 0.15f, 0});
      const auto feet = projection_.Project(ghost.position - world::Vec3{0, ghost.height_m / 2, 0});
      if (!head || !feet) continue;
      Item& item = AddAround(Kind::kGhost, *head, feet->y, Shortened(ghost.name, 60), 8, 3);
      item.ghost = &ghost;
      item.rank = rank += 0.01f;
    }
  }

  /// Names of places come last: there are many, and they do not move.
  void AddPlaces() {
    constexpr float kAfterAll = 5000, kThingsLater = 1000;
    for (const world::PlaceSnapshot& spot : scene_.overlays.places) {
      using Of = world::PlaceSnapshot::Kind;
      if (spot.name.empty() || !world::IsFinite(spot.position)) continue;
      const auto at = In(spot.position + world::Vec3{0, 0.25f, 0});
      const float distance = world::Distance(spot.position, camera_.position);
      if (!at || !(distance < GoneAt_m())) continue;
      Item& item = AddAround(Kind::kPlace, *at, at->y + 0.5f * metrics_.em, Shortened(spot.name, 40),
                             2.4f * metrics_.pad + PlaceSign(metrics_), 2);
      item.spot = &spot;
      item.rank = kAfterAll + distance + (spot.kind == Of::kThing ? kThingsLater : 0);
      item.alpha = AlphaAt(distance);
    }
  }

  void AddBodies() {
    std::vector<std::pair<float, ScreenBox>> found;
    for (const auto& agent : scene_.agents) {
      if (!agent.alive || agent.id == scene_.hidden) continue;
      const auto head = projection_.Project(agent.position + world::Vec3{0, agent.height_m / 2, 0});
      const auto feet = projection_.Project(agent.position - world::Vec3{0, agent.height_m / 2, 0});
      if (!head || !feet) continue;
      const float x = (head->x + feet->x) / 2, half = std::max(2.0f, 0.2f * std::abs(feet->y - head->y));
      found.emplace_back(world::Distance(agent.position, camera_.position),
                         ScreenBox{x - half, std::min(head->y, feet->y), x + half, std::max(head->y, feet->y)});
    }
    const std::size_t most = std::min(kMostSpared, found.size());
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(most), found.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < most; ++i) bodies.push_back(found[i].second);
  }

  float SpeechWrap() const { return 15 * metrics_.em; }
  float SpeechPad() const { return metrics_.em * 0.45f; }

 private:
  std::optional<ScreenPoint> In(world::Vec3 point) const {
    const auto at = projection_.Project(point);
    if (!at || at->x < 0 || at->x > screen_.x || at->y < 0 || at->y > screen_.y) return std::nullopt;
    return at;
  }
  /// The distance at which labels end. From high above, as on a map, the distance means little.
  float GoneAt_m() const { return std::max(kGone_m, 2.2f * camera_.position.y); }
  float AlphaAt(float distance_m) const {
    constexpr float kFadingShare = 1 - kFadeFrom_m / kGone_m;
    return std::clamp((GoneAt_m() - distance_m) / (GoneAt_m() * kFadingShare), 0.25f, 1.0f);
  }
  /// Adds a label that is this much larger than its text.
  Item& AddAround(Kind kind, ScreenPoint at, float below_y, std::string text, float wider, float higher) {
    Item& item = items.emplace_back();
    item.kind = kind;
    item.text = std::move(text);
    const ImVec2 size = SizeOf(metrics_.text, item.text.c_str());
    item.wish = {.at = at,
                 .habit = LabelHabit::kAround,
                 .below_y = below_y,
                 .width = std::ceil(size.x + wider),
                 .height = std::ceil(size.y + higher)};
    return item;
  }
  bool StandsOut(std::uint32_t id) const {
    return id == scene_.hovered ||
           std::find(scene_.selection.begin(), scene_.selection.end(), id) != scene_.selection.end();
  }

  const LabelScene& scene_;
  const world::CameraSnapshot& camera_;
  const Projection& projection_;
  const Metrics& metrics_;
  ImVec2 screen_;
};

/// Paints the labels that have a place: first all threads and arrows, then the labels over them.
class Painter {
 public:
  explicit Painter(const Metrics& metrics) : out_(*ImGui::GetBackgroundDrawList()), metrics_(metrics) {}

  void Thread(const Item& item) {
    const ScreenBox& box = item.place.box;
    if (item.kind == Kind::kSpeech) {
      for (const ScreenPoint head : item.speakers) Arrow(box, {head.x, head.y}, Faded(kSpeechPaper, item.alpha));
      return;
    }
    if (item.kind != Kind::kName) return;
    // A thread connects a label that is far from its agent.
    const ImVec2 at{item.wish.at.x, item.wish.at.y};
    const ImVec2 near{std::clamp(at.x, box.left + 3, box.right - 3), std::clamp(at.y, box.top + 3, box.bottom)};
    if (std::abs(near.x - at.x) + std::abs(near.y - at.y) > 5)
      out_.AddLine(near, at, Faded(IM_COL32(255, 255, 255, 170), item.alpha), 1.2f);
  }

  void Label(const Item& item) {
    switch (item.kind) {
      case Kind::kName:
        return Name(item);
      case Kind::kDot:
        return Dot(item);
      case Kind::kSpeech:
        return Speech(item);
      case Kind::kGhost:
        return GhostName(item);
      case Kind::kPlace:
        return PlaceName(item);
    }
  }

 private:
  static ImVec2 Low(const ScreenBox& box) { return {box.left, box.top}; }
  static ImVec2 High(const ScreenBox& box) { return {box.right, box.bottom}; }

  void Arrow(const ScreenBox& box, ImVec2 to, ImU32 ink) {
    // Starts at the point of the bubble's edge that is nearest.
    const float x = std::clamp(to.x, box.left + 8, std::max(box.left + 8, box.right - 8));
    const float y = std::clamp(to.y, box.top + 6, std::max(box.top + 6, box.bottom - 6));
    const ImVec2 from{x, y};
    const float dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
    if (length < 1) return;
    const float half = 5, nx = -dy / length * half, ny = dx / length * half;
    // It ends next to the head.
    const float stop = std::max(0.0f, 1 - 7 / length);
    out_.AddTriangleFilled({from.x + nx, from.y + ny}, {from.x - nx, from.y - ny},
                           {from.x + dx * stop, from.y + dy * stop}, ink);
  }

  void Name(const Item& item) {
    const world::AgentSnapshot& agent = *item.agent;
    const ScreenBox& box = item.place.box;
    const float alpha = item.alpha;
    out_.AddRectFilled(Low(box), High(box), Faded(kPaper, alpha), 4);
    out_.AddRectFilled(Low(box), {box.left + metrics_.swatch, box.bottom}, Packed(SwatchColor(agent), alpha), 4,
                       ImDrawFlags_RoundCornersLeft);
    if (item.stands_out) out_.AddRect(Low(box), High(box), Faded(IM_COL32(255, 219, 90, 255), alpha), 4, 0, 1.6f);
    const float left = box.left + metrics_.swatch + metrics_.pad;
    float y = box.top + metrics_.pad * 0.6f;
    const ImU32 ink = agent.failed ? IM_COL32(255, 150, 132, 255) : IM_COL32(255, 255, 255, 255);
    out_.AddText(metrics_.name, metrics_.name->FontSize, {left, y}, Faded(ink, alpha), item.title.c_str());
    y += metrics_.name->FontSize;
    if (!item.place.is_short && !item.text.empty()) {
      const ImU32 quiet = agent.failed ? ink : IM_COL32(188, 204, 220, 255);
      out_.AddText(metrics_.text, metrics_.text->FontSize, {left, y}, Faded(quiet, alpha), item.text.c_str());
    }
    if (!agent.alive) return;
    const float share = std::clamp(agent.health / 100.0f, 0.0f, 1.0f);
    const float top = box.bottom - metrics_.pad * 0.7f - metrics_.bar, right = box.right - metrics_.pad;
    out_.AddRectFilled({left, top}, {right, top + metrics_.bar}, Faded(IM_COL32(60, 70, 82, 255), alpha), 1);
    out_.AddRectFilled({left, top}, {left + (right - left) * share, top + metrics_.bar},
                       Packed(HealthColor(share), alpha), 1);
  }

  void Dot(const Item& item) {
    const ScreenBox& box = item.place.box;
    const ImVec2 middle{(box.left + box.right) / 2, (box.top + box.bottom) / 2};
    out_.AddCircleFilled(middle, box.width() / 2, Faded(kPaper, item.alpha), 12);
    out_.AddCircleFilled(middle, box.width() / 2 - 1.5f, Packed(SwatchColor(*item.agent), item.alpha), 12);
  }

  void Speech(const Item& item) {
    const ScreenBox& box = item.place.box;
    const float pad = metrics_.em * 0.45f;
    out_.AddRectFilled(Low(box), High(box), Faded(kSpeechPaper, item.alpha), 7);
    const ImU32 ink = Faded(IM_COL32(24, 30, 38, 255), item.alpha);
    const float size = metrics_.text->FontSize;
    if (item.place.is_short)
      out_.AddText(metrics_.text, size, {box.left + pad, box.top + pad * 0.3f}, ink, "\xe2\x80\xa6");
    else
      out_.AddText(metrics_.text, size, {box.left + pad, box.top + pad}, ink, item.text.c_str(), nullptr,
                   15 * metrics_.em);
  }

  void GhostName(const Item& item) {
    const ScreenBox& box = item.place.box;
    out_.AddRectFilled(Low(box), High(box), IM_COL32(12, 17, 24, 170), 3);
    world::Color ink = item.ghost->color;
    for (float* channel : {&ink.r, &ink.g, &ink.b}) *channel = 0.55f + 0.45f * *channel;
    ink.a = std::clamp(0.6f + item.ghost->opacity, 0.0f, 1.0f);
    out_.AddText(metrics_.text, metrics_.text->FontSize, {box.left + 4, box.top + 1}, Packed(ink), item.text.c_str());
  }

  /// The symbol shows the kind: a ring for a waypoint, a square for a region or a thing, a lozenge for an item.
  void PlaceName(const Item& item) {
    using Of = world::PlaceSnapshot::Kind;
    const ScreenBox& box = item.place.box;
    const bool is_item = item.spot->kind == Of::kItem;
    out_.AddRectFilled(Low(box), High(box), Faded(IM_COL32(12, 17, 24, 150), item.alpha), 3);
    const ImU32 ink = Faded(is_item ? IM_COL32(255, 222, 128, 255) : IM_COL32(222, 232, 240, 255), item.alpha);
    const float sign = PlaceSign(metrics_), half = sign * 0.36f;
    const ImVec2 middle{box.left + metrics_.pad + sign / 2, (box.top + box.bottom) / 2};
    switch (item.spot->kind) {
      case Of::kWaypoint:
        out_.AddCircle(middle, half, ink, 14, 1.4f);
        break;
      case Of::kRegion:
        out_.AddRect({middle.x - half, middle.y - half}, {middle.x + half, middle.y + half}, ink, 0, 0, 1.4f);
        break;
      case Of::kThing:
        out_.AddRectFilled({middle.x - half, middle.y - half}, {middle.x + half, middle.y + half}, ink);
        break;
      case Of::kItem:
        out_.AddQuadFilled({middle.x, middle.y - half * 1.3f}, {middle.x + half * 1.3f, middle.y},
                           {middle.x, middle.y + half * 1.3f}, {middle.x - half * 1.3f, middle.y}, ink);
        break;
    }
    out_.AddText(metrics_.text, metrics_.text->FontSize, {box.left + metrics_.pad + sign + 2, box.top + 1}, ink,
                 item.text.c_str());
  }

  ImDrawList& out_;
  const Metrics& metrics_;
};

}  // namespace

std::string ScoreText(float score) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", static_cast<double>(score));
  return text;
}

std::string LabelName(const world::AgentSnapshot& agent) {
  return agent.name.empty() ? "agent " + std::to_string(agent.id) : Shortened(agent.name, 40);
}

const world::AgentOverlay* OverlayOf(const world::OverlaySnapshot& overlays, std::uint32_t agent_id) {
  const auto at = std::lower_bound(overlays.agents.begin(), overlays.agents.end(), agent_id,
                                   [](const world::AgentOverlay& a, std::uint32_t id) { return a.id < id; });
  return at != overlays.agents.end() && at->id == agent_id ? &*at : nullptr;
}

std::uint32_t AgentLabels::AgentAt(ScreenPoint pixel) const {
  const auto is_there = [&](const ShownLabel& label) {
    return pixel.x >= label.box.left && pixel.x <= label.box.right && pixel.y >= label.box.top &&
           pixel.y <= label.box.bottom;
  };
  const auto label = std::find_if(shown_.begin(), shown_.end(), is_there);
  return label == shown_.end() ? 0 : label->agent_id;
}

void AgentLabels::Draw(ImFont* name_font, ImFont* text_font, const LabelScene& scene,
                       const world::CameraSnapshot& camera, const Projection& projection) {
  shown_.clear();
  const Metrics metrics(name_font, text_font);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  Collector found(scene, camera, projection, metrics, screen);
  if (scene.names) found.AddNames();
  if (scene.names) found.AddPlaces();
  if (scene.speech) found.AddSpeech();
  found.AddGhosts();
  if (found.items.empty() && found.far.empty()) return;
  found.AddBodies();
  for (Item& item : found.items) {
    const auto before = places_.find(KeyOf(item));
    if (before == places_.end() || item.agent == nullptr) continue;
    item.wish.usual_place = before->second;
    if (item.rank > 0) item.rank *= 0.9f;  // A label keeps its place unless another agent is clearly nearer.
  }
  // Equal ranks keep the agents' order.
  std::stable_sort(found.items.begin(), found.items.end(),
                   [](const Item& a, const Item& b) { return a.rank < b.rank; });

  LabelLayout layout({kEdge_px, kEdge_px, screen.x - kEdge_px, screen.y - kEdge_px}, kGap_px);
  for (const ScreenBox& box : scene.blocked) layout.Block(box);
  for (const ScreenBox& box : found.bodies) layout.Spare(box);
  std::vector<Item> shown;
  std::size_t names = 0, bubbles = 0, spots = 0;
  const bool are_many = scene.agents.size() > kMany;
  float left = kMostCovered * screen.x * screen.y;
  const auto place = [&](Item& item) {
    const auto at = layout.Place(item.wish);
    if (!at) return false;
    item.place = *at;
    shown.push_back(std::move(item));
    return true;
  };
  for (Item& item : found.items) {
    const world::AgentSnapshot* agent = item.agent;
    const ScreenPoint at = item.wish.at;
    if (item.kind == Kind::kSpeech) {
      if (bubbles < kMostSpeech && place(item)) ++bubbles;
    } else if (item.kind == Kind::kName) {
      if (are_many && !item.stands_out) item.wish.places = kPlacesOfMany;
      // In a crowd, only agents above this size have names.
      const bool is_small = are_many && item.body_px < 2.2f * metrics.em;
      const bool may_show = item.stands_out || (names < kMostNames && left > 0 && !is_small) || !are_many;
      if (may_show && place(item)) {
        ++names;
        left -= shown.back().place.box.width() * shown.back().place.box.height();
      } else if (agent->alive) {
        found.far.emplace_back(agent, at);
      }
    } else if (item.kind == Kind::kPlace) {
      // They are placed below, after the dots of agents.
    } else {
      place(item);
    }
  }
  for (const auto& [agent, at] : found.far) {
    Item item;
    item.kind = Kind::kDot;
    item.agent = agent;
    item.wish.at = at;
    item.wish.width = item.wish.height = std::round(metrics.em * (are_many ? 0.45f : 0.7f));
    place(item);
  }
  for (Item& item : found.items)
    if (item.kind == Kind::kPlace && spots < kMostPlaces && place(item)) ++spots;

  places_.clear();
  Painter painter(metrics);
  for (auto item = shown.rbegin(); item != shown.rend(); ++item) painter.Thread(*item);
  for (auto item = shown.rbegin(); item != shown.rend(); ++item) {
    painter.Label(*item);
    if (item->place.place >= 0 && item->agent != nullptr) places_[KeyOf(*item)] = item->place.place;
    const bool is_one = item->agent != nullptr && item->speakers.size() < 2;
    shown_.push_back({item->kind, is_one ? item->agent->id : 0, item->place.box, item->place.is_short});
  }
}

}  // namespace soarbox::viewer
