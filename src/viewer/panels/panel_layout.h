// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "viewer/panels/close_question.h"
#include "viewer/panels/finder.h"
#include "viewer/panels/first_steps.h"
#include "viewer/panels/panel.h"

namespace soarbox::viewer {

/// A rectangle of the window, in px from the top left.
struct PictureRect {
  int x = 0, y = 0, width = 1, height = 1;
  bool Holds(float px, float py) const {
    return px >= static_cast<float>(x) && py >= static_cast<float>(y) && px < static_cast<float>(x + width) &&
           py < static_cast<float>(y + height);
  }
  friend bool operator==(const PictureRect&, const PictureRect&) = default;
};

/// The frame around the picture: menu bar, toolbar, the panels on three sides with their tabs, the scrubber.
///
/// It only draws; requests of the user go into the frame's lists. Only the front panel of each area is drawn.
class Workspace {
 public:
  explicit Workspace(Layout layout);

  /// Returns the space for the picture in a window of this size, at the layout's text size.
  PictureRect PictureIn(int width, int height) const;
  void Draw(PanelFrame& frame, int width, int height, float frames_per_second);

  /// Whether a menu or another thing covers the picture and takes the mouse everywhere.
  bool IsModal() const { return modal_; }

  /// Called when the window is about to close. Returns true if it may close; false if the user is asked, and kQuit
  /// follows if the user agrees.
  bool MayClose(const workbench::Contents& contents);
  /// Withdraws the question whether to close the window. Returns true if it was open.
  bool StayOpen() { return closing_.is_open() ? (closing_.Stay(), true) : false; }

  /// Opens the search for commands, panels, agents, rules, files and texts, or for something to open.
  void Find(Finder::For what) { finder_.Open(what); }
  /// Returns true if it was open.
  bool CloseFinder() { return finder_.is_open() ? (finder_.Close(), true) : false; }

  /// Brings a panel to the front and gives it the keyboard.
  void Open(workbench::PanelId panel);
  /// Gives the keyboard to the field of the panel under the mouse, else of the panel used last.
  void FocusField() {
    focus_ = used_;
    focus_waits_ = 0;
  }
  /// Copies the contents of that panel to the clipboard.
  void CopyPanel() { wants_copy_ = true; }
  /// The part of the picture that a strip covers. Mouse input there does not reach the scene. Empty: none.
  PictureRect cover() const { return cover_; }

  Layout layout;
  bool show_help = false;
  bool only_picture = false;  ///< All panels are temporarily hidden.

 private:
  /// Positions and sizes of all parts, in px.
  struct Metrics {
    float scale, menu, toolbar, scrubber;
    float across, down;  ///< Length of one unit of an area's width and height.
    float width, height;
    float left, right, bottom;  ///< Sizes of the areas; 0: hidden.
    float top() const { return menu + toolbar; }
    float floor() const { return height - scrubber - bottom; }
  };
  Metrics Measure(int width, int height) const;
  void DrawMenus(PanelFrame& frame);
  void DrawFileMenu(PanelFrame& frame);
  void DrawLayoutMenu(PanelFrame& frame);
  /// Arranges the panels so; the size of texts and the colors stay.
  void UseLayout(Layout wanted);
  /// The actions of the window, for menus and the finder.
  std::vector<Finder::Action> Actions(PanelFrame& frame);
  void DrawActions(PanelFrame& frame, std::string_view menu);
  void DrawToolbar(PanelFrame& frame, const Metrics& metrics, float frames_per_second);
  void DrawScrubber(PanelFrame& frame, const Metrics& metrics);
  void DrawArea(PanelFrame& frame, Area area, const Metrics& metrics);
  void DrawTabs(PanelFrame& frame, Area area);
  void DrawOtherTabs(PanelFrame& frame, const std::vector<workbench::PanelId>& panels,
                     const std::vector<workbench::PanelId>& shown);
  void DrawTabMenu(PanelFrame& frame, workbench::PanelId panel);
  void Copy(PanelFrame& frame, workbench::PanelId panel);
  void DrawSplitter(Area area, ImVec2 corner, ImVec2 size, const Metrics& metrics);
  void DrawHelp(PanelFrame& frame, int width, int height);

  std::array<std::unique_ptr<Panel>, workbench::kPanelCount> panels_;
  bool modal_ = false;
  FirstSteps first_steps_;
  Closing closing_;
  Finder finder_;
  PictureRect cover_{0, 0, 0, 0};
  workbench::PanelId used_ =
      workbench::PanelId::kAgents;  ///< The panel under the mouse at its last movement, or opened by key since then.
  std::optional<workbench::PanelId> focus_;  ///< The panel whose field takes the keyboard as soon as it has one.
  int focus_waits_ = 0;                      ///< Number of frames in which that panel had no field.
  bool wants_copy_ = false;
  std::string layout_name_;  ///< As typed into the menu of layouts.
  std::string layout_fault_;
};

}  // namespace soarbox::viewer
