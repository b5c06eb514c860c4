// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "vocabulary/vocabulary.h"

namespace soarbox::vocabulary {

/// An attribute and its value, as on an input link or below a command. The value is a constant, or an object with
/// attributes. Plain data without references.
struct Percept {
  using Object = std::vector<Percept>;

  std::string attribute;
  std::uint32_t key = 0;  ///< Identifies one of several siblings with the same attribute in all ticks, for example by
                          ///< the number of an agent.
  std::variant<std::int64_t, double, std::string, Object> value;

  bool IsObject() const { return std::holds_alternative<Object>(value); }
  const std::string* Text() const { return std::get_if<std::string>(&value); }
  /// The value of an integer or a float.
  std::optional<double> Number() const;
  friend bool operator==(const Percept&, const Percept&) = default;
};
using PerceptList = Percept::Object;

/// The first percept with this attribute; null if there is none.
const Percept* FindPercept(const PerceptList& list, std::string_view attribute);
/// Formats percepts on one line: "^waypoint gate ^within 2"; objects as "(...)".
std::string Describe(const PerceptList& list);
std::string DescribeValue(const Percept& percept);

}  // namespace soarbox::vocabulary
