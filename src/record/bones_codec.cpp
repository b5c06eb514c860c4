// SPDX-License-Identifier: BSD-2-Clause
#include "record/bones_codec.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "world/animation/pose.h"
#include "world/animation/rig.h"

namespace soarbox::record {
namespace {

using world::BodyBones;
using world::Pose;
using Bones = std::vector<world::BonePose>;

/// How bones are stored.
enum class Form : std::uint8_t {
  kGiven,     ///< The pose of each bone.
  kSame,      ///< The same movements as in the tick before, at later times.
  kMovements  ///< Movements by name.
};

std::uint32_t Bits(float number) {
  return std::bit_cast<std::uint32_t>(number);
}

// Poses change in many numbers at once, but only slightly. The encoding is their bits XOR those of the tick before,
// with the highest bytes of all numbers first, so that most of it is zero.
constexpr std::size_t kNumbersPerBone = 7;

void AppendBits(const Bones& bones, std::vector<std::uint32_t>& bits) {
  for (const world::BonePose& bone : bones) {
    const world::Vec3& p = bone.position;
    const world::Quat& q = bone.orientation;
    for (const float number : {p.x, p.y, p.z, q.w, q.x, q.y, q.z}) bits.push_back(Bits(number));
  }
}

/// The bones to compute differences from. Bones of a pose are not used, because they would have to be computed first.
const Bones& GivenBefore(const BodyBones& before) {
  static const Bones kNone;
  return before.pose() == nullptr ? before.value() : kNone;
}

void PutGiven(BufferedWriter& out, const Bones& before, const Bones& now) {
  std::vector<std::uint32_t> bits, earlier;
  bits.reserve(now.size() * kNumbersPerBone);
  AppendBits(now, bits);
  AppendBits(before, earlier);
  earlier.resize(bits.size());
  out.Number(now.size());
  for (int shift = 24; shift >= 0; shift -= 8)
    for (std::size_t i = 0; i < bits.size(); ++i) out.Byte(static_cast<std::uint8_t>((bits[i] ^ earlier[i]) >> shift));
}

BodyBones GetGiven(ByteReader& in, const Bones& before) {
  std::vector<std::uint32_t> bits;
  const std::size_t count = in.Count(4 * kNumbersPerBone);
  AppendBits(before, bits);
  bits.resize(count * kNumbersPerBone);
  for (int shift = 24; shift >= 0; shift -= 8)
    for (std::uint32_t& number : bits) number ^= static_cast<std::uint32_t>(in.Byte()) << shift;
  Bones bones(count);
  std::size_t at = 0;
  for (world::BonePose& bone : bones) {
    world::Vec3& p = bone.position;
    world::Quat& q = bone.orientation;
    for (float* number : {&p.x, &p.y, &p.z, &q.w, &q.x, &q.y, &q.z}) *number = std::bit_cast<float>(bits[at++]);
  }
  return BodyBones(std::move(bones));
}

/// The built-in rigs that recordings refer to, by number; and the number for rigs of models from files.
constexpr std::uint8_t kModelRig = 2;
const world::Rig* RigNumbered(std::uint8_t number) {
  if (number == 0) return &world::SoldierRig();
  return number == 1 ? &world::RifleRig() : nullptr;
}

std::optional<std::uint8_t> NumberOf(const world::Rig* rig) {
  for (std::uint8_t number = 0; const world::Rig* known = RigNumbered(number); ++number)
    if (known == rig) return number;
  return rig->model.empty() ? std::nullopt : std::optional(kModelRig);
}

/// Maximum number of blended movements. One bit for each pair of numbers says whether they changed.
constexpr std::size_t kMostParts = 31;

bool HasSameMovements(const Pose& a, const Pose& b) {
  return a.rig == b.rig && a.played == b.played &&
         std::ranges::equal(a.parts, b.parts, {}, &Pose::Part::clip, &Pose::Part::clip);
}

/// Calls `see` with pairs of numbers of two poses with the same movements, in the order of the file.
template <typename Before, typename Now, typename See>
void EachNumber(Before& before, Now& now, See&& see) {
  see(before.legs, now.legs);
  for (std::size_t i = 0; i < now.parts.size(); ++i) {
    see(before.parts[i].time_s, now.parts[i].time_s);
    see(before.parts[i].weight, now.parts[i].weight);
  }
}

void PutSame(BufferedWriter& out, const Pose& before, const Pose& now) {
  std::uint64_t mask = 0, bit = 1;
  EachNumber(before, now, [&](float was, float is) {
    if (Bits(was) != Bits(is)) mask |= bit;
    bit <<= 1;
  });
  ShortWriterOf<10 + 4 * (1 + 2 * kMostParts)> numbers;
  numbers.Number(mask);
  EachNumber(before, now, [&](float was, float is) {
    if (Bits(was) != Bits(is)) numbers.Fixed32(Bits(is));
  });
  out.Append(numbers.bytes());
}

void PutMovements(BufferedWriter& out, std::uint8_t rig, const Pose& pose) {
  out.Byte(rig);
  if (rig == kModelRig) out.Text(pose.rig->model);
  out.Number(pose.parts.size());
  out.Number(pose.played);
  for (const Pose::Part& part : pose.parts)
    out.Text(part.clip < pose.rig->clips.size() ? std::string_view(pose.rig->clips[part.clip].name()) : "");
  EachNumber(pose, pose, [&](float, float number) { out.Float(number); });
}

/// The file may contain anything, but times, shares and weights must be finite to compute bones.
bool IsSound(const Pose& pose) {
  const auto is_share = [](float number) { return number >= 0 && number <= 1; };
  return is_share(pose.legs) && std::ranges::all_of(pose.parts, [](const Pose::Part& part) {
           return std::isfinite(part.time_s) && std::isfinite(part.weight) && part.weight >= 0;
         });
}

void GetSame(ByteReader& in, Pose& pose) {
  const std::uint64_t mask = in.Number();
  std::uint64_t bit = 1;
  EachNumber(pose, pose, [&](float&, float& number) {
    if ((mask & bit) != 0) number = in.Float();
    bit <<= 1;
  });
  if (mask >= bit) in.Fail();
}

void GetMovements(ByteReader& in, Pose& pose) {
  const std::uint8_t rig = in.Byte();
  pose.rig = RigNumbered(rig);
  if (rig == kModelRig) {
    // The file of the model may be missing in the recording.
    pose.rig = world::FindRig(in.Text());
    if (pose.rig == nullptr) pose.rig = &world::EmptyRig();
  }
  const std::uint64_t count = in.Number(), played = in.Number();
  if (pose.rig == nullptr || count > kMostParts || played > count) return in.Fail();
  pose.parts.resize(static_cast<std::size_t>(count));
  pose.played = static_cast<std::size_t>(played);
  for (Pose::Part& part : pose.parts) {
    // A movement that this program does not have does not influence the bones.
    const int clip = pose.rig->FindClip(in.Text());
    part.clip = static_cast<std::uint32_t>(clip < 0 ? static_cast<int>(pose.rig->clips.size()) : clip);
  }
  EachNumber(pose, pose, [&](float&, float& number) { number = in.Float(); });
}

}  // namespace

void PutBones(BufferedWriter& out, const BodyBones& before, const BodyBones& now) {
  const Pose* const pose = now.pose();
  const std::optional<std::uint8_t> rig = pose == nullptr ? std::nullopt : NumberOf(pose->rig);
  const auto put_form = [&](Form form) { out.Byte(static_cast<std::uint8_t>(form)); };
  if (!rig || pose->parts.size() > kMostParts || !IsSound(*pose)) {
    put_form(Form::kGiven);
    return PutGiven(out, GivenBefore(before), now.value());
  }
  if (before.pose() != nullptr && HasSameMovements(*before.pose(), *pose)) {
    put_form(Form::kSame);
    return PutSame(out, *before.pose(), *pose);
  }
  put_form(Form::kMovements);
  PutMovements(out, *rig, *pose);
}

void GetBones(ByteReader& in, BodyBones& bones) {
  const Form form = in.Kind(Form::kMovements);
  if (form == Form::kGiven) {
    bones = GetGiven(in, GivenBefore(bones));
    return;
  }
  // Bones are computed only when they are needed.
  constexpr std::uint64_t kBytes = 160;
  in.Charge(kBytes);
  Pose pose;
  if (form == Form::kMovements) {
    GetMovements(in, pose);
  } else if (bones.pose() == nullptr) {
    in.Fail();
  } else {
    pose = *bones.pose();
    GetSame(in, pose);
  }
  if (in.failed()) return;
  if (!IsSound(pose)) return in.Fail();
  bones = BodyBones(std::move(pose));
}

bool AreSameBones(const BodyBones& a, const BodyBones& b) {
  if (a.IsSame(b)) return true;
  if (a.empty() || b.empty() || (a.pose() == nullptr) != (b.pose() == nullptr)) return false;
  bool is_same = true;
  if (a.pose() != nullptr) {
    if (!HasSameMovements(*a.pose(), *b.pose())) return false;
    EachNumber(*a.pose(), *b.pose(), [&](float x, float y) { is_same = is_same && Bits(x) == Bits(y); });
    return is_same;
  }
  std::vector<std::uint32_t> of_a, of_b;
  AppendBits(a.value(), of_a);
  AppendBits(b.value(), of_b);
  return of_a == of_b;
}

}  // namespace soarbox::record
