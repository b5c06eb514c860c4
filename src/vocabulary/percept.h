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

/// An attribute with its value, as it stands on an input link or below a command: a constant, or an object with
/// attributes of its own. Plain data: who keeps it owns it.
struct Percept {
  using Object = std::vector<Percept>;

  std::string attribute;
  std::uint32_t key = 0;  ///< Tells siblings of one attribute apart from tick to tick: the number of an agent, say.
  std::variant<std::int64_t, double, std::string, Object> value;

  bool IsObject() const { return std::holds_alternative<Object>(value); }
  const std::string* Text() const { return std::get_if<std::string>(&value); }
  /// The value of an integer or a float.
  std::optional<double> Number() const;
  friend bool operator==(const Percept&, const Percept&) = default;
};
using PerceptList = Percept::Object;

/// The first attribute of that name; null if there is none.
const Percept* FindPercept(const PerceptList& list, std::string_view attribute);
/// "^waypoint gate ^within 2" on one line; objects as "(...)".
std::string Describe(const PerceptList& list);
std::string DescribeValue(const Percept& percept);

}  // namespace soarbox::vocabulary
