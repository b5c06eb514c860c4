// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "diagnostics/result.h"
#include "workbench/requests.h"

namespace soarbox::workbench {

using debugger::Json;

/// The form of requests as JSON: {"request": "seek", "tick": 120}. All that there are stand in one table, which
/// docs/workbench.md is made from.

struct RequestField {
  std::string_view name;
  std::string type;  ///< "text", "number", "true or false", or the words that it can be.
  std::string_view about;
  bool is_needed = false;  ///< Others may be left out.
};
struct RequestInfo {
  std::string_view name, about;
  std::vector<RequestField> fields;
};
/// All, in the order of Request.
std::vector<RequestInfo> RequestInfos();

/// The error names the request or the field and what it can be. `id` may be there for whoever sent it; nothing else may
/// that is not in the table.
Result<Request> ReadRequest(const Json& json);
Json ToJson(const Request& request);

}  // namespace soarbox::workbench
