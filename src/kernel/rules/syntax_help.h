// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace soarbox::kernel {

/// Translates Soar's message into what a rule's text lacks, in plain words: "expected a value: ...". Returns a message
/// unchanged if it is clear enough.
std::string_view DescribeSyntaxError(std::string_view soar_message);

/// Where the innermost bracket is that opens before `offset` and is not closed before it. Brackets between bars or
/// quotes do not count.
std::optional<std::size_t> FindOpenBracket(std::string_view body, std::size_t offset);

}  // namespace soarbox::kernel
