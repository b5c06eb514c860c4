// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// A list over the picture for searching. It offers commands, panels, agents, rules, files and texts that contain the
/// typed text; or scenarios and recordings to open. Enter executes the selected line, Esc closes the list.
class Finder {
 public:
  enum class For : std::uint8_t { kAnything, kScenario, kRecording };

  void Open(For what);
  void Close() { wants_close_ = is_open_; }
  bool is_open() const { return is_open_; }
  /// An action of the window, in the order of its menu. Without a title it separates groups of a menu.
  struct Action {
    std::string menu, title = {}, keys = {}, about = {};
    std::function<void()> act = {};
    bool is_on = false;
  };
  /// Draws the list if it is open.
  void Draw(PanelFrame& frame, float width, float height, const std::vector<Action>& more);

 private:
  struct Item {
    const char* kind;
    std::string title, detail;
    std::function<void()> act;
  };
  std::vector<Item> Items(PanelFrame& frame, const std::vector<Action>& more) const;
  void AddAnything(PanelFrame& frame, const std::vector<Action>& more, std::vector<Item>& items) const;
  void AddPlaces(PanelFrame& frame, std::vector<Item>& items) const;
  void AddOffers(PanelFrame& frame, std::vector<Item>& items) const;
  void DrawRows(PanelFrame& frame, const std::vector<Item>& items, bool chosen);
  void Leave(PanelFrame& frame);

  For for_ = For::kAnything;
  bool is_open_ = false, wants_focus_ = false, wants_close_ = false;
  std::string text_;
  std::optional<std::string> asked_;  // The text of the last search; nothing after opening.
  std::size_t at_ = 0;
};

}  // namespace soarbox::viewer
