// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/json.h"

#include <nlohmann/json.hpp>

#include "diagnostics/json_text.h"

namespace soarbox::debugger {

Json ToJson(const Diagnostic& diagnostic) {
  static constexpr const char* kSeverities[] = {"note", "warning", "error"};
  Json json;
  json["severity"] = kSeverities[static_cast<int>(diagnostic.severity)];
  if (!diagnostic.file.empty()) json["file"] = diagnostic.file;
  if (diagnostic.line > 0) json["line"] = diagnostic.line;
  if (diagnostic.column > 0) json["column"] = diagnostic.column;
  json["message"] = diagnostic.message;
  if (!diagnostic.excerpt.empty()) json["excerpt"] = diagnostic.excerpt;
  if (!diagnostic.hint.empty()) json["hint"] = diagnostic.hint;
  if (diagnostic.more > 0) json["more"] = diagnostic.more;
  return json;
}

std::string Print(const Json& json) {
  return JsonText(json) + "\n";
}

}  // namespace soarbox::debugger
