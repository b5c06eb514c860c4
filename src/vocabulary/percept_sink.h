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

/// What std::round gives, but for the sign of zero, without a call: every percept is rounded in each look around.
[[gnu::always_inline]] inline double Rounded(double value) {
  constexpr double kNoFraction = 4503599627370496;  // From here on.
  if (!(std::abs(value) < kNoFraction)) return value;
  const auto whole = static_cast<double>(static_cast<std::int64_t>(value));
  const double rest = value - whole;
  return rest >= 0.5 ? whole + 1 : rest <= -0.5 ? whole - 1 : whole;
}

/// A finite value as rules see it: within the row's range, rounded to its step. Where the row is one that the compiler
/// knows, little is left of this.
[[gnu::always_inline]] inline double AsPerceived(const PerceptRow& row, double value) {
  if (row.min != row.max) value = value < row.min ? row.min : value > row.max ? row.max : value;
  // Division by a whole number of steps keeps 0.1 and its like exactly what a rule's text says.
  if (row.steps_per_unit > 0) {
    value = Rounded(value * row.steps_per_unit) / row.steps_per_unit;
  } else if (row.step > 0) {
    value = Rounded(value / row.step) * row.step;
  }
  return value + 0.0;  // No negative zero.
}

/// A value that is no object.
using ConstantValue = std::variant<std::int64_t, double, std::string>;

/// Takes what a body perceives, attribute by attribute, in the order in which it stands on the input link.
///
/// Siblings of one attribute are told apart by a key, the number of an agent or a message, say.
class PerceptSink {
 public:
  virtual ~PerceptSink() = default;

  /// A number with its row's type, range and step. What is not finite is left out.
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
  /// A constant that is not in the table, such as a parameter of a message.
  virtual void Other(std::string_view attribute, const ConstantValue& value) = 0;
  /// An object; what comes until its Close() stands below it.
  virtual void Open(const PerceptRow& row, std::uint32_t key = 0) = 0;
  virtual void Close() = 0;

 protected:
  virtual void Integer(const PerceptRow& row, std::int64_t value) = 0;
  virtual void Float(const PerceptRow& row, double value) = 0;
};

/// Makes a list of what it is told.
class PerceptLister final : public PerceptSink {
 public:
  PerceptLister() { open_.push_back(&list_); }
  PerceptLister(const PerceptLister&) = delete;
  PerceptLister& operator=(const PerceptLister&) = delete;

  /// Everything that is closed.
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
  std::vector<PerceptList*> open_;  ///< From the outermost to the one that is told now.
};

}  // namespace soarbox::vocabulary
