// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "explain/rule_text.h"
#include "mind/rule_facts.h"

namespace soarbox::explain {

/// What the searches for slips and for reasons work with, from what the kernel's reader found in a rule.
RuleText TextOf(const mind::RuleFacts& facts);

}  // namespace soarbox::explain
