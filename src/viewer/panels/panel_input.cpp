// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/panel_input.h"

#include <SDL.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cfloat>

#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

const char* ReadClipboard(void* user) {
  auto& kept = *static_cast<std::string*>(user);
  char* text = SDL_GetClipboardText();
  kept = text != nullptr ? text : "";
  SDL_free(text);
  return kept.c_str();
}

void WriteClipboard(void*, const char* text) {
  SDL_SetClipboardText(text);
}

std::string& Clipboard() {
  static std::string text;
  return text;
}

/// SDL counts left, middle, right; ImGui left, right, middle.
int ButtonIndex(int sdl_button) {
  constexpr int kIndex[] = {0, 0, 2, 1, 3, 4};
  return sdl_button >= 1 && sdl_button <= 5 ? kIndex[sdl_button] : -1;
}

/// Keys that change the text or the caret. They must stay in order with the typed text.
bool Edits(int scancode) {
  switch (scancode) {
    case SDL_SCANCODE_RETURN:
    case SDL_SCANCODE_KP_ENTER:
    case SDL_SCANCODE_TAB:
    case SDL_SCANCODE_BACKSPACE:
    case SDL_SCANCODE_DELETE:
    case SDL_SCANCODE_ESCAPE:
    case SDL_SCANCODE_UP:
    case SDL_SCANCODE_DOWN:
    case SDL_SCANCODE_LEFT:
    case SDL_SCANCODE_RIGHT:
    case SDL_SCANCODE_HOME:
    case SDL_SCANCODE_END:
      return true;
    default:
      return false;
  }
}

}  // namespace

PanelInput::PanelInput() {
  ImGuiIO& io = ImGui::GetIO();
  const std::pair<ImGuiKey, SDL_Scancode> keys[] = {{ImGuiKey_Tab, SDL_SCANCODE_TAB},
                                                    {ImGuiKey_LeftArrow, SDL_SCANCODE_LEFT},
                                                    {ImGuiKey_RightArrow, SDL_SCANCODE_RIGHT},
                                                    {ImGuiKey_UpArrow, SDL_SCANCODE_UP},
                                                    {ImGuiKey_DownArrow, SDL_SCANCODE_DOWN},
                                                    {ImGuiKey_PageUp, SDL_SCANCODE_PAGEUP},
                                                    {ImGuiKey_PageDown, SDL_SCANCODE_PAGEDOWN},
                                                    {ImGuiKey_Home, SDL_SCANCODE_HOME},
                                                    {ImGuiKey_End, SDL_SCANCODE_END},
                                                    {ImGuiKey_Insert, SDL_SCANCODE_INSERT},
                                                    {ImGuiKey_Delete, SDL_SCANCODE_DELETE},
                                                    {ImGuiKey_Backspace, SDL_SCANCODE_BACKSPACE},
                                                    {ImGuiKey_Space, SDL_SCANCODE_SPACE},
                                                    {ImGuiKey_Enter, SDL_SCANCODE_RETURN},
                                                    {ImGuiKey_KeyPadEnter, SDL_SCANCODE_KP_ENTER},
                                                    {ImGuiKey_Escape, SDL_SCANCODE_ESCAPE},
                                                    {ImGuiKey_A, SDL_SCANCODE_A},
                                                    {ImGuiKey_C, SDL_SCANCODE_C},
                                                    {ImGuiKey_V, SDL_SCANCODE_V},
                                                    {ImGuiKey_X, SDL_SCANCODE_X},
                                                    {ImGuiKey_Y, SDL_SCANCODE_Y},
                                                    {ImGuiKey_Z, SDL_SCANCODE_Z}};
  for (const auto& [key, code] : keys) io.KeyMap[key] = code;
  io.GetClipboardTextFn = ReadClipboard;
  io.SetClipboardTextFn = WriteClipboard;
  io.ClipboardUserData = &Clipboard();
  io.MousePos = {-FLT_MAX, -FLT_MAX};
  const std::pair<ImGuiMouseCursor, SDL_SystemCursor> cursors[] = {
      {ImGuiMouseCursor_Arrow, SDL_SYSTEM_CURSOR_ARROW},
      {ImGuiMouseCursor_TextInput, SDL_SYSTEM_CURSOR_IBEAM},
      {ImGuiMouseCursor_ResizeAll, SDL_SYSTEM_CURSOR_SIZEALL},
      {ImGuiMouseCursor_ResizeNS, SDL_SYSTEM_CURSOR_SIZENS},
      {ImGuiMouseCursor_ResizeEW, SDL_SYSTEM_CURSOR_SIZEWE},
      {ImGuiMouseCursor_ResizeNESW, SDL_SYSTEM_CURSOR_SIZENESW},
      {ImGuiMouseCursor_ResizeNWSE, SDL_SYSTEM_CURSOR_SIZENWSE},
      {ImGuiMouseCursor_Hand, SDL_SYSTEM_CURSOR_HAND},
      {ImGuiMouseCursor_NotAllowed, SDL_SYSTEM_CURSOR_NO}};
  for (const auto& [cursor, shape] : cursors)
    cursors_[static_cast<std::size_t>(cursor)] = SDL_CreateSystemCursor(shape);
  SDL_StartTextInput();
}

PanelInput::~PanelInput() {
  for (void* cursor : cursors_) {
    if (cursor != nullptr) SDL_FreeCursor(static_cast<SDL_Cursor*>(cursor));
  }
}

void PanelInput::SetPicture(int x, int y, int width, int height, bool is_covered) {
  x_ = x;
  y_ = y;
  width_ = width;
  height_ = height;
  is_covered_ = is_covered;
}

