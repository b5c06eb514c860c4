// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

namespace soarbox::script {
namespace {

constexpr ApiFunction kUiFunctions[] = {
    {"UI.CreateChild", "ui: UI", "UI", "A panel in the same layer, with a position relative to its parent.",
     R"(local child = UI.CreateChild(ui)
UI.SetPosition(child, 10, 10))"},
    {"UI.GetBar", "ui: UI", "number",
     "The fraction of the panel's width that its bar fills, 0 to 1; nil without a bar.",
     R"(UI.SetBar(ui, 0.25)
print(UI.GetBar(ui))  --> 0.25)",
     true},
    {"UI.GetButton", "ui: UI", "string", "The panel's name as a button; nil if it is not a button.",
     R"(UI.SetButton(ui, "start", function(sandbox, ui) end)
print(UI.GetButton(ui))  --> start)",
     true},
    {"UI.GetDimensions", "ui: UI", "table [px]", "The size: {x, y} by name.",
     R"(print(UI.GetDimensions(ui).x)  --> 100)"},
    {"UI.GetFont", "ui: UI", "string", "The font of the plain text.", R"(print(UI.GetFont(ui))  --> small)"},
    {"UI.GetMarkupText", "ui: UI", "string", "The text with markup.",
     R"(UI.SetMarkupText(ui, "%1red")
print(UI.GetMarkupText(ui))  --> %1red)"},
    {"UI.GetOffsetPosition", "ui: UI", "table [px]",
     "The position of the parent on the screen; {0, 0} without a parent.",
     R"(print(UI.GetOffsetPosition(ui).x)  --> 0)"},
    {"UI.GetPosition", "ui: UI", "table [px]", "The position in the parent or on the screen: {x, y} by name.",
     R"(print(UI.GetPosition(ui).x)  --> 0)"},
    {"UI.GetScreenPosition", "ui: UI", "table [px]", "The position on the screen: {x, y} by name.",
     R"(UI.SetPosition(ui, 30, 40)
local child = UI.CreateChild(ui)
UI.SetPosition(child, 5, 5)
print(UI.GetScreenPosition(child).y)  --> 45)"},
    {"UI.GetText", "ui: UI", "string", "The plain text.", R"(print(#UI.GetText(ui))  --> 0)"},
    {"UI.GetTextMargin", "ui: UI", "table [px]", "The margin: {x = left, y = top}.",
     R"(UI.SetTextMargin(ui, 5, 10)
print(UI.GetTextMargin(ui).x)  --> 10)"},
    {"UI.IsVisible", "ui: UI", "boolean", "Whether the panel itself is shown, regardless of its parent.",
     R"(print(UI.IsVisible(ui))  --> true)"},
    {"UI.Remove", "ui: UI", "", "Removes the panel and all its children.", R"(UI.Remove(ui))", true},
    {"UI.RemoveBar", "ui: UI", "", "Removes the panel's bar.", R"(UI.RemoveBar(ui))", true},
    {"UI.RemoveButton", "ui: UI", "", "Turns a button back into a plain panel.", R"(UI.RemoveButton(ui))", true},
    {"UI.RemoveImage", "ui: UI", "", "Removes the panel's image.", R"(UI.RemoveImage(ui))", true},
    {"UI.SetBackgroundColor", "ui: UI, red: number 0..1, green: number 0..1, blue: number 0..1, alpha: number 0..1 = 1",
     "", "Colours the background; 0 to 1 per channel.", R"(UI.SetBackgroundColor(ui, 0, 0, 0.5, 0.8))"},
    {"UI.SetBar",
     "ui: UI, fraction: number 0..1, red: number 0..1 = 0.3, green: number 0..1 = 0.69, blue: number 0..1 = 0.31, "
     "alpha: number 0..1 = 1",
     "",
     "Shows a bar that fills this fraction of the panel's width. It is drawn over the background and under the text.",
     R"(UI.SetBar(ui, agent:GetHealth() / 100, 0.8, 0.2, 0.1))", true},
    {"UI.SetButton", "ui: UI, name: string, callback: function", "",
     "Turns the panel into a button: a click in the window or a page calls callback(sandbox, ui) in the next tick. The "
     "name must be unique in the world; recordings and files of inputs use it (docs/lua/names.md). A second call "
     "replaces the first. A hidden panel cannot be pressed.",
     R"(UI.SetText(ui, "Start")
UI.SetButton(ui, "start", function(sandbox, ui)
  UI.SetText(ui, "Running")
end))",
     true},
    {"UI.SetDimensions", "ui: UI, width: number 0..1e6 [px], height: number 0..1e6 [px]", "", "Changes the size.",
     R"(UI.SetDimensions(ui, 300, 120))"},
    {"UI.SetFont", "ui: UI, font: string", "",
     "The font of the plain text: small, small_mono, medium, medium_mono, large or large_mono.",
     R"(UI.SetFont(ui, "medium_mono"))"},
    {"UI.SetFontColor", "ui: UI, red: number 0..1, green: number 0..1, blue: number 0..1, alpha: number 0..1 = 1", "",
     "Colours the plain text; initially white.", R"(UI.SetFontColor(ui, 1, 1, 0))"},
    {"UI.SetGradientColor",
     "ui: UI, direction: string, red1: number 0..1, green1: number 0..1, blue1: number 0..1, alpha1: number 0..1, "
     "red2: number 0..1, green2: number 0..1, blue2: number 0..1, alpha2: number 0..1",
     "",
     "Colours the background with a gradient from the first colour to the second. The direction is north_south, "
     "west_east or diagonal.",
     R"(UI.SetGradientColor(ui, "north_south", 0, 0, 0, 0.75, 0, 0, 0, 0.35))"},
    {"UI.SetImage", "ui: UI, file: string", "",
     "Fills the panel with an image: a PNG file of the scenario's folder with 8 bits per channel, not interlaced, up "
     "to 4096 px on each side and 8 MB. A file that cannot be used is an error that states the reason.",
     R"(UI.SetImage(ui, "badge.png"))", true},
    {"UI.SetMarkupText", "ui: UI, text: string", "",
     "Shows text with markup: %0 to %9 change the colour; %@9%, %@14% and %@24% change the font (91, 141 and 241 have "
     "a fixed width); %M toggles fixed width; %% is a percent sign.",
     R"(UI.SetMarkupText(ui, "%@141%speed %1" .. 7 .. "%0 m/s"))"},
    {"UI.SetPosition", "ui: UI, x: number [px], y: number [px]", "",
     "Moves the panel, relative to the top left of its parent or of the screen.",
     R"(UI.SetPosition(ui, 20, Sandbox.GetScreenHeight(sandbox) - 120))"},
    {"UI.SetText", "ui: UI, text: string", "", "Shows plain text.", R"(UI.SetText(ui, "round 1"))"},
    {"UI.SetTextMargin", "ui: UI, top: number [px], left: number [px]", "",
     "Sets the margins between text and edges; the top comes first.", R"(UI.SetTextMargin(ui, 10, 10))"},
    {"UI.SetVisible", "ui: UI, visible: boolean", "", "Shows or hides the panel, but not its children.",
     R"(UI.SetVisible(ui, not UI.IsVisible(ui))
print(UI.IsVisible(ui))  --> false)"},
    {"UI.SetWorldPosition", "ui: UI, position: Vector [m]", "",
     "Moves a panel that CreateUIComponent3d created. For a panel on the screen, the call has no effect and gives a "
     "warning.",
     R"(UI.SetWorldPosition(panel, Vector.new(0, 3, 0)))"},
    {"UI.SetWorldRotation", "ui: UI, rotation: Vector [deg]", "",
     "Turns a panel that CreateUIComponent3d created. For a panel on the screen, the call has no effect and gives a "
     "warning.",
     R"(UI.SetWorldRotation(panel, Sandbox.GetCameraOrientation(sandbox)))"},
};

}  // namespace

std::span<const ApiFunction> UiApi() {
  return kUiFunctions;
}

}  // namespace soarbox::script
