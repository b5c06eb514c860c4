// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <lua.hpp>
#include <string_view>

#include "script/argument_check.h"
#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "world/rotation.h"

// UI: components of the user interface (lua_api.md 5.6, 10).

namespace soarbox::script {
namespace {

using world::Ui;
using world::UiId;

Ui& UiOf(lua_State* state) {
  return ContextOf(state).world.ui();
}

template <world::UiPoint (Ui::*Getter)(UiId) const>
int GetPoint(lua_State* state) {
  const world::UiPoint point = (UiOf(state).*Getter)(UiArgument(state, 1));
  PushPoint(state, point.x, point.y);
  return 1;
}

template <bool (Ui::*Setter)(UiId, float, float)>
int SetPoint(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  const float first = CheckFloat(state, 2), second = CheckFloat(state, 3);
  WarnUnless(state, (UiOf(state).*Setter)(id, first, second));
  return 0;
}

template <const std::string& (Ui::*Getter)(UiId) const>
int GetText(lua_State* state) {
  const std::string& text = (UiOf(state).*Getter)(UiArgument(state, 1));
  lua_pushlstring(state, text.data(), text.size());
  return 1;
}

template <bool (Ui::*Setter)(UiId, std::string_view)>
int SetText(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  (UiOf(state).*Setter)(id, TextArgument(state, 2));
  return 0;
}

int CreateChild(lua_State* state) {
  const UiId parent = UiArgument(state, 1);
  ChargeForCreation(state, Made::kPanel);
  PushHandle(state, {ValueKind::kUi, Number(UiOf(state).CreateChild(parent))});
  return 1;
}

int GetFont(lua_State* state) {
  const std::string_view name = Ui::FontName(UiOf(state).Font(UiArgument(state, 1)));
  lua_pushlstring(state, name.data(), name.size());
  return 1;
}

int SetFont(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  const auto font = Ui::FontByName(TextArgument(state, 2));
  if (font) {
    UiOf(state).SetFont(id, *font);
  } else {
    WarnIgnored(state, lua_pushfstring(state, "there is no font \"%s\"", lua_tostring(state, 2)));
  }
  return 0;
}

/// Reads the colour from argument 2 on; the alpha is used only if there are exactly five arguments.
world::Color ColorArgument(lua_State* state) {
  const float alpha = lua_gettop(state) == 5 ? CheckFloat(state, 5) : 1;
  return {CheckFloat(state, 2), CheckFloat(state, 3), CheckFloat(state, 4), alpha};
}

int SetFontColor(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  WarnUnless(state, UiOf(state).SetFontColor(id, ColorArgument(state)));
  return 0;
}

int SetBackgroundColor(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  WarnUnless(state, UiOf(state).SetBackgroundColor(id, ColorArgument(state)));
  return 0;
}

int SetGradientColor(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  static constexpr std::string_view kDirections[] = {"north_south", "west_east", "diagonal"};
  const auto* const named = std::find(std::begin(kDirections), std::end(kDirections), TextArgument(state, 2));
  if (named == std::end(kDirections))
    return ArgumentError(state, 2, "a direction is north_south, west_east or diagonal");
  const auto direction = static_cast<world::UiGradient>(named - std::begin(kDirections));
  const auto color = [&](int first) {
    return world::Color{CheckFloat(state, first), CheckFloat(state, first + 1), CheckFloat(state, first + 2),
                        CheckFloat(state, first + 3)};
  };
  WarnUnless(state, UiOf(state).SetGradientColor(id, direction, color(3), color(7)));
  return 0;
}

int IsVisible(lua_State* state) {
  lua_pushboolean(state, UiOf(state).IsVisible(UiArgument(state, 1)));
  return 1;
}

int SetVisible(lua_State* state) {
  UiOf(state).SetVisible(UiArgument(state, 1), TruthArgument(state, 2));
  return 0;
}

int Remove(lua_State* state) {
  UiOf(state).Remove(UiArgument(state, 1));
  ContextOf(state).buttons.RemoveGone(UiOf(state));
  return 0;
}

/// Warns if the panel is on the screen, because it then has no position in the world.
void WarnUnlessInWorld(lua_State* state, bool is_in_world) {
  if (!is_in_world)
    WarnIgnored(state, "this panel is on the screen; Sandbox.CreateUIComponent3d makes one in the world");
}

int SetWorldPosition(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  WarnUnlessInWorld(state, UiOf(state).SetWorldPosition(id, CheckVector(state, 2)));
  return 0;
}

int SetWorldRotation(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  WarnUnlessInWorld(state, UiOf(state).SetWorldOrientation(id, world::FromRotationVector(CheckVector(state, 2))));
  return 0;
}

constexpr Binding kUiBindings[] = {
    {"CreateChild", CreateChild, 1, 1, WrongCount::kIgnored},
    {"GetDimensions", GetPoint<&Ui::Dimensions>, 1, 1, WrongCount::kIgnored},
    {"GetFont", GetFont, 1, 1, WrongCount::kIgnored},
    {"GetMarkupText", GetText<&Ui::MarkupText>, 1, 1, WrongCount::kIgnored},
    {"GetOffsetPosition", GetPoint<&Ui::OffsetPosition>, 1, 1, WrongCount::kIgnored},
    {"GetPosition", GetPoint<&Ui::Position>, 1, 1, WrongCount::kIgnored},
    {"GetScreenPosition", GetPoint<&Ui::ScreenPosition>, 1, 1, WrongCount::kIgnored},
    {"GetText", GetText<&Ui::Text>, 1, 1, WrongCount::kIgnored},
    {"GetTextMargin", GetPoint<&Ui::TextMargin>, 1, 1, WrongCount::kIgnored},
    {"IsVisible", IsVisible, 1, 1, WrongCount::kIgnored},
    {"Remove", Remove, 1, 1, WrongCount::kError},
    {"SetBackgroundColor", SetBackgroundColor, 4, 9, WrongCount::kError},
    {"SetDimensions", SetPoint<&Ui::SetDimensions>, 3, 3, WrongCount::kError},
    {"SetFont", SetFont, 2, 2, WrongCount::kError},
    {"SetFontColor", SetFontColor, 4, 9, WrongCount::kError},
    {"SetGradientColor", SetGradientColor, 10, 10, WrongCount::kError},
    {"SetMarkupText", SetText<&Ui::SetMarkupText>, 2, 2, WrongCount::kError},
    {"SetPosition", SetPoint<&Ui::SetPosition>, 3, 3, WrongCount::kError},
    {"SetText", SetText<&Ui::SetText>, 2, 2, WrongCount::kError},
    {"SetTextMargin", SetPoint<&Ui::SetTextMargin>, 3, 3, WrongCount::kError},
    {"SetVisible", SetVisible, 2, 2, WrongCount::kError},
    {"SetWorldPosition", SetWorldPosition, 2, 2, WrongCount::kError},
    {"SetWorldRotation", SetWorldRotation, 2, 2, WrongCount::kError},
};

}  // namespace

void BindUi(lua_State* state) {
  RegisterTable(state, "UI", kUiBindings);
}

}  // namespace soarbox::script
