// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "workbench/panel_id.h"

namespace soarbox::viewer {

/// Where panels stand around the picture.
enum class Area : std::uint8_t { kLeft, kRight, kBottom };
inline constexpr std::size_t kAreaCount = 3;
inline constexpr std::array<std::string_view, kAreaCount> kAreaWords{"left", "right", "bottom"};

/// One side of the picture: panels as tabs, one of them in front.
struct AreaLayout {
  bool shown = true;
  float size = 300;  ///< Width, or height at the bottom, in px at 100 % text size.
  std::vector<workbench::PanelId> panels;
  std::size_t front = 0;  ///< Index into `panels`; meaningless while there are none.
};

/// How a user has arranged the window. A panel stands in at most one area.
struct Layout {
  static constexpr int kLeastText_percent = 75, kMostText_percent = 200;

  std::array<AreaLayout, kAreaCount> areas;
  int text_percent = 100;
  bool light = false;        ///< Dark letters on a light ground.
  bool first_steps = false;  ///< A new user is led through the window.

  AreaLayout& at(Area area) { return areas[static_cast<std::size_t>(area)]; }
  const AreaLayout& at(Area area) const { return areas[static_cast<std::size_t>(area)]; }

  /// Whether the panel is in front of its area, and the area is shown.
  bool IsVisible(workbench::PanelId panel) const;
  bool IsOpen(workbench::PanelId panel) const;
  /// Opens the panel (where it belongs by default, if it was closed) and brings it to the front.
  void Show(workbench::PanelId panel);
  /// Opens it behind the others of its area, if it is not open.
  void Offer(workbench::PanelId panel);
  void Close(workbench::PanelId panel);
  void Move(workbench::PanelId panel, Area area);
  void SetText(int percent);
};

/// What a new user sees.
Layout DefaultLayout();
/// Only these panels are open, each where it belongs.
Layout LayoutOf(const std::vector<workbench::PanelId>& panels);

/// The layout as lines of text, and back. What a file says that we do not understand is passed over; what it does not
/// say stays as in `base`.
std::string ToText(const Layout& layout);
Layout ReadLayout(std::string_view text, Layout base);

/// Layouts that come with the window, for tasks: a name and a sentence each.
struct NamedLayout {
  std::string_view name, about;
};
std::span<const NamedLayout> ShippedLayouts();
/// The layout of this name, one that was saved before one that comes with the window. Text size, colours and first
/// steps stay as in `base`. Nothing if there is none.
std::optional<Layout> FindLayout(const std::string& name, const Layout& base);
/// Names of layouts that were saved, sorted.
std::vector<std::string> SavedLayouts();
/// Saves a layout under a name: letters, digits, spaces, '-' and '_'.
Result<void> SaveLayoutAs(const std::string& name, const Layout& layout);
Result<void> RemoveLayout(const std::string& name);

/// Where the layout is remembered: $XDG_CONFIG_HOME/soarbox/window.ini, or below ~/.config. Empty if there is no home.
std::filesystem::path LayoutFile();
/// The remembered layout, or the default one if there is none or it cannot be read; users without one are led through
/// the window.
Layout LoadLayout(const std::filesystem::path& file);
/// Writes it, whole or not at all.
Result<void> SaveLayout(const Layout& layout, const std::filesystem::path& file);

}  // namespace soarbox::viewer
