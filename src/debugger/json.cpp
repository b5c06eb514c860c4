// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/json.h"

#include "debugger/fields.h"
#include "diagnostics/json_text.h"

namespace soarbox::debugger {

Json ToJson(const Diagnostic& diagnostic) {
  return JsonOf(diagnostic);
}

std::string Print(const Json& json) {
  return JsonText(json) + "\n";
}

}  // namespace soarbox::debugger
