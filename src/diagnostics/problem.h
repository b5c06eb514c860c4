// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "diagnostics/diagnostic.h"

namespace soarbox {

/// Creates an error about something without lines.
inline Diagnostic NewProblem(std::string message, std::string hint = {}) {
  Diagnostic problem;
  problem.message = std::move(message);
  problem.hint = std::move(hint);
  return problem;
}

/// Creates an error about an entire file.
inline Diagnostic ProblemIn(const std::filesystem::path& file, std::string message, std::string hint = {}) {
  Diagnostic problem = NewProblem(std::move(message), std::move(hint));
  problem.file = file.string();
  return problem;
}

}  // namespace soarbox
