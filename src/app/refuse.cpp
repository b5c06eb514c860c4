// SPDX-License-Identifier: BSD-2-Clause
#include "app/refuse.h"

#include <iostream>
#include <utility>

#include "app/exit_codes.h"

namespace soarbox::app {

int Refuse(const Diagnostic& problem) {
  std::cerr << Format(problem);
  return kCannotStart;
}

int Refuse(std::string message, std::string hint, std::string file) {
  Diagnostic problem;
  problem.message = std::move(message);
  problem.hint = std::move(hint);
  problem.file = std::move(file);
  return Refuse(problem);
}

}  // namespace soarbox::app
