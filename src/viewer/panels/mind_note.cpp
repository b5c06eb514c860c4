// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/mind_note.h"

#include <optional>

#include "debugger/file_place.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {

bool HasMind(PanelFrame& frame) {
  const workbench::Contents& contents = frame.contents;
  if (contents.agent.empty()) {
    EmptyNote("No agent is selected.", "Click one in the scene or in the list of agents, or press Tab.");
    return false;
  }
  if (!contents.has_mind) {
    EmptyNote(contents.agent + " has no Soar mind.", "Its script decides what it does. Select another agent.");
    return false;
  }
  if (!contents.not_available.empty()) {
    EmptyNote(contents.not_available);
    return false;
  }
  if (!contents.past_note.empty()) {
    Tag("as recorded", theme::kAccent);
    Tooltip("What the recording holds of this moment. " + contents.past_note);
    ImGui::SameLine();
    CutText(contents.past_note, ImGui::GetContentRegionAvail().x, theme::kQuiet);
  }
  return true;
}

void RuleLink(PanelFrame& frame, std::string_view rule) {
  const std::string name(rule);
  const std::string shown = FittingText(name, ImGui::GetContentRegionAvail().x);
  if (Link(name.c_str(), shown)) frame.AskIn(workbench::PanelId::kRules, workbench::RuleRequest{name});
  Tooltip(shown == name ? "Click to see this rule" : name);
}

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
  frame.shown_object = id;
  frame.AskIn(workbench::PanelId::kMemory, workbench::ObjectRequest{std::string(id), true});
}

}  // namespace soarbox::viewer
