// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "viewer/window_input.h"

union SDL_Event;

namespace soarbox::viewer {

/// Reads gamepads: opens those that are plugged in, and reports their buttons and axes by the names that scripts use.
/// Values of axes are rounded to two digits, are 0 near rest, and are reported at most once per frame.
class PadReader {
 public:
  ~PadReader();

  /// Returns false if the event is not about a gamepad. Button events are appended to `events` at once.
  bool Handle(const SDL_Event& event, std::vector<InputEvent>& events);
  /// Reports the axes that have moved since the last call.
  void ReportAxes(std::vector<InputEvent>& events);

 private:
  struct Pad {
    int number = 0;          ///< The lowest number, from 1, that no other gamepad has.
    void* opened = nullptr;  ///< SDL's handle; null if it could not be opened.
    std::map<std::string, float> reported;
    std::map<std::string, float> moved;  ///< Axes since the last report.
  };
  Pad& Of(int instance);
  void Remove(int instance, std::vector<InputEvent>& events);

  std::map<int, Pad> pads_;  ///< By SDL's number, which is never used twice.
};

}  // namespace soarbox::viewer
