// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/pad_reader.h"

#include <SDL.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace soarbox::viewer {
namespace {

constexpr int kPadsHeard = 8;
/// Sticks at rest report values near 0, not exactly 0. Pages use the same limit.
constexpr float kDeadZone = 0.12f;

/// By SDL_GameControllerButton.
constexpr std::array<const char*, 15> kPadButtons{"a_button",
                                                  "b_button",
                                                  "x_button",
                                                  "y_button",
                                                  "back_button",
                                                  "guide_button",
                                                  "start_button",
                                                  "left_stick_button",
                                                  "right_stick_button",
                                                  "left_shoulder_button",
                                                  "right_shoulder_button",
                                                  "up_button",
                                                  "down_button",
                                                  "left_button",
                                                  "right_button"};
/// By SDL_GameControllerAxis.
constexpr std::array<const char*, 6> kPadAxes{"left_x",  "left_y",       "right_x",
                                              "right_y", "left_trigger", "right_trigger"};

float AxisValue(int raw) {
  const float value = std::clamp(static_cast<float>(raw) / 32767.0f, -1.0f, 1.0f);
  return std::abs(value) < kDeadZone ? 0 : std::round(value * 100) / 100;
}

InputEvent PadEvent(int pad, std::string name, float value) {
  InputEvent event;
  event.kind = InputKind::kPad;
  event.pad = pad;
  event.name = std::move(name);
  event.value = value;
  event.pressed = value != 0;
  return event;
}

}  // namespace

PadReader::~PadReader() {
  for (const auto& [instance, pad] : pads_)
    if (pad.opened != nullptr) SDL_GameControllerClose(static_cast<SDL_GameController*>(pad.opened));
}

PadReader::Pad& PadReader::Of(int instance) {
  const auto [place, is_new] = pads_.try_emplace(instance);
  if (!is_new) return place->second;
  int number = 1;
  const auto is_used = [&](int wanted) {
    return std::ranges::any_of(pads_, [wanted](const auto& other) { return other.second.number == wanted; });
  };
  while (is_used(number)) ++number;
  place->second.number = number;
  return place->second;
}

void PadReader::Remove(int instance, std::vector<InputEvent>& events) {
  const auto found = pads_.find(instance);
  if (found == pads_.end()) return;
  // Releases all its buttons and axes.
  for (const auto& [name, value] : found->second.reported)
    if (value != 0) events.push_back(PadEvent(found->second.number, name, 0));
  if (found->second.opened != nullptr) SDL_GameControllerClose(static_cast<SDL_GameController*>(found->second.opened));
  pads_.erase(found);
}

bool PadReader::Handle(const SDL_Event& event, std::vector<InputEvent>& events) {
  switch (event.type) {
    case SDL_CONTROLLERDEVICEADDED:
      if (SDL_GameController* const opened = SDL_GameControllerOpen(event.cdevice.which); opened != nullptr)
        Of(SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(opened))).opened = opened;
      return true;
    case SDL_CONTROLLERDEVICEREMOVED:
      Remove(event.cdevice.which, events);
      return true;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP: {
      Pad& pad = Of(event.cbutton.which);
      if (event.cbutton.button >= kPadButtons.size() || pad.number > kPadsHeard) return true;
      const std::string name = kPadButtons[event.cbutton.button];
      const float value = event.type == SDL_CONTROLLERBUTTONDOWN ? 1.0f : 0.0f;
      if (std::exchange(pad.reported[name], value) != value) events.push_back(PadEvent(pad.number, name, value));
      return true;
    }
    case SDL_CONTROLLERAXISMOTION: {
      Pad& pad = Of(event.caxis.which);
      if (event.caxis.axis < kPadAxes.size() && pad.number <= kPadsHeard)
        pad.moved[kPadAxes[event.caxis.axis]] = AxisValue(event.caxis.value);
      return true;
    }
    default:
      return false;
  }
}

void PadReader::ReportAxes(std::vector<InputEvent>& events) {
  for (auto& [instance, pad] : pads_) {
    for (const auto& [name, value] : pad.moved)
      if (std::exchange(pad.reported[name], value) != value) events.push_back(PadEvent(pad.number, name, value));
    pad.moved.clear();
  }
}

}  // namespace soarbox::viewer
