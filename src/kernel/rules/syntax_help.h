// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace soarbox::kernel {

/// Replaces Soar's message about a syntax error by a clearer one: "expected a value: ...". Returns messages that are
/// clear enough unchanged.
std::string_view DescribeSyntaxError(std::string_view soar_message);

/// The offset of the innermost bracket that opens before `offset` and is not closed before it; nothing if there is
/// none. Brackets between bars or quotes do not count.
std::optional<std::size_t> FindOpenBracket(std::string_view body, std::size_t offset);

}  // namespace soarbox::kernel
