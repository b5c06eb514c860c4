-- The world that all variants of this scenario share: a sunlit plain under a cloudy sky, a help
-- panel, and the keys of the sandbox.
require "DebugUtilities";
require "GUI";
require "Plain";

local kHelp = {
    "W/A/S/D: move the camera",
    "Shift: move faster",
    "Right mouse button: look around",
    "",
    "Space: shoot a block",
    "F1: reset the camera",
    "F2: show or hide this panel",
    "F5: performance   F6: camera",
    "F7: physics debug",
};
local kCameraPosition = Vector.new(-30, 5, 7);
local kCameraRotation = Vector.new(-131, -68, -133);
local kBlock = "models/nobiax_modular/modular_block.mesh";

local helpPanel;

local function LookAtTheWorld(sandbox)
    Sandbox.SetCameraPosition(sandbox, kCameraPosition);
    Sandbox.SetCameraOrientation(sandbox, kCameraRotation);
end

local function CreateHelpPanel(sandbox)
    local width, height = 320, 190;
    helpPanel = Sandbox.CreateUIComponent(sandbox, 1);
    UI.SetPosition(
        helpPanel,
        Sandbox.GetScreenWidth(sandbox) - width - 20,
        Sandbox.GetScreenHeight(sandbox) - height - 35);
    UI.SetDimensions(helpPanel, width, height);
    UI.SetTextMargin(helpPanel, 10, 10);
    GUI_SetGradientColor(helpPanel);
    UI.SetMarkupText(
        helpPanel,
        GUI.MarkupColor.White .. GUI.Markup.SmallMono .. table.concat(kHelp, GUI.MarkupNewline));
end

local function ShootBlock(sandbox)
    local forward = Sandbox.GetCameraForward(sandbox);
    local block = Sandbox.CreateObject(sandbox, kBlock);
    Core.SetMass(block, 15);
    Core.SetRotation(block, Sandbox.GetCameraOrientation(sandbox));
    Core.SetPosition(block, Sandbox.GetCameraPosition(sandbox) + forward * 2);
    Core.ApplyImpulse(block, forward * 15000);
    Core.ApplyAngularImpulse(block, Sandbox.GetCameraLeft(sandbox) * 10);
end

-- Sky, ground, sun, camera and panels. Call it first in Sandbox_Initialize.
function ThesisWorld_Initialize(sandbox)
    Core.CacheResource(kBlock);
    GUI_CreateUI(sandbox);
    CreateHelpPanel(sandbox);
    LookAtTheWorld(sandbox);

    Plain_Create(sandbox);
end

function Sandbox_HandleEvent(sandbox, event)
    GUI_HandleEvent(sandbox, event);
    if (event.source ~= "keyboard" or not event.pressed) then
        return;
    end
    if (event.key == "f1_key") then
        LookAtTheWorld(sandbox);
    elseif (event.key == "f2_key") then
        UI.SetVisible(helpPanel, not UI.IsVisible(helpPanel));
    elseif (event.key == "space_key") then
        ShootBlock(sandbox);
    end
end

function Sandbox_Update(sandbox, deltaTimeInMillis)
    GUI_UpdateUI(sandbox);
    DebugUtilities_DrawDynamicBoundingSpheres(Sandbox.GetObjects(sandbox));
end
