// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::language {

/// A text of rules laid out as people write them: lines stay as they are, but rules begin in the first column, clauses
/// three columns in, and attributes that go on in the next line stand below the first of their clause. Blanks at line
/// ends go, as do all but one of several empty lines; the last line ends. Comments and quoted text keep their words.
/// Everything else stays. Formatting twice gives the same as once, and no rule changes its meaning.
std::string FormatRules(std::string_view text);

}  // namespace soarbox::language
