// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "vocabulary/percept.h"

namespace soarbox::vocabulary {

/// Same as std::round, except for the sign of zero, but without a call, because every percept is rounded in each
/// update.
[[gnu::always_inline]] inline double Rounded(double value) {
  constexpr double kNoFraction = 4503599627370496;  // Larger numbers have no fraction.
  if (!(std::abs(value) < kNoFraction)) return value;
  const auto whole = static_cast<double>(static_cast<std::int64_t>(value));
  const double rest = value - whole;
  return rest >= 0.5 ? whole + 1 : rest <= -0.5 ? whole - 1 : whole;
}

/// A finite value as rules perceive it: clamped to the row's range and rounded to its step. If the row is a
/// compile-time constant, most of this is optimized away.
[[gnu::always_inline]] inline double AsPerceived(const PerceptRow& row, double value) {
  if (row.min != row.max) value = value < row.min ? row.min : value > row.max ? row.max : value;
  // Dividing by an integer number of steps gives exactly the value of a literal such as 0.1 in a rule.
  if (row.steps_per_unit > 0) {
    value = Rounded(value * row.steps_per_unit) / row.steps_per_unit;
  } else if (row.step > 0) {
    value = Rounded(value / row.step) * row.step;
  }
  return value + 0.0;  // Avoids negative zero.
}

/// A constant value of a percept.
using ConstantValue = std::variant<std::int64_t, double, std::string>;

/// Base of the classes that receive what a body perceives, attribute by attribute, in the order of the input link.
/// `Sink` is the derived class. Senses are templates, so that reporting a percept takes no virtual call. A sink has
/// * Word(row, value, key = 0): reports a text;
/// * Other(attribute, value): reports a constant that is not in the table, such as a parameter of a message;
/// * Open(row, key = 0), Close(): begin and end an object. Everything between them is below it;
/// * Integer(row, value), Float(row, value): called by Number.
///
/// Siblings with the same attribute are distinguished by a key, such as the number of an agent or a message.
template <typename Sink>
class PerceptSink {
 public:
  /// Reports a number with the type, range and step of its row. Ignores values that are not finite.
  [[gnu::always_inline]] void Number(const PerceptRow& row, double value) {
    if (!std::isfinite(value)) return;
    const double perceived = AsPerceived(row, value);
    Sink& sink = static_cast<Sink&>(*this);
    if (row.type != ValueType::kInteger) {
      sink.Float(row, perceived);
    } else if (row.steps_per_unit == 1 && row.min != row.max) {
      sink.Integer(row, static_cast<std::int64_t>(perceived));  // It is an integer and in range.
    } else {
      sink.Integer(row, static_cast<std::int64_t>(std::llround(perceived)));
    }
  }

 protected:
  ~PerceptSink() = default;
};

/// Converts the reported percepts to a list.
class PerceptLister final : public PerceptSink<PerceptLister> {
 public:
  PerceptLister() { open_.push_back(&list_); }
  PerceptLister(const PerceptLister&) = delete;
  PerceptLister& operator=(const PerceptLister&) = delete;

  /// Contains all objects that were closed.
  const PerceptList& list() const { return list_; }

  void Word(const PerceptRow& row, std::string_view value, std::uint32_t key = 0);
  void Other(std::string_view attribute, const ConstantValue& value);
  void Open(const PerceptRow& row, std::uint32_t key = 0);
  void Close() { open_.pop_back(); }

 private:
  friend class PerceptSink<PerceptLister>;
  void Integer(const PerceptRow& row, std::int64_t value) { Add(row.Attribute(), 0).value = value; }
  void Float(const PerceptRow& row, double value) { Add(row.Attribute(), 0).value = value; }
  Percept& Add(std::string_view attribute, std::uint32_t key);

  PerceptList list_;
  std::vector<PerceptList*> open_;  ///< From the outermost object to the current one.
};

}  // namespace soarbox::vocabulary
