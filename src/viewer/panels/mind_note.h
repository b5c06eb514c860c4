// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// Whether the selected agent has a mind that can be looked into now; if not, says in the panel why and what to do.
bool HasMind(PanelFrame& frame);

/// The name of a rule; a click shows it in the panel of rules.
void RuleLink(PanelFrame& frame, std::string_view rule);

/// Shows an object of working memory in the panel Memory.
void ShowObject(PanelFrame& frame, std::string_view id);

}  // namespace soarbox::viewer
