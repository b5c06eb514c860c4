// SPDX-License-Identifier: BSD-2-Clause
// For Lua 5.1, which does not list the lines of functions inside other functions.
#include "script/script_debugger.h"

namespace soarbox::script {

std::vector<int> LinesOfScript(std::string_view, ScriptLines) {
  return {};
}

}  // namespace soarbox::script
