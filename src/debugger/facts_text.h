// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "explain/inspector.h"

namespace soarbox::debugger {

/// What a view says where a kernel does not tell something.
inline constexpr std::string_view kNotAvailable = "not available there";
/// The same of a recording.
inline constexpr std::string_view kNotRecorded = "not recorded";

/// "S1 ^color red", "S1 ^operator O1 +".
std::string Describe(const explain::ElementFact& element);
/// "rule propose*move (o-support)", "input", "the architecture".
std::string Describe(const explain::MakerFact& maker);
/// "seek (O1)", "O1", or nothing.
std::string NameAndId(std::string_view name, std::string_view id);

Json ToJson(const explain::ElementFact& element);
Json ToJson(const explain::MakerFact& maker);

/// Rows as columns of equal width, the first row as their titles.
std::string Table(const std::vector<std::vector<std::string>>& rows);

/// Whether each word of `filter` stands somewhere in the text; letters' case does not count.
bool Passes(std::string_view filter, std::string_view text);

}  // namespace soarbox::debugger
