// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/layout.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "diagnostics/problem.h"
#include "workbench/arrangement.h"

namespace soarbox::viewer {
namespace {

constexpr float kLeastSize = 80, kMostSize = 4000;

Area HomeOf(workbench::PanelId panel) {
  // Few runs take part in an exercise, so the panel is opened only in these.
  if (panel == workbench::PanelId::kExercise) return Area::kLeft;
  static const Layout home = DefaultLayout();
  for (std::size_t i = 0; i < kAreaCount; ++i) {
    const auto& panels = home.areas[i].panels;
    if (std::find(panels.begin(), panels.end(), panel) != panels.end()) return static_cast<Area>(i);
  }
  return Area::kRight;
}

}  // namespace

bool Layout::IsOpen(workbench::PanelId panel) const {
  return std::any_of(areas.begin(), areas.end(), [panel](const AreaLayout& area) {
    return std::find(area.panels.begin(), area.panels.end(), panel) != area.panels.end();
  });
}

bool Layout::IsVisible(workbench::PanelId panel) const {
  return std::any_of(areas.begin(), areas.end(), [panel](const AreaLayout& area) {
    return area.shown && area.front < area.panels.size() && area.panels[area.front] == panel;
  });
}

void Layout::Offer(workbench::PanelId panel) {
  if (!IsOpen(panel)) at(HomeOf(panel)).panels.push_back(panel);
}

void Layout::Show(workbench::PanelId panel) {
  Offer(panel);
  for (AreaLayout& area : areas) {
    const auto found = std::find(area.panels.begin(), area.panels.end(), panel);
    if (found == area.panels.end()) continue;
    area.front = static_cast<std::size_t>(found - area.panels.begin());
    area.shown = true;
  }
}

void Layout::Close(workbench::PanelId panel) {
  for (AreaLayout& area : areas) {
    const auto found = std::find(area.panels.begin(), area.panels.end(), panel);
    if (found == area.panels.end()) continue;
    const auto index = static_cast<std::size_t>(found - area.panels.begin());
    area.panels.erase(found);
    if (area.front > index || area.front == area.panels.size()) area.front = area.front == 0 ? 0 : area.front - 1;
  }
}

void Layout::Move(workbench::PanelId panel, Area area) {
  Close(panel);
  at(area).panels.push_back(panel);
  Show(panel);
}

void Layout::SetText(int percent) {
  text_percent = std::clamp(percent, kLeastText_percent, kMostText_percent);
}

Layout DefaultLayout() {
  const workbench::Arrangement& arranged = workbench::kWorldArrangement;
  Layout layout;
  layout.at(Area::kLeft) = {true, 275, arranged.left, 0};
  layout.at(Area::kRight) = {true, 360, arranged.right, 0};
  layout.at(Area::kBottom) = {true, 190, arranged.bottom, 0};
  return layout;
}

Layout LayoutOf(const std::vector<workbench::PanelId>& panels) {
  Layout layout = DefaultLayout();
  for (AreaLayout& area : layout.areas) {
    area.panels.clear();
    area.front = 0;
    area.shown = false;
  }
  // The first panel of an area is its front panel.
  for (auto panel = panels.rbegin(); panel != panels.rend(); ++panel) {
    AreaLayout& area = layout.at(HomeOf(*panel));
    if (std::find(area.panels.begin(), area.panels.end(), *panel) != area.panels.end()) continue;
    area.panels.insert(area.panels.begin(), *panel);
    area.shown = true;
  }
  return layout;
}

std::string ToText(const Layout& layout) {
  std::ostringstream out;
  out << "# How the window of Soarbox is arranged. Written when it closes; delete it to start over.\n";
  out << "text " << layout.text_percent << '\n';
  out << "colors " << (layout.light ? "light" : "dark") << '\n';
  out << "first-steps " << (layout.first_steps ? "shown" : "hidden") << '\n';
  for (std::size_t i = 0; i < kAreaCount; ++i) {
    const AreaLayout& area = layout.areas[i];
    out << kAreaWords[i] << (area.shown ? " shown " : " hidden ") << static_cast<int>(area.size) << ' ' << area.front;
    for (const workbench::PanelId panel : area.panels) out << ' ' << InfoOf(panel).word;
    out << '\n';
  }
  return out.str();
}

Layout ReadLayout(std::string_view text, Layout layout) {
  std::istringstream lines{std::string(text)};
  std::array<bool, workbench::kPanelCount> placed{};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "text") {
      int percent = 0;
      if (words >> percent) layout.SetText(percent);
      continue;
    }
    std::string shown;
    if (word == "colors") {
      if (words >> shown) layout.light = shown == "light";
      continue;
    }
    if (word == "first-steps") {
      if (words >> shown) layout.first_steps = shown != "hidden";
      continue;
    }
    const auto found = std::find(kAreaWords.begin(), kAreaWords.end(), word);
    float size = 0;
    std::size_t front = 0;
    if (found == kAreaWords.end() || !(words >> shown >> size >> front)) continue;
    AreaLayout& area = layout.areas[static_cast<std::size_t>(found - kAreaWords.begin())];
    area.shown = shown != "hidden";
    area.size = std::clamp(size, kLeastSize, kMostSize);
    area.panels.clear();
    while (words >> word) {
      const auto panel = workbench::FindPanel(word);
      if (!panel || placed[static_cast<std::size_t>(*panel)]) continue;
      placed[static_cast<std::size_t>(*panel)] = true;
      area.panels.push_back(*panel);
    }
    area.front = area.panels.empty() ? 0 : std::min(front, area.panels.size() - 1);
  }
  return layout;
}

