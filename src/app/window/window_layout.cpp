// SPDX-License-Identifier: BSD-2-Clause
#include "app/window/window_layout.h"

#include <sstream>
#include <string_view>
#include <vector>

#include "diagnostics/nearest_hint.h"
#include "diagnostics/problem.h"

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
        std::vector<std::string_view> all;
        std::string list = "it is 'default', 'none', or a comma-separated list of:";
        for (const workbench::PanelInfo& info : workbench::kPanelInfos) {
          all.push_back(info.word);
          list += " " + std::string(info.word);
        }
        return NewProblem("there is no panel '" + word + "'", NearestHint(word, all, std::move(list)));
      }
      panels.push_back(*panel);
    }
    layout = viewer::LayoutOf(panels);
  }
  layout.SetText(text_percent);
  return layout;
}

}  // namespace soarbox::app
