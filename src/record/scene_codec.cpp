// SPDX-License-Identifier: BSD-2-Clause
#include "record/scene_codec.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

#include "record/scene_fields.h"

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

void Put(ByteWriter& out, float value) {
  out.Float(value);
}
void Put(ByteWriter& out, double value) {
  out.Double(value);
}
void Put(ByteWriter& out, const std::string& value) {
  out.Text(value);
}
void Put(ByteWriter& out, const Vec3& value) {
  out.ManyFloats(value.x, value.y, value.z);
}
void Put(ByteWriter& out, const Quat& value) {
  out.ManyFloats(value.w, value.x, value.y, value.z);
}
void Put(ByteWriter& out, const Color& value) {
  out.ManyFloats(value.r, value.g, value.b, value.a);
}
template <typename T>
requires std::is_integral_v<T> || std::is_enum_v<T>
void Put(ByteWriter& out, T value) {
  // Negative numbers are few (layers of panels) and take ten bytes.
  out.Number(static_cast<std::uint64_t>(value));
}
template <typename T, std::size_t N>
void Put(ByteWriter& out, const T (&values)[N]) {
  for (const T& value : values) Put(out, value);
}
template <typename T, std::size_t N>
void Put(ByteWriter& out, const std::array<T, N>& values) {
  for (const T& value : values) Put(out, value);
}
template <HasFields T>
void Put(ByteWriter& out, const T& value) {
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

/// How many values an enumeration of the scene has: readers index tables with them.
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

// Bones, most of what soldiers take in a recording, change all at once and a little only: what is kept is their bits
// exclusive-or those of before, the highest bytes of all numbers first, so that much of it is zero.
constexpr std::size_t kNumbersPerBone = 7;
using Bones = std::vector<world::BonePose>;

void AppendBits(const Bones& bones, std::vector<std::uint32_t>& bits) {
  for (const world::BonePose& bone : bones) {
    const Vec3& p = bone.position;
    const Quat& q = bone.orientation;
    for (const float number : {p.x, p.y, p.z, q.w, q.x, q.y, q.z}) bits.push_back(std::bit_cast<std::uint32_t>(number));
  }
}

void Put(ByteWriter& out, const Bones& before, const Bones& now) {
  std::vector<std::uint32_t> bits, earlier;
  bits.reserve(now.size() * kNumbersPerBone);
  AppendBits(now, bits);
  AppendBits(before, earlier);
  earlier.resize(bits.size());
  out.Number(now.size());
  for (int shift = 24; shift >= 0; shift -= 8)
    for (std::size_t i = 0; i < bits.size(); ++i) out.Byte(static_cast<std::uint8_t>((bits[i] ^ earlier[i]) >> shift));
}

void Get(ByteReader& in, Shared<Bones>& shared) {
  std::vector<std::uint32_t> bits;
  const std::size_t count = in.Count(4 * kNumbersPerBone);
  AppendBits(shared, bits);
  bits.resize(count * kNumbersPerBone);
  for (int shift = 24; shift >= 0; shift -= 8)
    for (std::uint32_t& number : bits) number ^= static_cast<std::uint32_t>(in.Byte()) << shift;
  Bones bones(count);
  std::size_t at = 0;
  for (world::BonePose& bone : bones) {
    Vec3& p = bone.position;
    Quat& q = bone.orientation;
    for (float* number : {&p.x, &p.y, &p.z, &q.w, &q.x, &q.y, &q.z}) *number = std::bit_cast<float>(bits[at++]);
  }
  shared = std::move(bones);
}

template <typename T>
bool Same(const T& a, const T& b);

/// Bit for bit, so that -0 and NaN replay as they were.
bool Same(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}
bool Same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
template <typename T>
bool Same(const Shared<T>& a, const Shared<T>& b) {
  return a.IsSame(b) || Same(a.value(), b.value());
}
template <typename T>
bool Same(const T& a, const T& b) {
  if constexpr (HasFields<T>) {
    return std::apply([&](auto... members) { return (Same(a.*members, b.*members) && ...); }, FieldsOf(a));
  } else if constexpr (std::is_same_v<T, Vec3> || std::is_same_v<T, Quat> || std::is_same_v<T, Color>) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
  } else if constexpr (std::is_array_v<T> || std::is_same_v<T, std::vector<world::BonePose>>) {
    return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b),
                      [](const auto& x, const auto& y) { return Same(x, y); });
  } else {
    return a == b;
  }
}

