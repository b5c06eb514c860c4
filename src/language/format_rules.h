// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::language {

/// Formats a text of rules. Line breaks stay. Rules begin in the first column and clauses in the fourth; attributes
/// that continue a clause on the next line are aligned with the clause's first attribute. Removes blanks at line ends
/// and repeated empty lines; ends the last line. Comments and quoted text are not changed. Formatting twice has the
/// same result as once, and no rule changes its meaning.
std::string FormatRules(std::string_view text);

}  // namespace soarbox::language
