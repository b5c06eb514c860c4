// SPDX-License-Identifier: BSD-2-Clause
#include "sim/input_names.h"

#include <algorithm>
#include <sstream>

namespace soarbox::sim {
namespace {

/// All keys except letters, digits and function keys, without "_key".
constexpr const char* kKeys =
    "add subtract multiply divide decimal numpad_enter numpad_equals numpad_comma numlock "
    "escape tab space return back insert delete home end page_up page_down up down left right "
    "minus equals left_bracket right_bracket semicolon apostrophe grave backslash comma period slash oem_102 "
    "left_shift right_shift left_control right_control left_menu right_menu capital scroll left_windows right_windows "
    "application system_request pause power sleep wake mute volume_up volume_down play_pause media_stop next_track "
    "prev_track media_select mail my_computer calculator webhome web_search web_favorites web_refresh web_stop "
    "web_forward web_back kana kanji convert no_convert yen abnt_c1 abnt_c2 at colon underline stop ax unlabeled "
    "unassigned unknown";

std::vector<std::string> AllKeys() {
  std::vector<std::string> names;
  for (char letter = 'a'; letter <= 'z'; ++letter) names.push_back(std::string(1, letter) + "_key");
  for (int digit = 0; digit < 10; ++digit) {
    names.push_back(std::to_string(digit) + "_key");
    names.push_back("numpad_" + std::to_string(digit) + "_key");
  }
  for (int number = 1; number <= 15; ++number) names.push_back("f" + std::to_string(number) + "_key");
  std::istringstream others(kKeys);
  for (std::string name; others >> name;) names.push_back(name + "_key");
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> AllButtons() {
  std::vector<std::string> names = {"left_button", "middle_button", "right_button", "unknown_button"};
  for (int number = 3; number <= 7; ++number) names.push_back("mouse_button_" + std::to_string(number));
  std::sort(names.begin(), names.end());
  return names;
}

/// Names as on an Xbox controller: "a" is the lower button.
constexpr const char* kPadParts =
    "a_button b_button x_button y_button back_button guide_button start_button left_stick_button right_stick_button "
    "left_shoulder_button right_shoulder_button up_button down_button left_button right_button "
    "left_x left_y right_x right_y left_trigger right_trigger";

std::vector<std::string> AllPadParts() {
  std::vector<std::string> names;
  std::istringstream parts(kPadParts);
  for (std::string name; parts >> name;) names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

const std::vector<std::string>& PadNames() {
  static const std::vector<std::string> names = AllPadParts();
  return names;
}

bool IsPadButton(std::string_view name) {
  return name.ends_with("_button");
}

const std::vector<std::string>& KeyNames() {
  static const std::vector<std::string> names = AllKeys();
  return names;
}

const std::vector<std::string>& ButtonNames() {
  static const std::vector<std::string> names = AllButtons();
  return names;
}

}  // namespace soarbox::sim
