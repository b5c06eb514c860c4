// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "world/animation/body_bones.h"
#include "world/math.h"
#include "world/shared.h"
#include "world/shared_list.h"

namespace soarbox::world {

/// Everything visible at the end of one tick, as plain data. The viewer draws it and recordings store it. A snapshot
/// does not point into the world; its creator owns it. Ids stay the same from tick to tick, so that a reader can cache
/// what it built for an id.
struct Color {
  float r = 1, g = 1, b = 1, a = 1;
  friend bool operator==(Color x, Color y) = default;
};

enum class ShapeKind : std::uint8_t {
  // Each shape is centred at the drawable's position; a mesh has its own origin there.
  kMesh,      ///< A named resource, "models/nobiax_modular/modular_block.mesh".
  kBox,       ///< size = full extents in m.
  kCapsule,   ///< Upright; size.x = radius, size.y = total height in m.
  kCylinder,  ///< Upright; size.x = radius, size.y = height in m.
  kPlane,     ///< Horizontal, facing up; size.x by size.z m.
  kSphere,    ///< size.x = radius in m.
};

/// How a drawable hangs on a bone of another one: position and rotation relative to the bone.
struct HungSnapshot {
  std::uint32_t on = 0;  ///< The id of that drawable; 0: it does not hang on a bone.
  std::uint32_t bone = 0;
  Vec3 position;
  Quat orientation;
};

/// One visible object, in world coordinates.
struct DrawableSnapshot {
  std::uint32_t id = 0;        ///< Unique among drawables during the life of the world.
  std::uint32_t owner_id = 0;  ///< The sandbox object or agent that it belongs to.
  bool belongs_to_agent = false;
  ShapeKind shape = ShapeKind::kMesh;
  Shared<std::string> mesh;      ///< For kMesh only.
  Shared<std::string> material;  ///< Empty: the default of the shape or mesh.
  Vec3 size;                     ///< See ShapeKind.
  Vec3 texture_repeats{1, 1, 1};
  Vec3 position;
  Quat orientation;
  Vec3 scale{1, 1, 1};
  bool visible = true;
  BodyBones bones;              ///< For meshes with a skeleton.
  bool shows_skeleton = false;  ///< Also draw its bones.
  HungSnapshot hung;            ///< If set, position and orientation follow from it (PlaceHung).
};

enum class LightKind : std::uint8_t { kDirectional, kPoint };

struct LightSnapshot {
  std::uint32_t id = 0;
  LightKind kind = LightKind::kDirectional;
  Vec3 position;             ///< Point lights.
  Vec3 direction{0, -1, 0};  ///< For directional lights: the direction in which the light shines.
  Vec3 diffuse{1, 1, 1};     ///< May exceed 1.
  Vec3 specular{0, 0, 0};
  float range_m = 0;                 ///< Point lights; 0 = unlimited.
  float attenuation[3] = {1, 0, 0};  ///< Point lights: constant, linear, quadratic.
  bool casts_shadows = true;
};

/// A line that exists for this tick only.
struct LineSnapshot {
  Vec3 from, to;
  Color color;
};

/// A horizontal circle that exists for this tick only. Renderers convert it to lines (AppendLines).
struct CircleSnapshot {
  Vec3 center;
  float radius_m = 0;
  Color color;
};
inline constexpr std::size_t kLinesOfCircle = 10;
void AppendLines(const std::vector<CircleSnapshot>& circles, std::vector<LineSnapshot>& lines);

/// A filled, translucent triangle of debug drawing that exists for this tick only. Visible from both sides.
struct TriangleSnapshot {
  Vec3 a, b, c;
  Color color;
};

/// A particle emitter with a named template.
struct ParticleSnapshot {
  std::uint32_t id = 0;
  std::string effect;  ///< "Bullet", "BulletImpact"; empty if the catalog does not contain the name: draw nothing.
  Vec3 position;
  Quat orientation;
  bool has_direction = false;
  Vec3 direction{0, 0, 1};     ///< In world coordinates; used if has_direction, else the template's own direction.
  std::uint32_t restarts = 0;  ///< When this number changes, the effect plays from its start.
  bool visible = true;
};

/// An agent, for labels, picking and panels.
struct AgentSnapshot {
  std::uint32_t id = 0;
  std::string name;
  std::string kind;    ///< "lua", "soar seeking", ...
  std::string script;  ///< File name of its body script.
  Vec3 position;
  Vec3 velocity;  ///< m/s
  Vec3 forward{0, 0, 1};
  float radius_m = 0.5f;
  float height_m = 2.0f;
  float health = 100;
  bool alive = true;
  std::string team;
  std::string last_command;  ///< The last command of its mind; without a mind, the text that its script shows as its
                             ///< activity.
  std::string shown;         ///< What its script shows of its state, as text (world::ReadShown); may be empty.
  bool failed = false;       ///< Its script stopped on an error.
  bool has_score = false;
  float score = 0;          ///< Its score in a game.
  std::uint32_t texts = 0;  ///< Changes when its texts change. Allows a caller that refills a snapshot to skip copying
                            ///< them.
};

enum class UiFont : std::uint8_t { kSmall, kSmallMono, kMedium, kMediumMono, kLarge, kLargeMono };

/// A rectangle with text on the screen, with an optional gradient in the background. In pixels, origin at the top left.
struct UiSnapshot {
  std::uint32_t id = 0;
  std::uint32_t parent_id = 0;  ///< 0: positioned relative to the screen, else relative to the parent.
  int layer = 0;
  float x = 0, y = 0, width = 0, height = 0;
  float margin_left = 0, margin_top = 0;
  bool visible = true;
  bool has_gradient = false;
  bool gradient_is_vertical = true;
  Color gradient_from, gradient_to;
  UiFont font = UiFont::kSmall;
  Color text_color;
  bool is_markup = false;  ///< The text contains the sandbox's markup: %0..%9 colours, @nn fonts
                           ///< (docs/spec/lua_api.md, UI.SetMarkupText).
  std::string text;
  /// The key of an image (world/asset_store.h) or the name of a material that fills the panel; empty: none.
  std::string material;
  std::string caption;  ///< A plain text in addition to the markup text; empty unless the component has both.
  bool gradient_is_diagonal = false;  ///< From the top left to the bottom right; gradient_is_vertical is then ignored.
  bool in_world = false;              ///< A panel in the world: 1 px = 0.005 m, x to its right, y down, facing its +z.
  Vec3 world_position;                ///< Position of the panel's top left corner; only if in_world.
  Quat world_orientation;
  std::string button;  ///< The button's name; empty: this is not a button.
  bool has_bar = false;
  float bar = 0;  ///< Filled fraction of the width, 0..1; only if has_bar.
  Color bar_color;
};

/// A sound that started within the last kSoundStays_s. Renderers play each sound once; they recognise it by its id.
struct SoundSnapshot {
  std::uint32_t id = 0;  ///< From 1, in the order in which sounds started.
  std::string file;      ///< The key of a file (world/asset_store.h).
  double time_s = 0;     ///< When it started, in simulated time.
  float volume = 1;      ///< 0..1
  bool in_world = false;
  Vec3 position;  ///< Only if in_world; other sounds are equally loud everywhere.
};
/// How long a sound stays in snapshots, so that renderers that skip ticks do not miss it; and the maximum number of
/// sounds in a snapshot.
inline constexpr double kSoundStays_s = 1;
inline constexpr std::size_t kMostSounds = 32;

struct CameraSnapshot {
  Vec3 position{0, 5, 0};
  Quat orientation;  ///< Looks along its -z.
  float vertical_fov_deg = 45;
};

/// Whether the position and orientation of drawables that hang on bones are computed, which takes a microsecond each.
enum class HungThings : std::uint8_t {
  kPlaced,
  kNotPlaced,  ///< They are those of an earlier snapshot. PlaceHung computes them.
};

struct SceneSnapshot {
  std::uint64_t tick = 0;
  double time_s = 0;
  SharedList<DrawableSnapshot> drawables;  ///< In the order of creation. Blocks that did not change are shared with
                                           ///< earlier snapshots.
  std::vector<LightSnapshot> lights;
  std::vector<AgentSnapshot> agents;        ///< In creation order.
  std::vector<UiSnapshot> ui;               ///< In creation order.
  std::vector<LineSnapshot> lines;          ///< Debug lines of this tick, physics debug included if switched on.
  std::vector<CircleSnapshot> circles;      ///< Debug circles of this tick.
  std::vector<TriangleSnapshot> triangles;  ///< Debug fills of this tick.
  std::vector<ParticleSnapshot> particles;  ///< In creation order.
  std::vector<SoundSnapshot> sounds;        ///< Those of the last second, in the order in which they started.
  /// The colours of %0 to %9 in markup texts.
  std::array<Color, 10> markup_palette{};
  Vec3 ambient{0.5f, 0.5f, 0.5f};
  std::string sky;  ///< Name of the sky, "ThickCloudsWaterSkyBox"; empty: plain.
  Vec3 sky_rotation_deg;
  CameraSnapshot camera;           ///< Its pose, set by scripts or the user; `camera_moves` counts calls of scripts.
  std::uint32_t camera_moves = 0;  ///< When this number changes, the viewer must move its camera to `camera`.
  bool camera_is_fixed = false;    ///< The viewer should keep this pose and not follow agents.

  /// Which world filled this snapshot, and the versions of data that seldom change. When the same world fills this
  /// snapshot or a copy again, it skips unchanged data. Not part of the scene.
  struct Kept {
    std::uint64_t world = 0;  ///< 0: none.
    std::uint64_t few = 0, ui = 0;
  } kept;
};

/// Computes position and orientation of each drawable that hangs on a bone. A drawable is not changed if the drawable
/// with the bone does not exist or hangs on a bone itself.
void PlaceHung(SharedList<DrawableSnapshot>& drawables);

}  // namespace soarbox::world
