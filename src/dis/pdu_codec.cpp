// SPDX-License-Identifier: BSD-2-Clause
#include "dis/pdu_codec.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <string_view>
#include <type_traits>

#include "diagnostics/name_table.h"

namespace soarbox::dis {
namespace {

constexpr std::size_t kHeaderBytes = 12, kMarkingBytes = 11, kMostTexts = 16, kMostTextBytes = 1024;
/// Maximum distance from the centre of the earth, and maximum of other values such as speeds.
constexpr double kMostCoordinate = 1e8, kMostOther = 1e6;

/// The fields of the standard's records, in their order. An archive is a Writer, which appends the fields to a PDU, or
/// a Reader, which sets them. Called with a PDU that is not const in both cases.
template <class Archive>
void Fields(Archive& archive, EntityId& id) {
  archive.Numbers(id.site, id.application, id.entity);
}
template <class Archive>
void Fields(Archive& archive, EventId& id) {
  archive.Numbers(id.site, id.application, id.number);
}
template <class Archive>
void Fields(Archive& archive, EntityType& type) {
  archive.Numbers(type.kind, type.domain, type.country, type.category, type.subcategory, type.specific, type.extra);
}
template <class Archive>
void Fields(Archive& archive, Burst& burst) {
  Fields(archive, burst.munition);
  archive.Numbers(burst.warhead, burst.fuse, burst.quantity, burst.rate);
}

template <class Archive>
void Fields(Archive& archive, EntityState& state) {
  Fields(archive, state.id);
  archive.Numbers(state.force);
  archive.Zeros(1);  // No articulated parts; those of others follow everything that is read.
  Fields(archive, state.type);
  Fields(archive, state.alternative);
  archive.Floats(state.velocity);
  archive.Doubles(state.position);
  archive.Float(state.orientation.psi);
  archive.Float(state.orientation.theta);
  archive.Float(state.orientation.phi);
  archive.Numbers(state.appearance);
  archive.Enum(state.algorithm);
  archive.Zeros(15);
  archive.Floats(state.acceleration);
  archive.Floats(state.turn);
  std::uint8_t ascii = 1;
  archive.Numbers(ascii);
  archive.Text(state.marking, kMarkingBytes);
  archive.Numbers(state.capabilities);
}

template <class Archive>
void Fields(Archive& archive, Fire& fire) {
  for (EntityId* id : {&fire.shooter, &fire.target, &fire.munition}) Fields(archive, *id);
  Fields(archive, fire.event);
  archive.Numbers(fire.mission);
  archive.Doubles(fire.position);
  Fields(archive, fire.burst);
  archive.Floats(fire.velocity);
  archive.Float(fire.range_m);
}

template <class Archive>
void Fields(Archive& archive, Detonation& hit) {
  for (EntityId* id : {&hit.shooter, &hit.target, &hit.munition}) Fields(archive, *id);
  Fields(archive, hit.event);
  archive.Floats(hit.velocity);
  archive.Doubles(hit.position);
  Fields(archive, hit.burst);
  archive.Floats(hit.position_in_target);
  archive.Numbers(hit.result);
  archive.Zeros(3);  // No articulated parts.
}

template <class Archive>
void Fields(Archive& archive, Collision& collision) {
  Fields(archive, collision.issuer);
  Fields(archive, collision.other);
  Fields(archive, collision.event);
  archive.Numbers(collision.type);
  archive.Zeros(1);
  archive.Floats(collision.velocity);
  archive.Float(collision.mass_kg);
  archive.Floats(collision.position_in_issuer);
}

template <class Archive>
void Fields(Archive& archive, Comment& comment) {
  Fields(archive, comment.from);
  Fields(archive, comment.to);
  archive.Texts(comment.texts);
}

/// Whether the receiver of an order can comply with it.
constexpr std::uint16_t kAble = 1, kUnable = 2;

template <class Archive>
void Fields(Archive& archive, Management& order) {
  Fields(archive, order.from);
  Fields(archive, order.to);
  if (order.type == PduType::kStartResume) archive.Zeros(16);
  if (order.type == PduType::kStopFreeze) {
    archive.Zeros(8);
    archive.Numbers(order.reason);
    archive.Zeros(3);
  }
  if (order.type == PduType::kAcknowledge) {
    std::uint16_t answer = order.is_able ? kAble : kUnable;
    archive.Numbers(order.flag, answer);
    order.is_able = answer != kUnable;
  }
  archive.Numbers(order.request);
}

class Writer {
 public:
  template <class... Number>
  void Numbers(Number... values) {
    (Unsigned(values), ...);
  }
  template <class Number>
  void Enum(Number value) {
    Unsigned(static_cast<std::underlying_type_t<Number>>(value));
  }
  template <class Real>
  void Float(Real value) {
    Unsigned(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }
  void Zeros(std::size_t count) { bytes_.resize(bytes_.size() + count); }
  void Floats(const Vector& v) {
    for (const double part : {v.x, v.y, v.z}) Float(part);
  }
  void Doubles(const Vector& v) {
    for (const double part : {v.x, v.y, v.z}) Unsigned(std::bit_cast<std::uint64_t>(part));
  }
  /// Adds zeros or cuts the text so that it has this size.
  void Text(std::string_view text, std::size_t size) {
    text = text.substr(0, size);
    for (const char c : text) Unsigned(static_cast<std::uint8_t>(c));
    Zeros(size - text.size());
  }
  void Texts(const std::vector<std::string>& texts) {
    Unsigned(std::uint32_t{0});  // No fixed data.
    const std::size_t count = std::min(texts.size(), kMostTexts);
    Unsigned(static_cast<std::uint32_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t size = std::min(texts[i].size(), kMostTextBytes);
      Unsigned(std::uint32_t{0});  // Not one of the standard's kinds.
      Unsigned(static_cast<std::uint32_t>(size * 8));
      Text(texts[i], size);
      Zeros((8 - size % 8) % 8);
    }
  }

  std::vector<std::byte> Take() {
    bytes_[8] = static_cast<std::byte>(bytes_.size() >> 8 & 0xFF);
    bytes_[9] = static_cast<std::byte>(bytes_.size() & 0xFF);
    return std::move(bytes_);
  }

 private:
  template <class Number>
  void Unsigned(Number value) {
    for (int shift = static_cast<int>(sizeof(Number)) * 8 - 8; shift >= 0; shift -= 8)
      bytes_.push_back(static_cast<std::byte>(value >> shift & 0xFF));
  }

  std::vector<std::byte> bytes_;
};

/// Reads fields; keeps the first error.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool ok() const { return ok_; }

