// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/key_names.h"

#include <SDL_mouse.h>
#include <SDL_scancode.h>

#include <algorithm>
#include <iterator>

namespace soarbox::viewer {
namespace {

struct NamedKey {
  int scancode;
  const char* name;
};

constexpr NamedKey kNamedKeys[] = {
    {SDL_SCANCODE_0, "0_key"},
    {SDL_SCANCODE_RETURN, "return_key"},
    {SDL_SCANCODE_ESCAPE, "escape_key"},
    {SDL_SCANCODE_BACKSPACE, "back_key"},
    {SDL_SCANCODE_TAB, "tab_key"},
    {SDL_SCANCODE_SPACE, "space_key"},
    {SDL_SCANCODE_MINUS, "minus_key"},
    {SDL_SCANCODE_EQUALS, "equals_key"},
    {SDL_SCANCODE_LEFTBRACKET, "left_bracket_key"},
    {SDL_SCANCODE_RIGHTBRACKET, "right_bracket_key"},
    {SDL_SCANCODE_BACKSLASH, "backslash_key"},
    {SDL_SCANCODE_NONUSHASH, "backslash_key"},
    {SDL_SCANCODE_SEMICOLON, "semicolon_key"},
    {SDL_SCANCODE_APOSTROPHE, "apostrophe_key"},
    {SDL_SCANCODE_GRAVE, "grave_key"},
    {SDL_SCANCODE_COMMA, "comma_key"},
    {SDL_SCANCODE_PERIOD, "period_key"},
    {SDL_SCANCODE_SLASH, "slash_key"},
    {SDL_SCANCODE_NONUSBACKSLASH, "oem_102_key"},
    {SDL_SCANCODE_CAPSLOCK, "capital_key"},
    {SDL_SCANCODE_PRINTSCREEN, "system_request_key"},
    {SDL_SCANCODE_SCROLLLOCK, "scroll_key"},
    {SDL_SCANCODE_PAUSE, "pause_key"},
    {SDL_SCANCODE_INSERT, "insert_key"},
    {SDL_SCANCODE_DELETE, "delete_key"},
    {SDL_SCANCODE_HOME, "home_key"},
    {SDL_SCANCODE_END, "end_key"},
    {SDL_SCANCODE_PAGEUP, "page_up_key"},
    {SDL_SCANCODE_PAGEDOWN, "page_down_key"},
    {SDL_SCANCODE_UP, "up_key"},
    {SDL_SCANCODE_DOWN, "down_key"},
    {SDL_SCANCODE_LEFT, "left_key"},
    {SDL_SCANCODE_RIGHT, "right_key"},
    {SDL_SCANCODE_NUMLOCKCLEAR, "numlock_key"},
    {SDL_SCANCODE_KP_0, "numpad_0_key"},
    {SDL_SCANCODE_KP_PLUS, "add_key"},
    {SDL_SCANCODE_KP_MINUS, "subtract_key"},
    {SDL_SCANCODE_KP_MULTIPLY, "multiply_key"},
    {SDL_SCANCODE_KP_DIVIDE, "divide_key"},
    {SDL_SCANCODE_KP_PERIOD, "decimal_key"},
    {SDL_SCANCODE_KP_ENTER, "numpad_enter_key"},
    {SDL_SCANCODE_KP_EQUALS, "numpad_equals_key"},
    {SDL_SCANCODE_KP_COMMA, "numpad_comma_key"},
    {SDL_SCANCODE_LSHIFT, "left_shift_key"},
    {SDL_SCANCODE_RSHIFT, "right_shift_key"},
    {SDL_SCANCODE_LCTRL, "left_control_key"},
    {SDL_SCANCODE_RCTRL, "right_control_key"},
    {SDL_SCANCODE_LALT, "left_menu_key"},
    {SDL_SCANCODE_RALT, "right_menu_key"},
    {SDL_SCANCODE_LGUI, "left_windows_key"},
    {SDL_SCANCODE_RGUI, "right_windows_key"},
    {SDL_SCANCODE_APPLICATION, "application_key"},
    {SDL_SCANCODE_POWER, "power_key"},
    {SDL_SCANCODE_SLEEP, "sleep_key"},
    {SDL_SCANCODE_MUTE, "mute_key"},
    {SDL_SCANCODE_AUDIOMUTE, "mute_key"},
    {SDL_SCANCODE_VOLUMEUP, "volume_up_key"},
    {SDL_SCANCODE_VOLUMEDOWN, "volume_down_key"},
    {SDL_SCANCODE_AUDIOPLAY, "play_pause_key"},
    {SDL_SCANCODE_AUDIOSTOP, "media_stop_key"},
    {SDL_SCANCODE_AUDIONEXT, "next_track_key"},
    {SDL_SCANCODE_AUDIOPREV, "prev_track_key"},
    {SDL_SCANCODE_MEDIASELECT, "media_select_key"},
    {SDL_SCANCODE_MAIL, "mail_key"},
    {SDL_SCANCODE_COMPUTER, "my_computer_key"},
    {SDL_SCANCODE_CALCULATOR, "calculator_key"},
    {SDL_SCANCODE_AC_HOME, "webhome_key"},
    {SDL_SCANCODE_AC_SEARCH, "web_search_key"},
    {SDL_SCANCODE_AC_BOOKMARKS, "web_favorites_key"},
    {SDL_SCANCODE_AC_REFRESH, "web_refresh_key"},
    {SDL_SCANCODE_AC_STOP, "web_stop_key"},
    {SDL_SCANCODE_AC_FORWARD, "web_forward_key"},
    {SDL_SCANCODE_AC_BACK, "web_back_key"},
    {SDL_SCANCODE_INTERNATIONAL1, "abnt_c1_key"},
    {SDL_SCANCODE_INTERNATIONAL2, "kana_key"},
    {SDL_SCANCODE_INTERNATIONAL3, "yen_key"},
    {SDL_SCANCODE_INTERNATIONAL4, "convert_key"},
    {SDL_SCANCODE_INTERNATIONAL5, "no_convert_key"},
    {SDL_SCANCODE_LANG1, "kanji_key"},
    {SDL_SCANCODE_STOP, "stop_key"},
};

}  // namespace

std::string KeyName(int code) {
  const auto numbered = [code](int first, int number) { return std::to_string(code - first + number) + "_key"; };
  if (code >= SDL_SCANCODE_A && code <= SDL_SCANCODE_Z) {
    return std::string(1, static_cast<char>('a' + code - SDL_SCANCODE_A)) + "_key";
  }
  if (code >= SDL_SCANCODE_1 && code <= SDL_SCANCODE_9) return numbered(SDL_SCANCODE_1, 1);
  if (code >= SDL_SCANCODE_KP_1 && code <= SDL_SCANCODE_KP_9) return "numpad_" + numbered(SDL_SCANCODE_KP_1, 1);
  if (code >= SDL_SCANCODE_F1 && code <= SDL_SCANCODE_F12) return "f" + numbered(SDL_SCANCODE_F1, 1);
  if (code >= SDL_SCANCODE_F13 && code <= SDL_SCANCODE_F15) return "f" + numbered(SDL_SCANCODE_F13, 13);
  const auto found = std::find_if(std::begin(kNamedKeys), std::end(kNamedKeys),
                                  [code](const NamedKey& key) { return key.scancode == code; });
  return found != std::end(kNamedKeys) ? found->name : "unknown_key";
}

std::string MouseButtonName(int button) {
  switch (button) {
    case SDL_BUTTON_LEFT:
      return "left_button";
    case SDL_BUTTON_RIGHT:
      return "right_button";
    case SDL_BUTTON_MIDDLE:
      return "middle_button";
    default:
      break;
  }
  return button >= 4 && button <= 8 ? "mouse_button_" + std::to_string(button - 1) : "unknown_button";
}

}  // namespace soarbox::viewer
