// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "diagnostics/diagnostic.h"

namespace soarbox::app {

using Json = nlohmann::ordered_json;

/// A diagnostic as all JSON output shows it; parts that are unknown are left out.
Json ToJson(const Diagnostic& diagnostic);

/// One line without a newline; bytes that are not UTF-8 are replaced rather than refused.
std::string ToLine(const Json& json);

}  // namespace soarbox::app
