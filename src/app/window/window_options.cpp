// SPDX-License-Identifier: BSD-2-Clause
#include "app/window/window_options.h"

#include <iostream>

#include "app/refuse.h"
#include "app/window/window_layout.h"

namespace soarbox::app {
namespace {

/// Panels on the command line are used once; otherwise the user's own arrangement is used and saved.
bool HasOwnLayout(const WindowWishes& wishes) {
  return wishes.panels.empty() && wishes.ui_script.empty();
}

}  // namespace

Result<viewer::ViewerOptions> WindowOptionsOf(const WindowWishes& wishes, const sim::DataFolders& data, bool hidden) {
  viewer::ViewerOptions window;
  window.media_dir = data.media;
  window.hidden = hidden;
  window.vsync = !hidden;
  window.frame_agents = true;
  window.detail = wishes.detail == "low"    ? viewer::Detail::kLow
                  : wishes.detail == "full" ? viewer::Detail::kFull
                                            : viewer::Detail::kAuto;
  window.render_scale = wishes.render_scale;
  window.ui_script = wishes.ui_script;
  window.ui_script_from = wishes.ui_script_from;
  window.on_diagnostic = [](const Diagnostic& diagnostic) { std::cerr << Format(diagnostic); };
  if (!wishes.panels.empty()) {
    Result<viewer::Layout> layout = LayoutNamed(wishes.panels, wishes.text_percent);
    if (!layout) return layout.error();
    window.layout = *layout;
  } else if (!hidden) {
    window.layout = HasOwnLayout(wishes) ? viewer::LoadLayout(viewer::LayoutFile()) : viewer::DefaultLayout();
  }
  return window;
}

int AfterWindow(const viewer::Viewer& viewer, const WindowWishes& wishes, int code) {
  if (HasOwnLayout(wishes) && !viewer::LayoutFile().empty()) {
    if (const Result<void> saved = viewer::SaveLayout(viewer.layout(), viewer::LayoutFile()); !saved)
      std::cerr << Format(saved.error());
  }
  const std::optional<Diagnostic> failure = viewer.ui_script().failure;
  return failure ? Refuse(*failure) : code;
}

}  // namespace soarbox::app
