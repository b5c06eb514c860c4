// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/semantic_records.h"

#include <algorithm>
#include <vector>

#include "bytes/byte_stream.h"

namespace soarbox::kernel::records {
namespace {

enum class Kind : std::uint8_t {
  kImage = 1,
  kObject,
  kNewObject,
  kAdd,
  kRemove,
  kAlias,
  kTouch,
  kClear,
  kTouchNoAdvance,
  kNextNumber,
  kWeights
};
/// From version 2 on, images end with the weights of links.
constexpr std::uint8_t kImageVersion = 2;

std::string OfNumber(Kind kind, Lti number) {
  std::string bytes;
  ByteWriter out(bytes);
  out.Byte(static_cast<std::uint8_t>(kind));
  out.Number(number);
  return bytes;
}

void WriteTerm(ByteWriter& out, const Knowledge& knowledge, StoreTerm term) {
  out.Byte(static_cast<std::uint8_t>(term.kind()));
  switch (term.kind()) {
    case TermKind::kString:
      out.Text(knowledge.terms().Text(term));
      break;
    case TermKind::kInteger:
      out.Fixed64(static_cast<std::uint64_t>(knowledge.terms().IntegerValue(term)));
      break;
    case TermKind::kFloat:
      out.Double(knowledge.terms().FloatValue(term));
      break;
    case TermKind::kObject:
      out.Number(knowledge.NumberAt(term.index()));
      break;
  }
}

StoreTerm ReadTerm(ByteReader& in, Knowledge& knowledge, bool may_be_object) {
  switch (static_cast<TermKind>(in.Byte())) {
    case TermKind::kString:
      return knowledge.terms().String(in.Text());
    case TermKind::kInteger:
      return knowledge.terms().Integer(static_cast<std::int64_t>(in.Fixed64()));
    case TermKind::kFloat:
      return knowledge.terms().Float(in.Double());
    case TermKind::kObject: {
      const Lti number = in.Number();
      if (may_be_object && number != 0 && !in.failed()) return StoreTerm::Object(knowledge.FindOrAdd(number));
      break;
    }
  }
  in.Fail();
  return {};
}

}  // namespace

std::string Object(Lti number) {
  return OfNumber(Kind::kObject, number);
}
std::string NewObject(Lti number) {
  return OfNumber(Kind::kNewObject, number);
}
std::string NextNumber(Lti number) {
  return OfNumber(Kind::kNextNumber, number);
}
std::string Touch(Lti number, bool advance) {
  return OfNumber(advance ? Kind::kTouch : Kind::kTouchNoAdvance, number);
}

std::string Clear() {
  return {static_cast<char>(Kind::kClear)};
}

std::string Edge(const Knowledge& knowledge, std::uint32_t object, StoreTerm attribute, StoreTerm value, bool added) {
  std::string bytes;
  ByteWriter out(bytes);
  out.Byte(static_cast<std::uint8_t>(added ? Kind::kAdd : Kind::kRemove));
  out.Number(knowledge.NumberAt(object));
  WriteTerm(out, knowledge, attribute);
  WriteTerm(out, knowledge, value);
  return bytes;
}

std::string Alias(std::string_view name, Lti number) {
  std::string bytes;
  ByteWriter out(bytes);
  out.Byte(static_cast<std::uint8_t>(Kind::kAlias));
  out.Text(name);
  out.Number(number);
  return bytes;
}

std::string Weights(const Knowledge& knowledge, std::uint32_t object, const LinkWeights::Weights& weights) {
  std::string bytes;
  ByteWriter out(bytes);
  out.Byte(static_cast<std::uint8_t>(Kind::kWeights));
  out.Number(knowledge.NumberAt(object));
  out.Number(weights.size());
  for (const auto& [linked, weight] : weights) {
    out.Number(knowledge.NumberAt(linked));
    out.Double(weight);
  }
  return bytes;
}

bool Apply(std::string_view record, Knowledge& knowledge, Activations& activations, LinkWeights& weights) {
  ByteReader in(record);
  switch (static_cast<Kind>(in.Byte())) {
    case Kind::kObject:
    case Kind::kNewObject: {
      const bool is_new = record[0] == static_cast<char>(Kind::kNewObject);
      const Lti number = in.Number();
      if (in.failed() || number == 0) return false;
      knowledge.FindOrAdd(number);
      if (is_new) knowledge.set_next_number(number + 1);
      return true;
    }
    case Kind::kAdd:
    case Kind::kRemove: {
      const bool adds = record[0] == static_cast<char>(Kind::kAdd);
      const Lti number = in.Number();
      if (in.failed() || number == 0) return false;
      const std::uint32_t object = knowledge.FindOrAdd(number);
      const StoreTerm attribute = ReadTerm(in, knowledge, false);
      const StoreTerm value = ReadTerm(in, knowledge, true);
      if (in.failed()) return false;
      if (value.IsObject()) weights.Forget(object);
      return adds ? knowledge.AddEdge(object, attribute, value) : knowledge.RemoveEdge(object, attribute, value);
    }
    case Kind::kNextNumber: {
      const Lti number = in.Number();
      if (in.failed() || number == 0) return false;
      knowledge.set_next_number(number);
      return true;
    }
    case Kind::kAlias: {
      const std::string_view name = in.Text();
      const Lti number = in.Number();
      if (in.failed() || number == 0) return false;
      knowledge.SetAlias(name, number);
      return true;
    }
    case Kind::kTouch:
    case Kind::kTouchNoAdvance: {
      const std::uint32_t object = knowledge.Find(in.Number());
      if (in.failed() || object == Knowledge::kNowhere) return false;
      activations.Touch(object, record[0] == static_cast<char>(Kind::kTouch));
      return true;
    }
    case Kind::kClear:
      knowledge.Clear();
      activations.Clear();
      weights.Clear();
      return true;
    case Kind::kWeights: {
      const std::uint32_t object = knowledge.Find(in.Number());
      LinkWeights::Weights links;
      for (std::uint64_t n = in.Number(); n > 0 && !in.failed(); --n) {
        const std::uint32_t linked = knowledge.Find(in.Number());
        links[linked] = in.Double();
      }
      return !in.failed() && object != Knowledge::kNowhere && weights.Set(knowledge, object, std::move(links));
    }
    case Kind::kImage:
      break;
  }
  return false;
}

std::string Image(const Knowledge& knowledge, const Activations& activations, const LinkWeights& weights) {
  std::string bytes;
  ByteWriter out(bytes);
  out.Byte(static_cast<std::uint8_t>(Kind::kImage));
  out.Byte(kImageVersion);
  out.Number(knowledge.next_number());
  out.Number(knowledge.object_count());
  for (std::uint32_t place = 0; place < knowledge.object_count(); ++place) out.Number(knowledge.NumberAt(place));
  // In order of creation, because rows decide ties.
  struct Entry {
    std::uint32_t row, object;
    StoreTerm attribute, value;
  };
  std::vector<Entry> entries;
  entries.reserve(knowledge.edge_count());
  for (std::uint32_t place = 0; place < knowledge.object_count(); ++place) {
    for (const kernel::Edge& edge : knowledge.EdgesAt(place)) {
      entries.push_back({edge.row, place, edge.attribute, edge.value});
    }
  }
  std::ranges::sort(entries, {}, &Entry::row);
  // Each constant once, in order of first use in the store.
  FlatMap noted;
  std::vector<StoreTerm> constants;
  const auto note = [&](StoreTerm term) {
    if (term.IsObject()) return;
    const auto next = static_cast<std::uint32_t>(constants.size());
    if (noted.FindOrAdd(term.bits(), next) == next) constants.push_back(term);
  };
  for (const Entry& entry : entries) {
    note(entry.attribute);
    note(entry.value);
  }
  std::ranges::sort(constants, {}, [&](StoreTerm term) { return knowledge.terms().Order(term); });
  FlatMap places;
  for (const StoreTerm term : constants) places.FindOrAdd(term.bits(), static_cast<std::uint32_t>(places.size()));
  out.Number(constants.size());
  for (const StoreTerm term : constants) WriteTerm(out, knowledge, term);
  out.Number(entries.size());
  const auto write = [&](StoreTerm term) {
    out.Number(term.IsObject() ? 2 * std::uint64_t{term.index()} + 1 : 2 * std::uint64_t{places.Find(term.bits())});
  };
  for (const Entry& entry : entries) {
    out.Number(entry.object);
    write(entry.attribute);
    write(entry.value);
  }
  const auto aliases = knowledge.Aliases();
  out.Number(aliases.size());
  for (const auto& [name, number] : aliases) {
    out.Text(name);
    out.Number(number);
  }
  out.Number(activations.tick());
  out.Number(activations.records().size());
  for (const Activations::Touched& touched : activations.records()) {
    out.Number(touched.object);
    out.Byte(touched.forget_last ? 1 : 0);
    out.Double(touched.activation);
    out.Number(touched.count);
    out.Number(touched.first);
    for (std::size_t n = 0; n < std::min<std::size_t>(touched.count, Activations::kHistory); ++n) {
      out.Number(touched.ticks[n]);
    }
  }
  std::vector<std::uint32_t> weighted;
  for (std::uint32_t place = 0; place < knowledge.object_count(); ++place) {
    if (weights.Known(place) != nullptr) weighted.push_back(place);
  }
  out.Number(weighted.size());
  for (const std::uint32_t place : weighted) {
    const LinkWeights::Weights& links = *weights.Known(place);
    out.Number(place);
    out.Number(links.size());
    for (const auto& [linked, weight] : links) {
      out.Number(linked);
      out.Double(weight);
    }
  }
  return bytes;
}

bool ReadImage(std::string_view image, Knowledge& knowledge, Activations& activations, LinkWeights& weights) {
  ByteReader in(image);
  if (in.Byte() != static_cast<std::uint8_t>(Kind::kImage)) return false;
  const std::uint8_t version = in.Byte();
  if (version == 0 || version > kImageVersion) return false;
  const Lti next_number = in.Number();
  const std::uint64_t objects = in.Number();
  for (std::uint64_t n = 0; n < objects && !in.failed(); ++n) {
    const Lti number = in.Number();
    if (number == 0 || knowledge.FindOrAdd(number) != n) return false;
  }
  std::vector<StoreTerm> constants;
  for (std::uint64_t n = in.Number(); n > 0 && !in.failed(); --n) constants.push_back(ReadTerm(in, knowledge, false));
  const auto read = [&]() -> StoreTerm {
    const std::uint64_t word = in.Number();
    const std::uint64_t index = word / 2;
    if (word % 2 == 1 && index < objects) return StoreTerm::Object(static_cast<std::uint32_t>(index));
    if (word % 2 == 0 && index < constants.size()) return constants[index];
    in.Fail();
    return {};
  };
  for (std::uint64_t n = in.Number(); n > 0 && !in.failed(); --n) {
    const std::uint64_t object = in.Number();
    const StoreTerm attribute = read();
    const StoreTerm value = read();
    if (in.failed() || object >= objects || attribute.IsObject()) return false;
    if (!knowledge.AddEdge(static_cast<std::uint32_t>(object), attribute, value)) return false;
  }
  for (std::uint64_t n = in.Number(); n > 0 && !in.failed(); --n) {
    const std::string_view name = in.Text();
    const Lti number = in.Number();
    if (!in.failed()) knowledge.SetAlias(name, number);
  }
  const std::uint64_t tick = in.Number();
  std::vector<Activations::Touched> touched;
  for (std::uint64_t n = in.Number(); n > 0 && !in.failed(); --n) {
    Activations::Touched record;
    const std::uint64_t object = in.Number();
    if (object >= objects) return false;
    record.object = static_cast<std::uint32_t>(object);
    record.forget_last = in.Byte() != 0;
    record.activation = in.Double();
    record.count = in.Number();
    record.first = in.Number();
    for (std::size_t k = 0; k < std::min<std::size_t>(record.count, Activations::kHistory); ++k) {
      record.ticks[k] = in.Number();
      if (record.ticks[k] > tick + 1) return false;
    }
    if (record.first > tick + 1) return false;
    touched.push_back(record);
  }
  for (std::uint64_t n = version < 2 ? 0 : in.Number(); n > 0 && !in.failed(); --n) {
    const std::uint64_t object = in.Number();
    LinkWeights::Weights links;
    for (std::uint64_t left = in.Number(); left > 0 && !in.failed(); --left) {
      const std::uint64_t linked = in.Number();
      links[static_cast<std::uint32_t>(linked)] = in.Double();
    }
    if (in.failed() || object >= objects) return false;
    if (!weights.Set(knowledge, static_cast<std::uint32_t>(object), std::move(links))) return false;
  }
  if (in.failed() || !in.AtEnd()) return false;
  if (next_number == 0) return false;
  knowledge.set_next_number(next_number);
  activations.Restore(tick, touched);
  return true;
}

}  // namespace soarbox::kernel::records
