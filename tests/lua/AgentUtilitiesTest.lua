-- SPDX-License-Identifier: BSD-2-Clause
-- Steering helpers and debug drawing.
require "Check";
require "AgentUtilities";
require "DebugUtilities";

local tests = {};

local function Walker()
    local walker = Sandbox.CreateAgent(sandbox, "Quiet.lua");
    walker:SetPosition(Vector.new(50, 0.8, 50));
    return walker;
end

function tests.TheHorizontalSpeedIsClampedAndFallingIsNot()
    local walker = Walker();
    walker:SetVelocity(Vector.new(30, -20, 40));
    AgentUtilities_ClampHorizontalSpeed(walker);
    local velocity = walker:GetVelocity();
    CheckNear(7, walker:GetSpeed());
    CheckNear(-20, velocity.y);
    CheckNear(velocity.z / velocity.x, 4 / 3, 0.01);
    walker:SetVelocity(Vector.new(1, 0, 2));
    AgentUtilities_ClampHorizontalSpeed(walker);
    CheckEqual(1, walker:GetVelocity().x);
end

function tests.APhysicsForceIsFlattenedAndTurnsTheAgent()
    local walker = Walker();
    local force = Vector.new(5, 9, 0);
    AgentUtilities_ApplyPhysicsSteeringForce(walker, force, 1 / 30);
    CheckEqual(0, force.y);
    CheckNear(1, walker:GetForward().x);
    AgentUtilities_ApplyPhysicsSteeringForce(walker, Vector.new(), 1 / 30);
    walker:SetMass(0);
    AgentUtilities_ApplyPhysicsSteeringForce(walker, Vector.new(0, 0, 1), 1 / 30);
    CheckNear(1, walker:GetForward().x);
end

function tests.TheSecondSteeringForceSmoothsTheAcceleration()
    local walker, accumulator = Walker(), Vector.new();
    local full = walker:GetMaxForce() / walker:GetMass();
    AgentUtilities_ApplySteeringForce2(walker, Vector.new(0, 0, 3), accumulator, 0.1);
    CheckNear(0.4 * full, accumulator.z, 0.01);
    CheckNear(0.04 * full, walker:GetVelocity().z, 0.01);
    AgentUtilities_ApplySteeringForce2(walker, Vector.new(0, 0, 3), accumulator, 0.1);
    CheckNear(0.64 * full, accumulator.z, 0.01);
    AgentUtilities_ApplySteeringForce2(walker, Vector.new(0.1, 0, 0.1), accumulator, 0.1);
    CheckNear(0.64 * full, accumulator.z, 0.01);
end

function tests.PositionsFollowVelocities()
    local walker = Walker();
    walker:SetVelocity(Vector.new(2, 0, 0));
    AgentUtilities_UpdatePosition(walker, 0.5);
    CheckNear(51, walker:GetPosition().x);
    Check(Core.IsVisible(AgentUtilities_CreateAgentRepresentation(walker, 1.6, 0.3)));
    AgentUtilities_DrawLineToTarget(walker);
    AgentUtilities_DrawTargetRadius(walker);
end

function tests.DrawingTakesEmptyPathsAndAllArguments()
    DebugUtilities_DrawPath({});
    DebugUtilities_DrawPath({ Vector.new() }, true);
    DebugUtilities_DrawPath(
        { Vector.new(), Vector.new(1), Vector.new(2, 0, 0) }, true, Vector.new(0, 1, 0), DebugUtilities.Orange);
    local walker = Walker();
    walker:SetPath({ Vector.new(), Vector.new(5, 0, 0) });
    DebugUtilities_DrawPaths({ walker, agent });
    DebugUtilities_DrawBoundingSpheres(Sandbox.GetObjects(sandbox));
    DebugUtilities_DrawDynamicBoundingSpheres(Sandbox.GetObjects(sandbox));
    CheckEqual(1, DebugUtilities.Green.y);
end

RunTests(tests);
