-- SPDX-License-Identifier: BSD-2-Clause
-- The body of a soldier: its look, animation states, movement, and the effects of its rifle.
require "AgentCommunications";
require "AgentUtilities";
require "AnimationStateMachine";
require "SoldierBody";

-- SoldierStates and WeaponStates contain the names of the states below: SoldierStates.STAND_FIRE is "fire", CROUCH_FIRE
-- is "crouch_fire".
Soldier = {
    Height = { Stand = 1.6, Crouch = 1.3 },
    Speed = { Stand = 3, Crouch = 1 },
    SoldierStates = {},
    WeaponStates = {}
};

local kMesh = "default";
local kFallingSpeed = -4.9;
local kLandingSpeed = -0.98;
local kMovingSpeedSquared = 2;
local kBulletDamage = 5;
local kImpactMillis = 2000;
local kMuzzleForce = 750;
local kTurnDistance = 2;
local kTries = 50;

-- Name, animation, looping, rate.
local kStates = {
    { "idle_aim", "stand_idle_aim", true },
    { "crouch_idle_aim", "crouch_idle_aim", true },
    { "crouch_dead", "stand_dead_2", false, 0.8 },
    { "crouch_fire", "crouch_fire_one_shot", true },
    { "crouch_forward", "crouch_forward_aim", true },
    { "dead", "stand_dead_2" },
    { "dead_headshot", "stand_dead_headshot" },
    { "fall_dead", "stand_dead_2" },
    { "fall_idle", "stand_idle_aim", true },
    { "fire", "stand_fire_one_shot", true },
    { "jump_land", "stand_jump_land" },
    { "jump_up", "stand_jump_up" },
    { "melee", "stand_melee_1_with_weapon" },
    { "reload", "stand_reload" },
    { "run_backward", "stand_run_backward_aim", true },
    { "run_forward", "stand_run_forward_aim", true },
    { "smg_transform", "stand_smg_transform" },
    { "sniper_transform", "stand_sniper_transform" }
};

-- By state: whether it may be left at any time or only at its end, and the duration of the fade to each other state in
-- seconds. A second number is the start time in the other animation.
local kTransitions = {
    idle_aim = { any = true, to = {
        crouch_idle_aim = 0.3, dead = 0.1, fall_dead = { 0.15, 1 }, dead_headshot = 0.2, fire = 0.1, melee = 0.2,
        reload = 0.2, run_backward = 0.2, run_forward = 0.5, smg_transform = 0.2, sniper_transform = 0.2 } },
    crouch_idle_aim = { any = true, to = {
        idle_aim = 0.3, crouch_dead = { 0.2, 0.5 }, crouch_fire = 0.1, crouch_forward = 0.5, fire = 0.5, reload = 0.3,
        run_forward = 0.5 } },
    crouch_forward = { any = true, to = {
        crouch_dead = { 0.2, 0.5 }, crouch_fire = 0.2, crouch_idle_aim = 0.2, fall_idle = 0.2, fire = 0.5, idle_aim = 0.5,
        reload = 0.5, run_forward = 0.4 } },
    run_forward = { any = true, to = {
        crouch_fire = 0.5, crouch_forward = 0.2, crouch_idle_aim = 0.5, dead = 0.2, fall_idle = 0.1, fire = 0.5,
        idle_aim = 0.5, reload = 0.5 } },
    crouch_fire = { to = {
        crouch_dead = { 0.2, 0.5 }, crouch_forward = 0.5, crouch_idle_aim = 0.1, fire = 0.3, idle_aim = 0.3, reload = 0.3,
        run_forward = 0.5 } },
    fire = { to = {
        idle_aim = 0.1, reload = 0.1, run_forward = 0.5, run_backward = 0.5, crouch_idle_aim = 0.5, crouch_fire = 0.3,
        crouch_forward = 0.5 } },
    fall_idle = { any = true, to = { fall_dead = { 0.15, 1 } } },
    melee = { to = { idle_aim = 0.2 } },
    reload = { to = { idle_aim = 0.2 } },
    run_backward = { to = { idle_aim = 0.2 } },
    smg_transform = { to = { idle_aim = 0.2 } },
    sniper_transform = { to = { idle_aim = 0.2 } }
};

local kWeaponStates = {
    { "sniper_idle", "sniper_idle", true },
    { "sniper_reload", "sniper_reload" },
    { "sniper_transform", "sniper_transform" },
    { "smg_idle", "smg_idle", true },
    { "smg_transform", "smg_transform" }
};

