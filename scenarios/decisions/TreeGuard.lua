-- SPDX-License-Identifier: BSD-2-Clause
-- A guard with a decision tree as its mind: tired? rest; sees the intruder? chase; else patrol.
require "DecisionTree";
require "GuardBody";

local guard, tree;

function Agent_Initialize(agent)
    guard = GuardBody_Create(agent);
    local patrol, chase, rest = GuardBody_Actions(guard);
    local awake, tired = DecisionBranch.new(GuardBody_SeesIntruder), DecisionBranch.new(GuardBody_IsTired);
    awake:AddChild(chase);
    awake:AddChild(patrol);
    tired:AddChild(rest);
    tired:AddChild(awake);
    tree = DecisionTree.new(guard);
    tree:SetBranch(tired);
end

function Agent_Update(agent, deltaTimeInMillis)
    tree:Update(deltaTimeInMillis);
    GuardBody_Update(guard, deltaTimeInMillis);
end
