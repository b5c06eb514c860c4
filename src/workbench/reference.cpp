// SPDX-License-Identifier: BSD-2-Clause
// Generates docs/workbench.md from the tables of contents and requests, and the page's tables of panels and commands.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "debugger/json_fields.h"
#include "workbench/arrangement.h"
#include "workbench/contents_json.h"
#include "workbench/document/panels.h"
#include "workbench/empty_panels.h"
#include "workbench/flow_info.h"
#include "workbench/requests_json.h"

namespace soarbox::workbench {
namespace {

/// Escapes | for a table.
std::string Cell(std::string_view text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
  return cell;
}

/// A table of fields for each type.
std::string TypeTables(const debugger::TypeLister& types) {
  std::string text;
  for (const debugger::TypeInfo& type : types.types()) {
    text += "\n`" + std::string(type.name) + "`: " + Cell(type.about) +
            "\n\n| field | type | what it is |\n| --- | --- | --- |\n";
    for (const debugger::TypeField& field : type.fields) {
      const std::string name = "`" + std::string(field.name) + "`";
      text += "| " + (field.is_needed ? name : "[" + name + "]") + " | " + field.type.words + " | " +
              Cell(field.about) + " |\n";
    }
  }
  return text;
}

std::string AboutContent(std::string_view name) {
  if (name == "moment") return "The current moment of the run, and the selected agent.";
  if (name == "offers") return "What can be opened and found, while `offer` is on.";
  if (name == "ghosts") return "What is drawn in addition to the bodies of the world.";
  const std::optional<PanelId> panel = FindPanel(name);
  return panel ? std::string(InfoOf(*panel).about) : std::string();
}

}  // namespace

std::string PanelTable() {
  const auto quoted = [](std::string_view text) { return Json(std::string(text)).dump(); };
  std::string text =
      "// SPDX-License-Identifier: BSD-2-Clause\n"
      "// Written by reference_pages from src/workbench/panel_id.h.\n\n"
      "/** Word, title and description of a panel. */\n"
      "export interface PanelInfo {\n  readonly word: string;\n  readonly title: string;\n  readonly about: string;\n"
      "  readonly hasDocument: boolean;\n}\n\nexport const PANELS: readonly PanelInfo[] = [\n";
  for (const PanelInfo& info : kPanelInfos) {
    text += "  {\n    word: " + quoted(info.word) + ", title: " + quoted(info.title) +
            ",\n    about: " + quoted(info.about) +
            ",\n    hasDocument: " + (document::HasDocument(info.id) ? "true" : "false") + ",\n  },\n";
  }
  text +=
      "];\n\n/** The initial positions of panels. The page adds its own panel for the output of agents. */\n"
      "export const ARRANGEMENTS = {\n";
  for (const Arrangement& arranged : {kWorldArrangement, kLessonArrangement, kReportArrangement}) {
    text += "  " + std::string(arranged.word) + ": {\n";
    for (const auto& [side, panels] :
         {std::pair{"left", arranged.left}, std::pair{"right", arranged.right}, std::pair{"bottom", arranged.bottom}}) {
      text += std::string("    ") + side + ": [";
      std::size_t number = 0;
      for (const PanelId panel : panels) {
        text += (number == 0 ? "" : number % 8 == 0 ? ",\n      " : ", ") + quoted(InfoOf(panel).word);
        ++number;
        if (panel == (arranged.word == kLessonArrangement.word ? PanelId::kMind : PanelId::kTimeline))
          text += ", \"output\"";
      }
      text += "],\n";
    }
    text += "  },\n";
  }
  text += "} as const;\n\n/** The texts of empty panels that no document describes. */\nexport const EMPTY = {\n";
  for (const auto& [word, empty] : {std::pair{"timeline", kEmptyTimeline}, std::pair{"edit", kEmptyEdit}})
    text += "  " + std::string(word) + ": " + quoted(std::string(empty.what) + " " + std::string(empty.advice)) + ",\n";
  return text + "} as const;\n";
}

std::string FlowTable() {
  const auto quoted = [](std::string_view text) { return Json(std::string(text)).dump(); };
  std::string text =
      "// SPDX-License-Identifier: BSD-2-Clause\n"
      "// Written by reference_pages from src/workbench/flow_info.h.\n\n"
      "/** What a command of the run is called, in the window and here. */\n"
      "export const FLOWS = {\n";
  for (const FlowInfo& info : kFlowInfos) {
    if (!IsRequest(info.flow)) continue;
    text += "  " + quoted(info.word) + ": {\n    button: " + quoted(info.button) + ", title: " + quoted(info.title) +
            ",\n    meaning: " + quoted(info.meaning) + ",\n  },\n";
  }
  return text +
         "} as const;\n\n/** The button that continues a run from the moment that is shown. */\nexport const RESUME "
         "= " +
         quoted(kResumeButton) + ";\n/** A return to the present. */\nexport const LIVE = " + quoted(kLiveTitle) +
         ";\n";
}

const char* const kDocuments =
    "\n## Documents\n\n"
    "Nearly all panels are described by a **document** (`src/workbench/document/`): what they show, without colors, "
    "sizes "
    "and "
    "positions. It is built from\nthe contents. The window draws it with ImGui (`viewer/panels/document_panel.cpp`), "
    "pages and "
    "reports with HTML (`web/src/document/`), and\n`ToText` writes it as text. A page gets the document instead of the "
    "contents: `{\"document\": [node, ...]}`, and `badge`, the number on the panel's tab, if it has one. A node is an "
    "object; `is` says what it is.\n\n"
    "**Spans** are a text, or a list of texts and of `[text, role, action, hint]`; a number instead of the text is a "
    "tick: it is shown as a time, and a click goes there.\nAn **action** is `[request, panel]`: the panel comes to the "
    "front. `press` and `unfold` are `{do, "
    "field, argument}`: the "
    "request's field becomes\nthe row's key, or its n-th argument. **Keys** stay the same from one document to the "
    "next, so that selection, filters and unfolded rows are kept.\n";

std::string WorkbenchReference() {
  std::string text =
      "# Contents and requests\n\n"
      "`src/workbench` is the common model of all programs that show a run. **Contents** are the values that panels "
      "show. **Requests** say what\nthe user wants. A **desk** (`workbench/desk.h`) turns requests into contents, tick "
      "by tick, for a live run and for a recording. Windows\nand pages only draw contents and send requests. This page "
      "is made from the lists of fields in `requests_json.cpp`, `contents_json.cpp`,\n`contents_fields.h` and "
      "`debugger/fields.h` (`reference_pages docs`), as are the page's types in `web/src/run/contents.ts`; a test "
      "compares them.\n\n"
      "## Requests\n\n"
      "A request is an object with its name and its fields: `{\"request\": \"seek\", \"tick\": 120}`. Fields in "
      "brackets may be left out. A field\nthat is unknown, missing or of another type is an error, which names it. A "
      "sender may add an `id`.\n\n"
      "| request | what it does | fields |\n| --- | --- | --- |\n";
  for (const RequestInfo& info : RequestInfos()) {
    text += "| `" + std::string(info.name) + "` | " + Cell(info.about) + " | ";
    for (std::size_t i = 0; i < info.fields.size(); ++i) {
      const RequestField& field = info.fields[i];
      const std::string name = "`" + std::string(field.name) + "`";
      text += (i == 0 ? "" : "; ") + (field.is_needed ? name : "[" + name + "]") + " (" + field.type +
              "): " + Cell(field.about);
    }
    text += " |\n";
  }
  text +=
      "\n## Contents\n\n"
      "The contents of a panel are an object, named by the panel's word. They are filled in while the panel is visible "
      "(request `look`).\nLists that grow with the run contain only the newest 500 lines. If a view is named, `soarbox "
      "inspect --json --view VIEW` prints the same form.\n";
  debugger::TypeLister types;
  for (const std::string_view name : ContentNames()) {
    text += "\n### " + std::string(name) + "\n\n" + AboutContent(name) +
            "\n\n| field | type | what it is | view |\n| --- | --- | --- | --- |\n";
    for (const ContentField& field : ContentFields()) {
      if (field.content != name) continue;
      text += "| `" + std::string(field.name) + "` | " + field.type(types).words + " | " + Cell(field.about) + " | " +
              (field.view.empty() ? "" : "`" + std::string(field.view) + "` ") + "|\n";
    }
  }
  text +=
      "\n### Types\n\nThe objects in these contents. Fields in brackets are left out if they have no value. "
      "A field of the type JSON has the form\nthat `soarbox inspect --json` prints.\n";
  text += TypeTables(types);
  debugger::TypeLister nodes;
  ListNodes(nodes);
  return text + kDocuments + TypeTables(nodes);
}

}  // namespace soarbox::workbench
