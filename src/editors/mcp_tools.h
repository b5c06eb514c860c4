// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <nlohmann/json.hpp>

namespace soarbox::editors {

/// The tools of the Model Context Protocol's server, as `tools/list` describes them.
nlohmann::ordered_json McpTools();

}  // namespace soarbox::editors
