// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/mind_note.h"

#include <optional>

#include "debugger/file_place.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {

void GoToFile(PanelFrame& frame, const std::string& file, int line) {
  if (frame.contents.moment.is_recording || !debugger::IsEditable(file)) {
    frame.Ask(workbench::OpenFileRequest{file, line});
  } else {
    frame.AskIn(workbench::PanelId::kEdit, workbench::EditRequest{file, line});
  }
}

void TextWithPlace(PanelFrame& frame, const char* id, std::string_view text, ImVec4 color) {
  const std::optional<debugger::FilePlace> place = debugger::FindFilePlace(text);
  if (!place) return ColoredText(color, text);
  if (Link(id, text, color)) GoToFile(frame, place->file, place->line);
  Tooltip("Click to go to line " + std::to_string(place->line) + " of " + place->file);
}

void ShowObject(PanelFrame& frame, std::string_view id) {
  frame.AskIn(workbench::PanelId::kMemory, workbench::ObjectRequest{std::string(id), true});
}

}  // namespace soarbox::viewer