local kWeaponTransitions = {
    sniper_idle = { any = true, to = { sniper_reload = 0.2, smg_transform = 0.2 } },
    smg_idle = { any = true, to = { sniper_transform = 0.2 } },
    sniper_reload = { to = { sniper_idle = 0.2 } },
    sniper_transform = { to = { sniper_idle = 0.2 } },
    smg_transform = { to = { smg_idle = 0.2 } }
};

for _, state in ipairs(kStates) do
    local crouches = string.find(state[1], "^crouch_");
    Soldier.SoldierStates[(crouches and "" or "STAND_") .. string.upper(state[1])] = state[1];
end
for _, state in ipairs(kWeaponStates) do
    Soldier.WeaponStates[string.upper(state[1])] = state[1];
end

local function CreateStateMachine(mesh, states, transitions, first)
    local machine, lengths = AnimationStateMachine.new(), {};
    for _, state in ipairs(states) do
        local animation = Animation.GetAnimation(mesh, state[2]);
        lengths[state[1]] = Animation.GetLength(animation);
        machine:AddState(state[1], animation, state[3], state[4]);
    end
    for from, ways in pairs(transitions) do
        for to, fade in pairs(ways.to) do
            local duration, start = fade, 0;
            if (type(fade) == "table") then
                duration, start = fade[1], fade[2];
            end
            machine:AddTransition(from, to, ways.any and lengths[from] or duration, duration, start);
        end
    end
    machine:RequestState(first);
    return machine;
end

function Soldier_CreateSoldierStateMachine(soldier)
    return CreateStateMachine(soldier, kStates, kTransitions, Soldier.SoldierStates.STAND_IDLE_AIM);
end

function Soldier_CreateWeaponStateMachine(weapon)
    return CreateStateMachine(weapon, kWeaponStates, kWeaponTransitions, Soldier.WeaponStates.SNIPER_IDLE);
end

local function CreateBody(agent, mesh)
    local soldier = Core.CreateMesh(agent, mesh);
    Core.SetPosition(soldier, Vector.new(0, -agent:GetHeight() / 2, 0));
    return soldier;
end

-- With a dark uniform; the other one is light.
function Soldier_CreateSoldier(agent)
    return CreateBody(agent, SoldierBody.DarkMesh);
end

function Soldier_CreateLightSoldier(agent)
    return CreateBody(agent, SoldierBody.Mesh);
end

function Soldier_CreateWeapon(agent)
    return Core.CreateMesh(agent, SoldierBody.Rifle);
end

-- The node of the weapon is invalid after this; animations that were obtained from it before continue.
function Soldier_AttachWeapon(soldier, weapon)
    Animation.AttachToBone(soldier, "b_RightHand", weapon, Vector.new(0.04, 0.05, -0.01), Vector.new(98, 97, 0));
end

-- For half a second at least.
function Soldier_IsFalling(agent)
    return agent:GetVelocity().y < kFallingSpeed;
end

function Soldier_OnGround(agent)
    return agent:GetVelocity().y > kLandingSpeed;
end

function Soldier_IsMoving(agent)
    return Vector.LengthSquared(agent:GetVelocity()) > kMovingSpeedSquared;
end

-- Stands up or crouches; the feet stay in place.
function Soldier_SetHeight(agent, soldier, height)
    local position = agent:GetPosition();
    position.y = position.y + (height - agent:GetHeight()) / 2;
    agent:SetHeight(height);
    agent:SetPosition(position);
    Core.SetPosition(soldier, Vector.new(0, -height / 2, 0));
end

local function Hurry(agent, force, push)
    force.y = 0;
    if (agent:GetSpeed() < agent:GetMaxSpeed()) then
        return force + agent:ForceToTargetSpeed(agent:GetMaxSpeed()) * push;
    end
    return force;
end

-- The direction of movement: along the path, around agents and obstacles. One for standing soldiers, one for crouching
-- ones.
function Soldier_CalculateSteering(agent, deltaTimeInSeconds)
    local way = agent:ForceToFollowPath(0.5) * 1.5 + agent:ForceToStayOnPath(0.5) * 0.4;
    return Hurry(agent, way + agent:ForceToAvoidAgents(0.5) + agent:ForceToAvoidObjects(0.5) * 2, 7);
end

function Soldier_CalculateSlowSteering(agent, deltaTimeInSeconds)
    local way = Vector.Normalize(agent:ForceToFollowPath(0.5)) + Vector.Normalize(agent:ForceToStayOnPath(0.5)) * 0.2;
    return Hurry(agent, way + agent:ForceToAvoidAgents(0.5) + agent:ForceToAvoidObjects(0.5), 5);
