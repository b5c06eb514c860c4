// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace soarbox::rule_reading {

/// The built-in function that is probably meant by a name that no function has: `write` for `print` and other printers,
/// "rand-int or rand-float" for `random`, otherwise one that is spelled alike. Empty if there is none.
std::string_view NearestFunction(std::string_view name);

}  // namespace soarbox::rule_reading
