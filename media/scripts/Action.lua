-- SPDX-License-Identifier: BSD-2-Clause
-- An activity that takes time: it is initialized, updated until its status says that it has ended, and cleaned up.
-- Decision trees, state machines and behavior trees run actions.

Action = {
    Status = { UNINITIALIZED = "UNINITIALIZED", RUNNING = "RUNNING", TERMINATED = "TERMINATED" },
    Type = "Action"
};
Action.__index = Action;

-- initialize(userData), update(deltaTimeInMillis, userData) and cleanUp(userData) may each be nil. update returns a
-- status; an action without an update ends at once.
function Action.new(name, initialize, update, cleanUp, userData)
    return setmetatable({
        name_ = name or "",
        type_ = Action.Type,
        status_ = Action.Status.UNINITIALIZED,
        initialize_ = initialize,
        update_ = update,
        cleanUp_ = cleanUp,
        userData_ = userData
    }, Action);
end

function Action:GetName()
    return self.name_;
end

function Action:GetStatus()
    return self.status_;
end

function Action:IsTerminated()
    return self.status_ == Action.Status.TERMINATED;
end

-- Does nothing if the action is running.
function Action:Initialize()
    if (self.status_ ~= Action.Status.UNINITIALIZED) then
        return;
    end
    if (self.initialize_) then
        self.initialize_(self.userData_);
    end
    self.status_ = Action.Status.RUNNING;
end

-- Returns the status after this step.
function Action:Update(deltaTimeInMillis)
    if (self.status_ == Action.Status.UNINITIALIZED) then
        self:Initialize();
    elseif (self.status_ == Action.Status.RUNNING) then
        local status = Action.Status.TERMINATED;
        if (self.update_) then
            status = self.update_(deltaTimeInMillis, self.userData_);
            assert(Action.Status[status], "the update of the action '" .. self.name_ .. "' returned no status");
        end
        self.status_ = status;
    end
    return self.status_;
end

-- Resets an action that has ended, so that it can start again; does nothing otherwise.
function Action:CleanUp()
    if (self.status_ ~= Action.Status.TERMINATED) then
        return;
    end
    if (self.cleanUp_) then
        self.cleanUp_(self.userData_);
    end
    self.status_ = Action.Status.UNINITIALIZED;
end