  template <class... Number>
  void Numbers(Number&... values) {
    ((values = Unsigned<Number>()), ...);
  }
  template <class Number>
  void Enum(Number& value) {
    value = static_cast<Number>(Unsigned<std::underlying_type_t<Number>>());
  }
  template <class Real>
  void Float(Real& value) {
    const auto number = std::bit_cast<float>(Unsigned<std::uint32_t>());
    value = static_cast<Real>(Checked(static_cast<double>(number), kMostOther));
  }
  /// Bytes that are not needed; others may put something there.
  void Zeros(std::size_t count) {
    ok_ = ok_ && count <= left();
    if (ok_) at_ += count;
  }
  void Floats(Vector& v) {
    for (double* part : {&v.x, &v.y, &v.z}) Float(*part);
  }
  void Doubles(Vector& v) {
    for (double* part : {&v.x, &v.y, &v.z})
      *part = Checked(std::bit_cast<double>(Unsigned<std::uint64_t>()), kMostCoordinate);
  }
  /// The printable part of this number of bytes, up to the first zero.
  void Text(std::string& text, std::size_t size) {
    bool ended = false;
    for (std::size_t i = 0; i < size; ++i) {
      const auto c = Unsigned<std::uint8_t>();
      ended |= c == 0;
      if (!ended) text += c >= 0x20 && c < 0x7F ? static_cast<char>(c) : '?';
    }
  }
  void Texts(std::vector<std::string>& texts) {
    std::uint32_t fixed = 0, variable = 0;
    Numbers(fixed, variable);
    ok_ = ok_ && fixed <= left() / 8 && variable <= kMostTexts;
    Zeros(std::size_t{fixed} * 8);
    for (std::uint32_t i = 0; ok_ && i < variable; ++i) {
      std::uint32_t kind = 0, bits = 0;
      Numbers(kind, bits);
      const std::size_t size = (std::size_t{bits} + 7) / 8;
      ok_ = ok_ && size <= kMostTextBytes && size <= left();
      if (!ok_) break;
      Text(texts.emplace_back(), size);
      Zeros(std::min((8 - size % 8) % 8, left()));
    }
  }

 private:
  std::size_t left() const { return bytes_.size() - at_; }

