// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <lua.hpp>
#include <string_view>

#include "script/api_call.h"
#include "script/argument_check.h"
#include "script/script_asset.h"
#include "world/rotation.h"

// UI: components of the user interface (lua_api.md 5.6, 10), with their buttons, bars and images.

namespace soarbox::script {
namespace {

using world::Ui;
using world::UiId;
using world::Vec3;
using enum WrongCount;

Handle CreateChild(lua_State* state, Ui& ui, UiId parent) {
  ChargeForCreation(state, Made::kPanel);
  return {ValueKind::kUi, Number(ui.CreateChild(parent))};
}

std::string_view GetFont(const Ui& ui, UiId id) {
  return Ui::FontName(ui.Font(id));
}

void SetFont(lua_State* state, Ui& ui, UiId id, std::string_view name) {
  if (const auto font = Ui::FontByName(name)) {
    ui.SetFont(id, *font);
  } else {
    WarnIgnored(state, lua_pushfstring(state, "there is no font \"%s\"", lua_tostring(state, 2)));
  }
}

/// The alpha is used only if there are exactly five arguments.
template <auto kSet>
void SetColor(lua_State* state, Ui& ui, UiId id, float red, float green, float blue) {
  const float alpha = lua_gettop(state) == 5 ? CheckFloat(state, 5) : 1;
  WarnUnless(state, (ui.*kSet)(id, {red, green, blue, alpha}));
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
  WarnUnless(state, ContextOf(state).world.ui().SetGradientColor(id, direction, color(3), color(7)));
  return 0;
}

void Remove(lua_State* state, Ui& ui, UiId id) {
  ui.Remove(id);
  ContextOf(state).buttons.RemoveGone(ui);
}

/// Warns if the panel is on the screen, because it then has no position in the world.
void WarnUnlessInWorld(lua_State* state, bool is_in_world) {
  if (!is_in_world)
    WarnIgnored(state, "this panel is on the screen; Sandbox.CreateUIComponent3d makes one in the world");
}

void SetWorldPosition(lua_State* state, Ui& ui, UiId id, Vec3 position) {
  WarnUnlessInWorld(state, ui.SetWorldPosition(id, position));
}

void SetWorldRotation(lua_State* state, Ui& ui, UiId id, Vec3 rotation) {
  WarnUnlessInWorld(state, ui.SetWorldOrientation(id, world::FromRotationVector(rotation)));
}

int GetBar(lua_State* state) {
  const auto fraction = ContextOf(state).world.ui().Bar(UiArgument(state, 1));
  fraction ? lua_pushnumber(state, *fraction) : lua_pushnil(state);
  return 1;
}

int GetButton(lua_State* state) {
  const std::string& name = ContextOf(state).world.ui().Button(UiArgument(state, 1));
  name.empty() ? lua_pushnil(state) : lua_pushlstring(state, name.data(), name.size());
  return 1;
}

void RemoveButton(lua_State* state, Ui& ui, UiId id) {
  ui.SetButton(id, {});
  ContextOf(state).buttons.Remove(id);
}

void RemoveImage(Ui& ui, UiId id) {
  ui.SetImage(id, {});
}

/// (ui, fraction [, r, g, b [, a]])
void SetBar(lua_State* state, Ui& ui, UiId id, float fraction) {
  world::Color color{0.30f, 0.69f, 0.31f, 1};
  int index = 3;
  for (float* const channel : {&color.r, &color.g, &color.b, &color.a}) {
    if (index > lua_gettop(state)) break;
    *channel = CheckFloat(state, index++);
  }
  WarnUnless(state, ui.SetBar(id, fraction, color));
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
  lua_pushvalue(state, 3);
  context.buttons.Set(id, LuaMachine::Of(state), luaL_ref(state, LUA_REGISTRYINDEX));
  return 0;
}

void SetImage(lua_State* state, Ui& ui, UiId id) {
  ui.SetImage(id, ImageArgument(state, 2));
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
    {"UI.GetDimensions", kCall<&Ui::Dimensions>, kIgnored, "ui: UI", "table [px]", "The size: {x, y} by name.",
     R"(print(UI.GetDimensions(ui).x)  --> 100)"},
    {"UI.GetFont", kCall<GetFont>, kIgnored, "ui: UI", "string", "The font of the plain text.",
     R"(print(UI.GetFont(ui))  --> small)"},
    {"UI.GetMarkupText", kCall<&Ui::MarkupText>, kIgnored, "ui: UI", "string", "The text with markup.",
     R"(UI.SetMarkupText(ui, "%1red")
print(UI.GetMarkupText(ui))  --> %1red)"},
    {"UI.GetOffsetPosition", kCall<&Ui::OffsetPosition>, kIgnored, "ui: UI", "table [px]",
     "The position of the parent on the screen; {0, 0} without a parent.",
     R"(print(UI.GetOffsetPosition(ui).x)  --> 0)"},
    {"UI.GetPosition", kCall<&Ui::Position>, kIgnored, "ui: UI", "table [px]",
     "The position in the parent or on the screen: {x, y} by name.", R"(print(UI.GetPosition(ui).x)  --> 0)"},
    {"UI.GetScreenPosition", kCall<&Ui::ScreenPosition>, kIgnored, "ui: UI", "table [px]",
     "The position on the screen: {x, y} by name.",
     R"(UI.SetPosition(ui, 30, 40)
local child = UI.CreateChild(ui)
UI.SetPosition(child, 5, 5)
print(UI.GetScreenPosition(child).y)  --> 45)"},
    {"UI.GetText", kCall<&Ui::Text>, kIgnored, "ui: UI", "string", "The plain text.",
     R"(print(#UI.GetText(ui))  --> 0)"},
    {"UI.GetTextMargin", kCall<&Ui::TextMargin>, kIgnored, "ui: UI", "table [px]", "The margin: {x = left, y = top}.",
     R"(UI.SetTextMargin(ui, 5, 10)
print(UI.GetTextMargin(ui).x)  --> 10)"},
    {"UI.IsVisible", kCall<&Ui::IsVisible>, kIgnored, "ui: UI", "boolean",
     "Whether the panel itself is shown, regardless of its parent.", R"(print(UI.IsVisible(ui))  --> true)"},
    {"UI.Remove", kCall<Remove>, kError, "ui: UI", "", "Removes the panel and all its children.", R"(UI.Remove(ui))",
     true},
    {"UI.RemoveBar", kCall<&Ui::RemoveBar>, kError, "ui: UI", "", "Removes the panel's bar.", R"(UI.RemoveBar(ui))",
     true},
    {"UI.RemoveButton", kCall<RemoveButton>, kError, "ui: UI", "", "Turns a button back into a plain panel.",
     R"(UI.RemoveButton(ui))", true},
    {"UI.RemoveImage", kCall<RemoveImage>, kError, "ui: UI", "", "Removes the panel's image.", R"(UI.RemoveImage(ui))",
     true},
    {"UI.SetBackgroundColor", kCall<SetColor<&Ui::SetBackgroundColor>>, kError,
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
    {"UI.SetDimensions", kCall<&Ui::SetDimensions>, kError,
     "ui: UI, width: number 0..1e6 [px], height: number 0..1e6 [px]", "", "Changes the size.",
     R"(UI.SetDimensions(ui, 300, 120))"},
    {"UI.SetFont", kCall<SetFont>, kError, "ui: UI, font: string", "",
     "The font of the plain text: small, small_mono, medium, medium_mono, large or large_mono.",
     R"(UI.SetFont(ui, "medium_mono"))"},
    {"UI.SetFontColor", kCall<SetColor<&Ui::SetFontColor>>, kError,
     "ui: UI, red: number 0..1, green: number 0..1, blue: number 0..1, alpha: number 0..1 = 1", "",
     "Colours the plain text; initially white.", R"(UI.SetFontColor(ui, 1, 1, 0))", false, 4},
    {"UI.SetGradientColor", SetGradientColor, kError,
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
    {"UI.SetMarkupText", kCall<&Ui::SetMarkupText>, kError, "ui: UI, text: string", "",
     "Shows text with markup: %0 to %9 change the colour; %@9%, %@14% and %@24% change the font (91, 141 and 241 have "
     "a fixed width); %M toggles fixed width; %% is a percent sign.",
     R"(UI.SetMarkupText(ui, "%@141%speed %1" .. 7 .. "%0 m/s"))"},
    {"UI.SetPosition", kCall<&Ui::SetPosition>, kError, "ui: UI, x: number [px], y: number [px]", "",
     "Moves the panel, relative to the top left of its parent or of the screen.",
     R"(UI.SetPosition(ui, 20, Sandbox.GetScreenHeight(sandbox) - 120))"},
    {"UI.SetText", kCall<&Ui::SetText>, kError, "ui: UI, text: string", "", "Shows plain text.",
     R"(UI.SetText(ui, "round 1"))"},
    {"UI.SetTextMargin", kCall<&Ui::SetTextMargin>, kError, "ui: UI, top: number [px], left: number [px]", "",
     "Sets the margins between text and edges; the top comes first.", R"(UI.SetTextMargin(ui, 10, 10))"},
    {"UI.SetVisible", kCall<&Ui::SetVisible>, kError, "ui: UI, visible: boolean", "",
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
