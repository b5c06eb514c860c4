// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace soarbox::app {

/// What is asked of a window, whatever it shows. The next window of the same user is opened with the same wishes.
struct WindowWishes {
  std::string detail = "auto";  ///< Of the picture: low, full, or what suits the machine.
  double render_scale = 0;      ///< Share of the picture's size that the scene is drawn in; 0: what suits the machine.
  std::string panels;           ///< Which panels it shows, "default" or their words; empty: the user's own arrangement,
                                ///< or none in a picture.
  int text_percent = 100;       ///< Of the panels named above.
  std::optional<int> width_px, height_px;  ///< None: what suits the display, or as large as the recorded window was.
  bool browser = false;                    ///< A page in a browser instead.
  std::filesystem::path page;              ///< Then: the folder of that page; empty: the program's own.
  std::filesystem::path ui_script;         ///< Plays the user of the window; empty: none.
  std::size_t ui_script_from = 0;          ///< So many of its steps another window has done.
};

}  // namespace soarbox::app
