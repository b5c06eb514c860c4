// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "explain/inspector.h"

namespace soarbox::debugger {

/// The present value of a watch.
struct WatchValue {
  std::string text;       ///< One or more lines; empty if the object does not exist now.
  bool is_error = false;  ///< The text is an error message.
};

/// Evaluates a watch of the user. It reads the mind and executes no command. A watch can be
///
///   a path            "io.input-link.self.health", "S3.operator.name", "<s>.operator": all its values; it begins at
///                     an identifier, at <ts> (the top state; the default), <s> (the lowest state) or <o>
///                     (the operator that is selected in the lowest state that has one)
///   print ID [-d N]   an identifier as a tree, N levels deep
///   print RULE        a rule
///   preferences [ID]  the operators of a state, and why one of them won
///   matches RULE      how far a rule matches
///   stack             the goal stack
WatchValue LookAtWatch(explain::Inspector& mind, std::string_view what);

/// Checks a watch without a mind. Returns an error message, or an empty string if the watch is valid.
std::string WatchFault(std::string_view what);

}  // namespace soarbox::debugger
