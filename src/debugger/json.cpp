// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/json.h"

#include <nlohmann/json.hpp>

namespace soarbox::debugger {

std::string Print(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace soarbox::debugger
