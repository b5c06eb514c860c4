// SPDX-License-Identifier: BSD-2-Clause
#include "app/rules_of_project.h"

#include <vector>

#include "diagnostics/problem.h"
#include "language/visual_soar.h"

namespace soarbox::app {

namespace fs = std::filesystem;

Result<fs::path> RulesOfProject(const fs::path& file) {
  if (!language::IsVisualSoarProject(file)) return file;
  std::vector<Diagnostic> problems;
  const Result<language::VisualSoarProject> project = language::ReadVisualSoar(file, problems);
  if (!project) return project.error();
  fs::path root = language::RootOfProject(file);
  if (root.empty())
    return ProblemIn(file, "there is no file beside this project that loads its rules",
                     "VisualSoar writes it: a file with the project's name that ends in .soar");
  return root;
}

}  // namespace soarbox::app
