// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/surroundings.h"

#include "diagnostics/problem.h"

namespace soarbox::workbench {
namespace {

Diagnostic NotHere(const std::string& what) {
  return NewProblem(what + " cannot be opened here", "open it in a window: soarbox run, soarbox replay");
}

}  // namespace

Result<void> Surroundings::OpenInEditor(const std::string& file, int /*line*/) {
  return NotHere(file);
}

Result<void> Surroundings::OpenRun(const std::string& what, const std::string& /*lesson*/) {
  return NotHere(what);
}

}  // namespace soarbox::workbench
