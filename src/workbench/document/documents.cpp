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

}  // namespace soarbox::workbench::document
