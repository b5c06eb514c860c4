// SPDX-License-Identifier: BSD-2-Clause
#include "record/scene_codec.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

#include "record/bones_codec.h"
#include "record/scene_fields.h"
#include "world/rotation.h"

namespace soarbox::record {
namespace {

using world::Color;
using world::Quat;
using world::Shared;
using world::SharedList;
using world::Vec3;

template <typename T>
concept HasFields = requires(const T& value) {
  FieldsOf(value);
};

void Put(BufferedWriter& out, float value) {
  out.Float(value);
}
void Put(BufferedWriter& out, double value) {
  out.Double(value);
}
void Put(BufferedWriter& out, const std::string& value) {
  out.Text(value);
}
void Put(BufferedWriter& out, const Vec3& value) {
  for (const float part : {value.x, value.y, value.z}) out.Float(part);
}
void Put(BufferedWriter& out, const Quat& value) {
  for (const float part : {value.w, value.x, value.y, value.z}) out.Float(part);
}
void Put(BufferedWriter& out, const Color& value) {
  for (const float part : {value.r, value.g, value.b, value.a}) out.Float(part);
}
template <typename T>
requires std::is_integral_v<T> || std::is_enum_v<T>
void Put(BufferedWriter& out, T value) {
  // Negative numbers are rare (layers of panels) and use ten bytes.
  out.Number(static_cast<std::uint64_t>(value));
}
template <typename T, std::size_t N>
void Put(BufferedWriter& out, const T (&values)[N]) {
  for (const T& value : values) Put(out, value);
}
template <typename T, std::size_t N>
void Put(BufferedWriter& out, const std::array<T, N>& values) {
  for (const T& value : values) Put(out, value);
}
template <HasFields T>
void Put(BufferedWriter& out, const T& value) {
  std::apply([&](auto... members) { (Put(out, value.*members), ...); }, FieldsOf(value));
}

void Get(ByteReader& in, float& value) {
  value = in.Float();
}
void Get(ByteReader& in, double& value) {
  value = in.Double();
}
void Get(ByteReader& in, std::string& value) {
  value = in.Text();
}
void Get(ByteReader& in, Shared<std::string>& value) {
  value = in.Text();
}
void Get(ByteReader& in, Vec3& value) {
  for (float* part : {&value.x, &value.y, &value.z}) *part = in.Float();
}
void Get(ByteReader& in, Quat& value) {
  for (float* part : {&value.w, &value.x, &value.y, &value.z}) *part = in.Float();
}
void Get(ByteReader& in, Color& value) {
  for (float* part : {&value.r, &value.g, &value.b, &value.a}) *part = in.Float();
}

/// Number of values of an enumeration in a scene. Readers check it, because they use values as indices.
constexpr std::uint64_t ValuesOf(world::ShapeKind) {
  return static_cast<std::uint64_t>(world::ShapeKind::kSphere) + 1;
}
constexpr std::uint64_t ValuesOf(world::LightKind) {
  return static_cast<std::uint64_t>(world::LightKind::kPoint) + 1;
}
constexpr std::uint64_t ValuesOf(world::UiFont) {
  return static_cast<std::uint64_t>(world::UiFont::kLargeMono) + 1;
}

template <typename T>
requires std::is_integral_v<T> || std::is_enum_v<T>
void Get(ByteReader& in, T& value) {
  const std::uint64_t number = in.Number();
  if constexpr (std::is_enum_v<T>) {
    if (number >= ValuesOf(T{})) return in.Fail();
  }
  if constexpr (std::is_same_v<T, bool>) {
    value = number != 0;
  } else {
    value = static_cast<T>(number);
  }
}
template <typename T, std::size_t N>
void Get(ByteReader& in, T (&values)[N]) {
  for (T& value : values) Get(in, value);
}
template <typename T, std::size_t N>
void Get(ByteReader& in, std::array<T, N>& values) {
  for (T& value : values) Get(in, value);
}
template <HasFields T>
void Get(ByteReader& in, T& value) {
  std::apply([&](auto... members) { (Get(in, value.*members), ...); }, FieldsOf(value));
}

template <typename T>
bool Same(const T& a, const T& b);

/// Compares bit for bit, so that -0 and NaN replay exactly.
std::uint32_t BitsOf(float number) {
  return std::bit_cast<std::uint32_t>(number);
}
bool Same(float a, float b) {
  return BitsOf(a) == BitsOf(b);
}
bool Same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool Same(const world::BodyBones& a, const world::BodyBones& b) {
  return AreSameBones(a, b);
}
template <typename T>
bool Same(const Shared<T>& a, const Shared<T>& b) {
  return a.IsSame(b) || Same(a.value(), b.value());
}
template <typename T>
bool Same(const T& a, const T& b) {
  if constexpr (HasFields<T>) {
    return std::apply([&](auto... members) { return (Same(a.*members, b.*members) && ...); }, FieldsOf(a));
  } else if constexpr (std::is_same_v<T, Vec3>) {
    return ((BitsOf(a.x) ^ BitsOf(b.x)) | (BitsOf(a.y) ^ BitsOf(b.y)) | (BitsOf(a.z) ^ BitsOf(b.z))) == 0;
  } else if constexpr (std::is_same_v<T, Quat> || std::is_same_v<T, Color>) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
  } else if constexpr (std::is_array_v<T>) {
    return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b),
                      [](const auto& x, const auto& y) { return Same(x, y); });
  } else {
    return a == b;
  }
}

