// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

#include "diagnostics/diagnostic.h"

namespace soarbox::app {

/// Prints on stderr why the command cannot be executed, and returns its exit code (`kCannotStart`).
int Refuse(const Diagnostic& problem);

/// The same for an error with this message, with advice and a file name if they are known.
int Refuse(std::string message, std::string hint = {}, std::string file = {});

/// Also passes the errors of Refuse to a function, until it is called with {}.
void OnRefusal(std::function<void(const Diagnostic& problem)> listener);

/// Returns what `run` returns. If it throws an exception, refuses with the text of that; only a lack of memory is
/// thrown again.
int RefuseExceptions(const std::function<int()>& run);

/// Prints a note or a warning on stderr.
void Remark(Severity severity, Diagnostic remark);

}  // namespace soarbox::app
