// SPDX-License-Identifier: BSD-2-Clause
#include "sim/scene_sense.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/arena.h"
#include "sim/attention.h"
#include "sim/directions.h"
#include "world/weapon.h"

namespace soarbox::sim {
namespace {

using world::Quat;
using world::Vec3;

/// Rounds to millimetres and thousandths of a radian. Smaller changes are ignored.
std::string NumberText(float value) {
  const double rounded = std::round(static_cast<double>(value) * 1000) / 1000 + 0.0;
  std::array<char, 64> text{};
  char* const end = std::to_chars(text.data(), text.data() + text.size(), rounded).ptr;
  return std::string(text.data(), end);
}

std::string CoordinatesText(Vec3 vector) {
  return " " + NumberText(vector.x) + " " + NumberText(vector.y) + " " + NumberText(vector.z);
}

std::string BoxText(Vec3 low, Vec3 high) {
  std::string shape = " v";
  for (int corner = 0; corner < 8; ++corner) {
    shape += CoordinatesText({corner & 4 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 1 ? high.z : low.z});
  }
  return shape;
}

/// The upright body of an agent.
std::string BodyText(float radius_m, float height_m) {
  const Vec3 half{radius_m, height_m / 2, radius_m};
  return BoxText(-half, half);
}

/// A round region, as a prism with 12 sides and the height of a person.
std::string DiscText(float radius_m, float height_m) {
  constexpr int kSides = 12;
  std::string shape = " v";
  for (int side = 0; side < kSides; ++side) {
    const Vec3 rim = AlongHeading(360.0f * static_cast<float>(side) / kSides) * radius_m;
    shape += CoordinatesText(rim) + CoordinatesText({rim.x, height_m, rim.z});
  }
  return shape;
}

std::string PoseText(Vec3 position, Vec3 rotation_rad = {}) {
  return " p" + CoordinatesText(position) + " r" + CoordinatesText(rotation_rad);
}

/// A rotation about the vertical axis.
std::string UprightPoseText(Vec3 position, Vec3 forward) {
  return PoseText(position, {0, std::atan2(forward.x, forward.z), 0});
}

/// The angles of a rotation about x, y and z, in this order.
Vec3 AnglesOf(Quat q) {
  const float sine = std::clamp(2 * (q.w * q.y - q.z * q.x), -1.0f, 1.0f);
  return {std::atan2(2 * (q.w * q.x + q.y * q.z), 1 - 2 * (q.x * q.x + q.y * q.y)), std::asin(sine),
          std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))};
}

std::string_view YesOrNoText(bool truth) {
  return truth ? "yes" : "no";
}

/// Makes a name one word of a line: replaces blanks and control characters by hyphens.
std::string WordOfName(std::string_view name) {
  std::string word(name);
  std::replace_if(
      word.begin(), word.end(), [](unsigned char c) { return c <= ' '; }, '-');
  return word.empty() ? "unnamed" : word;
}

}  // namespace

std::string SceneSense::Update(const Actor& actor, bool surroundings) {
  std::string lines;
  for (auto& [id, node] : shown_) node.wanted = !surroundings && !node.is_own;
  ShowOwn(actor, lines);
  if (surroundings) {
    ShowOthers(actor, lines);
    ShowThings(actor, lines);
    ShowPlaces(actor, lines);
  }
  std::erase_if(shown_, [&](const auto& entry) {
    if (!entry.second.wanted) lines += "delete " + entry.first + "\n";
    return !entry.second.wanted;
  });
  return lines;
}

void SceneSense::Show(std::string_view name, Shown node, std::string& lines) {
  std::string id = WordOfName(name);
  // A second node of the same name gets a number.
  const std::string first = id;
  for (int n = 2; id == "world" || (shown_.contains(id) && shown_[id].wanted); ++n)
    id = first + "-" + std::to_string(n);
  node.wanted = true;
  const auto [at, is_new] = shown_.try_emplace(id);
  Shown& known = at->second;
  if (is_new || known.shape.substr(0, 2) != node.shape.substr(0, 2)) {
    if (!is_new) lines += "delete " + id + "\n";
    lines += "add " + id + " world" + node.shape + node.pose + "\n";
    known.tags.clear();
  } else if (known.shape != node.shape || known.pose != node.pose) {
    lines += "change " + id + (known.shape != node.shape ? node.shape : std::string()) + node.pose + "\n";
  }
  for (const auto& [tag, value] : node.tags) {
    const auto old = known.tags.find(tag);
    if (old == known.tags.end() || old->second != value) {
      lines += "tag change " + id + " " + tag + " " + WordOfName(value) + "\n";
    }
  }
  for (const auto& [tag, value] : known.tags) {
    if (!node.tags.contains(tag)) lines += "tag delete " + id + " " + tag + "\n";
  }
  known = std::move(node);
}

