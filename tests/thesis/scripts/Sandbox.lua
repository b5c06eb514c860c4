-- The thesis' world in the dialect of its scripts: functions are called through their tables
-- (Sandbox.GetObjects(sandbox)), agents are made by the creators of its three classes. The scenario scenarios/thesis
-- tells the same world in today's dialect.
require "DebugUtilities";
require "GUI";

local BLOCK = "models/nobiax_modular/modular_block.mesh";
local menu;

local function MakeMenu(sandbox)
    menu = Sandbox.CreateUIComponent(sandbox, 1);
    UI.SetDimensions(menu, 200, 60);
    UI.SetPosition(menu, Sandbox.GetScreenWidth(sandbox) - 220, Sandbox.GetScreenHeight(sandbox) - 95);
    UI.SetTextMargin(menu, 10, 10);
    GUI_SetGradientColor(menu);
    local style = GUI.MarkupColor.White .. GUI.Markup.SmallMono;
    UI.SetMarkupText(menu, style .. "Space shoots" .. GUI.MarkupNewline .. "F2 hides this");
end

local function Shoot(sandbox)
    local ahead = Sandbox.GetCameraForward(sandbox);
    local shot = Sandbox.CreateObject(sandbox, BLOCK);
    Core.SetMass(shot, 15);
    Core.SetPosition(shot, Sandbox.GetCameraPosition(sandbox) + ahead * 2);
    Core.SetRotation(shot, Sandbox.GetCameraOrientation(sandbox));
    Core.ApplyImpulse(shot, Vector.new(ahead * 15000));
    Core.ApplyAngularImpulse(shot, Sandbox.GetCameraLeft(sandbox) * 10);
end

function Sandbox_Cleanup(sandbox)
end

function Sandbox_HandleEvent(sandbox, event)
    GUI_HandleEvent(sandbox, event);
    local down = event.source == "keyboard" and event.pressed;
    if (down and event.key == "space_key") then
        Shoot(sandbox);
    elseif (down and event.key == "f2_key") then
        UI.SetVisible(menu, not UI.IsVisible(menu));
    end
end

function Sandbox_Initialize(sandbox)
    Core.CacheResource(BLOCK);
    GUI_CreateUI(sandbox);
    MakeMenu(sandbox);
    Sandbox.SetCameraPosition(sandbox, Vector.new(-30, 5, 7));
    Sandbox.SetCameraOrientation(sandbox, Vector.new(-131, -68, -133));
    Sandbox.CreateSkyBox(sandbox, "ThickCloudsWaterSkyBox", Vector.new(0, 180, 0));
    Sandbox.SetAmbientLight(sandbox, Vector.new(0.3));
    local ground = Sandbox.CreatePlane(sandbox, 200, 200);
    Core.SetMaterial(ground, "Ground2");
    local sun = Core.CreateDirectionalLight(sandbox, Vector.new(1, -1, 1));
    Core.SetLightDiffuse(sun, Vector.new(1.8, 1.4, 0.9));
    Core.SetLightSpecular(sun, Vector.new(1.8, 1.4, 0.9));

    Sandbox.CreateAgent(sandbox, "SeekingLuaAgent.lua");
    for _ = 1, 4 do
        Sandbox.CreateSoarFollowerAgent(sandbox, "FollowerAgent.lua");
    end
    Sandbox.CreateSoarWaypointAgent(sandbox, "WaypointsAgent.lua");
end

function Sandbox_Update(sandbox, deltaTimeInMillis)
    GUI_UpdateUI(sandbox);
    DebugUtilities_DrawDynamicBoundingSpheres(Sandbox.GetObjects(sandbox));
end