/// Positions and rotations change slightly, so the highest bytes of each component are usually the same. One byte with
/// two bits per component, lowest first, says what follows: 0 nothing (unchanged), 1 the two lowest bytes, 2 three
/// bytes, 3 all four.
template <typename T>
constexpr bool kIsMoved = std::is_same_v<T, Vec3> || std::is_same_v<T, Quat>;

auto PartsOf(Vec3& value) {
  return std::array{&value.x, &value.y, &value.z};
}
auto PartsOf(Quat& value) {
  return std::array{&value.w, &value.x, &value.y, &value.z};
}

template <typename T>
void PutMoved(BufferedWriter& out, T before, T now) {
  const auto earlier = PartsOf(before), parts = PartsOf(now);
  char* const bytes = out.Room(1 + sizeof(T));
  std::size_t size = 1;
  unsigned kinds = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::uint32_t bits = BitsOf(*parts[i]), differs = bits ^ BitsOf(*earlier[i]);
    if (differs == 0) continue;
    const unsigned kind = differs >> 24 != 0 ? 3 : differs >> 16 != 0 ? 2 : 1;
    kinds |= kind << (2 * i);
    for (unsigned at = 0; at <= kind; ++at) bytes[size++] = static_cast<char>(bits >> (8 * at));
  }
  bytes[0] = static_cast<char>(kinds);
  out.Wrote(size);
}

template <typename T>
void GetMoved(ByteReader& in, T& value) {
  unsigned kinds = in.Byte();
  for (float* part : PartsOf(value)) {
    const unsigned kind = kinds & 3;
    kinds >>= 2;
    if (kind == 0) continue;
    std::uint32_t bits = kind == 3 ? 0 : BitsOf(*part) >> (8 * (kind + 1)) << (8 * (kind + 1));
    for (unsigned at = 0; at <= kind; ++at) bits |= static_cast<std::uint32_t>(in.Byte()) << (8 * at);
    *part = std::bit_cast<float>(bits);
  }
  if (kinds != 0) in.Fail();
}

/// The default expectation: an entry is unchanged.
template <typename T>
struct Expected {
  const T& before;
  template <typename Member>
  const Member& operator->*(Member T::*member) const {
    return before.*member;
  }
};

/// Position and orientation of a drawable that hangs on a bone follow from the bone, so they are never stored. Of one
/// that hung on a bone before, they are expected to be the defaults.
template <>
struct Expected<world::DrawableSnapshot> {
  const world::DrawableSnapshot& before;
  world::Vec3 position;
  world::Quat orientation;

  Expected(const world::DrawableSnapshot& earlier, const world::DrawableSnapshot& now) : before(earlier) {
    if (const bool is_hung = now.hung.on != 0; is_hung || earlier.hung.on == 0) {
      position = is_hung ? now.position : earlier.position;
      orientation = is_hung ? now.orientation : earlier.orientation;
    }
  }

  template <typename Member>
  const Member& operator->*(Member world::DrawableSnapshot::*member) const {
    if constexpr (std::is_same_v<Member, Vec3>)
      if (member == &world::DrawableSnapshot::position) return position;
    if constexpr (std::is_same_v<Member, Quat>)
      if (member == &world::DrawableSnapshot::orientation) return orientation;
    return before.*member;
  }
};

