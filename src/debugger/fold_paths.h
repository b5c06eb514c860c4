// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "explain/inspector.h"

namespace soarbox::debugger {

/// Joins conditions to paths, as an author writes them. The kernel splits a path into conditions:
///
///     (<s> ^io <i*1>)  (<i*1> ^input-link <i*2>)  (<i*2> ^health { < 10 <h*1> })
///
/// becomes (<s> ^io.input-link.health < 10) again, without the generated variables. If a rule stops matching in the
/// middle of a path, the path ends there. All other conditions stay. `failing` is the index among the remaining
/// conditions.
explain::MatchFacts FoldPaths(explain::MatchFacts facts);

}  // namespace soarbox::debugger
