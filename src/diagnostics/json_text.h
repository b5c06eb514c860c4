// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox {

/// Prints a nlohmann::json or ordered_json. Texts of users can contain any bytes; invalid UTF-8 is replaced. `indent`:
/// blanks per level for output on several lines; -1: output on one line.
template <typename Json>
std::string JsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace soarbox
