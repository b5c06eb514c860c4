// SPDX-License-Identifier: BSD-2-Clause
#include "app/diagnostic_json.h"

namespace soarbox::app {

std::string ToLine(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace soarbox::app
