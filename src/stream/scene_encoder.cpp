// SPDX-License-Identifier: BSD-2-Clause
#include "stream/scene_encoder.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "bytes/byte_stream.h"
#include "stream/deflate.h"
#include "stream/quantise.h"
#include "stream/scene_layout.h"
#include "world/animation/rig.h"
#include "world/body_meshes.h"

namespace soarbox::stream {
namespace {

using world::Vec3;

constexpr std::uint8_t kMark = 0x53, kVersion = 1, kFull = 1, kDeflated = 2;
constexpr double kSlack_s = 1e-4;
constexpr std::size_t kManyBodies = 4;
constexpr double kBones_s = 1.0 / 15, kBonesOfMany_s = 1.0 / 10;
constexpr std::size_t kMostBones = 256;

enum Tag : std::uint8_t {
  kEnd,
  kSurroundings,
  kCamera,
  kThings,
  kPeople,
  kComponents,
  kLines,
  kParticles,
  kMinds,
  kShotsAndSpeech,
  kPlaces,
  kPushes,
  kOverlayLines,
  kSounds,
};

enum Part : std::uint8_t { kDescription = 1, kPlace = 2, kTurn = 4, kBones = 8, kState = 16, kMovements = 16 };

/// Differences between the continued movements of a reader and the actual ones that are not corrected.
constexpr float kTimeSlack_s = 0.004f, kWeightSlack = 0.01f;

float Finite(float value) {
  return std::isfinite(value) ? value : 0;
}

/// Writes ascending ids of a list as differences.
class Ids {
 public:
  explicit Ids(ByteWriter& out) : out_(out) {}
  void Write(std::uint32_t id) {
    out_.Number(id - last_);
    last_ = id;
  }

