// SPDX-License-Identifier: BSD-2-Clause
#include "app/window.h"

#include <algorithm>
#include <cstdlib>

#include "app/sibling_program.h"

namespace soarbox::app {
namespace {

/// The variable in which soarbox passes its build id to soarbox-window.
constexpr char kWindowOf[] = "SOARBOX_WINDOW_OF";

const Window*& TheWindow() {
  static const Window* window = nullptr;
  return window;
}

}  // namespace

const Window* ProgramWindow() {
  return TheWindow();
}

void SetProgramWindow(const Window* window) {
  TheWindow() = window;
}

bool CanOpenWindow() {
  return ProgramWindow() != nullptr && ProgramWindow()->CanOpen();
}

bool Window::CanOpen() const {
  return HasDisplay();
}

bool HasDisplay() {
  const char* display = std::getenv("DISPLAY");
  return display != nullptr && *display != '\0';
}

void GoOnInWindow(char** argv) {
  if (ProgramWindow() != nullptr || !HasDisplay()) return;
  // Passes this program's build id on. Both programs belong to one build, but the linker gives each its own id.
  setenv(kWindowOf, record::BuildId().c_str(), 1);
  GoOnAs("soarbox-window", argv);
  unsetenv(kWindowOf);
}

void BeThatBuild() {
  if (const char* id = std::getenv(kWindowOf)) record::SetBuildId(id);
}

WindowSize WindowSizeOf(const RunOptions& options) {
  WindowSize size;
  const bool is_looked_at = options.screenshot.empty() && options.ui_script.empty() && !options.headless;
  const Window* window = ProgramWindow();
  if (!options.width_px && !options.height_px && is_looked_at && window != nullptr) {
    if (const auto room = window->RoomOnDisplay()) {
      // Maximum size. A larger window does not show more that a user can see at a glance.
      constexpr int kMostWidth = 2560, kMostHeight = 1440;
      const auto share = [](int whole, int least, int most) {
        constexpr double kShare = 0.92;
        return std::min({std::max(static_cast<int>(kShare * whole), least), whole, most});
      };
      size = {share(room->first, size.width, kMostWidth), share(room->second, size.height, kMostHeight)};
    }
  }
  return {options.width_px.value_or(size.width), options.height_px.value_or(size.height)};
}

}  // namespace soarbox::app
