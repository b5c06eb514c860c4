// SPDX-License-Identifier: BSD-2-Clause
// docs/workbench.md, from the tables of contents and requests.
#include <algorithm>

#include "workbench/contents_json.h"
#include "workbench/requests_json.h"

namespace soarbox::workbench {
namespace {

/// | in a table stands for itself.
std::string Cell(std::string_view text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
  return cell;
}

std::string AboutContent(std::string_view name) {
  if (name == "moment") return "Where the run stands, and who is selected.";
  if (name == "offers") return "What can be opened and found, while `offer` is on.";
  if (name == "ghosts") return "What is drawn beside the bodies that are there.";
  const std::optional<PanelId> panel = FindPanel(name);
  return panel ? std::string(InfoOf(*panel).about) : std::string();
}

}  // namespace

std::string WorkbenchReference() {
  std::string text =
      "# Contents and requests\n\n"
      "`src/workbench` holds what everybody who watches a run works with. **Contents** are the values that panels "
      "show. **Requests** say what\nthe user wants. A **desk** (`workbench/desk.h`) turns requests into contents, tick "
      "by tick, for a live run and for a recording. Windows\nand pages only draw contents and send requests. This page "
      "is made from the tables in `contents_json.cpp` and `requests_json.cpp`\n(`reference_pages docs`); "
      "a test compares it.\n\n"
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
      "The contents of a panel are an object, named by the panel's word. They are filled in while the panel is looked "
      "at (request `look`).\nWhat grows with the run is cut: the newest 500 lines. Where a view is named, "
      "`soarbox inspect --json --view VIEW` prints the same form.\n";
  for (const std::string_view name : ContentNames()) {
    text += "\n### " + std::string(name) + "\n\n" + AboutContent(name) +
            "\n\n| field | what it is | view |\n| --- | --- | --- |\n";
    for (const ContentField& field : ContentFields()) {
      if (field.content != name) continue;
      text += "| `" + std::string(field.name) + "` | " + Cell(field.about) + " | " +
              (field.view.empty() ? "" : "`" + std::string(field.view) + "` ") + "|\n";
    }
  }
  return text;
}

}  // namespace soarbox::workbench
