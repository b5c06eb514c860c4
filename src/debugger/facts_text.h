// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "explain/inspector.h"

namespace soarbox::debugger {

/// What a view shows for data that a kernel does not report.
inline constexpr std::string_view kNotAvailable = "not available there";
/// What a view shows for data that a recording does not contain.
inline constexpr std::string_view kNotRecorded = "not recorded";

/// "S1 ^color red", "S1 ^operator O1 +".
std::string Describe(const explain::ElementFact& element);
/// "rule propose*move (o-support)", "input", "the architecture".
std::string Describe(const explain::MakerFact& maker);
/// "seek (O1)", "O1", or nothing.
std::string NameAndId(std::string_view name, std::string_view id);

/// Formats rows as columns of equal width. The first row contains the titles.
std::string Table(const std::vector<std::vector<std::string>>& rows);

/// Whether the text contains each word of `filter`, regardless of case.
bool Passes(std::string_view filter, std::string_view text);

}  // namespace soarbox::debugger
