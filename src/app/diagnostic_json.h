// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "debugger/json.h"
#include "diagnostics/json_text.h"

namespace soarbox::app {

using Json = nlohmann::ordered_json;

using debugger::ToJson;

}  // namespace soarbox::app
