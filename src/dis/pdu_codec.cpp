// SPDX-License-Identifier: BSD-2-Clause
#include "dis/pdu_codec.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "diagnostics/name_table.h"

namespace soarbox::dis {
namespace {

constexpr std::size_t kHeaderBytes = 12, kMarkingBytes = 11, kMostTexts = 16, kMostTextBytes = 1024;
/// Maximum distance from the centre of the earth, and maximum of other values such as speeds.
constexpr double kMostCoordinate = 1e8, kMostOther = 1e6;

class Writer {
 public:
  template <class Number>
  void Unsigned(Number value) {
    for (int shift = static_cast<int>(sizeof(Number)) * 8 - 8; shift >= 0; shift -= 8)
      bytes_.push_back(static_cast<std::byte>(value >> shift & 0xFF));
  }
  void Byte(std::uint8_t value) { bytes_.push_back(static_cast<std::byte>(value)); }
  void Float(double value) { Unsigned(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  void Double(double value) { Unsigned(std::bit_cast<std::uint64_t>(value)); }
  void Zeros(std::size_t count) { bytes_.resize(bytes_.size() + count); }
  void Floats(const Vector& v) {
    for (const double part : {v.x, v.y, v.z}) Float(part);
  }
  void Doubles(const Vector& v) {
    for (const double part : {v.x, v.y, v.z}) Double(part);
  }
  void Id(const EntityId& id) {
    for (const std::uint16_t part : {id.site, id.application, id.entity}) Unsigned(part);
  }
  void Event(const EventId& id) {
    for (const std::uint16_t part : {id.site, id.application, id.number}) Unsigned(part);
  }
  void Type(const EntityType& type) {
    Byte(type.kind);
    Byte(type.domain);
    Unsigned(type.country);
    for (const std::uint8_t part : {type.category, type.subcategory, type.specific, type.extra}) Byte(part);
  }
  void BurstOf(const Burst& burst) {
    Type(burst.munition);
    for (const std::uint16_t part : {burst.warhead, burst.fuse, burst.quantity, burst.rate}) Unsigned(part);
  }

  std::vector<std::byte> Take() {
    bytes_[8] = static_cast<std::byte>(bytes_.size() >> 8 & 0xFF);
    bytes_[9] = static_cast<std::byte>(bytes_.size() & 0xFF);
    return std::move(bytes_);
  }

 private:
  std::vector<std::byte> bytes_;
};

/// Whether the receiver of an order can comply with it.
constexpr std::uint16_t kAble = 1, kUnable = 2;
/// Protocol families of the kinds of PDUs.
constexpr std::uint8_t kEntityFamily = 1, kWarfareFamily = 2, kManagementFamily = 5;

std::pair<PduType, std::uint8_t> KindOf(const Body& body) {
  if (std::holds_alternative<EntityState>(body)) return {PduType::kEntityState, kEntityFamily};
  if (std::holds_alternative<Collision>(body)) return {PduType::kCollision, kEntityFamily};
  if (std::holds_alternative<Fire>(body)) return {PduType::kFire, kWarfareFamily};
  if (std::holds_alternative<Detonation>(body)) return {PduType::kDetonation, kWarfareFamily};
  if (std::holds_alternative<Comment>(body)) return {PduType::kComment, kManagementFamily};
  return {std::get<Management>(body).type, kManagementFamily};
}

struct BodyWriter {
  Writer& out;

  void operator()(const EntityState& state) const {
    out.Id(state.id);
    out.Byte(state.force);
    out.Byte(0);  // No articulated parts.
    out.Type(state.type);
    out.Type(state.alternative);
    out.Floats(state.velocity);
    out.Doubles(state.position);
    for (const double angle : {state.orientation.psi, state.orientation.theta, state.orientation.phi}) out.Float(angle);
    out.Unsigned(state.appearance);
    out.Byte(static_cast<std::uint8_t>(state.algorithm));
    out.Zeros(15);
    out.Floats(state.acceleration);
    out.Floats(state.turn);
    out.Byte(1);  // The marking is ASCII.
    for (std::size_t i = 0; i < kMarkingBytes; ++i)
      out.Byte(i < state.marking.size() ? static_cast<std::uint8_t>(state.marking[i]) : 0);
    out.Unsigned(state.capabilities);
  }
  void operator()(const Fire& fire) const {
    for (const EntityId& id : {fire.shooter, fire.target, fire.munition}) out.Id(id);
    out.Event(fire.event);
    out.Unsigned(fire.mission);
    out.Doubles(fire.position);
    out.BurstOf(fire.burst);
    out.Floats(fire.velocity);
    out.Float(static_cast<double>(fire.range_m));
  }
  void operator()(const Detonation& hit) const {
    for (const EntityId& id : {hit.shooter, hit.target, hit.munition}) out.Id(id);
    out.Event(hit.event);
    out.Floats(hit.velocity);
    out.Doubles(hit.position);
    out.BurstOf(hit.burst);
    out.Floats(hit.position_in_target);
    out.Byte(hit.result);
    out.Byte(0);  // No articulated parts.
    out.Zeros(2);
  }
  void operator()(const Collision& collision) const {
    out.Id(collision.issuer);
    out.Id(collision.other);
    out.Event(collision.event);
    out.Byte(collision.type);
    out.Zeros(1);
    out.Floats(collision.velocity);
    out.Float(static_cast<double>(collision.mass_kg));
    out.Floats(collision.position_in_issuer);
  }
  void operator()(const Comment& comment) const {
    out.Id(comment.from);
    out.Id(comment.to);
    out.Unsigned(std::uint32_t{0});  // No fixed data.
    const std::size_t count = std::min(comment.texts.size(), kMostTexts);
    out.Unsigned(static_cast<std::uint32_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
      const std::string_view text = std::string_view(comment.texts[i]).substr(0, kMostTextBytes);
      out.Unsigned(std::uint32_t{0});  // Not one of the standard's kinds.
      out.Unsigned(static_cast<std::uint32_t>(text.size() * 8));
      for (const char c : text) out.Byte(static_cast<std::uint8_t>(c));
      out.Zeros((8 - text.size() % 8) % 8);
    }
  }
  void operator()(const Management& order) const {
    out.Id(order.from);
    out.Id(order.to);
    switch (order.type) {
      case PduType::kStartResume:
        out.Zeros(16);
        break;
      case PduType::kStopFreeze:
        out.Zeros(8);
        out.Byte(order.reason);
        out.Zeros(3);
        break;
      case PduType::kAcknowledge:
        out.Unsigned(order.flag);
        out.Unsigned(order.is_able ? kAble : kUnable);
        break;
      default:
        break;
    }
    out.Unsigned(order.request);
  }
};

/// Reads fields; keeps the first error.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool ok() const { return ok_; }
  void Fail() { ok_ = false; }
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
  std::uint8_t Byte() {
    if (left() == 0) {
      ok_ = false;
      return 0;
    }
    return std::to_integer<std::uint8_t>(bytes_[at_++]);
  }
  double Float(double most = kMostOther) {
    return Checked(static_cast<double>(std::bit_cast<float>(Unsigned<std::uint32_t>())), most);
  }
  double Double() { return Checked(std::bit_cast<double>(Unsigned<std::uint64_t>()), kMostCoordinate); }
  void Skip(std::size_t count) {
    ok_ = ok_ && count <= left();
    if (ok_) at_ += count;
  }
  Vector Floats() {
    Vector v;
    for (double* part : {&v.x, &v.y, &v.z}) *part = Float();
    return v;
  }
  Vector Doubles() {
    Vector v;
    for (double* part : {&v.x, &v.y, &v.z}) *part = Double();
    return v;
  }
  EntityId Id() {
    EntityId id;
    for (std::uint16_t* part : {&id.site, &id.application, &id.entity}) *part = Unsigned<std::uint16_t>();
    return id;
  }
  EventId Event() {
    EventId id;
    for (std::uint16_t* part : {&id.site, &id.application, &id.number}) *part = Unsigned<std::uint16_t>();
    return id;
  }
  EntityType Type() {
    EntityType type;
    type.kind = Byte();
    type.domain = Byte();
    type.country = Unsigned<std::uint16_t>();
    for (std::uint8_t* part : {&type.category, &type.subcategory, &type.specific, &type.extra}) *part = Byte();
    return type;
  }
  Burst BurstOf() {
    Burst burst;
    burst.munition = Type();
    for (std::uint16_t* part : {&burst.warhead, &burst.fuse, &burst.quantity, &burst.rate})
      *part = Unsigned<std::uint16_t>();
    return burst;
  }
  /// The printable part of this number of bytes, up to the first zero.
  std::string Text(std::size_t size) {
    std::string text;
    bool ended = false;
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint8_t c = Byte();
      ended |= c == 0;
      if (!ended) text += c >= 0x20 && c < 0x7F ? static_cast<char>(c) : '?';
    }
    return text;
  }

