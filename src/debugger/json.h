// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace soarbox::debugger {

using Json = nlohmann::ordered_json;

/// On one line, with its end; bytes that are no UTF-8 are replaced.
std::string Print(const Json& json);

}  // namespace soarbox::debugger
