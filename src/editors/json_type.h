// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <nlohmann/json.hpp>

namespace soarbox::editors {

using Json = nlohmann::json;

}  // namespace soarbox::editors
