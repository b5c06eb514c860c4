// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "explain/inspector.h"

namespace soarbox::debugger {

/// The conditions as an author writes them: a path that the kernel takes apart,
///
///     (<s> ^io <i*1>)  (<i*1> ^input-link <i*2>)  (<i*2> ^health { < 10 <h*1> })
///
/// becomes (<s> ^io.input-link.health < 10) again, without the variables that nobody wrote. Where a rule stops in the
/// middle of a path, the path ends there. All else stays; `failing` counts what is left.
explain::MatchFacts FoldPaths(explain::MatchFacts facts);

}  // namespace soarbox::debugger
