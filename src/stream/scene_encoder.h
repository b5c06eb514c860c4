// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "world/animation/pose.h"
#include "world/overlay_snapshot.h"
#include "world/scene_snapshot.h"

namespace soarbox::stream {

/// The scene at one moment, as bytes for a page (docs/dev/stream.md).
struct Block {
  std::string bytes;
  bool is_full = false;  ///< A reader can start with this block; otherwise it needs the previous block.
};

/// Encodes a scene at consecutive moments, as full blocks and as differences from the previous block.
///
/// Positions are rounded to millimetres, rotations to 1/2048 rad, bones to 1/256 rad and 4 mm. Values that are not
/// finite are written as 0. Bones are written at most 15 times per second, or 10 times if more than 4 bodies have
/// bones. A reader that has a full block and all later blocks has the complete scene. Not thread-safe.
class SceneEncoder {
 public:
  struct Settings {
    double full_every_s = 1;          ///< Simulated time between two full blocks; 0: each block is full.
    std::size_t deflate_above = 300;  ///< Larger payloads are compressed if that makes them smaller.
    std::size_t most_lines = 20'000;  ///< Maximum number of lines, of circles and of triangles; the rest is omitted.
  };

  SceneEncoder() = default;
  explicit SceneEncoder(const Settings& settings) : settings_(settings) {}

  /// `overlay` may be null. Returns a full block if `want_full`, for the first scene, if the time is earlier than that
  /// of the previous block, and when Settings::full_every_s have passed since the last full block.
  Block Encode(const world::SceneSnapshot& scene, const world::OverlaySnapshot* overlay = nullptr,
               bool want_full = false);

 private:
  using Triple = std::array<std::int32_t, 3>;
  struct Bone {
    Triple turn{}, place{};
    friend bool operator==(const Bone&, const Bone&) = default;
  };
  /// An animation of a model from a file, and how its time and its weight change.
  struct Movement {
    std::uint32_t clip = 0;
    float time_s = 0, weight = 0, speed = 0, weight_per_s = 0;
  };
  /// The animations of a model at one moment.
  struct Movements {
    double at_s = 0;
    std::vector<Movement> list;
  };
  struct Thing {
    std::string description;
    Triple place{}, turn{};
    std::vector<Bone> bones;
    Movements movements;  ///< As sent. A reader continues them.
    std::uint64_t seen = 0;
  };
  struct Person {
    std::string description, state;
    Triple place{}, forward{};
    std::uint64_t seen = 0;
  };
  struct Mind {
    std::string bytes;
    std::uint64_t seen = 0;
  };
  class Out;
  class RecordWriter;

  void Begin();
  std::uint64_t TextIndex(std::string_view text);
  template <typename Records>
  void WriteRecords(Out& out, const Records& records);
  void WriteSection(std::string& payload, std::uint8_t tag, const std::string& bytes);
  void WriteIfChanged(std::string& payload, std::uint8_t tag, const std::string& bytes);
  std::string Surroundings(const world::SceneSnapshot& scene);
  std::string Camera(const world::SceneSnapshot& scene);
  std::string Things(const world::SceneSnapshot& scene, bool with_bones);
  bool UpdateMovements(Thing& thing, std::uint32_t id, const world::Pose* pose, double time_s);
  void ForgetMovements(double time_s);
  std::string People(const world::SceneSnapshot& scene);
  std::string Components(const world::SceneSnapshot& scene);
  std::string Particles(const world::SceneSnapshot& scene);
  std::string Sounds(const world::SceneSnapshot& scene);
  std::string Lines(const std::vector<world::LineSnapshot>& lines, const std::vector<world::CircleSnapshot>& circles,
                    const std::vector<world::TriangleSnapshot>& triangles);
  std::string Minds(const world::OverlaySnapshot& overlay);
  template <typename Known>
  std::string GoneAndChanged(std::map<std::uint32_t, Known>& known, const std::string& changed);
  std::string OneMind(const world::AgentOverlay& agent);
  std::string ShotsAndSpeech(const world::OverlaySnapshot& overlay);
  std::string Places(const world::OverlaySnapshot& overlay);
  std::string Pushes(const world::OverlaySnapshot& overlay);

  Settings settings_;
  std::uint64_t blocks_ = 0;
  bool has_block_ = false;
  double time_s_ = 0, full_at_s_ = 0, bones_at_s_ = 0;
  std::map<std::string, std::uint64_t, std::less<>> texts_;
  std::vector<std::string> new_texts_;
  std::map<std::uint8_t, std::string> sections_;
  std::map<std::uint32_t, Thing> things_;
  std::map<std::uint32_t, Movements> last_movements_;  ///< Of the previous block, by thing; without rates.
  std::map<std::uint32_t, Person> people_;
  std::map<std::uint32_t, Mind> minds_;
};

}  // namespace soarbox::stream
