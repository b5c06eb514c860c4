// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <bitset>
#include <deque>
#include <string>

union SDL_Event;

namespace soarbox::viewer {

/// Passes the user's input to the panels: the mouse over panels and menus, and keys while the user types there.
///
/// ImGui receives all events in order. It never receives a press and its release in the same frame. So a click that is
/// shorter than a frame is not lost.
class PanelInput {
 public:
  PanelInput();
  ~PanelInput();
  PanelInput(const PanelInput&) = delete;
  PanelInput& operator=(const PanelInput&) = delete;

  /// Sets the rectangle of the picture, whether something covers it, and the size of the window.
  void SetPicture(int x, int y, int width, int height, bool is_covered);

  /// Sets the part of the picture that something covers, in px; zero size: none.
  void SetCover(int x, int y, int width, int height) { cover_ = {x, y, width, height}; }

  /// Notes an event for the panels. Returns true if it concerns only them. Otherwise the mouse position in the event is
  /// converted to picture coordinates.
  bool Take(SDL_Event& event);
  /// Removes the focus from the current field after the text that was typed so far; the text is kept.
  void LeaveField() { notes_.push_back({Kind::kLeave}); }
  /// Passes the noted events to ImGui. Call it before each frame.
  void Apply();

  /// Sets the mouse cursor that the panel under it requests. Call it after each frame.
  void ShowCursor();
  /// Whether no event waits.
  bool idle() const { return notes_.empty(); }

  /// Whether the mouse is over a panel.
  bool has_mouse() const { return over_panel_; }
  /// Whether the user types into a panel.
  bool has_keys() const;

 private:
  enum class Kind { kMove, kButton, kWheel, kKey, kText, kLeave };
  struct Note {
    Kind kind;
    float x = 0, y = 0;
    int index = 0;
    bool pressed = false;
    int modifiers = 0;
    std::string text = {};
  };
  bool IsOverPanel(float x, float y) const;

  std::deque<Note> notes_;
  int x_ = 0, y_ = 0, width_ = 1, height_ = 1;
  std::array<int, 4> cover_{};  ///< x, y, width, height.
  bool is_covered_ = false, over_panel_ = false;
  std::bitset<8> panel_buttons_, world_buttons_;  ///< Pressed buttons, by the place where they were pressed.
  std::bitset<512> world_keys_;
  std::array<void*, 9> cursors_{};
  int cursor_ = -1;
};

}  // namespace soarbox::viewer
