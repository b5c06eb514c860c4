// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox {

/// A nlohmann::json, or an ordered one, on one line. Names and texts of users may hold any bytes: what is not UTF-8 is
/// replaced. `indent`: blanks per level, on many lines; -1: one line.
template <typename Json>
std::string JsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace soarbox
