// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "debugger/json.h"

namespace soarbox::app {

using Json = nlohmann::ordered_json;

using debugger::ToJson;

/// One line without a newline; bytes that are not UTF-8 are replaced rather than refused.
std::string ToLine(const Json& json);

}  // namespace soarbox::app
