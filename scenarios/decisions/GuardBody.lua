-- SPDX-License-Identifier: BSD-2-Clause
-- What a guard can see and do, whatever decides for it: patrol from post to post, chase the intruder, rest when it is tired.
require "Action";
require "AgentUtilities";

local kPosts = { Vector.new(-15, 0.8, -15), Vector.new(15, 0.8, -15), Vector.new(15, 0.8, 15), Vector.new(-15, 0.8, 15) };
local kSight = 12;
local kReach = 1.2;
local kRestMillis = 3000;

-- The guard of this script: {agent, intruder, post, strength, goal}; strength goes from 1 to 0.
function GuardBody_Create(agent)
    AgentUtilities_CreateAgentRepresentation(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetMaxSpeed(4);
    agent:SetPosition(Vector.new(0, 0.8, 0));
    local intruder = Sandbox.GetAgents(agent:GetSandbox())[1];
    return { agent = agent, intruder = intruder, post = 1, strength = 1 };
end

function GuardBody_IsTired(guard)
    return guard.strength <= 0;
end

function GuardBody_SeesIntruder(guard)
    return Vector.Distance(guard.agent:GetPosition(), guard.intruder:GetPosition()) < kSight;
end

-- Moves the guard towards its goal; running costs strength.
function GuardBody_Update(guard, deltaTimeInMillis)
    local agent = guard.agent;
    if (not guard.goal) then
        agent:SetVelocity(agent:GetVelocity() * 0.8);
        return;
    end
    AgentUtilities_ApplyPhysicsSteeringForce(agent, agent:ForceToPosition(guard.goal), deltaTimeInMillis / 1000);
    AgentUtilities_ClampHorizontalSpeed(agent);
    Core.DrawLine(agent:GetPosition(), guard.goal, Vector.new(1, 0.5, 0));
end

local function Announce(guard, what)
    print(guard.agent:GetId() .. " " .. what);
end

local function Near(guard, place)
    return Vector.Distance(guard.agent:GetPosition(), place) < kReach;
end

function GuardBody_Actions(guard)
    local running, terminated = Action.Status.RUNNING, Action.Status.TERMINATED;
    local function Stop(self)
        self.goal = nil;
    end

    local patrol = Action.new("patrol",
        function(self)
            Announce(self, "patrols to post " .. self.post);
            self.goal = kPosts[self.post];
        end,
        function(delta, self)
            if (GuardBody_SeesIntruder(self)) then
                return terminated;
            elseif (Near(self, self.goal)) then
                self.post = self.post % #kPosts + 1;
                return terminated;
            end
            return running;
        end, Stop, guard);

    local chase = Action.new("chase",
        function(self) Announce(self, "chases"); end,
        function(delta, self)
            self.goal = self.intruder:GetPosition();
            self.strength = self.strength - delta / 8000;
            if (Near(self, self.goal)) then
                Announce(self, "catches");
                Sandbox.AddEvent(self.agent:GetSandbox(), "Caught", {});
                return terminated;
            end
            return (GuardBody_IsTired(self) or not GuardBody_SeesIntruder(self)) and terminated or running;
        end, Stop, guard);

    local rest = Action.new("rest",
        function(self)
            Announce(self, "rests");
            self.restLeft = kRestMillis;
        end,
        function(delta, self)
            self.restLeft = self.restLeft - delta;
            return self.restLeft <= 0 and terminated or running;
        end,
        function(self) self.strength = 1; end, guard);

    return patrol, chase, rest;
end
