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

/// Receives what a body perceives, attribute by attribute, in the order of the input link.
///
/// Siblings with the same attribute are distinguished by a key, such as the number of an agent or a message.
class PerceptSink {
 public:
  virtual ~PerceptSink() = default;

  /// Reports a number with the type, range and step of its row. Ignores values that are not finite.
  void Number(const PerceptRow& row, double value) {
    if (!std::isfinite(value)) return;
    const double perceived = AsPerceived(row, value);
    if (row.type == ValueType::kInteger) {
      Integer(row, static_cast<std::int64_t>(std::llround(perceived)));
    } else {
      Float(row, perceived);
    }
  }
  virtual void Word(const PerceptRow& row, std::string_view value, std::uint32_t key = 0) = 0;
  /// Reports a constant that is not in the table, such as a parameter of a message.
  virtual void Other(std::string_view attribute, const ConstantValue& value) = 0;
  /// Begins an object. Everything up to its Close() is below it.
  virtual void Open(const PerceptRow& row, std::uint32_t key = 0) = 0;
  virtual void Close() = 0;

 protected:
  virtual void Integer(const PerceptRow& row, std::int64_t value) = 0;
  virtual void Float(const PerceptRow& row, double value) = 0;
};

/// Converts the reported percepts to a list.
class PerceptLister final : public PerceptSink {
 public:
  PerceptLister() { open_.push_back(&list_); }
  PerceptLister(const PerceptLister&) = delete;
  PerceptLister& operator=(const PerceptLister&) = delete;

  /// Contains all objects that were closed.
  const PerceptList& list() const { return list_; }

  void Word(const PerceptRow& row, std::string_view value, std::uint32_t key = 0) override;
  void Other(std::string_view attribute, const ConstantValue& value) override;
  void Open(const PerceptRow& row, std::uint32_t key = 0) override;
  void Close() override { open_.pop_back(); }

 private:
  void Integer(const PerceptRow& row, std::int64_t value) override { Add(row.Attribute(), 0).value = value; }
  void Float(const PerceptRow& row, double value) override { Add(row.Attribute(), 0).value = value; }
  Percept& Add(std::string_view attribute, std::uint32_t key);

  PerceptList list_;
  std::vector<PerceptList*> open_;  ///< From the outermost object to the current one.
};

}  // namespace soarbox::vocabulary
