// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <bitset>
#include <deque>
#include <string>

union SDL_Event;

namespace soarbox::viewer {

/// Gives the panels their share of the user's input: the mouse over panels and menus, keys while somebody types there.
///
/// ImGui gets everything in order, and never a press and its release in one frame, so that a click that is
/// shorter than a frame is not lost.
class PanelInput {
 public:
  PanelInput();
  ~PanelInput();
  PanelInput(const PanelInput&) = delete;
  PanelInput& operator=(const PanelInput&) = delete;

  /// Where the picture stands, whether something lies over it, and how large the window is.
  void SetPicture(int x, int y, int width, int height, bool is_covered);

  /// Where something lies over a part of the picture, in px; of no size: nowhere.
  void SetCover(int x, int y, int width, int height) { cover_ = {x, y, width, height}; }

  /// Notes an event for the panels. True if it is theirs alone; otherwise the mouse's place in it has become one in the
  /// picture.
  bool Take(SDL_Event& event);
  /// The keyboard leaves the field that has it, after what was typed so far; the text stays.
  void LeaveField() { notes_.push_back({Kind::kLeave}); }
  /// Hands what was noted to ImGui; before each frame.
  void Apply();

  /// Gives the mouse the shape that the panel under it asks for; after each frame.
  void ShowCursor();
  /// Nothing waits to be handed over.
  bool idle() const { return notes_.empty(); }

  /// The mouse is over a panel.
  bool has_mouse() const { return over_panel_; }
  /// Somebody types into a panel.
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
  std::bitset<8> panel_buttons_, world_buttons_;  ///< Held down, by where they went down.
  std::bitset<512> world_keys_;
  std::array<void*, 9> cursors_{};
  int cursor_ = -1;
};

}  // namespace soarbox::viewer
