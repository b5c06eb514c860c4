// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "diagnostics/diagnostic.h"

namespace soarbox::app {

/// Says on stderr why the command cannot do its work, and returns the exit status for that (`kCannotStart`).
int Refuse(const Diagnostic& problem);

/// The same for an error of this message, with what to do about it and the file it is about, where these are known.
int Refuse(std::string message, std::string hint = {}, std::string file = {});

}  // namespace soarbox::app
