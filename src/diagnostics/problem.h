// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "diagnostics/diagnostic.h"

namespace soarbox {

/// An error in something that has no lines: what is wrong, and what to do about it.
inline Diagnostic NewProblem(std::string message, std::string hint = {}) {
  Diagnostic problem;
  problem.message = std::move(message);
  problem.hint = std::move(hint);
  return problem;
}

/// An error about a whole file.
inline Diagnostic ProblemIn(const std::filesystem::path& file, std::string message, std::string hint = {}) {
  Diagnostic problem = NewProblem(std::move(message), std::move(hint));
  problem.file = file.string();
  return problem;
}

}  // namespace soarbox