/// One bit per member that differs.
template <HasFields T>
std::uint64_t Differences(const T& before, const T& now) {
  std::uint64_t mask = 0;
  std::uint64_t bit = 1;
  const auto compare = [&](auto member) {
    if (!Same(before.*member, now.*member)) mask |= bit;
    bit <<= 1;
  };
  std::apply([&](auto... members) { (compare(members), ...); }, FieldsOf(now));
  return mask;
}

template <HasFields T>
void PutMembers(ByteWriter& out, std::uint64_t mask, const T& before, const T& now) {
  out.Number(mask);
  const auto put = [&](auto member) {
    if ((mask & 1) != 0) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(now.*member)>, Shared<Bones>>) {
        Put(out, (before.*member).value(), (now.*member).value());
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
    if ((mask & 1) != 0) Get(in, value.*member);
    mask >>= 1;
  };
  std::apply([&](auto... members) { (get(members), ...); }, FieldsOf(value));
  if (mask != 0) in.Fail();
}

// A list is a sequence of steps along the earlier list: so many stay as they are, then one changes, goes, or comes.
enum class Step : std::uint8_t { kEnd, kChanged, kGone, kNew };

template <HasFields T>
class StepWriter {
 public:
  explicit StepWriter(ByteWriter& out) : out_(out) {}

  void Same(std::size_t count) { unchanged_ += count; }
  void Gone() { Put(Step::kGone); }
  void New(const T& value) {
    static const T kNothing{};
    Put(Step::kNew);
    out_.Number(value.id);
    PutMembers(out_, Differences(kNothing, value), kNothing, value);
  }
  /// The same entry, changed or not.
  void Next(const T& earlier, const T& value) {
    const std::uint64_t mask = Differences(earlier, value);
    if (mask == 0) return Same(1);
    Put(Step::kChanged);
    PutMembers(out_, mask, earlier, value);
  }
  void End() { Put(Step::kEnd); }

 private:
  void Put(Step kind) {
    out_.Number(std::exchange(unchanged_, 0));
    out_.Byte(static_cast<std::uint8_t>(kind));
  }

  ByteWriter& out_;
  std::size_t unchanged_ = 0;
};

template <HasFields T>
void WriteList(ByteWriter& out, const std::vector<T>& before, const std::vector<T>& now) {
  StepWriter<T> steps(out);
  std::size_t old = 0;
  for (const T& value : now) {
    // Ids ascend in both lists; what is in front of this id has gone.
    for (; old < before.size() && before[old].id < value.id; ++old) steps.Gone();
    if (old < before.size() && before[old].id == value.id) {
      steps.Next(before[old++], value);
    } else {
      steps.New(value);
    }
  }
  for (; old < before.size(); ++old) steps.Gone();
  steps.End();
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

/// Blocks that both lists share hold the same.
template <HasFields T>
void WriteList(ByteWriter& out, const SharedList<T>& before, const SharedList<T>& now) {
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
      steps.Next(before.At(old), value);
      old = before.After(old);
    } else {
      steps.New(value);
    }
    at = now.After(at);
  }
  for (; !before.IsEnd(old); old = before.After(old)) steps.Gone();
  steps.End();
}

/// In place, so that blocks that stay as they are stay shared.
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

/// Lists of things without ids, which last for one tick.
template <HasFields T>
void WritePlain(ByteWriter& out, const std::vector<T>& now) {
  out.Number(now.size());
  for (const T& value : now) Put(out, value);
}

template <HasFields T>
void ReadPlain(ByteReader& in, std::vector<T>& list) {
  list.resize(in.Count(sizeof(T)));
  for (T& value : list) Get(in, value);
}

}  // namespace

void WriteScene(ByteWriter& out, const world::SceneSnapshot& before, const world::SceneSnapshot& now) {
  PutMembers(out, Differences(before, now), before, now);
  WriteList(out, before.drawables, now.drawables);
  WriteList(out, before.lights, now.lights);
  WriteList(out, before.agents, now.agents);
  WriteList(out, before.ui, now.ui);
  WriteList(out, before.particles, now.particles);
  WritePlain(out, now.lines);
  WritePlain(out, now.triangles);
  WritePlain(out, now.circles);
}

void ReadScene(ByteReader& in, world::SceneSnapshot& scene, std::uint16_t version) {
  GetMembers(in, scene);
  ReadList(in, scene.drawables);
  ReadList(in, scene.lights);
  ReadList(in, scene.agents);
  ReadList(in, scene.ui);
  ReadList(in, scene.particles);
  ReadPlain(in, scene.lines);
  ReadPlain(in, scene.triangles);
  constexpr std::uint16_t kLastWithoutCircles = 5;  // They stood among the lines.
  scene.circles.clear();
  if (version > kLastWithoutCircles) ReadPlain(in, scene.circles);
}

}  // namespace soarbox::record
