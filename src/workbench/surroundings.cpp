// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/surroundings.h"

namespace soarbox::workbench {
namespace {

Diagnostic NotHere(const std::string& what) {
  Diagnostic problem;
  problem.message = what + " cannot be opened here";
  problem.hint = "open it in a window: soarbox run, soarbox replay";
  return problem;
}

}  // namespace

Result<void> Surroundings::OpenInEditor(const std::string& file, int /*line*/) {
  return NotHere(file);
}

Result<void> Surroundings::OpenRun(const std::string& what, const std::string& /*lesson*/) {
  return NotHere(what);
}

}  // namespace soarbox::workbench
