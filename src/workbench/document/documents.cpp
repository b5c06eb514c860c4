// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <iterator>

#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {

bool HasDocument(PanelId panel) {
  return std::ranges::find(kPanelDocuments, panel, &PanelDocument::panel) != std::end(kPanelDocuments);
}

namespace {

/// Panels that are empty if the selected agent's mind cannot be shown.
constexpr PanelId kOfMind[] = {PanelId::kMemory,   PanelId::kRules,    PanelId::kLinks,
                               PanelId::kLongTerm, PanelId::kLearning, PanelId::kImagery};

}  // namespace

Nodes DocumentOf(PanelId panel, const Contents& contents) {
  const auto found = std::ranges::find(kPanelDocuments, panel, &PanelDocument::panel);
  if (found == std::end(kPanelDocuments)) return {};
  if (std::ranges::find(kOfMind, panel) == std::end(kOfMind)) return found->build(contents);
  if (std::optional<Nodes> without = WithoutMind(contents)) return std::move(*without);
  Nodes nodes;
  NoteRecorded(contents, nodes);
  std::ranges::move(found->build(contents), std::back_inserter(nodes));
  return nodes;
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