 private:
  ByteWriter& out_;
  std::uint32_t last_ = 0;
};

}  // namespace

/// The bytes of a section, with functions that write the values of the scene.
class SceneEncoder::Out : public ByteWriter {
 public:
  explicit Out(std::string& bytes) : ByteWriter(bytes) {}
  void Signed(std::int64_t value) {
    Number((static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
  }
  void Difference(const Triple& now, const Triple& before) {
    for (std::size_t i = 0; i < 3; ++i) Signed(static_cast<std::int64_t>(now[i]) - before[i]);
  }
  void Whole(Vec3 place, double per_unit = kPerMetre) { Difference(Steps(place, per_unit), {}); }
  void Floats(Vec3 v) { ManyFloats(Finite(v.x), Finite(v.y), Finite(v.z)); }
  void Number01(float value) {
    Byte(static_cast<std::uint8_t>(std::lround(std::fmin(std::fmax(Finite(value), 0.0f), 1.0f) * 255)));
  }
  void Color(world::Color c) {
    for (const float part : {c.r, c.g, c.b, c.a}) Number01(part);
  }
};

/// Writes the values of a record (scene_layout.h).
class SceneEncoder::RecordWriter {
 public:
  /// `last`: the point before, for records with points.
  RecordWriter(SceneEncoder& encoder, Out& out, Triple* last = nullptr) : encoder_(encoder), out_(out), last_(last) {}

  template <typename Record>
  void Write(const Record& record) {
    Layout(*this, record);
  }

  void Type(std::string_view, std::string_view) {}
  void Number(std::string_view, std::uint64_t value) { out_.Number(value); }
  void Steps(std::string_view, float value, double per_unit) { out_.Signed(stream::Steps(value, per_unit)); }
  void Share(std::string_view, double share, double per_unit) {
    out_.Byte(static_cast<std::uint8_t>(std::lround(per_unit * std::fmin(std::fmax(share, 0.0), 1.0))));
  }
  void Float(std::string_view, float value) { out_.Float(Finite(value)); }
  void Floats(std::string_view, const Vec3& value) { out_.Floats(value); }
  void Flag(std::string_view, bool value) { out_.Byte(value ? 1 : 0); }
  void IsZero(std::string_view, std::uint8_t value) { out_.Byte(value); }
  void Flags(FlagList flags) {
    unsigned bits = 0, bit = 1;
    for (const stream::Flag& flag : flags) {
      if (flag.second) bits |= bit;
      bit *= 2;
    }
    out_.Byte(static_cast<std::uint8_t>(bits));
  }
  void Words(std::string_view, std::uint8_t value, std::span<const std::string_view>) { out_.Byte(value); }
  void Color(std::string_view, const world::Color& value) { out_.Color(value); }
  void Word(std::string_view, std::string_view value) { out_.Number(encoder_.TextIndex(value)); }
  void Turn(std::string_view, const world::Quat& value) { out_.Whole(TurnVector(value), kPerRadian); }
  void Place(std::string_view, const Vec3& value, double per_unit) { out_.Whole(value, per_unit); }
  void PlaceIf(bool is_there, std::string_view, const Vec3& value) {
    out_.Byte(is_there ? 1 : 0);
    if (is_there) out_.Whole(value);
  }
  void Point(std::string_view, const Vec3& value) {
    const Triple now = stream::Steps(value, kPerMetre);
    out_.Difference(now, *last_);
    *last_ = now;
  }
  /// The moment, because the age would change in each block.
  void Moment(std::string_view, double age_s) { out_.Signed(std::lround((encoder_.time_s_ - age_s) * 100)); }

 private:
  SceneEncoder& encoder_;
  Out& out_;
  Triple* last_;
};

/// Writes the number of the records, and the records.
template <typename Records>
void SceneEncoder::WriteRecords(Out& out, const Records& records) {
  out.Number(records.size());
  RecordWriter writer(*this, out);
  for (const auto& record : records) writer.Write(record);
}

/// Writes the ids of objects that no longer exist, and removes them from `known`. Then appends the changes. Empty if
/// there are neither.
template <typename Known>
std::string SceneEncoder::GoneAndChanged(std::map<std::uint32_t, Known>& known, const std::string& changed) {
  std::vector<std::uint32_t> gone;
  for (const auto& entry : known)
    if (entry.second.seen != blocks_) gone.push_back(entry.first);
  if (gone.empty() && changed.empty()) return {};
  std::string bytes;
  Out out(bytes);
  out.Number(gone.size());
  Ids ids(out);
  for (const std::uint32_t id : gone) {
    ids.Write(id);
    known.erase(id);
  }
  return bytes + changed;
}

void SceneEncoder::Begin() {
  texts_.clear();
  sections_.clear();
  things_.clear();
  people_.clear();
  minds_.clear();
}

/// Each text is written once between two full blocks; number 0 is the empty text.
std::uint64_t SceneEncoder::TextIndex(std::string_view text) {
  if (text.empty()) return 0;
  if (const auto known = texts_.find(text); known != texts_.end()) return known->second;
  new_texts_.emplace_back(text);
  return texts_.emplace(std::string(text), texts_.size() + 1).first->second;
}

void SceneEncoder::WriteSection(std::string& payload, std::uint8_t tag, const std::string& bytes) {
  ByteWriter out(payload);
  out.Byte(tag);
  out.Text(bytes);
}

void SceneEncoder::WriteIfChanged(std::string& payload, std::uint8_t tag, const std::string& bytes) {
  std::string& before = sections_.try_emplace(tag).first->second;
  if (before == bytes) return;
  before = bytes;
  WriteSection(payload, tag, bytes);
}

std::string SceneEncoder::Surroundings(const world::SceneSnapshot& scene) {
  std::string bytes;
  Out out(bytes);
  out.Floats(scene.ambient);
  out.Number(TextIndex(scene.sky));
  out.Floats(scene.sky_rotation_deg);
  for (const world::Color& color : scene.markup_palette) out.Color(color);
  WriteRecords(out, scene.lights);
  return bytes;
}

std::string SceneEncoder::Camera(const world::SceneSnapshot& scene) {
  std::string bytes;
  Out out(bytes);
  RecordWriter(*this, out).Write(MovedCamera{scene.camera_moves, scene.camera});
  return bytes;
}

/// Compares the movements of a model with those that a reader continues. If they differ, stores the new ones with the
/// rates of the last block, and returns true. `pose`: null for things without movements.
bool SceneEncoder::UpdateMovements(Thing& thing, std::uint32_t id, const world::Pose* pose, double time_s) {
  if (pose == nullptr) return std::exchange(thing.movements, {}).list.size() > 0;
  Movements now{time_s, {}};
  for (const world::Pose::Part& part : pose->parts)
    if (part.clip < pose->rig->clips.size()) now.list.push_back({part.clip, part.time_s, part.weight, 0, 0});
  const Movements last = std::exchange(last_movements_[id], now);
  const auto since_s = static_cast<float>(time_s - thing.movements.at_s);
  const bool is_continued =
      std::ranges::equal(thing.movements.list, now.list, [&](const Movement& a, const Movement& b) {
        return a.clip == b.clip && std::abs(a.time_s + a.speed * since_s - b.time_s) < kTimeSlack_s &&
               std::abs(a.weight + a.weight_per_s * since_s - b.weight) < kWeightSlack;
      });
  if (is_continued) return false;
  const auto step_s = static_cast<float>(time_s - last.at_s);
  for (Movement& movement : now.list) {
    const auto before = std::ranges::find(last.list, movement.clip, &Movement::clip);
    if (before == last.list.end() || step_s <= 0) continue;
    // At its end, a looping animation continues at its start.
    const float length_s = pose->rig->clips[movement.clip].length_s();
    float moved_s = movement.time_s - before->time_s;
    if (std::abs(moved_s) > length_s / 2) moved_s -= std::copysign(length_s, moved_s);
    movement.speed = moved_s / step_s;
    movement.weight_per_s = (movement.weight - before->weight) / step_s;
  }
  thing.movements = std::move(now);
  return true;
}

/// Removes the movements of things that are not in the present block.
void SceneEncoder::ForgetMovements(double time_s) {
  std::erase_if(last_movements_, [time_s](const auto& entry) { return entry.second.at_s != time_s; });
}

std::string SceneEncoder::Things(const world::SceneSnapshot& scene, bool with_bones) {
  std::string changed;
  Out out(changed);
  Ids ids(out);
  for (const world::DrawableSnapshot& drawn : scene.drawables) {
    const auto [at, is_new] = things_.try_emplace(drawn.id);
    Thing& thing = at->second;
    thing.seen = blocks_;

    std::string description;
    Out told(description);
    told.Number(drawn.owner_id);
    told.Byte(static_cast<std::uint8_t>((drawn.belongs_to_agent ? 1 : 0) | (drawn.visible ? 2 : 0) |
                                        (drawn.shows_skeleton ? 4 : 0)));
    told.Byte(static_cast<std::uint8_t>(drawn.shape));
    told.Number(TextIndex(drawn.mesh.value()));
    told.Number(TextIndex(drawn.material.value()));
    told.Floats(drawn.size);
    told.Floats(drawn.texture_repeats);
    told.Floats(drawn.scale);

    const Triple place = Steps(drawn.position, kPerMetre);
    const Triple turn = Steps(TurnVector(drawn.orientation), kPerRadian);
    std::vector<Bone> bones;
    const world::Pose* const blended = drawn.bones.pose();
    const bool is_model = blended != nullptr && !blended->rig->model.empty();
    const bool has_new_movements = UpdateMovements(thing, drawn.id, is_model ? blended : nullptr, scene.time_s);
    if (!drawn.bones.empty() && !is_model && (with_bones || is_new)) {
      // Relative to their parents, bones change least.
      const world::BodyMesh* mesh = world::FindBodyMesh(drawn.mesh.value());
      const std::vector<world::BonePose>& poses = drawn.bones.value();
      bones.resize(std::min(poses.size(), kMostBones));
      for (std::size_t i = 0; i < bones.size(); ++i) {
        world::BonePose pose = poses[i];
        if (mesh != nullptr && i < mesh->rig().skeleton.bones().size()) {
          const int parent = mesh->rig().skeleton.bones()[i].parent;
          if (parent >= 0) pose = world::Inverse(poses[static_cast<std::size_t>(parent)]) * pose;
        }
        const Bone before = i < thing.bones.size() ? thing.bones[i] : Bone{};
        bones[i] = {SteadySteps(TurnVector(pose.orientation), kBonePerRadian, before.turn),
                    SteadySteps(pose.position, kBonePerMetre, before.place)};
      }
    } else {
      bones = thing.bones;
    }

    std::uint8_t parts = 0;
    if (is_new || description != thing.description) parts |= kDescription;
    if (place != thing.place) parts |= kPlace;
    if (turn != thing.turn) parts |= kTurn;
    if (bones != thing.bones) parts |= kBones;
    if (has_new_movements) parts |= kMovements;
    if (parts == 0) continue;
    ids.Write(drawn.id);
    out.Byte(parts);
    if ((parts & kDescription) != 0) out.Text(description);
    if ((parts & kPlace) != 0) out.Difference(place, thing.place);
    if ((parts & kTurn) != 0) out.Difference(turn, thing.turn);
    if ((parts & kBones) != 0) {
      thing.bones.resize(bones.size());
      out.Number(bones.size());
      for (std::size_t i = 0; i < bones.size(); ++i) {
        const bool turned = bones[i].turn != thing.bones[i].turn, moved = bones[i].place != thing.bones[i].place;
        if (turned || moved) {
          out.Byte(static_cast<std::uint8_t>((turned ? 1 : 0) | (moved ? 2 : 0)));
          if (turned) out.Difference(bones[i].turn, thing.bones[i].turn);
          if (moved) out.Difference(bones[i].place, thing.bones[i].place);
        } else {
          out.Byte(0);
        }
      }
    }
    if (has_new_movements) {
      out.Number(thing.movements.list.size());
      for (const Movement& movement : thing.movements.list) {
        out.Number(movement.clip);
        out.ManyFloats(movement.time_s, movement.weight, movement.speed, movement.weight_per_s);
      }
    }
    thing.description = std::move(description);
    thing.place = place;
    thing.turn = turn;
    thing.bones = std::move(bones);
  }
  ForgetMovements(scene.time_s);
  return GoneAndChanged(things_, changed);
}

std::string SceneEncoder::People(const world::SceneSnapshot& scene) {
  std::vector<const world::AgentSnapshot*> agents;
  for (const world::AgentSnapshot& agent : scene.agents) agents.push_back(&agent);
  std::sort(agents.begin(), agents.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
  std::string changed;
  Out out(changed);
  Ids ids(out);
  for (const world::AgentSnapshot* agent : agents) {
    const auto [at, is_new] = people_.try_emplace(agent->id);
    Person& person = at->second;
    person.seen = blocks_;
    std::string description, state;
    Out told(description), stated(state);
    RecordWriter(*this, told).Write(AgentLooks{*agent});
    RecordWriter(*this, stated).Write(AgentState{*agent});
    const Triple place = Steps(agent->position, kPerMetre), forward = Steps(agent->forward, kPerDirection);
    std::uint8_t parts = 0;
    if (is_new || description != person.description) parts |= kDescription;
    if (place != person.place) parts |= kPlace;
    if (forward != person.forward) parts |= kTurn;
    if (is_new || state != person.state) parts |= kState;
    if (parts == 0) continue;
    ids.Write(agent->id);
    out.Byte(parts);
    if ((parts & kDescription) != 0) out.Text(description);
    if ((parts & kPlace) != 0) out.Difference(place, person.place);
    if ((parts & kTurn) != 0) out.Difference(forward, person.forward);
    if ((parts & kState) != 0) out.Text(state);
    person.description = std::move(description);
    person.state = std::move(state);
    person.place = place;
    person.forward = forward;
  }
  return GoneAndChanged(people_, changed);
}

std::string SceneEncoder::Components(const world::SceneSnapshot& scene) {
  std::string bytes;
  Out out(bytes);
  out.Number(scene.ui.size());
  for (const world::UiSnapshot& c : scene.ui) {
    out.Number(c.id);
    out.Number(c.parent_id);
    out.Signed(c.layer);
    for (const float value : {c.x, c.y, c.width, c.height, c.margin_left, c.margin_top}) out.Float(Finite(value));
    out.Byte(static_cast<std::uint8_t>((c.visible ? 1 : 0) | (c.has_gradient ? 2 : 0) |
                                       (c.gradient_is_vertical ? 4 : 0) | (c.gradient_is_diagonal ? 8 : 0) |
                                       (c.is_markup ? 16 : 0) | (c.in_world ? 32 : 0) | (c.button.empty() ? 0 : 64) |
                                       (c.has_bar ? 128 : 0)));
    out.Color(c.gradient_from);
    out.Color(c.gradient_to);
    out.Color(c.text_color);
    out.Byte(static_cast<std::uint8_t>(c.font));
    out.Number(TextIndex(c.text));
    out.Number(TextIndex(c.material));
    out.Number(TextIndex(c.caption));
    if (!c.button.empty()) out.Number(TextIndex(c.button));
    if (c.has_bar) {
      out.Float(Finite(c.bar));
      out.Color(c.bar_color);
    }
    if (!c.in_world) continue;
    out.Whole(c.world_position);
    out.Whole(TurnVector(c.world_orientation), kPerRadian);
  }
  return bytes;
}

std::string SceneEncoder::Particles(const world::SceneSnapshot& scene) {
  std::string bytes;
  Out out(bytes);
  WriteRecords(out, scene.particles);
  return bytes;
}

std::string SceneEncoder::Sounds(const world::SceneSnapshot& scene) {
  std::string bytes;
  Out out(bytes);
  WriteRecords(out, scene.sounds);
  return bytes;
}

/// Writes each point as the difference from the previous point.
std::string SceneEncoder::Lines(const std::vector<world::LineSnapshot>& lines,
                                const std::vector<world::CircleSnapshot>& circles,
                                const std::vector<world::TriangleSnapshot>& triangles) {
  std::string bytes;
  Out out(bytes);
  Triple last{};
  RecordWriter writer(*this, out, &last);
  const auto write = [&](const auto& records) {
    const std::size_t count = std::min(records.size(), settings_.most_lines);
    out.Number(count);
    for (std::size_t i = 0; i < count; ++i) writer.Write(records[i]);
  };
  write(lines);
  write(circles);
  write(triangles);
  return bytes;
}

Block SceneEncoder::Encode(const world::SceneSnapshot& scene, const world::OverlaySnapshot* overlay, bool want_full) {
  Block block;
  block.is_full = want_full || !has_block_ || scene.time_s < time_s_ ||
                  scene.time_s - full_at_s_ >= settings_.full_every_s - kSlack_s;
  ++blocks_;
  has_block_ = true;
  time_s_ = scene.time_s;
  if (block.is_full) {
    Begin();
    full_at_s_ = scene.time_s;
  }
  std::size_t bodies = 0;
  for (const world::DrawableSnapshot& drawn : scene.drawables) bodies += drawn.bones.empty() ? 0 : 1;
  const bool with_bones =
      block.is_full || scene.time_s - bones_at_s_ >= (bodies > kManyBodies ? kBonesOfMany_s : kBones_s) - kSlack_s;
  if (with_bones) bones_at_s_ = scene.time_s;

  std::string sections;
  WriteIfChanged(sections, kSurroundings, Surroundings(scene));
  WriteIfChanged(sections, kCamera, Camera(scene));
  if (const std::string bytes = Things(scene, with_bones); !bytes.empty()) WriteSection(sections, kThings, bytes);
  if (const std::string bytes = People(scene); !bytes.empty()) WriteSection(sections, kPeople, bytes);
  WriteIfChanged(sections, kComponents, Components(scene));
  WriteIfChanged(sections, kLines, Lines(scene.lines, scene.circles, scene.triangles));
  WriteIfChanged(sections, kParticles, Particles(scene));
  // In most worlds there are no sounds.
  if (!scene.sounds.empty() || sections_.contains(kSounds)) WriteIfChanged(sections, kSounds, Sounds(scene));
  if (overlay != nullptr) {
    if (const std::string bytes = Minds(*overlay); !bytes.empty()) WriteSection(sections, kMinds, bytes);
    WriteIfChanged(sections, kShotsAndSpeech, ShotsAndSpeech(*overlay));
    WriteIfChanged(sections, kPlaces, Places(*overlay));
    WriteIfChanged(sections, kPushes, Pushes(*overlay));
    WriteIfChanged(sections, kOverlayLines, Lines(overlay->lines, {}, overlay->triangles));
  }

  std::string payload;
  ByteWriter out(payload);
  out.Number(scene.tick);
  out.Double(scene.time_s);
  out.Number(new_texts_.size());
  for (const std::string& text : new_texts_) out.Text(text);
  new_texts_.clear();
  payload += sections;
  out.Byte(kEnd);

  std::uint8_t flags = block.is_full ? kFull : 0;
  if (payload.size() > settings_.deflate_above) {
    if (std::string small = Deflate(payload); !small.empty() && small.size() < payload.size()) {
      payload = std::move(small);
      flags |= kDeflated;
    }
  }
  ByteWriter head(block.bytes);
  for (const std::uint8_t byte : {kMark, kVersion, flags}) head.Byte(byte);
  block.bytes += payload;
  return block;
}

std::string SceneEncoder::OneMind(const world::AgentOverlay& agent) {
  std::string bytes;
  Out out(bytes);
  out.Number(TextIndex(agent.operator_name));
  out.Number(TextIndex(agent.doing));
  out.Byte(static_cast<std::uint8_t>((agent.has_senses ? 1 : 0) | (agent.measured ? 2 : 0) | (agent.goal ? 4 : 0) |
                                     (agent.path_is_whole ? 8 : 0)));
  if (agent.has_senses) {
    out.Signed(Steps(agent.sight_m, kPerSign));
    out.Signed(Steps(agent.view_deg, 1));
    out.Signed(Steps(agent.hearing_m, kPerSign));
  }
  if (agent.measured) out.Whole(*agent.measured, kPerSign);
  if (agent.goal) out.Whole(*agent.goal, kPerSign);
  out.Number(agent.target_id);
  out.Number(agent.leader_id);
  out.Number(agent.path.size());
  Triple last{};
  for (const Vec3 corner : agent.path) {
    const Triple now = Steps(corner, kPerSign);
    out.Difference(now, last);
    last = now;
  }
  WriteRecords(out, agent.contacts);
  return bytes;
}

std::string SceneEncoder::Minds(const world::OverlaySnapshot& overlay) {
  std::string changed;
  Out out(changed);
  Ids ids(out);
  for (const world::AgentOverlay& agent : overlay.agents) {
    Mind& mind = minds_.try_emplace(agent.id).first->second;
    mind.seen = blocks_;
    std::string bytes = OneMind(agent);
    if (bytes == mind.bytes) continue;
    ids.Write(agent.id);
    out.Text(bytes);
    mind.bytes = std::move(bytes);
  }
  return GoneAndChanged(minds_, changed);
}

std::string SceneEncoder::ShotsAndSpeech(const world::OverlaySnapshot& overlay) {
  std::string bytes;
  Out out(bytes);
  WriteRecords(out, overlay.shots);
  WriteRecords(out, overlay.speech);
  return bytes;
}

std::string SceneEncoder::Places(const world::OverlaySnapshot& overlay) {
  std::string bytes;
  Out out(bytes);
  WriteRecords(out, overlay.places);
  return bytes;
}

std::string SceneEncoder::Pushes(const world::OverlaySnapshot& overlay) {
  std::string bytes;
  Out out(bytes);
  WriteRecords(out, overlay.pushes);
  return bytes;
}

}  // namespace soarbox::stream