  template <class Number>
  Number Unsigned() {
    if (left() < sizeof(Number)) {
      ok_ = false;
      return 0;
    }
    Number value = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      value = static_cast<Number>(value << 8 | std::to_integer<Number>(bytes_[at_++]));
    return value;
  }
  double Checked(double value, double most) {
    if (std::isfinite(value) && std::abs(value) <= most) return value;
    ok_ = false;
    return 0;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

/// The PDUs that are read, with their protocol family and minimum size in bytes.
struct Kind {
  PduType type;
  std::uint8_t family;
  std::size_t least_bytes;
  Body (*make)(PduType type);
};
constexpr std::uint8_t kEntityFamily = 1, kWarfareFamily = 2, kManagementFamily = 5;
template <class Part>
Body Make(PduType type) {
  Part part;
  if constexpr (std::is_same_v<Part, Management>) part.type = type;
  return part;
}
constexpr Kind kKinds[] = {
    {PduType::kEntityState, kEntityFamily, 144, Make<EntityState>},
    {PduType::kCollision, kEntityFamily, 60, Make<Collision>},
    {PduType::kFire, kWarfareFamily, 96, Make<Fire>},
    {PduType::kDetonation, kWarfareFamily, 104, Make<Detonation>},
    {PduType::kComment, kManagementFamily, 32, Make<Comment>},
    {PduType::kStartResume, kManagementFamily, 44, Make<Management>},
    {PduType::kStopFreeze, kManagementFamily, 40, Make<Management>},
    {PduType::kAcknowledge, kManagementFamily, 32, Make<Management>},
    {PduType::kCreateEntity, kManagementFamily, 28, Make<Management>},
    {PduType::kRemoveEntity, kManagementFamily, 28, Make<Management>},
};

const Kind& KindOf(const Body& body) {
  const auto* const order = std::get_if<Management>(&body);
  return *std::ranges::find_if(kKinds, [&](const Kind& kind) {
    return order != nullptr ? kind.type == order->type : kind.make(kind.type).index() == body.index();
  });
}

}  // namespace

std::string ToText(const EntityId& id) {
  return std::to_string(id.site) + ":" + std::to_string(id.application) + ":" + std::to_string(id.entity);
}

std::string ToText(const EntityType& type) {
  std::string text = std::to_string(type.kind) + "." + std::to_string(type.domain) + "." + std::to_string(type.country);
  for (const std::uint8_t part : {type.category, type.subcategory, type.specific, type.extra})
    text += "." + std::to_string(part);
  return text;
}

std::string_view Name(Refusal refusal) {
  static constexpr const char* kNames[] = {"too short", "another version", "another kind", "wrong length",
                                           "impossible contents"};
  return NameIn(kNames, refusal);
}

std::vector<std::byte> Encode(Pdu pdu) {
  Writer out;
  const Kind& kind = KindOf(pdu.body);
  out.Numbers(pdu.version, pdu.exercise, static_cast<std::uint8_t>(kind.type), kind.family, pdu.timestamp);
  out.Zeros(4);  // The length, which Take() sets, and the status or padding.
  std::visit([&](auto& body) { Fields(out, body); }, pdu.body);
  return out.Take();
}

std::size_t LengthOf(std::span<const std::byte> bytes) {
  if (bytes.size() < kHeaderBytes) return 0;
  const std::size_t length = std::to_integer<std::size_t>(bytes[8]) << 8 | std::to_integer<std::size_t>(bytes[9]);
  return length < kHeaderBytes || length > bytes.size() ? 0 : length;
}

std::variant<Pdu, Refusal> Decode(std::span<const std::byte> bytes) {
  const std::size_t length = LengthOf(bytes);
  if (length == 0) return Refusal::kTooShort;
  Reader in(bytes.first(length));
  Pdu pdu;
  std::uint8_t type = 0, family = 0;  // The family follows from the type.
  in.Numbers(pdu.version, pdu.exercise, type, family, pdu.timestamp);
  in.Zeros(4);
  if (pdu.version != 6 && pdu.version != 7) return Refusal::kVersion;
  const auto* const kind = std::ranges::find(kKinds, static_cast<PduType>(type), &Kind::type);
  if (kind == std::end(kKinds)) return Refusal::kOtherKind;
  if (length < kind->least_bytes) return Refusal::kBadLength;
  pdu.body = kind->make(kind->type);
  std::visit([&](auto& body) { Fields(in, body); }, pdu.body);
  if (!in.ok()) return Refusal::kBadContents;
  return pdu;
}

}  // namespace soarbox::dis
