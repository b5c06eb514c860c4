// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "diagnostics/diagnostic.h"

namespace soarbox::debugger {

using Json = nlohmann::ordered_json;

/// A diagnostic as all JSON output shows it; parts that are unknown are left out.
Json ToJson(const Diagnostic& diagnostic);

/// On one line, with its end; bytes that are no UTF-8 are replaced.
std::string Print(const Json& json);

}  // namespace soarbox::debugger
