// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "workbench/contents.h"
#include "workbench/panel_id.h"

namespace soarbox::workbench {

using debugger::Json;

/// The form of contents as JSON: for each panel an object, named by the panel's word, and "moment", "offers" and
/// "ghosts", which belong to no panel. All fields stand in one table, which docs/workbench.md is made from; what
/// `soarbox inspect --json` prints of a view is the value of one of them.

struct ContentField {
  std::string_view content;  ///< "mind"
  std::string_view name;     ///< "stack"
  std::string_view view;     ///< Of `soarbox inspect`, which prints the same; empty: none does.
  std::string_view about;
  Json (*value)(const Contents& contents);
};
std::span<const ContentField> ContentFields();

/// "moment", "offers", "ghosts" and the words of panels, in the order of the table.
std::vector<std::string_view> ContentNames();
/// What belongs to these panels, with "moment"; and "offers" and "ghosts" if there are any.
std::vector<std::string_view> ContentNames(const PanelSet& panels, const Contents& contents);

/// The contents of this name; null if there is none by it.
Json ToJson(const Contents& contents, std::string_view name);

/// The same as a page shows it: of a panel with a document {"document": ...} alone.
Json PageJson(const Contents& contents, std::string_view name);

/// docs/workbench.md.
std::string WorkbenchReference();
/// web/src/panels/panel_table.ts.
std::string PanelTable();

}  // namespace soarbox::workbench