std::span<const NamedLayout> ShippedLayouts() {
  static constexpr NamedLayout kShipped[] = {{"Explore", "The default: agents, mind and timeline around the picture"},
                                             {"Debug", "Rules, memory, watch, console and trace; a small picture"},
                                             {"Write rules", "A large editor, with problems and console"},
                                             {"Compare", "Several minds side by side, with messages and plots"}};
  return kShipped;
}

namespace {

/// The layouts that come with the window, as in files. Areas that a text does not contain are those of the default.
std::optional<Layout> ShippedLayout(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> kTexts[] = {
      {"Explore", ""},
      {"Debug",
       "left shown 300 0 rules breakpoints agents problems\n"
       "right shown 420 0 mind memory why links watch edit futures\n"
       "bottom shown 280 0 console trace timeline plots messages minds longterm learning imagery script\n"},
      {"Write rules",
       "left shown 250 0 agents rules\n"
       "right shown 560 0 edit mind why memory links watch breakpoints futures\n"
       "bottom shown 200 0 problems console trace timeline plots messages minds longterm learning imagery script\n"},
      {"Compare",
       "right shown 340 0 watch mind why memory rules links edit breakpoints futures\n"
       "bottom shown 300 0 minds messages plots timeline trace console longterm learning imagery script\n"}};
  for (const auto& [known, text] : kTexts)
    if (known == name) return ReadLayout(text, DefaultLayout());
  return std::nullopt;
}

std::filesystem::path LayoutsFolder() {
  const std::filesystem::path file = LayoutFile();
  return file.empty() ? file : file.parent_path() / "layouts";
}

bool IsName(const std::string& name) {
  return !name.empty() && name.size() <= 40 && name.front() != ' ' && name.back() != ' ' &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == ' ' || c == '-' || c == '_'; });
}

Diagnostic BadName(const std::string& name) {
  return NewProblem("'" + name + "' is not a name for a layout: letters, digits, spaces, '-' and '_', at most 40");
}

}  // namespace

std::optional<Layout> FindLayout(const std::string& name, const Layout& base) {
  std::optional<Layout> found;
  std::error_code error;
  const std::filesystem::path file = LayoutsFolder() / (name + ".ini");
  if (IsName(name) && std::filesystem::exists(file, error))
    found = LoadLayout(file);
  else
    found = ShippedLayout(name);
  if (!found) return found;
  found->text_percent = base.text_percent;
  found->light = base.light;
  found->first_steps = base.first_steps;
  return found;
}

std::vector<std::string> SavedLayouts() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(LayoutsFolder(), error)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() == ".ini" && IsName(path.stem().string())) names.push_back(path.stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Result<void> SaveLayoutAs(const std::string& name, const Layout& layout) {
  if (!IsName(name)) return BadName(name);
  return SaveLayout(layout, LayoutsFolder() / (name + ".ini"));
}

Result<void> RemoveLayout(const std::string& name) {
  if (!IsName(name)) return BadName(name);
  std::error_code error;
  std::filesystem::remove(LayoutsFolder() / (name + ".ini"), error);
  if (!error) return {};
  return NewProblem("the layout '" + name + "' cannot be deleted: " + error.message());
}

std::filesystem::path LayoutFile() {
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config == '/')
    return std::filesystem::path(config) / "soarbox/window.ini";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
    return std::filesystem::path(home) / ".config/soarbox/window.ini";
  return {};
}

Layout LoadLayout(const std::filesystem::path& file) {
  std::ifstream in(file);
  Layout empty = DefaultLayout();
  empty.first_steps = true;
  if (!in) return empty;
  // Real layouts are shorter; other files are not read completely.
  std::string text(4096, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return ReadLayout(text, empty);
}

Result<void> SaveLayout(const Layout& layout, const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  std::filesystem::path whole = file;
  whole += ".new";
  {
    std::ofstream out(whole);
    out << ToText(layout);
    out.close();
    if (!out) error = std::make_error_code(std::errc::io_error);
  }
  if (!error) std::filesystem::rename(whole, file, error);
  if (!error) return {};
  Diagnostic failure;
  failure.severity = Severity::kWarning;
  failure.file = file.string();
  failure.message = "the window's layout cannot be saved: " + error.message();
  failure.hint = "may you write to this folder?";
  return failure;
}

}  // namespace soarbox::viewer
