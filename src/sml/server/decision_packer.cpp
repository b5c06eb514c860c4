// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/decision_packer.h"

#include <bit>
#include <cstring>

#include "mind/decision_codec.h"
#include "mind/field_writer.h"

namespace soarbox::server {
namespace {

bool IsAlone(const kernel::DecisionReport& report) {
  return report.preferences.size() == 1 && report.preferences[0].type == kernel::PreferenceType::kAcceptable &&
         report.selected == report.preferences[0].value && report.candidates.size() == 1 && !report.is_forced;
}

}  // namespace

std::uint64_t DecisionPacker::PlaceOf(kernel::Symbol op) {
  for (std::size_t place = 0; place < operators_.size(); ++place)
    if (operators_[place].op == op) return place;
  operators_.push_back({op});
  return operators_.size() - 1;
}

/// Sets operators_ (without their texts), key_ and rules_.
void DecisionPacker::ReadKey(const kernel::Agent& agent, const kernel::DecisionReport& report) {
  constexpr std::uint64_t kNoOperator = 0xFFFF;
  const kernel::ExplorationSettings& exploration = agent.exploration();
  operators_.clear();
  rules_.clear();
  key_.resize(2 + 3 * report.preferences.size());
  std::uint64_t* next = key_.data() + 2;
  for (const kernel::SlotPreference& preference : report.preferences) {
    using enum kernel::PreferenceType;
    std::uint64_t word = static_cast<std::uint64_t>(preference.type) | PlaceOf(preference.value) << 16;
    if (preference.type == kBetter || preference.type == kWorse || preference.type == kBinaryIndifferent)
      word |= PlaceOf(preference.referent) << 32;
    const std::string_view rule = agent.ProductionName(agent.memory().preference(preference.preference).instantiation);
    rules_.push_back(rule);
    *next++ = word;
    *next++ = preference.type == kNumericIndifferent ? std::bit_cast<std::uint64_t>(preference.number) : 0;
    *next++ = rule.size();
  }
  key_[0] = static_cast<std::uint64_t>(exploration.policy) | std::uint64_t{report.is_forced} << 8 |
            std::uint64_t{exploration.average_numbers} << 9 | static_cast<std::uint64_t>(report.impasse) << 16 |
            (report.selected ? PlaceOf(report.selected) : kNoOperator) << 32;
  key_[1] = report.candidates.size();
  if (report.candidates.size() < 2) return;
  key_.push_back(std::bit_cast<std::uint64_t>(exploration.epsilon.value));
  key_.push_back(std::bit_cast<std::uint64_t>(exploration.temperature.value));
}

bool DecisionPacker::HasRules(const Shape& shape) const {
  const char* at = shape.rules.data();
  for (const std::string_view rule : rules_) {
    if (!rule.empty() && std::memcmp(at, rule.data(), rule.size()) != 0) return false;
    at += rule.size();
  }
  return true;
}

/// Finds the shape of the decision that was read; null if it is new.
const DecisionPacker::Shape* DecisionPacker::FindShape() {
  for (std::size_t i = 0, at = last_; i < shapes_.size(); ++i, at = at + 1 == shapes_.size() ? 0 : at + 1) {
    const Shape& shape = shapes_[at];
    if (shape.key != key_ || !HasRules(shape)) continue;
    last_ = at;
    return &shape;
  }
  return nullptr;
}

/// The fast path of FindShape, for decisions that satisfy IsAlone.
const DecisionPacker::Shape* DecisionPacker::FindAlone(const kernel::Agent& agent,
                                                       const kernel::DecisionReport& report) {
  const kernel::SlotPreference& only = report.preferences[0];
  const std::string_view rule = agent.ProductionName(agent.memory().preference(only.preference).instantiation);
  const kernel::ExplorationPolicy policy = agent.exploration().policy;
  for (const Shape& shape : shapes_) {
    if (!shape.is_alone || shape.policy != policy || shape.rules != rule) continue;
    operators_.resize(1);
    operators_[0].op = only.value;
    return &shape;
  }
  return nullptr;
}

std::string_view DecisionPacker::PackAs(const kernel::Agent& agent, const Shape& shape) {
  std::size_t used = 0;
  const auto reserve = [&](std::size_t more) {
    if (used + more > bytes_.size()) bytes_.resize(2 * (used + more));
    return bytes_.data() + used;
  };
  const auto put = [&](std::string_view bytes) {
    bytes.copy(reserve(bytes.size()), bytes.size());
    used += bytes.size();
  };
  put(shape.head);
  for (Mentioned& mentioned : operators_) {
    const IdentifierText made(agent, mentioned.op);
    const std::string_view id = made.view(), name = names_.NameOfOperator(agent, mentioned.op);
    char* const begin = reserve(2 * mind::FieldWriter::kMostOfNumber + id.size() + name.size());
    mind::FieldWriter out(begin);
    out("", id);
    mentioned.id_size = id.size();
    mentioned.id = used + static_cast<std::size_t>(out.at() - begin) - id.size();
    out("", name);
    used += static_cast<std::size_t>(out.at() - begin);
    mentioned.name_size = name.size();
    mentioned.name = used - name.size();
  }
  put(shape.tail);
  return std::string_view(bytes_).substr(0, used);
}

std::string_view DecisionPacker::PackAnew(const kernel::Agent& agent, const kernel::DecisionReport& report, bool keep) {
  const mind::DecisionView& decision = reader_.Read(agent, report);
  bytes_.clear();
  const mind::PackedOperators operators = mind::Pack(decision, bytes_);
  if (!keep || decision.operators.size() != operators_.size()) return bytes_;
  if (shapes_.size() < kMostShapes) {
    last_ = shapes_.size();
    shapes_.emplace_back();
  } else {
    last_ = next_;
    next_ = (next_ + 1) % kMostShapes;
  }
  Shape& shape = shapes_[last_];
  shape.key = key_;
  shape.is_alone = IsAlone(report);
  shape.policy = agent.exploration().policy;
  shape.rules.clear();
  for (const std::string_view rule : rules_) shape.rules += rule;
  shape.head.assign(bytes_, 0, operators.begin);
  shape.tail.assign(bytes_, operators.end);
  return bytes_;
}

std::string_view DecisionPacker::Pack(const kernel::Agent& agent, const kernel::DecisionReport& report) {
  const bool is_small = report.preferences.size() <= kMostPreferences;
  const Shape* shape = IsAlone(report) ? FindAlone(agent, report) : nullptr;
  if (shape == nullptr && is_small) {
    ReadKey(agent, report);
    shape = FindShape();
  }
  is_anew_ = shape == nullptr;
  return is_anew_ ? PackAnew(agent, report, is_small) : PackAs(agent, *shape);
}

DecisionPacker::Operator DecisionPacker::Find(kernel::Symbol op) const {
  if (is_anew_) {
    const mind::DecisionView::Operator* const found = reader_.Find(op);
    return found == nullptr ? Operator{} : Operator{found->id, found->name};
  }
  const std::string_view bytes = bytes_;
  for (const Mentioned& at : operators_)
    if (at.op == op) return {bytes.substr(at.id, at.id_size), bytes.substr(at.name, at.name_size)};
  return {};
}

}  // namespace soarbox::server