 private:
  double Checked(double value, double most) {
    if (std::isfinite(value) && std::abs(value) <= most) return value;
    ok_ = false;
    return 0;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

EntityState ReadEntityState(Reader& in) {
  EntityState state;
  state.id = in.Id();
  state.force = in.Byte();
  in.Byte();  // Articulated parts follow everything that is read.
  state.type = in.Type();
  state.alternative = in.Type();
  state.velocity = in.Floats();
  state.position = in.Doubles();
  for (double* angle : {&state.orientation.psi, &state.orientation.theta, &state.orientation.phi}) *angle = in.Float();
  state.appearance = in.Unsigned<std::uint32_t>();
  state.algorithm = static_cast<DeadReckoning>(in.Byte());
  in.Skip(15);
  state.acceleration = in.Floats();
  state.turn = in.Floats();
  in.Byte();  // The character set.
  state.marking = in.Text(kMarkingBytes);
  state.capabilities = in.Unsigned<std::uint32_t>();
  return state;
}

Fire ReadFire(Reader& in) {
  Fire fire;
  for (EntityId* id : {&fire.shooter, &fire.target, &fire.munition}) *id = in.Id();
  fire.event = in.Event();
  fire.mission = in.Unsigned<std::uint32_t>();
  fire.position = in.Doubles();
  fire.burst = in.BurstOf();
  fire.velocity = in.Floats();
  fire.range_m = static_cast<float>(in.Float());
  return fire;
}

Detonation ReadDetonation(Reader& in) {
  Detonation hit;
  for (EntityId* id : {&hit.shooter, &hit.target, &hit.munition}) *id = in.Id();
  hit.event = in.Event();
  hit.velocity = in.Floats();
  hit.position = in.Doubles();
  hit.burst = in.BurstOf();
  hit.position_in_target = in.Floats();
  hit.result = in.Byte();
  in.Skip(3);
  return hit;
}

Collision ReadCollision(Reader& in) {
  Collision collision;
  collision.issuer = in.Id();
  collision.other = in.Id();
  collision.event = in.Event();
  collision.type = in.Byte();
  in.Skip(1);
  collision.velocity = in.Floats();
  collision.mass_kg = static_cast<float>(in.Float());
  collision.position_in_issuer = in.Floats();
  return collision;
}

Comment ReadComment(Reader& in) {
  Comment comment;
  comment.from = in.Id();
  comment.to = in.Id();
  const auto fixed = in.Unsigned<std::uint32_t>(), variable = in.Unsigned<std::uint32_t>();
  if (fixed > in.left() / 8 || variable > kMostTexts) in.Fail();
  if (in.ok()) in.Skip(std::size_t{fixed} * 8);
  for (std::uint32_t i = 0; in.ok() && i < variable; ++i) {
    in.Unsigned<std::uint32_t>();  // The kind of text.
    const std::size_t size = (std::size_t{in.Unsigned<std::uint32_t>()} + 7) / 8;
    if (size > kMostTextBytes || size > in.left()) in.Fail();
    if (!in.ok()) break;
    comment.texts.push_back(in.Text(size));
    in.Skip(std::min((8 - size % 8) % 8, in.left()));
  }
  return comment;
}

Management ReadManagement(Reader& in, PduType type) {
  Management order;
  order.type = type;
  order.from = in.Id();
  order.to = in.Id();
  if (type == PduType::kStartResume) in.Skip(16);
  if (type == PduType::kStopFreeze) {
    in.Skip(8);
    order.reason = in.Byte();
    in.Skip(3);
  }
  if (type == PduType::kAcknowledge) {
    order.flag = in.Unsigned<std::uint16_t>();
    order.is_able = in.Unsigned<std::uint16_t>() != kUnable;
  }
  order.request = in.Unsigned<std::uint32_t>();
  return order;
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

std::vector<std::byte> Encode(const Pdu& pdu) {
  Writer out;
  const auto [type, family] = KindOf(pdu.body);
  out.Byte(pdu.version);
  out.Byte(pdu.exercise);
  out.Byte(static_cast<std::uint8_t>(type));
  out.Byte(family);
  out.Unsigned(pdu.timestamp);
  out.Zeros(4);  // The length, which Take() sets, and the status or padding.
  std::visit(BodyWriter{out}, pdu.body);
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
  pdu.version = in.Byte();
  if (pdu.version != 6 && pdu.version != 7) return Refusal::kVersion;
  pdu.exercise = in.Byte();
  const auto type = static_cast<PduType>(in.Byte());
  in.Byte();  // The family follows from the type.
  pdu.timestamp = in.Unsigned<std::uint32_t>();
  in.Skip(4);
  std::size_t least = 0;
  const auto wants = [&](std::size_t size) {
    least = size;
    return length >= size;
  };
  switch (type) {
    case PduType::kEntityState:
      if (wants(144)) pdu.body = ReadEntityState(in);
      break;
    case PduType::kFire:
      if (wants(96)) pdu.body = ReadFire(in);
      break;
    case PduType::kDetonation:
      if (wants(104)) pdu.body = ReadDetonation(in);
      break;
    case PduType::kCollision:
      if (wants(60)) pdu.body = ReadCollision(in);
      break;
    case PduType::kComment:
      if (wants(32)) pdu.body = ReadComment(in);
      break;
    case PduType::kStartResume:
      if (wants(44)) pdu.body = ReadManagement(in, type);
      break;
    case PduType::kStopFreeze:
      if (wants(40)) pdu.body = ReadManagement(in, type);
      break;
    case PduType::kAcknowledge:
      if (wants(32)) pdu.body = ReadManagement(in, type);
      break;
    case PduType::kCreateEntity:
    case PduType::kRemoveEntity:
      if (wants(28)) pdu.body = ReadManagement(in, type);
      break;
    default:
      return Refusal::kOtherKind;
  }
  if (length < least) return Refusal::kBadLength;
  if (!in.ok()) return Refusal::kBadContents;
  return pdu;
}

}  // namespace soarbox::dis