bool PanelInput::IsOverPanel(float x, float y) const {
  if (is_covered_) return true;
  const auto left = static_cast<float>(cover_[0]), top = static_cast<float>(cover_[1]);
  if (x >= left && y >= top && x < left + static_cast<float>(cover_[2]) && y < top + static_cast<float>(cover_[3]))
    return true;
  return x < static_cast<float>(x_) || y < static_cast<float>(y_) || x >= static_cast<float>(x_ + width_) ||
         y >= static_cast<float>(y_ + height_);
}

bool PanelInput::has_keys() const {
  return ImGui::GetIO().WantTextInput;
}

bool PanelInput::Take(SDL_Event& event) {
  switch (event.type) {
    case SDL_MOUSEMOTION: {
      const auto x = static_cast<float>(event.motion.x), y = static_cast<float>(event.motion.y);
      notes_.push_back({Kind::kMove, x, y});
      over_panel_ = world_buttons_.none() && (panel_buttons_.any() || IsOverPanel(x, y));
      event.motion.x -= x_;
      event.motion.y -= y_;
      return over_panel_;
    }
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP: {
      const auto x = static_cast<float>(event.button.x), y = static_cast<float>(event.button.y);
      const bool pressed = event.type == SDL_MOUSEBUTTONDOWN;
      const auto button = static_cast<std::size_t>(event.button.button & 7);
      notes_.push_back({Kind::kMove, x, y});
      const bool is_pictures = pressed ? !(world_buttons_.none() && IsOverPanel(x, y)) : world_buttons_[button];
      // A click on the picture does not interrupt a line that is being typed.
      const bool stays = KeyboardIsKept() && is_pictures;
      if (const int index = ButtonIndex(event.button.button); index >= 0 && !stays)
        notes_.push_back({Kind::kButton, x, y, index, pressed});
      event.button.x -= x_;
      event.button.y -= y_;
      if (!pressed) {
        const bool ours = panel_buttons_[button];
        panel_buttons_[button] = world_buttons_[button] = false;
        return ours;
      }
      over_panel_ = world_buttons_.none() && IsOverPanel(x, y);
      (over_panel_ ? panel_buttons_ : world_buttons_)[button] = true;
      return over_panel_;
    }
    case SDL_MOUSEWHEEL:
      if (!over_panel_) return false;
      notes_.push_back({Kind::kWheel, static_cast<float>(event.wheel.x), static_cast<float>(event.wheel.y)});
      return true;
    case SDL_TEXTINPUT:
      if ((SDL_GetModState() & KMOD_LALT) != 0) return true;  // A shortcut types no text.
      notes_.push_back({Kind::kText, 0, 0, 0, false, 0, event.text.text});
      return true;
    case SDL_KEYDOWN:
    case SDL_KEYUP: {
      const int code = event.key.keysym.scancode;
      const bool pressed = event.type == SDL_KEYDOWN;
      if (code < 0 || code >= 512) return false;
      const auto key = static_cast<std::size_t>(code);
      notes_.push_back({Kind::kKey, 0, 0, code, pressed, event.key.keysym.mod});
      if (!pressed) {
        const bool was_worlds = world_keys_[key];
        world_keys_[key] = false;
        return !was_worlds;
      }
      if (world_keys_[key]) return false;  // It is an automatic repeat.
      if (has_keys()) return true;
      world_keys_[key] = true;
      return false;
    }
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_LEAVE && panel_buttons_.none())
        notes_.push_back({Kind::kMove, -FLT_MAX, -FLT_MAX});
      return false;
    default:
      return false;
  }
}

void PanelInput::Apply() {
  ImGuiIO& io = ImGui::GetIO();
  std::bitset<8> changed;
  std::bitset<512> keys;
  bool moved = false, wrote = false;
  while (!notes_.empty()) {
    const Note& note = notes_.front();
    switch (note.kind) {
      case Kind::kMove:
        // A frame shows the mouse at the place where a button changed.
        if (changed.any()) return;
        io.MousePos = {note.x, note.y};
        moved = true;
        break;
      case Kind::kButton:
        // ImGui must see the new position one frame before the button, so that the item there is hovered.
        if (changed[static_cast<std::size_t>(note.index)] || (moved && note.pressed)) return;
        changed[static_cast<std::size_t>(note.index)] = true;
        io.MouseDown[note.index] = note.pressed;
        break;
      case Kind::kWheel:
        io.MouseWheelH += note.x;
        io.MouseWheel += note.y;
        break;
      case Kind::kKey:
        if (keys[static_cast<std::size_t>(note.index)] || (wrote && note.pressed && Edits(note.index))) return;
        keys[static_cast<std::size_t>(note.index)] = true;
        io.KeysDown[note.index] = note.pressed;
        io.KeyCtrl = (note.modifiers & KMOD_CTRL) != 0;
        io.KeyShift = (note.modifiers & KMOD_SHIFT) != 0;
        io.KeyAlt = (note.modifiers & KMOD_ALT) != 0;
        break;
      case Kind::kLeave:
        // Escape would make the field drop the typed text, so it goes into a later frame.
        if (wrote || keys.any()) return;
        ImGui::ClearActiveID();
        break;
      case Kind::kText:
        if (keys.any() && io.KeyCtrl) break;
        io.AddInputCharactersUTF8(note.text.c_str());
        wrote = true;
        break;
    }
    notes_.pop_front();
  }
}

void PanelInput::ShowCursor() {
  const int wanted = ImGui::GetMouseCursor();
  if (wanted == cursor_ || wanted < 0 || wanted >= static_cast<int>(cursors_.size())) return;
  cursor_ = wanted;
  if (void* cursor = cursors_[static_cast<std::size_t>(wanted)]) SDL_SetCursor(static_cast<SDL_Cursor*>(cursor));
}

}  // namespace soarbox::viewer
