// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "workbench/contents.h"
#include "workbench/panel_id.h"

namespace soarbox::debugger {
struct FieldType;
class TypeLister;
}  // namespace soarbox::debugger

namespace soarbox::workbench {

using debugger::Json;

/// Contents as JSON: an object for each panel, named by the panel's word, and the objects "moment", "offers" and
/// "ghosts", which belong to no panel. One table lists all fields; docs/workbench.md is generated from it. `soarbox
/// inspect --json` prints the value of one field.

struct ContentField {
  std::string_view content;  ///< "mind"
  std::string_view name;     ///< "stack"
  std::string_view view;     ///< The view of `soarbox inspect` that prints the same value; empty if there is none.
  std::string_view about;
  Json (*value)(const Contents& contents);
  debugger::FieldType (*type)(debugger::TypeLister& lister);
};
std::span<const ContentField> ContentFields();

/// "moment", "offers", "ghosts" and the words of the panels, in the order of the table.
std::vector<std::string_view> ContentNames();
/// The names of the contents that these panels need, "moment" and "ghosts"; also "offers" if it is not empty.
std::vector<std::string_view> ContentNames(const PanelSet& panels, const Contents& contents);

/// The contents of this name; null if there are none.
Json ToJson(const Contents& contents, std::string_view name);

/// The contents of this name as pages get them. For a panel that has a document, only {"document": ..., "badge":
/// ...}, without an empty badge. For the panel Mission, also its contents.
Json PageJson(const Contents& contents, std::string_view name);

/// Generates docs/workbench.md.
std::string WorkbenchReference();
/// Adds the types of the nodes of a document, and returns their names.
std::vector<std::string> ListNodes(debugger::TypeLister& lister);
/// Generates web/src/document/nodes.ts.
std::string DocumentTypes();
/// Generates web/src/run/contents.ts.
std::string ContentTypes();
/// Generates web/src/panels/panel_table.ts.
std::string PanelTable();

}  // namespace soarbox::workbench
