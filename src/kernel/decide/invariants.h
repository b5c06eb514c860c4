// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::kernel {

struct Engine;

/// Checks, between phases, what must be true of an agent: slots agree with elements, elements with the preferences that
/// support them, counts with lists, links with levels, the matcher with itself. Returns the first violation in words,
/// or an empty text. Walks everything: for tests and builds with SOARBOX_CHECK_INVARIANTS.
std::string FindViolation(const Engine& engine);

/// Checks every handle that a record holds: symbols of elements, preferences, slots, rules and the literals of
/// justifications; makers of elements; instantiations of preferences; rules and matches of instantiations; and that
/// each count of references is the number of those that refer. The same use.
std::string FindDanglingHandle(const Engine& engine);

}  // namespace soarbox::kernel
