// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "diagnostics/result.h"
#include "workbench/requests.h"

namespace soarbox::workbench {

using debugger::Json;

/// Requests as JSON: {"request": "seek", "tick": 120}. One table lists all requests; docs/workbench.md is generated
/// from it.

struct RequestField {
  std::string_view name;
  std::string type;    ///< "text", "number", "true or false", or the allowed words.
  std::string script;  ///< The type in TypeScript: "string", "number".
  std::string_view about;
  bool is_needed = false;  ///< Other fields may be omitted.
};
struct RequestInfo {
  std::string_view name, about;
  std::vector<RequestField> fields;
};
/// All requests, in the order of Request.
std::vector<RequestInfo> RequestInfos();

/// Parses a request. An error names the request or the field, and the allowed values. Accepts no other fields than
/// those of the table, except `id`, which is ignored.
Result<Request> ReadRequest(const Json& json);
Json ToJson(const Request& request);

}  // namespace soarbox::workbench
