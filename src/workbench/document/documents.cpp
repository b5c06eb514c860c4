// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <iterator>

#include "workbench/document/panels.h"

namespace soarbox::workbench::document {

bool HasDocument(PanelId panel) {
  return std::ranges::find(kPanelDocuments, panel, &PanelDocument::panel) != std::end(kPanelDocuments);
}

Nodes DocumentOf(PanelId panel, const Contents& contents) {
  const auto found = std::ranges::find(kPanelDocuments, panel, &PanelDocument::panel);
  return found == std::end(kPanelDocuments) ? Nodes() : found->build(contents);
}

std::string BadgeOf(PanelId panel, const Contents& contents) {
  if (panel == PanelId::kMission) {
    const CheckCounts counts = CountChecks(contents);
    return counts.all == 0 ? std::string() : std::to_string(counts.passed) + "/" + std::to_string(counts.all);
  }
  if (panel != PanelId::kProblems) return {};
  const auto count = std::ranges::count_if(
      contents.problems, [](const ProblemRow& problem) { return problem.diagnostic.severity != Severity::kNote; });
  return count == 0 ? std::string() : std::to_string(count);
}

}  // namespace soarbox::workbench::document
