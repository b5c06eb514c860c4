// SPDX-License-Identifier: BSD-2-Clause
#include "app/refuse.h"

#include <iostream>
#include <utility>

#include "app/exit_codes.h"
#include "diagnostics/problem.h"

namespace soarbox::app {
namespace {

std::function<void(const Diagnostic&)>& Told() {
  static std::function<void(const Diagnostic&)> told;
  return told;
}

}  // namespace

void OnRefusal(std::function<void(const Diagnostic& problem)> told) {
  Told() = std::move(told);
}

int Refuse(const Diagnostic& problem) {
  std::cerr << Format(problem);
  if (Told()) Told()(problem);
  return kCannotStart;
}

int Refuse(std::string message, std::string hint, std::string file) {
  return Refuse(ProblemIn(file, std::move(message), std::move(hint)));
}

void Remark(Severity severity, Diagnostic remark) {
  remark.severity = severity;
  std::cerr << Format(remark);
}

}  // namespace soarbox::app
