// SPDX-License-Identifier: BSD-2-Clause
// For systems that cannot start other programs (WebAssembly).
#include "editors/run_program.h"

namespace soarbox::editors {

ProgramEnd RunProgram(const std::vector<std::string>&, const ProgramLimits&) {
  ProgramEnd end;
  end.err = "this build cannot start other programs; use the native soarbox";
  return end;
}

}  // namespace soarbox::editors
