// SPDX-License-Identifier: BSD-2-Clause
// Generates the page's types of contents.
#include <cctype>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "debugger/json_fields.h"
#include "workbench/contents_json.h"
#include "workbench/document/document_fields.h"

namespace soarbox::workbench {
namespace {

/// Pages get the contents of panels without a document, and those of Mission. Reports get those of Imagery, too.
bool IsReadByPages(std::string_view content) {
  const std::optional<PanelId> panel = FindPanel(content);
  return !panel || !document::HasDocument(*panel) || *panel == PanelId::kMission || *panel == PanelId::kImagery;
}

std::string Capitalized(std::string_view word) {
  std::string name(word);
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return name;
}

std::string FieldLine(std::string_view name, const std::string& type, std::string_view about, bool is_needed) {
  return "  /** " + std::string(about) + " */\n  readonly " + std::string(name) + (is_needed ? ": " : "?: ") + type +
         ";\n";
}

std::string TypesText(const debugger::TypeLister& lister) {
  std::string text;
  for (const debugger::TypeInfo& type : lister.types()) {
    text += "\n/** " + std::string(type.about) + " */\nexport interface " + std::string(type.name) + " {\n";
    for (const debugger::TypeField& field : type.fields)
      text += FieldLine(field.name, field.type.script, field.about, field.is_needed);
    text += "}\n";
  }
  return text;
}

/// Lists the kinds of nodes, and returns their names.
template <typename... Kinds>
std::vector<std::string> ListNodes(debugger::TypeLister& lister, const std::variant<Kinds...>*) {
  return {lister.TypeOf<Kinds>().script...};
}

}  // namespace

std::vector<std::string> ListNodes(debugger::TypeLister& lister) {
  constexpr const decltype(document::Node::is)* kKinds = nullptr;
  std::vector<std::string> names = ListNodes(lister, kKinds);
  lister.TypeOf<document::CellValue>();
  return names;
}

std::string DocumentTypes() {
  debugger::TypeLister lister;
  std::string text =
      "// SPDX-License-Identifier: BSD-2-Clause\n"
      "// Written by reference_pages from src/workbench/document/document_fields.h.\n"
      "import type { Action, Span, Spans } from \"./document\";\n\nexport type DocumentNode =";
  for (const std::string& name : ListNodes(lister)) text += "\n  | " + name;
  return text + ";\n\nexport type Cell = Spans | CellValue;\n" + TypesText(lister);
}

std::string ContentTypes() {
  debugger::TypeLister lister;
  std::string panels;
  for (const std::string_view content : ContentNames()) {
    if (!IsReadByPages(content)) continue;
    panels += "\nexport interface " + Capitalized(content) + " {\n";
    for (const ContentField& field : ContentFields())
      if (field.content == content) panels += FieldLine(field.name, field.type(lister).script, field.about, true);
    panels += "}\n";
  }
  std::string text =
      "// SPDX-License-Identifier: BSD-2-Clause\n"
      "// Written by reference_pages from src/workbench/contents_fields.h, contents_json.cpp and "
      "src/debugger/fields.h.\n"
      "import type { Document } from \"../document/document\";\n";
  text += TypesText(lister) + panels +
          "\n/** The contents of a panel that is described by a document, and the number on its tab. */\n"
          "export interface DocumentContent {\n  readonly document?: Document;\n  readonly badge?: string;\n}\n\n"
          "/** All contents by name. Those that have not arrived yet are missing. */\nexport interface Contents {\n";
  for (const std::string_view content : ContentNames()) {
    const std::optional<PanelId> panel = FindPanel(content);
    const bool has_document = panel && document::HasDocument(*panel);
    const std::string name = Capitalized(content);
    text += "  " + std::string(content) + "?: " +
            (!has_document                 ? name
             : *panel == PanelId::kMission ? "DocumentContent & " + name
                                           : "DocumentContent") +
            ";\n";
  }
  return text + "}\nexport type ContentName = keyof Contents;\n";
}

}  // namespace soarbox::workbench
