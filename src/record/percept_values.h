// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "mind/event_log.h"

namespace soarbox::record {

/// The value of a constant percept: a word, an integer or a float.
using PerceptValue = std::variant<std::string, std::int64_t, double>;
std::string TextOf(const PerceptValue& value);

/// The percepts of a mind at a moment, by path ("self.speed", "agent#3.range").
using PerceptValues = std::map<std::string, PerceptValue, std::less<>>;

/// Applies the changes of a tick. Removing a percept removes everything below it.
void ApplyPercepts(const mind::EventLog& events, PerceptValues& values);

}  // namespace soarbox::record
