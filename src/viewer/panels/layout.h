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

/// The places of panels around the picture.
enum class Area : std::uint8_t { kLeft, kRight, kBottom };
inline constexpr std::size_t kAreaCount = 3;
inline constexpr std::array<std::string_view, kAreaCount> kAreaWords{"left", "right", "bottom"};

/// One side of the picture: panels as tabs, one of them at the front.
struct AreaLayout {
  bool shown = true;
  float size = 300;  ///< Width, or height at the bottom, in px at 100 % text size.
  std::vector<workbench::PanelId> panels;
  std::size_t front = 0;  ///< Index into `panels`; meaningless if `panels` is empty.
};

/// The user's arrangement of the window. A panel is in at most one area.
struct Layout {
  static constexpr int kLeastText_percent = 75, kMostText_percent = 200;

  std::array<AreaLayout, kAreaCount> areas;
  int text_percent = 100;
  bool light = false;        ///< Dark text on a light background.
  bool first_steps = false;  ///< The window guides a new user (FirstSteps).

  AreaLayout& at(Area area) { return areas[static_cast<std::size_t>(area)]; }
  const AreaLayout& at(Area area) const { return areas[static_cast<std::size_t>(area)]; }

  /// Whether the panel is the front one of its area, and the area is shown.
  bool IsVisible(workbench::PanelId panel) const;
  bool IsOpen(workbench::PanelId panel) const;
  /// Opens the panel (in its default area if it was closed) and brings it to the front.
  void Show(workbench::PanelId panel);
  /// If the panel is not open, adds it as the last tab of its default area. The front tab stays.
  void Offer(workbench::PanelId panel);
  void Close(workbench::PanelId panel);
  void Move(workbench::PanelId panel, Area area);
  void SetText(int percent);
};

/// The layout for new users.
Layout DefaultLayout();
/// A layout in which only these panels are open, each in its default area.
Layout LayoutOf(const std::vector<workbench::PanelId>& panels);

/// Converts the layout to lines of text, and back. Unknown entries of a file are ignored. Missing entries keep the
/// values of `base`.
std::string ToText(const Layout& layout);
Layout ReadLayout(std::string_view text, Layout base);

/// Layouts that come with the window, for certain tasks: a name and a sentence each.
struct NamedLayout {
  std::string_view name, about;
};
std::span<const NamedLayout> ShippedLayouts();
/// Returns the layout with this name; a saved one takes precedence over one that comes with the window. Text size,
/// colours and first steps are those of `base`. Nothing if there is none.
std::optional<Layout> FindLayout(const std::string& name, const Layout& base);
/// Names of saved layouts, sorted.
std::vector<std::string> SavedLayouts();
/// Saves a layout under a name: letters, digits, spaces, '-' and '_'.
Result<void> SaveLayoutAs(const std::string& name, const Layout& layout);
Result<void> RemoveLayout(const std::string& name);

/// Path of the file that stores the layout: $XDG_CONFIG_HOME/soarbox/window.ini, or below ~/.config. Empty without a
/// home folder.
std::filesystem::path LayoutFile();
/// Reads the stored layout. Returns the default layout if there is none or it cannot be read; the window then guides
/// the user.
Layout LoadLayout(const std::filesystem::path& file);
/// Writes the file atomically.
Result<void> SaveLayout(const Layout& layout, const std::filesystem::path& file);

}  // namespace soarbox::viewer
