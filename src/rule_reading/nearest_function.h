// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace soarbox::rule_reading {

/// Suggests a built-in function for an unknown name: `write` for `print` and other printing functions, "rand-int or
/// rand-float" for `random`, otherwise one with a similar name. Empty if there is none.
std::string_view NearestFunction(std::string_view name);

}  // namespace soarbox::rule_reading
