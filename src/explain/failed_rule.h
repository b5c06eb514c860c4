// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::explain {

/// An error in a file of rules.
struct FailedRule {
  std::string rule;     ///< The rule that did not load; empty if the error names none.
  std::string place;    ///< "hero.soar:12".
  std::string problem;  ///< "expected ..."
};

}  // namespace soarbox::explain
