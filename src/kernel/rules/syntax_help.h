// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace soarbox::kernel {

/// What a rule's text lacks, in words for people, by Soar's message for it: "expected a value: ...". A message that
/// says enough by itself is given back.
std::string_view DescribeSyntaxError(std::string_view soar_message);

/// Where the innermost bracket stands that opens before `offset` and is not closed there. Bars and quotes hide
/// brackets.
std::optional<std::size_t> FindOpenBracket(std::string_view body, std::size_t offset);

}  // namespace soarbox::kernel