/// The expectation for an entry `now` that was `before`.
template <typename T>
Expected<T> Expect(const T& before, const T& now) {
  if constexpr (std::is_same_v<T, world::DrawableSnapshot>) {
    return {before, now};
  } else {
    return {before};
  }
}

/// The state of an entry from which its changes are read.
template <typename T>
void PrepareToRead(T&) {}
void PrepareToRead(world::DrawableSnapshot& drawable) {
  if (drawable.hung.on == 0) return;
  drawable.position = {};
  drawable.orientation = {};
}

/// One bit per member that differs from the expectation. `same_texts`: members that are texts are known to be
/// unchanged.
template <HasFields T, typename E>
std::uint64_t Differences(const E& expected, const T& now, bool same_texts = false) {
  std::uint64_t mask = 0;
  std::uint64_t bit = 1;
  const auto compare = [&](auto member) __attribute__((always_inline)) {
    constexpr bool kIsText = std::is_same_v<std::remove_cvref_t<decltype(now.*member)>, std::string>;
    if (!(kIsText && same_texts) && !Same(expected->*member, now.*member)) mask |= bit;
    bit <<= 1;
  };
  std::apply([&](auto... members) { (compare(members), ...); }, FieldsOf(now));
  return mask;
}

template <HasFields T, typename E>
void PutMembers(BufferedWriter& out, std::uint64_t mask, const E& expected, const T& now) {
  out.Number(mask);
  const auto put = [&](auto member) {
    if ((mask & 1) != 0) {
      using Member = std::remove_cvref_t<decltype(now.*member)>;
      if constexpr (std::is_same_v<Member, world::BodyBones>) {
        PutBones(out, expected->*member, now.*member);
      } else if constexpr (kIsMoved<Member>) {
        PutMoved(out, expected->*member, now.*member);
      } else {
        Put(out, now.*member);
      }
    }
    mask >>= 1;
  };
  std::apply([&](auto... members) { (put(members), ...); }, FieldsOf(now));
}

template <HasFields T>
void GetMembers(ByteReader& in, T& value) {
  std::uint64_t mask = in.Number();
  const auto get = [&](auto member) {
    if ((mask & 1) != 0) {
      using Member = std::remove_cvref_t<decltype(value.*member)>;
      if constexpr (std::is_same_v<Member, world::BodyBones>) {
        GetBones(in, value.*member);
      } else if constexpr (kIsMoved<Member>) {
        GetMoved(in, value.*member);
      } else {
        Get(in, value.*member);
      }
    }
    mask >>= 1;
  };
  std::apply([&](auto... members) { (get(members), ...); }, FieldsOf(value));
  if (mask != 0) in.Fail();
}

// A list is a sequence of steps along the earlier list: a number of unchanged entries, followed by one that changed,
// was removed or is new.
enum class Step : std::uint8_t { kEnd, kChanged, kGone, kNew };

template <HasFields T>
class StepWriter {
 public:
  explicit StepWriter(BufferedWriter& out) : out_(out) {}

  void Same(std::size_t count) { unchanged_ += count; }
  void Gone() { Put(Step::kGone); }
  void New(const T& value) {
    static const T kNothing{};
    const Expected<T> expected = Expect(kNothing, value);
    Put(Step::kNew);
    out_.Number(value.id);
    PutMembers(out_, Differences(expected, value), expected, value);
  }
  /// An entry that exists in both lists, whether it changed or not.
  template <typename E>
  void Next(const E& expected, const T& value, bool same_texts = false) {
    const std::uint64_t mask = Differences(expected, value, same_texts);
    if (mask == 0) return Same(1);
    Put(Step::kChanged);
    PutMembers(out_, mask, expected, value);
  }
  void End() { Put(Step::kEnd); }

 private:
  void Put(Step kind) {
    out_.Number(std::exchange(unchanged_, 0));
    out_.Byte(static_cast<std::uint8_t>(kind));
  }

  BufferedWriter& out_;
  std::size_t unchanged_ = 0;
};

