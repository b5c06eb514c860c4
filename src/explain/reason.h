// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace soarbox::explain {

/// One reason why an agent does nothing, in one or two full sentences.
struct Reason {
  enum class Kind : std::uint8_t {
    kOther,
    kRefused,        ///< The world refused the last command, or could not carry it out.
    kStalled,        ///< An operator was applied and stays selected.
    kTorn,           ///< Operators are tied, or each is worse than another.
    kAwaitsTurn,     ///< A rule waits for its operator to be selected.
    kStops,          ///< A rule stops at a condition.
    kStopsAtUnmade,  ///< A rule stops at an attribute that no percept and no rule makes.
    kUnmade,         ///< A rule tests an attribute that no percept and no rule makes.
    kPercepts,       ///< What the agent perceives.
  };
  static constexpr Kind kLastKind = Kind::kPercepts;

  // Not explicit: most reasons are only a sentence.
  Reason(std::string sentence, Kind what = Kind::kOther, std::string name = {})  // NOLINT(google-explicit-constructor)
      : text(std::move(sentence)), kind(what), rule(std::move(name)) {}
  Reason() = default;

  std::string text;
  Kind kind = Kind::kOther;
  std::string rule;  ///< The rule that it is about; may be empty.
};

}  // namespace soarbox::explain
