// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <nlohmann/json.hpp>

namespace soarbox::editors {

/// The descriptions of the server's tools for `tools/list`.
nlohmann::ordered_json McpTools();

}  // namespace soarbox::editors
