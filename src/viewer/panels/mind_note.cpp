// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/mind_note.h"

#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
bool HasMind(PanelFrame& frame) {
  const PanelContents& contents = frame.contents;
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
  if (Link(name.c_str(), name)) {
    frame.Ask(RuleRequest{name});
    frame.layout.Show(PanelId::kRules);
  }
}

void ShowObject(PanelFrame& frame, std::string_view id) {
  frame.shown_object = id;
  frame.Ask(ObjectRequest{std::string(id), true});
  frame.layout.Show(PanelId::kMemory);
}

}  // namespace soarbox::viewer
