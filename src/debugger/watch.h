// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "explain/inspector.h"

namespace soarbox::debugger {

/// What a watch shows of a mind now.
struct WatchValue {
  std::string text;       ///< One or several lines; empty: there is nothing of this kind now.
  bool is_error = false;  ///< The text says what a watch may be.
};

/// Looks at what the user watches. Reads only: no command is carried out. A watch may be
///
///   a path            "io.input-link.self.health", "S3.operator.name", "<s>.operator": all its values; it begins at
///                     an identifier, at <ts> (the top state, also when nothing is said), <s> (the lowest) or <o>
///                     (the operator that is selected in the lowest state that has one)
///   print ID [-d N]   an identifier as a tree, N levels deep
///   print RULE        a rule
///   preferences [ID]  the operators of a state, and why one of them won
///   matches RULE      how far a rule matches
///   stack             the goal stack
WatchValue LookAtWatch(explain::Inspector& mind, std::string_view what);

/// What is wrong with a watch before any mind is asked, a sentence; empty: nothing.
std::string WatchFault(std::string_view what);

}  // namespace soarbox::debugger