/// The expectation for agents, whose ids ascend. They have the horizontal position and the direction of their first
/// drawable that hangs on no bone, and the same height as before. If they have no drawable, they are unchanged.
class Followed {
 public:
  Followed(const world::SceneSnapshot& scene) {
    for (const world::DrawableSnapshot& drawable : scene.drawables)
      if (drawable.belongs_to_agent && drawable.hung.on == 0) bodies_.push_back(&drawable);
    if (!std::ranges::is_sorted(bodies_, {}, kOwner)) std::ranges::stable_sort(bodies_, {}, kOwner);
  }
  void Follow(std::uint32_t agent, Vec3& position, Vec3& forward) {
    while (next_ < bodies_.size() && bodies_[next_]->owner_id < agent) ++next_;
    if (next_ == bodies_.size() || bodies_[next_]->owner_id != agent) return;
    const world::DrawableSnapshot& body = *bodies_[next_];
    position = {body.position.x, position.y, body.position.z};
    // Quaternions that are not finite give different bits on different machines.
    if (const Vec3 ahead = Rotate(body.orientation, {0, 0, 1}); world::IsFinite(ahead)) forward = ahead;
  }

 private:
  static constexpr auto kOwner = &world::DrawableSnapshot::owner_id;

  std::vector<const world::DrawableSnapshot*> bodies_;
  std::size_t next_ = 0;
};

template <>
struct Expected<world::AgentSnapshot> {
  const world::AgentSnapshot& before;
  Vec3 position = before.position, forward = before.forward;

  template <typename Member>
  const Member& operator->*(Member world::AgentSnapshot::*member) const {
    if constexpr (std::is_same_v<Member, Vec3>) {
      if (member == &world::AgentSnapshot::position) return position;
      if (member == &world::AgentSnapshot::forward) return forward;
    }
    return before.*member;
  }
};

/// `expect(earlier)`: the expected entry. `same_texts(earlier, value)`: whether its texts are known to be unchanged.
template <HasFields T, typename Expect, typename SameTexts>
void WriteList(BufferedWriter& out, const std::vector<T>& before, const std::vector<T>& now, Expect&& expect,
               SameTexts&& same_texts) {
  StepWriter<T> steps(out);
  std::size_t old = 0;
  for (const T& value : now) {
    // Ids ascend in both lists. Entries before this id were removed.
    for (; old < before.size() && before[old].id < value.id; ++old) steps.Gone();
    if (old < before.size() && before[old].id == value.id) {
      steps.Next(expect(before[old]), value, same_texts(before[old], value));
      ++old;
    } else {
      steps.New(value);
    }
  }
  for (; old < before.size(); ++old) steps.Gone();
  steps.End();
}

template <HasFields T>
void WriteList(BufferedWriter& out, const std::vector<T>& before, const std::vector<T>& now) {
  WriteList(
      out, before, now, [](const T& earlier) { return Expected<T>{earlier}; },
      [](const T&, const T&) { return false; });
}

template <HasFields T>
void ReadList(ByteReader& in, std::vector<T>& list) {
  std::vector<T> before = std::exchange(list, {});
  list.reserve(before.size());
  std::size_t old = 0;
  while (!in.failed()) {
    const std::uint64_t unchanged = in.Number();
    const auto step = static_cast<Step>(in.Byte());
    const std::size_t needed = step == Step::kChanged || step == Step::kGone ? 1 : 0;
    if (in.failed() || before.size() - old < needed || unchanged > before.size() - old - needed) return in.Fail();
    for (std::uint64_t i = 0; i < unchanged; ++i) list.push_back(std::move(before[old++]));
    switch (step) {
      case Step::kEnd:
        if (old != before.size()) in.Fail();
        return;
      case Step::kChanged:
        list.push_back(std::move(before[old++]));
        GetMembers(in, list.back());
        break;
      case Step::kGone:
        ++old;
        break;
      case Step::kNew:
        in.Charge(sizeof(T));
        list.emplace_back();
        Get(in, list.back().id);
        GetMembers(in, list.back());
        break;
      default:
        return in.Fail();
    }
  }
}

/// Blocks that both lists share are equal.
template <HasFields T>
void WriteList(BufferedWriter& out, const SharedList<T>& before, const SharedList<T>& now) {
  StepWriter<T> steps(out);
  typename SharedList<T>::Place old, at;
  while (!now.IsEnd(at)) {
    const bool both_begin = at.index == 0 && old.index == 0 && !before.IsEnd(old);
    if (both_begin && now.SharesBlock(at.block, before, old.block)) {
      steps.Same(now.BlockSize(at.block));
      at = {at.block + 1, 0};
      old = {old.block + 1, 0};
      continue;
    }
    const T& value = now.At(at);
    for (; !before.IsEnd(old) && before.At(old).id < value.id; old = before.After(old)) steps.Gone();
    if (!before.IsEnd(old) && before.At(old).id == value.id) {
      steps.Next(Expect(before.At(old), value), value);
      old = before.After(old);
    } else {
      steps.New(value);
    }
    at = now.After(at);
  }
  for (; !before.IsEnd(old); old = before.After(old)) steps.Gone();
  steps.End();
}