end

-- By agent: the acceleration that AgentUtilities_ApplySteeringForce2 stores.
local accelerations = {};

function Soldier_ApplySteering(agent, force, deltaTimeInSeconds)
    local id = agent:GetId();
    accelerations[id] = accelerations[id] or Vector.new();
    AgentUtilities_ApplySteeringForce2(agent, force, accelerations[id], deltaTimeInSeconds);
    AgentUtilities_ClampHorizontalSpeed(agent);
end

-- Stops a soldier within some steps; a rate of 2 removes half of the speed in each step.
function Soldier_SlowMovement(agent, deltaTimeInMillis, rate)
    local velocity, kept = agent:GetVelocity(), 0.91 / (rate or 1);
    agent:SetVelocity(Vector.new(velocity.x * kept, velocity.y, velocity.z * kept));
end

-- A place on the navigation mesh that the agent can reach, and the path to it; nothing if there is none.
function Soldier_PathToRandomPoint(agent)
    local sandbox = agent:GetSandbox();
    for _ = 1, kTries do
        local path = Sandbox.FindPath(sandbox, kMesh, agent:GetPosition(), Sandbox.RandomPoint(sandbox, kMesh));
        if (#path > 0) then
            return path[#path], path;
        end
    end
end

-- Gives the soldier a path, and turns it at once if the path starts behind it.
function Soldier_SetPath(agent, path, cyclic)
    agent:SetPath(path, cyclic);
    if (#path < 2) then
        return;
    end
    local along = agent:GetDistanceAlongPath(agent:GetPosition()) + kTurnDistance;
    local ahead = agent:GetPointOnPath(along) - agent:GetPosition();
    ahead.y = 0;
    if (Vector.DotProduct(ahead, agent:GetForward()) < 0) then
        agent:SetVelocity(ahead * agent:GetSpeed());
        agent:SetForward(ahead);
    end
end

-- The particles of impacts and their remaining times.
local impacts = {};

-- Call it once per step of the agent.
function Soldier_Update(agent, deltaTimeInMillis)
    for index = #impacts, 1, -1 do
        impacts[index].left = impacts[index].left - deltaTimeInMillis;
        if (impacts[index].left <= 0) then
            Core.Remove(impacts[index].node);
            table.remove(impacts, index);
        end
    end
end

local function OnBulletHit(sandbox, collision)
    Sandbox.RemoveObject(sandbox, collision.objectA);
    local node = Core.CreateParticle(sandbox, "BulletImpact");
    Core.SetPosition(node, collision.pointA);
    Core.SetParticleDirection(node, collision.normalOnB);
    table.insert(impacts, { node = node, left = kImpactMillis });

    if (Agent.IsAgent(collision.objectB)) then
        collision.objectB:SetHealth(collision.objectB:GetHealth() - kBulletDamage);
    end
    AgentCommunications_SendMessage(
        sandbox, AgentCommunications.EventType.BulletImpact, { position = collision.pointA });
end

-- Shoots a bullet from the rifle's muzzle. A callback for states that fire; data contains agent and soldier, its mesh.
function Soldier_Shoot(stateName, data)
    local sandbox = data.agent:GetSandbox();
    local position = Animation.GetBonePosition(data.soldier, "b_muzzle");
    local rotation = Animation.GetBoneRotation(data.soldier, "b_muzzle");
    local forward = Vector.Rotate(Vector.new(1, 0, 0), rotation);
    local up = Vector.Rotate(Vector.new(0, 1, 0), rotation);
    local left = Vector.Rotate(Vector.new(0, 0, -1), rotation);

    local bullet = Sandbox.CreatePhysicsCapsule(sandbox, 0.3, 0.01);
    Core.SetMass(bullet, 0.1);
    Core.SetGravity(bullet, Vector.new(0, -0.01, 0));
    Core.SetAxis(bullet, left, -forward, up);
    Core.SetPosition(bullet, position + forward * 0.2);
    local trail = Core.CreateParticle(bullet, "Bullet");
    Core.SetRotation(trail, Vector.new(-90, 0, 0));
    Core.ApplyImpulse(bullet, forward * kMuzzleForce);
    Sandbox.AddCollisionCallback(sandbox, bullet, OnBulletHit);
    AgentCommunications_SendMessage(
        sandbox, AgentCommunications.EventType.BulletShot, { position = position });
end
