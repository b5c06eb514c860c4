// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>
#include <string>
#include <string_view>

#include "script/api_call.h"
#include "script/argument_check.h"
#include "script/script_asset.h"
#include "world/rotation.h"

// UI: components of the user interface (lua_api.md 5.6, 10), with their buttons, bars and images.

namespace soarbox::script {
namespace {

using world::Color;
using world::Ui;
using world::UiComponent;
using world::UiId;
using world::UiPoint;
using world::UiSnapshot;
using world::Vec3;
using enum WrongCount;

Handle CreateChild(lua_State* state, Ui& ui, UiId parent) {
  ChargeForCreation(state, Made::kPanel);
  return {ValueKind::kUi, Number(ui.CreateChild(parent))};
}

/// Two numbers of the component.
template <float UiSnapshot::*kX, float UiSnapshot::*kY>
UiPoint GetPoint(const UiComponent& panel) {
  return {panel.view.*kX, panel.view.*kY};
}

template <float UiSnapshot::*kFirst, float UiSnapshot::*kSecond>
void SetPoint(UiComponent& panel, float first, float second) {
  panel.view.*kFirst = first;
  panel.view.*kSecond = second;
}

template <std::string UiComponent::*kText>
std::string_view GetText(const UiComponent& panel) {
  return panel.*kText;
}

template <std::string UiComponent::*kText>
void SetText(UiComponent& panel, std::string_view text) {
  panel.*kText = text;
}

std::string_view GetFont(const UiComponent& panel) {
  return Ui::FontName(panel.view.font);
}

void SetFont(lua_State* state, UiComponent& panel, std::string_view name) {
  if (const auto font = Ui::FontByName(name)) {
    panel.view.font = *font;
  } else {
    WarnIgnored(state, lua_pushfstring(state, "there is no font \"%s\"", lua_tostring(state, 2)));
  }
}

/// Reads three numbers and the alpha, from argument `first` on.
Color ColorFrom(lua_State* state, int first, bool has_alpha) {
  return {CheckFloat(state, first), CheckFloat(state, first + 1), CheckFloat(state, first + 2),
          has_alpha ? CheckFloat(state, first + 3) : 1};
}

/// The alpha is used only if there are exactly five arguments.
void SetFontColor(lua_State* state, UiComponent& panel) {
  panel.view.text_color = ColorFrom(state, 2, lua_gettop(state) == 5);
}

void SetBackground(UiComponent& panel, std::string_view direction, Color from, Color to) {
  panel.view.has_gradient = true;
  panel.view.gradient_is_vertical = direction == "north_south";
  panel.view.gradient_is_diagonal = direction == "diagonal";
  panel.view.gradient_from = from;
  panel.view.gradient_to = to;
}

/// A flat background is a gradient between equal colours. The alpha is used only if there are exactly five arguments.
void SetBackgroundColor(lua_State* state, UiComponent& panel) {
  const Color color = ColorFrom(state, 2, lua_gettop(state) == 5);
  SetBackground(panel, "north_south", color, color);
}

void SetGradientColor(lua_State* state, UiComponent& panel, std::string_view direction) {
  if (direction != "north_south" && direction != "west_east" && direction != "diagonal")
    ArgumentError(state, 2, "a direction is north_south, west_east or diagonal");
  SetBackground(panel, direction, ColorFrom(state, 3, true), ColorFrom(state, 7, true));
}

bool IsVisible(const UiComponent& panel) {
  return panel.view.visible;
}

void SetVisible(UiComponent& panel, bool visible) {
  panel.view.visible = visible;
}

void Remove(lua_State* state, Ui& ui, UiId id) {
  ui.Remove(id);
  ContextOf(state).buttons.RemoveIf([&](std::uint32_t panel) { return !ui.Find(UiId{panel}); });
}

/// Warns if the panel is on the screen, because it then has no position in the world.
bool IsInWorld(lua_State* state, const UiComponent& panel) {
  if (!panel.view.in_world)
    WarnIgnored(state, "this panel is on the screen; Sandbox.CreateUIComponent3d makes one in the world");
  return panel.view.in_world;
}

void SetWorldPosition(lua_State* state, UiComponent& panel, Vec3 position) {
  if (IsInWorld(state, panel)) panel.view.world_position = position;
}

void SetWorldRotation(lua_State* state, UiComponent& panel, Vec3 rotation) {
  if (IsInWorld(state, panel)) panel.view.world_orientation = Normalized(world::FromRotationVector(rotation));
}

int GetBar(lua_State* state) {
  const UiSnapshot& panel = ContextOf(state).world.ui().Find(UiArgument(state, 1))->view;
  panel.has_bar ? lua_pushnumber(state, panel.bar) : lua_pushnil(state);
  return 1;
}

int GetButton(lua_State* state) {
  const std::string& name = ContextOf(state).world.ui().Find(UiArgument(state, 1))->view.button;
  name.empty() ? lua_pushnil(state) : lua_pushlstring(state, name.data(), name.size());
  return 1;
}

void RemoveBar(UiComponent& panel) {
  panel.view.has_bar = false;
}

void RemoveButton(lua_State* state, Ui& ui, UiId id) {
  ui.SetButton(id, {});
  ContextOf(state).buttons.Remove(Number(id));
}

void RemoveImage(UiComponent& panel) {
  panel.view.material.clear();
}

/// (ui, fraction [, r, g, b [, a]])
void SetBar(lua_State* state, UiComponent& panel, float fraction) {
  Color color{0.30f, 0.69f, 0.31f, 1};
  int index = 3;
  for (float* const channel : {&color.r, &color.g, &color.b, &color.a}) {
    if (index > lua_gettop(state)) break;
    *channel = CheckFloat(state, index++);
  }
  panel.view.has_bar = true;
  panel.view.bar = fraction;
  panel.view.bar_color = color;
}

/// (ui, name, function)
int SetButton(lua_State* state) {
  const UiId id = UiArgument(state, 1);
  const std::string_view name = TextArgument(state, 2);
  constexpr std::size_t kLongestName = 100;
  if (name.empty() || name.size() > kLongestName)
    return ArgumentError(state, 2, "a button's name has 1 to 100 letters");
  ScriptContext& context = ContextOf(state);
  if (!context.world.ui().SetButton(id, name)) return ArgumentError(state, 2, "another button has this name");
  context.buttons.Set({ValueKind::kUi, Number(id)}, state, 3);
  return 0;
}

void SetImage(lua_State* state, UiComponent& panel) {
  panel.view.material = ImageArgument(state, 2);
}

constexpr ApiFunction kUiFunctions[] = {
    {"UI.CreateChild", kCall<CreateChild>, kIgnored, "ui: UI", "UI",
     "A panel in the same layer, with a position relative to its parent.",
     R"(local child = UI.CreateChild(ui)
UI.SetPosition(child, 10, 10))"},
    {"UI.GetBar", GetBar, kError, "ui: UI", "number",
     "The fraction of the panel's width that its bar fills, 0 to 1; nil without a bar.",
     R"(UI.SetBar(ui, 0.25)
print(UI.GetBar(ui))  --> 0.25)",
     true},
    {"UI.GetButton", GetButton, kError, "ui: UI", "string", "The panel's name as a button; nil if it is not a button.",
     R"(UI.SetButton(ui, "start", function(sandbox, ui) end)
print(UI.GetButton(ui))  --> start)",
     true},
    {"UI.GetDimensions", kCall<GetPoint<&UiSnapshot::width, &UiSnapshot::height>>, kIgnored, "ui: UI", "table [px]",
     "The size: {x, y} by name.", R"(print(UI.GetDimensions(ui).x)  --> 100)"},
    {"UI.GetFont", kCall<GetFont>, kIgnored, "ui: UI", "string", "The font of the plain text.",
     R"(print(UI.GetFont(ui))  --> small)"},
    {"UI.GetMarkupText", kCall<GetText<&UiComponent::markup>>, kIgnored, "ui: UI", "string", "The text with markup.",
     R"(UI.SetMarkupText(ui, "%1red")
print(UI.GetMarkupText(ui))  --> %1red)"},
    {"UI.GetOffsetPosition", kCall<&Ui::OffsetPosition>, kIgnored, "ui: UI", "table [px]",
     "The position of the parent on the screen; {0, 0} without a parent.",
     R"(print(UI.GetOffsetPosition(ui).x)  --> 0)"},
    {"UI.GetPosition", kCall<GetPoint<&UiSnapshot::x, &UiSnapshot::y>>, kIgnored, "ui: UI", "table [px]",
     "The position in the parent or on the screen: {x, y} by name.", R"(print(UI.GetPosition(ui).x)  --> 0)"},
    {"UI.GetScreenPosition", kCall<&Ui::ScreenPosition>, kIgnored, "ui: UI", "table [px]",
     "The position on the screen: {x, y} by name.",
     R"(UI.SetPosition(ui, 30, 40)
local child = UI.CreateChild(ui)
UI.SetPosition(child, 5, 5)
print(UI.GetScreenPosition(child).y)  --> 45)"},
    {"UI.GetText", kCall<GetText<&UiComponent::caption>>, kIgnored, "ui: UI", "string", "The plain text.",
     R"(print(#UI.GetText(ui))  --> 0)"},
    {"UI.GetTextMargin", kCall<GetPoint<&UiSnapshot::margin_left, &UiSnapshot::margin_top>>, kIgnored, "ui: UI",
     "table [px]", "The margin: {x = left, y = top}.",
     R"(UI.SetTextMargin(ui, 5, 10)
print(UI.GetTextMargin(ui).x)  --> 10)"},
    {"UI.IsVisible", kCall<IsVisible>, kIgnored, "ui: UI", "boolean",
     "Whether the panel itself is shown, regardless of its parent.", R"(print(UI.IsVisible(ui))  --> true)"},
    {"UI.Remove", kCall<Remove>, kError, "ui: UI", "", "Removes the panel and all its children.", R"(UI.Remove(ui))",
     true},
    {"UI.RemoveBar", kCall<RemoveBar>, kError, "ui: UI", "", "Removes the panel's bar.", R"(UI.RemoveBar(ui))", true},
    {"UI.RemoveButton", kCall<RemoveButton>, kError, "ui: UI", "", "Turns a button back into a plain panel.",
     R"(UI.RemoveButton(ui))", true},
    {"UI.RemoveImage", kCall<RemoveImage>, kError, "ui: UI", "", "Removes the panel's image.", R"(UI.RemoveImage(ui))",
     true},
    {"UI.SetBackgroundColor", kCall<SetBackgroundColor>, kError,
     "ui: UI, red: number 0..1, green: number 0..1, blue: number 0..1, alpha: number 0..1 = 1", "",
     "Colours the background; 0 to 1 per channel.", R"(UI.SetBackgroundColor(ui, 0, 0, 0.5, 0.8))", false, 4},
    {"UI.SetBar", kCall<SetBar>, kError,
     "ui: UI, fraction: number 0..1, red: number 0..1 = 0.3, green: number 0..1 = 0.69, blue: number 0..1 = 0.31, "
     "alpha: number 0..1 = 1",
     "",
     "Shows a bar that fills this fraction of the panel's width. It is drawn over the background and under the text.",
     R"(UI.SetBar(ui, agent:GetHealth() / 100, 0.8, 0.2, 0.1))", true},
    {"UI.SetButton", SetButton, kError, "ui: UI, name: string, callback: function", "",
     "Turns the panel into a button: a click in the window or a page calls callback(sandbox, ui) in the next tick. The "
     "name must be unique in the world; recordings and files of inputs use it (docs/lua/names.md). A second call "
     "replaces the first. A hidden panel cannot be pressed.",
     R"(UI.SetText(ui, "Start")
UI.SetButton(ui, "start", function(sandbox, ui)
  UI.SetText(ui, "Running")
end))",
     true},
    {"UI.SetDimensions", kCall<SetPoint<&UiSnapshot::width, &UiSnapshot::height>>, kError,
     "ui: UI, width: number 0..1e6 [px], height: number 0..1e6 [px]", "", "Changes the size.",
     R"(UI.SetDimensions(ui, 300, 120))"},
    {"UI.SetFont", kCall<SetFont>, kError, "ui: UI, font: string", "",
     "The font of the plain text: small, small_mono, medium, medium_mono, large or large_mono.",
     R"(UI.SetFont(ui, "medium_mono"))"},
    {"UI.SetFontColor", kCall<SetFontColor>, kError,
     "ui: UI, red: number 0..1, green: number 0..1, blue: number 0..1, alpha: number 0..1 = 1", "",
     "Colours the plain text; initially white.", R"(UI.SetFontColor(ui, 1, 1, 0))", false, 4},
    {"UI.SetGradientColor", kCall<SetGradientColor>, kError,
     "ui: UI, direction: string, red1: number 0..1, green1: number 0..1, blue1: number 0..1, alpha1: number 0..1, "
     "red2: number 0..1, green2: number 0..1, blue2: number 0..1, alpha2: number 0..1",
     "",
     "Colours the background with a gradient from the first colour to the second. The direction is north_south, "
     "west_east or diagonal.",
     R"(UI.SetGradientColor(ui, "north_south", 0, 0, 0, 0.75, 0, 0, 0, 0.35))"},
    {"UI.SetImage", kCall<SetImage>, kError, "ui: UI, file: string", "",
     "Fills the panel with an image: a PNG file of the scenario's folder with 8 bits per channel, not interlaced, up "
     "to 4096 px on each side and 8 MB. A file that cannot be used is an error that states the reason.",
     R"(UI.SetImage(ui, "badge.png"))", true},
    {"UI.SetMarkupText", kCall<SetText<&UiComponent::markup>>, kError, "ui: UI, text: string", "",
     "Shows text with markup: %0 to %9 change the colour; %@9%, %@14% and %@24% change the font (91, 141 and 241 have "
     "a fixed width); %M toggles fixed width; %% is a percent sign.",
     R"(UI.SetMarkupText(ui, "%@141%speed %1" .. 7 .. "%0 m/s"))"},
    {"UI.SetPosition", kCall<SetPoint<&UiSnapshot::x, &UiSnapshot::y>>, kError,
     "ui: UI, x: number [px], y: number [px]", "",
     "Moves the panel, relative to the top left of its parent or of the screen.",
     R"(UI.SetPosition(ui, 20, Sandbox.GetScreenHeight(sandbox) - 120))"},
    {"UI.SetText", kCall<SetText<&UiComponent::caption>>, kError, "ui: UI, text: string", "", "Shows plain text.",
     R"(UI.SetText(ui, "round 1"))"},
    {"UI.SetTextMargin", kCall<SetPoint<&UiSnapshot::margin_top, &UiSnapshot::margin_left>>, kError,
     "ui: UI, top: number [px], left: number [px]", "", "Sets the margins between text and edges; the top comes first.",
     R"(UI.SetTextMargin(ui, 10, 10))"},
    {"UI.SetVisible", kCall<SetVisible>, kError, "ui: UI, visible: boolean", "",
     "Shows or hides the panel, but not its children.",
     R"(UI.SetVisible(ui, not UI.IsVisible(ui))
print(UI.IsVisible(ui))  --> false)"},
    {"UI.SetWorldPosition", kCall<SetWorldPosition>, kError, "ui: UI, position: Vector [m]", "",
     "Moves a panel that CreateUIComponent3d created. For a panel on the screen, the call has no effect and gives a "
     "warning.",
     R"(UI.SetWorldPosition(panel, Vector.new(0, 3, 0)))"},
    {"UI.SetWorldRotation", kCall<SetWorldRotation>, kError, "ui: UI, rotation: Vector [deg]", "",
     "Turns a panel that CreateUIComponent3d created. For a panel on the screen, the call has no effect and gives a "
     "warning.",
     R"(UI.SetWorldRotation(panel, Sandbox.GetCameraOrientation(sandbox)))"},
};

}  // namespace

std::span<const ApiFunction> UiApi() {
  return kUiFunctions;
}

}  // namespace soarbox::script