/// Changes the list in place, so that unchanged blocks stay shared.
template <HasFields T>
void ReadList(ByteReader& in, SharedList<T>& list) {
  typename SharedList<T>::Place at;
  while (!in.failed()) {
    for (std::uint64_t unchanged = in.Number(); unchanged > 0;) {
      if (list.IsEnd(at)) return in.Fail();
      const std::size_t rest = list.BlockSize(at.block) - at.index;
      at = unchanged >= rest ? typename SharedList<T>::Place{at.block + 1, 0}
                             : typename SharedList<T>::Place{at.block, at.index + static_cast<std::size_t>(unchanged)};
      unchanged -= std::min<std::uint64_t>(unchanged, rest);
    }
    const auto step = static_cast<Step>(in.Byte());
    if (in.failed() || (list.IsEnd(at) && (step == Step::kChanged || step == Step::kGone))) return in.Fail();
    switch (step) {
      case Step::kEnd:
        if (!list.IsEnd(at)) in.Fail();
        return;
      case Step::kChanged:
        PrepareToRead(list.Edit(at));
        GetMembers(in, list.Edit(at));
        at = list.After(at);
        break;
      case Step::kGone:
        at = list.Erase(at);
        break;
      case Step::kNew: {
        T made;
        Get(in, made.id);
        GetMembers(in, made);
        in.Charge(sizeof(T));
        at = list.After(list.Insert(at, std::move(made)));
        break;
      }
      default:
        return in.Fail();
    }
  }
}

/// Lists of items without ids, which exist for one tick. Each item is compared with the one at the same index in the
/// tick before.
template <HasFields T>
void WritePlain(BufferedWriter& out, const std::vector<T>& before, const std::vector<T>& now) {
  static const T kNothing;
  out.Number(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Expected<T> expected{i < before.size() ? before[i] : kNothing};
    PutMembers(out, Differences(expected, now[i]), expected, now[i]);
  }
}

template <HasFields T>
void ReadPlain(ByteReader& in, std::vector<T>& list) {
  list.resize(in.CountOf(sizeof(T)));
  for (T& value : list) GetMembers(in, value);
}

}  // namespace

void WriteScene(BufferedWriter& out, const world::SceneSnapshot& before, const world::SceneSnapshot& now) {
  const Expected<world::SceneSnapshot> expected{before};
  PutMembers(out, Differences(expected, now), expected, now);
  WriteList(out, before.drawables, now.drawables);
  WriteList(out, before.lights, now.lights);
  const bool is_one_world = before.kept.world != 0 && before.kept.world == now.kept.world;
  Followed followed(now);
  const auto expect = [&](const world::AgentSnapshot& earlier) {
    Expected<world::AgentSnapshot> agent{earlier};
    followed.Follow(earlier.id, agent.position, agent.forward);
    return agent;
  };
  WriteList(out, before.agents, now.agents, expect, [&](const world::AgentSnapshot& a, const world::AgentSnapshot& b) {
    return is_one_world && a.texts == b.texts;
  });
  WriteList(out, before.ui, now.ui);
  WriteList(out, before.particles, now.particles);
  WriteList(out, before.sounds, now.sounds);
  WritePlain(out, before.lines, now.lines);
  WritePlain(out, before.triangles, now.triangles);
  WritePlain(out, before.circles, now.circles);
}

void ReadScene(ByteReader& in, world::SceneSnapshot& scene) {
  GetMembers(in, scene);
  ReadList(in, scene.drawables);
  ReadList(in, scene.lights);
  Followed followed(scene);
  for (world::AgentSnapshot& agent : scene.agents) followed.Follow(agent.id, agent.position, agent.forward);
  ReadList(in, scene.agents);
  ReadList(in, scene.ui);
  ReadList(in, scene.particles);
  ReadList(in, scene.sounds);
  ReadPlain(in, scene.lines);
  ReadPlain(in, scene.triangles);
  ReadPlain(in, scene.circles);
}

}  // namespace soarbox::record
