// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::kernel {

struct AgentCore;

/// Checks the invariants of an agent between phases: slots agree with elements, elements with the preferences that
/// support them, counts with lists, links with levels, and the matcher with itself. Returns a description of the first
/// violation, or an empty text. Slow: walks all data. For tests and builds with SOARBOX_CHECK_INVARIANTS.
std::string FindViolation(const AgentCore& core);

/// Checks every handle in every record: symbols of elements, preferences, slots, rules and the literals of
/// justifications; creators of elements; instantiations of preferences; rules and matches of instantiations. Also
/// checks that each reference count equals the number of references. Used like FindViolation.
std::string FindDanglingHandle(const AgentCore& core);

}  // namespace soarbox::kernel