void SceneSense::ShowOwn(const Actor& actor, std::string& lines) {
  const world::Agent& body = actor.body();
  const auto own = [](std::string shape, std::string pose, std::string_view kind) {
    return Shown{std::move(shape), std::move(pose), {{"kind", std::string(kind)}, {"solid", "no"}}, true, true};
  };
  Shown self = own(BodyText(body.Radius(), body.Height()), UprightPoseText(body.Position(), body.Forward()), "self");
  self.tags["team"] = body.Team();
  Show("self", std::move(self), lines);
  const Vec3 eyes = world::EyesOf(body);
  Show("eye", own(" v 0 0 0", UprightPoseText(eyes, body.Forward()), "eye"), lines);
  Show("reach", own(" b " + NumberText(body.Radius() + kArmsReach_m), PoseText(body.Position()), "reach"), lines);
}

void SceneSense::ShowOthers(const Actor& actor, std::string& lines) {
  if (!actor.kind().senses.Has("agents")) return;
  const Attention attention(actor);
  for (const auto& [id, contact] : actor.contacts()) {
    if (!attention.Reaches(id, contact)) continue;
    const world::Agent& other = *actor.world().FindAgent(id);
    Shown node{
        BodyText(other.Radius(), other.Height()), UprightPoseText(contact.position, contact.forward), {}, false, true};
    node.tags = {{"kind", "agent"},
                 {"solid", "yes"},
                 {"team", other.Team()},
                 {"relation", other.Team() == actor.body().Team() ? "friend" : "enemy"},
                 {"alive", std::string(YesOrNoText(contact.alive))},
                 {"visible", std::string(YesOrNoText(contact.visible))}};
    Show(other.name(), std::move(node), lines);
  }
}

void SceneSense::ShowThings(const Actor& actor, std::string& lines) {
  if (!actor.kind().senses.Has("objects")) return;
  for (const auto& [id, thing] : actor.things()) {
    const bool is_ball = thing.kind == "sphere";
    const float radius_m = (thing.high.x - thing.low.x) / 2;
    Shown node{is_ball ? " b " + NumberText(radius_m) : BoxText(thing.low, thing.high),
               PoseText(thing.position, AnglesOf(thing.orientation)),
               {},
               false,
               true};
    node.tags = {{"kind", thing.kind},
                 {"solid", "yes"},
                 {"moves", std::string(YesOrNoText(thing.moves))},
                 {"visible", std::string(YesOrNoText(thing.visible))}};
    Show(thing.name, std::move(node), lines);
  }
}

void SceneSense::ShowPlaces(const Actor& actor, std::string& lines) {
  constexpr float kTall_m = 2;
  const Places& places = actor.arena().places();
  if (actor.kind().senses.Has("waypoints")) {
    for (const Waypoint& waypoint : places.waypoints) {
      Show(waypoint.name,
           {" v 0 0 0", PoseText(waypoint.position), {{"kind", "waypoint"}, {"solid", "no"}}, false, true}, lines);
    }
  }
  if (!actor.kind().senses.Has("regions")) return;
  for (const Region& region : places.regions) {
    const Vec3 half{region.half_x_m, 0, region.half_z_m};
    const std::string shape =
        region.half_x_m > 0 ? BoxText(-half, half + Vec3{0, kTall_m, 0}) : DiscText(region.radius_m, kTall_m);
    Show(region.name, {shape, PoseText(region.center), {{"kind", "region"}, {"solid", "no"}}, false, true}, lines);
  }
}

}  // namespace soarbox::sim
