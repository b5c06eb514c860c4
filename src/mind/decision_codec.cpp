// SPDX-License-Identifier: BSD-2-Clause
#include "mind/decision_codec.h"

#include <cstddef>

#include "bytes/byte_stream.h"
#include "mind/field_writer.h"

namespace soarbox::mind {
namespace {

class In : public ByteReader {
 public:
  using ByteReader::ByteReader;

  /// An index below `end`, or none.
  std::uint32_t Place(std::size_t end) {
    const std::uint64_t value = Number();
    if (value > end) Fail();
    return value == 0 || failed() ? Decision::kNoOperator : static_cast<std::uint32_t>(value - 1);
  }
};

// The input may be anything. Real decisions are far below these limits.
constexpr std::size_t kMostBytes = 4u << 20;
constexpr std::size_t kMostNamed = 16u << 20;  ///< Total bytes of names, counted for each reference.
constexpr std::size_t kMostCauses = 1u << 16;  ///< How far the sum of Drop::count may exceed the size of `by`.

bool HasReferent(PreferenceKind kind) {
  return kind == PreferenceKind::kBetter || kind == PreferenceKind::kWorse || kind == PreferenceKind::kEqual;
}

/// Whether processing and describing the decision takes a limited amount of time and memory.
bool IsModest(const Decision& decision) {
  std::size_t named = 0, causes = 0, dominated = 0;
  const auto name = [&](std::uint32_t op) {
    named += decision.operators[op].id.size() + decision.operators[op].name.size();
  };
  for (const Decision::Preference& preference : decision.preferences) {
    name(preference.op);
    if (HasReferent(preference.kind)) name(preference.referent);
  }
  for (const Decision::Chance& chance : decision.left) name(chance.op);
  for (const Decision::Drop& drop : decision.drops) {
    name(drop.op);
    causes += drop.count;
    if (drop.stage == Stage::kDominated) dominated += drop.count;
  }
  // Each dominated operator has separate preferences.
  return named <= kMostNamed && causes <= decision.by.size() + kMostCauses && dominated <= decision.by.size();
}

}  // namespace

template <typename Text>
PackedOperators Pack(const DecisionOf<Text>& decision, std::string& bytes) {
  constexpr std::size_t kNumber = FieldWriter::kMostOfNumber;
  std::size_t most = 8 * kNumber + (decision.by.size() + 3 * decision.left.size()) * kNumber;
  for (const auto& op : decision.operators) most += 2 * kNumber + op.id.size() + op.name.size();
  for (const auto& preference : decision.preferences) most += 5 * kNumber + preference.rule.size();
  most += 5 * kNumber * decision.drops.size();
  const std::size_t before = bytes.size();
  bytes.resize(before + most);

  FieldWriter out(bytes.data() + before);
  const auto put = [&out](auto value) { out("", value); };
  const auto put_place = [&out](std::uint32_t value) {  // Or none, stored as 0.
    out.Number(value == Decision::kNoOperator ? 0 : std::uint64_t{value} + 1);
  };
  put(decision.impasse);
  put(decision.policy);
  out.Byte(static_cast<std::uint8_t>((decision.is_forced ? 1 : 0) | (decision.has_changed ? 2 : 0)));
  out.Number(decision.operators.size());
  PackedOperators operators;
  operators.begin = static_cast<std::size_t>(out.at() - bytes.data());
  for (const auto& op : decision.operators) {
    put(std::string_view(op.id));
    put(std::string_view(op.name));
  }
  operators.end = static_cast<std::size_t>(out.at() - bytes.data());
  put_place(decision.selected);
  out.Number(decision.preferences.size());
  for (const auto& preference : decision.preferences) {
    put(preference.kind);
    put_place(preference.op);
    if (HasReferent(preference.kind)) put_place(preference.referent);
    if (preference.kind == PreferenceKind::kNumeric) put(preference.number);
    put(std::string_view(preference.rule));
  }
  out.Number(decision.by.size());
  for (const std::uint32_t place : decision.by) put_place(place);
  out.Number(decision.drops.size());
  for (const auto& drop : decision.drops) {
    put_place(drop.op);
    put(drop.stage);
    put(drop.decisive);
    out.Number(drop.first);
    out.Number(drop.count);
  }
  out.Number(decision.left.size());
  for (const auto& chance : decision.left) {
    put_place(chance.op);
    put(chance.value);
    put(chance.probability);
  }
  bytes.resize(static_cast<std::size_t>(out.at() - bytes.data()));
  return operators;
}

template PackedOperators Pack(const Decision& decision, std::string& bytes);
template PackedOperators Pack(const DecisionView& decision, std::string& bytes);

std::optional<Decision> Unpack(std::string_view bytes) {
  if (bytes.size() > kMostBytes) return std::nullopt;
  In in(bytes);
  Decision decision;
  decision.impasse = in.Kind(Impasse::kConstraintFailure);
  decision.policy = in.Kind(Policy::kLast);
  const std::uint8_t flags = in.Byte();
  decision.is_forced = (flags & 1) != 0;
  decision.has_changed = (flags & 2) != 0;
  if (flags > 3) return std::nullopt;
  decision.operators.resize(in.Count(2));
  for (Decision::Operator& op : decision.operators) {
    op.id = in.Text();
    op.name = in.Text();
  }
  const std::size_t operators = decision.operators.size();
  decision.selected = in.Place(operators);
  decision.preferences.resize(in.Count(3));
  for (Decision::Preference& preference : decision.preferences) {
    preference.kind = in.Kind(PreferenceKind::kEqual);
    preference.op = in.Place(operators);
    if (HasReferent(preference.kind)) preference.referent = in.Place(operators);
    if (preference.kind == PreferenceKind::kNumeric) preference.number = in.Double();
    preference.rule = in.Text();
  }
  decision.by.resize(in.Count(1));
  for (std::uint32_t& place : decision.by) {
    place = in.Place(decision.preferences.size());
    if (place == Decision::kNoOperator) return std::nullopt;
  }
  decision.drops.resize(in.Count(5));
  for (Decision::Drop& drop : decision.drops) {
    drop.op = in.Place(operators);
    drop.stage = in.Kind(Stage::kWorst);
    drop.decisive = in.Kind(Decisive::kNo);
    const std::uint64_t first = in.Number(), count = in.Number();
    const std::size_t most = decision.by.size();
    if (drop.op == Decision::kNoOperator || first > most || count > most - first) return std::nullopt;
    drop.first = static_cast<std::uint32_t>(first);
    drop.count = static_cast<std::uint32_t>(count);
  }
  decision.left.resize(in.Count(17));
  for (Decision::Chance& chance : decision.left) {
    chance.op = in.Place(operators);
    chance.value = in.Double();
    chance.probability = in.Double();
    if (chance.op == Decision::kNoOperator) return std::nullopt;
  }
  for (const Decision::Preference& preference : decision.preferences) {
    if (preference.op == Decision::kNoOperator) return std::nullopt;
    if (HasReferent(preference.kind) && preference.referent == Decision::kNoOperator) return std::nullopt;
  }
  if (in.failed() || !in.AtEnd() || !IsModest(decision)) return std::nullopt;
  return decision;
}

Decision Owned(const DecisionView& from) {
  Decision to;
  to.impasse = from.impasse;
  to.selected = from.selected;
  to.is_forced = from.is_forced;
  to.has_changed = from.has_changed;
  to.policy = from.policy;
  for (const DecisionView::Operator& op : from.operators)
    to.operators.push_back({std::string(op.id), std::string(op.name)});
  for (const DecisionView::Preference& p : from.preferences)
    to.preferences.push_back({p.kind, p.op, p.referent, p.number, std::string(p.rule)});
  for (const DecisionView::Drop& drop : from.drops)
    to.drops.push_back({drop.op, drop.stage, drop.decisive, drop.first, drop.count});
  to.by = from.by;
  for (const DecisionView::Chance& chance : from.left) to.left.push_back({chance.op, chance.value, chance.probability});
  return to;
}

}  // namespace soarbox::mind
