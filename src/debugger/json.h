// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "diagnostics/diagnostic.h"

namespace soarbox::debugger {

using Json = nlohmann::ordered_json;

/// Formats a diagnostic for JSON output. Parts that are not known are left out.
Json ToJson(const Diagnostic& diagnostic);

/// Prints JSON on one line, with a line end. Replaces bytes that are not UTF-8.
std::string Print(const Json& json);

}  // namespace soarbox::debugger
