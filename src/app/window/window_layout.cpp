// SPDX-License-Identifier: BSD-2-Clause
#include "app/window/window_layout.h"

#include <sstream>
#include <string_view>
#include <vector>

namespace soarbox::app {

Result<viewer::Layout> LayoutNamed(const std::string& named, int text_percent) {
  viewer::Layout layout = viewer::DefaultLayout();
  if (named == "none") {
    layout = viewer::LayoutOf({});
  } else if (named != "default") {
    std::vector<workbench::PanelId> panels;
    std::istringstream words(named);
    for (std::string word; std::getline(words, word, ',');) {
      const auto panel = workbench::FindPanel(word);
      if (!panel) {
        Diagnostic problem;
        problem.message = "there is no panel '" + word + "'";
        std::vector<std::string_view> all;
        for (const workbench::PanelInfo& info : workbench::kPanelInfos) all.push_back(info.word);
        const std::string_view near = Suggest(word, all);
        if (!near.empty()) {
          problem.hint = "did you mean '" + std::string(near) + "'?";
        } else {
          problem.hint = "it is 'default', 'none', or a comma-separated list of:";
          for (const std::string_view known : all) problem.hint += " " + std::string(known);
        }
        return problem;
      }
      panels.push_back(*panel);
    }
    layout = viewer::LayoutOf(panels);
  }
  layout.SetText(text_percent);
  return layout;
}

}  // namespace soarbox::app
