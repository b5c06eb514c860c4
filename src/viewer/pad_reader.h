// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "viewer/window_input.h"

union SDL_Event;

namespace soarbox::viewer {

/// Reads gamepads: opens those that are plugged in, and reports their buttons and axes in the words of scripts. Axes
/// have two digits, are 0 near their rest, and are reported once per frame at most.
class PadReader {
 public:
  ~PadReader();

  /// False if the event is not about a gamepad. Buttons go to `events` at once.
  bool Handle(const SDL_Event& event, std::vector<InputEvent>& events);
  /// Reports the axes that have moved since the last call.
  void ReportAxes(std::vector<InputEvent>& events);

 private:
  struct Pad {
    int number = 0;          ///< From 1: the lowest that no other one has.
    void* opened = nullptr;  ///< SDL's handle; null if it could not be opened.
    std::map<std::string, float> reported;
    std::map<std::string, float> moved;  ///< Axes since the last report.
  };
  Pad& Of(int instance);
  void Remove(int instance, std::vector<InputEvent>& events);

  std::map<int, Pad> pads_;  ///< By SDL's number, which is never used twice.
};

}  // namespace soarbox::viewer
