// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/panels/layout.h"
#include "viewer/panels/panel_fonts.h"
#include "viewer/viewer.h"
#include "viewer/viewer_command.h"
#include "workbench/contents.h"
#include "workbench/requests.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// The input of the panels of a frame, and the requests that the user makes while they are drawn.
struct PanelFrame {
  const workbench::Contents& contents;
  const world::SceneSnapshot& scene;
  const RunStatus& status;
  PanelFonts fonts;
  float scale = 1;  ///< Of texts: 1 is 100 %.
  Layout& layout;
  std::uint32_t& selected;  ///< Id of the selected agent; 0: none.
  std::vector<workbench::Request>& requests;
  std::vector<ViewerCommand>& commands;
  std::function<bool(ViewerCommand)> is_on;  ///< Whether an overlay or a camera mode is on.

  /// A length in px, scaled with the text size.
  float Px(float length) const { return length * scale; }
  void Ask(workbench::Request request) { requests.push_back(std::move(request)); }
  /// Sends a request whose result another panel shows, and brings that panel to the front.
  void AskIn(workbench::PanelId panel, workbench::Request request) {
    Ask(std::move(request));
    layout.Show(panel);
  }
  void Command(ViewerCommand command) { commands.push_back(command); }
  const world::AgentSnapshot* Selected() const {
    for (const world::AgentSnapshot& agent : scene.agents) {
      if (agent.id == selected) return &agent;
    }
    return nullptr;
  }
  /// Selects the agent of this name if it is in the scene.
  void Select(std::string_view name) {
    for (const world::AgentSnapshot& agent : scene.agents) {
      if (agent.name == name) selected = agent.id;
    }
  }
};

/// A panel. It is drawn into its own child window and stores the user's settings (filters, unfolded parts).
class Panel {
 public:
  virtual ~Panel() = default;
  virtual void Draw(PanelFrame& frame) = 0;
  /// Its contents as text for the clipboard; empty if there is nothing to copy.
  virtual std::string Text(const PanelFrame& frame) const = 0;
  /// A sentence about typed text that would be lost with the window; empty: none.
  virtual std::string Unsent() const { return {}; }
};

std::unique_ptr<Panel> MakeTimelinePanel();
std::unique_ptr<Panel> MakeEditPanel();

}  // namespace soarbox::viewer
