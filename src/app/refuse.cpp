// SPDX-License-Identifier: BSD-2-Clause
#include "app/refuse.h"

#include <exception>
#include <iostream>
#include <new>
#include <utility>

#include "app/exit_codes.h"
#include "diagnostics/problem.h"

namespace soarbox::app {
namespace {

std::function<void(const Diagnostic&)>& Listener() {
  static std::function<void(const Diagnostic&)> listener;
  return listener;
}

}  // namespace

void OnRefusal(std::function<void(const Diagnostic& problem)> listener) {
  Listener() = std::move(listener);
}

int Refuse(const Diagnostic& problem) {
  std::cerr << Format(problem);
  if (Listener()) Listener()(problem);
  return kCannotStart;
}

int Refuse(std::string message, std::string hint, std::string file) {
  return Refuse(ProblemIn(file, std::move(message), std::move(hint)));
}

int RefuseExceptions(const std::function<int()>& run) {
  try {
    return run();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return Refuse(error.what());
  }
}

void Remark(Severity severity, Diagnostic remark) {
  remark.severity = severity;
  std::cerr << Format(remark);
}

}  // namespace soarbox::app
