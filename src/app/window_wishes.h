// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace soarbox::app {

/// Options of a window for a run or a recording. The next window that the user opens from it gets the same options.
struct WindowWishes {
  std::string detail = "auto";  ///< Of the picture: low, full, or auto (depends on the machine).
  double render_scale = 0;      ///< Scale at which the scene is drawn; 0: depends on the machine.
  std::string panels;  ///< The panels that it shows, "default" or their words; empty: the user's own arrangement, or
                       ///< none in a picture.
  int text_percent = 100;                  ///< Of the panels named above.
  std::optional<int> width_px, height_px;  ///< None: depends on the display, or the size of the recorded window.
  bool browser = false;                    ///< Show a page in a browser instead of the window.
  std::filesystem::path page;              ///< With `browser`: the folder of the page; empty: the program's own.
  std::filesystem::path ui_script;         ///< Plays the user of the window; empty: none.
  std::size_t ui_script_from = 0;          ///< Number of its steps that another window has already executed.
};

}  // namespace soarbox::app
