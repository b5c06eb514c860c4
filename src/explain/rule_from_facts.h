// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "explain/rule_text.h"
#include "mind/rule_facts.h"

namespace soarbox::explain {

/// Converts what the kernel's reader found in a rule to the form that the searches for slips and reasons use.
RuleText TextOf(const mind::RuleFacts& facts);

}  // namespace soarbox::explain
