-- SPDX-License-Identifier: BSD-2-Clause
-- A parade: a soldier for each movement, with its name above, and two patrols that walk and run around them.
require "SandboxUtilities";
require "SoldierBody";

local kColumns, kGap = 8, 2.2;
local kWeapon = { stand_reload = "sniper_reload", crouch_reload = "sniper_reload",
                  stand_smg_transform = "smg_transform", stand_sniper_transform = "sniper_transform" };
local kMovements = {
    "stand_idle", "stand_idle_aim", "stand_fire_one_shot", "stand_reload",
    "stand_melee_1_with_weapon", "stand_hit", "stand_smg_transform", "stand_sniper_transform",
    "stand_walk_forward", "stand_walk_forward_aim", "stand_run_forward", "stand_run_forward_aim",
    "stand_sprint_forward", "stand_walk_backward_aim", "stand_run_backward_aim", "stand_walk_left_aim",
    "stand_walk_right_aim", "stand_turn_left", "stand_turn_right", "stand_jump_up",
    "stand_jump_land", "crouch_idle_aim", "crouch_forward_aim", "crouch_fire_one_shot",
    "crouch_reload", "crouch_hit", "stand_to_crouch", "crouch_dead",
    "stand_dead_2", "stand_dead_headshot", "stand_walk_forward_free", "stand_run_forward_free",
};

local parade = {};
local soldiers = {};
local showsBones = false;

local function AddLabel(sandbox, name, position)
    local label = Sandbox.CreateUIComponent3d(sandbox, position);
    UI.SetDimensions(label, 260, 26);
    UI.SetWorldRotation(label, Vector.new(0, 180, 0));
    UI.SetFont(label, "small");
    UI.SetTextMargin(label, 4, 6);
    UI.SetText(label, name);
    UI.SetBackgroundColor(label, 0, 0, 0, 0.45);
end

local function AddToParade(sandbox, name, index)
    local column, row = (index - 1) % kColumns, math.floor((index - 1) / kColumns);
    local position = Vector.new((column - (kColumns - 1) / 2) * -kGap, 0, row * 2.6);
    local soldier = Core.CreateMesh(sandbox, row % 2 == 0 and SoldierBody.Mesh or SoldierBody.DarkMesh);
    Core.SetPosition(soldier, position);
    Core.SetRotation(soldier, Vector.new(0, 180, 0));
    local rifle = nil;
    if (not string.find(name, "_free")) then
        rifle = SoldierBody_GiveRifle(sandbox, soldier);
    end
    local movements = { Animation.GetAnimation(soldier, name) };
    if (kWeapon[name]) then
        movements[2] = Animation.GetAnimation(rifle, kWeapon[name]);
    end
    for i, movement in ipairs(movements) do
        Animation.SetEnabled(movement, true);
    end
    parade[index] = movements;
    soldiers[index] = soldier;
    AddLabel(sandbox, name, position + Vector.new(0.65, 2.12, 0));
end

local function Scatter(sandbox, name, x, z, rotation)
    local thing = Sandbox.CreateObject(sandbox, "models/soarbox/" .. name .. ".mesh");
    Core.SetMass(thing, 0);
    Core.SetRotation(thing, Vector.new(0, rotation, 0));
    Core.SetPosition(thing, Vector.new(x, 0, z));
end

function Sandbox_Initialize(sandbox)
    SandboxUtilities_CreateLights(sandbox);
    Sandbox.CreateSkyBox(sandbox, "ThickCloudsWaterSkyBox", Vector.new(0, 180, 0));
    Core.SetMaterial(Sandbox.CreatePlane(sandbox, 200, 200), "Ground2");
    for index, name in ipairs(kMovements) do
        AddToParade(sandbox, name, index);
    end
    Sandbox.CreateAgent(sandbox, "Patrol.lua");
    Sandbox.CreateAgent(sandbox, "Patrol.lua");
    Scatter(sandbox, "pine_2", 14, 18, 0);
    Scatter(sandbox, "pine_1", 17, 14, 40);
    Scatter(sandbox, "oak_2", -15, 19, 0);
    Scatter(sandbox, "oak_1", -19, 14, 70);
    Scatter(sandbox, "pine_1", 5, 22, 120);
    Scatter(sandbox, "oak_1", -5, 24, 200);
    Scatter(sandbox, "rock_3", 15, 8, 30);
    Scatter(sandbox, "rock_2", -14, 9, 80);
    Scatter(sandbox, "rock_1", -13, 7, 10);
    Scatter(sandbox, "rock_4", 12, 16, 200);
    SandboxUtilities_CreateObject(sandbox, "modular_wall_brick_1", Vector.new(-9, 1.28, 16), Vector.new(0, 20, 0));
    SandboxUtilities_CreateObject(sandbox, "modular_pillar_concrete_1", Vector.new(9, 1.28, 16));
    SandboxUtilities_CreateObject(sandbox, "modular_block", Vector.new(7.6, 0.32, 15));
    Sandbox.SetCameraPosition(sandbox, Vector.new(0, 3.4, -8.5));
    Sandbox.SetCameraOrientation(sandbox, Vector.new(-166, 0, -180));
end

function Sandbox_Update(sandbox, deltaTimeInMillis)
    for _, movements in ipairs(parade) do
        for _, movement in ipairs(movements) do
            Animation.StepAnimation(movement, deltaTimeInMillis);
        end
    end
end

-- F3 shows the bones of all soldiers, or hides them.
function Sandbox_HandleEvent(sandbox, event)
    if (event.source == "keyboard" and event.key == "f3_key" and event.pressed) then
        showsBones = not showsBones;
        for _, soldier in ipairs(soldiers) do
            Animation.SetDisplaySkeleton(soldier, showsBones);
        end
    end
end
