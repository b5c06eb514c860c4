// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/agent.h"

namespace soarbox::cli {

/// A pattern of `print`: (id ^attribute value [+]). `*` matches anything.
struct WmePattern {
  kernel::Symbol id, attribute, value;  ///< The null symbol matches anything.
  bool acceptable = false;
  std::string error;  ///< If not empty, the text is not a pattern, and this is Soar's message.
};

WmePattern ParseWmePattern(kernel::Agent& agent, std::string_view text);

/// Whether an element matches the pattern.
bool Matches(const WmePattern& pattern, const kernel::Wme& wme);

/// The matching elements, in the order in which they entered the match. `by_object`: grouped by object, older objects
/// first.
std::vector<kernel::WmeId> FindWmes(const kernel::Agent& agent, const WmePattern& pattern, bool by_object);

}  // namespace soarbox::cli
