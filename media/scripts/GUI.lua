-- SPDX-License-Identifier: BSD-2-Clause
-- The panels that all sandboxes share: F5 performance, F6 camera, F7 physics debug lines; and names for the codes of
-- the markup language.

local kSamples = 15;
local kPanelMargin = 36;  -- Distance from the edges of the window, in pixels.

local cameraPanel;
local profilePanel;
local renderTimes = {};
local simulationTimes = {};
local totalTimes = {};

GUI = {
    Fonts = {
        Small = "small",
        SmallMono = "small_mono",
        Medium = "medium",
        MediumMono = "medium_mono",
        Large = "large",
        LargeMono = "large_mono"
    },
    Markup = {
        Small = "%@9%",
        SmallMono = "%@91%",
        Medium = "%@14%",
        MediumMono = "%@141%",
        Large = "%@24%",
        LargeMono = "%@241%"
    },
    MarkupNewline = "\n",
    MarkupColor = {
        White = "%0",
        Red = "%1",
        Green = "%2",
        Blue = "%3",
        Yellow = "%4",
        Purple = "%5",
        Teal = "%6",
        Orange = "%7",
        Gray = "%8",
        Black = "%9"
    }
};

-- The colours by name, with the numbers of their markup codes.
GUI.Palette = {
    White = { red = 1, green = 1, blue = 1 },
    Red = { red = 1, green = 0, blue = 0 },
    Green = { red = 0, green = 1, blue = 0 },
    Blue = { red = 0, green = 0, blue = 1 },
    Yellow = { red = 1, green = 1, blue = 0 },
    Purple = { red = 1, green = 0, blue = 1 },
    Teal = { red = 0, green = 1, blue = 1 },
    Orange = { red = 1, green = 0.65, blue = 0 },
    Gray = { red = 0.75, green = 0.75, blue = 0.75 },
    Black = { red = 0, green = 0, blue = 0 }
};
GUI.MarkupColorTable = {};
for name, code in pairs(GUI.MarkupColor) do
    GUI.MarkupColorTable[tonumber(string.sub(code, 2))] = GUI.Palette[name];
end

local function CreatePanel(sandbox, x, y, width, height)
    local panel = Sandbox.CreateUIComponent(sandbox, 1);
    UI.SetPosition(panel, x, y);
    UI.SetDimensions(panel, width, height);
    UI.SetTextMargin(panel, 10, 10);
    GUI_SetGradientColor(panel);
    UI.SetVisible(panel, false);
    return panel;
end

local function Toggle(panel)
    if (panel) then
        UI.SetVisible(panel, not UI.IsVisible(panel));
    end
end

-- The mean of the last values, which are stored in `samples`.
local function Average(samples, value)
    samples[#samples + 1] = value;
    if (#samples > kSamples) then
        table.remove(samples, 1);
    end
    local sum = 0;
    for index = 1, #samples do
        sum = sum + samples[index];
    end
    return sum / #samples;
end

local function VectorText(name, vector)
    return GUI.MarkupColor.Yellow .. name .. GUI.MarkupColor.White ..
        string.format(" %8.2f %8.2f %8.2f", vector.x, vector.y, vector.z) .. GUI.MarkupNewline;
end

local function ValueText(name, value, unit)
    return GUI.MarkupColor.Yellow .. name .. GUI.MarkupColor.White ..
        string.format(" %8.2f %s", value, unit) .. GUI.MarkupNewline;
end

function GUI_SetGradientColor(ui)
    UI.SetGradientColor(ui, "north_south", 0, 0, 0, 0.75, 0, 0, 0, 0.35);
end

function GUI_CreateCameraInformation(sandbox)
    cameraPanel = CreatePanel(sandbox, kPanelMargin, kPanelMargin, 330, 110);
    return cameraPanel;
end

function GUI_CreateProfileInformation(sandbox)
    local width = 330;
    local x = Sandbox.GetScreenWidth(sandbox) - width - kPanelMargin;
    profilePanel = CreatePanel(sandbox, x, kPanelMargin, width, 110);
    return profilePanel;
end

-- Sets the colours of the markup, and creates the two hidden panels.
function GUI_CreateUI(sandbox)
    for index, color in pairs(GUI.MarkupColorTable) do
        Sandbox.SetMarkupColor(sandbox, index, color.red, color.green, color.blue);
    end
    GUI_CreateCameraInformation(sandbox);
    GUI_CreateProfileInformation(sandbox);
end

function GUI_HandleEvent(sandbox, event)
    if (event.source ~= "keyboard" or not event.pressed) then
        return;
    end
    if (event.key == "f5_key") then
        Toggle(profilePanel);
    elseif (event.key == "f6_key") then
        Toggle(cameraPanel);
    elseif (event.key == "f7_key") then
        Sandbox.SetDrawPhysicsWorld(sandbox, not Sandbox.GetDrawPhysicsWorld(sandbox));
    end
end

function GUI_UpdateCameraInformation(sandbox)
    if (not cameraPanel or not UI.IsVisible(cameraPanel)) then
        return;
    end
    UI.SetMarkupText(cameraPanel,
        GUI.Markup.SmallMono ..
        VectorText("position   ", Sandbox.GetCameraPosition(sandbox)) ..
        VectorText("orientation", Sandbox.GetCameraOrientation(sandbox)) ..
        VectorText("forward    ", Sandbox.GetCameraForward(sandbox)) ..
        VectorText("left       ", Sandbox.GetCameraLeft(sandbox)) ..
        VectorText("up         ", Sandbox.GetCameraUp(sandbox)));
end

function GUI_UpdateProfileInformation(sandbox)
    if (not profilePanel or not UI.IsVisible(profilePanel)) then
        return;
    end
    local render = Average(renderTimes, Sandbox.GetRenderTime(sandbox));
    local simulation = Average(simulationTimes, Sandbox.GetSimulationTime(sandbox));
    local total = Average(totalTimes, Sandbox.GetTotalSimulationTime(sandbox));
    UI.SetMarkupText(profilePanel,
        GUI.Markup.SmallMono ..
        ValueText("frame time      ", render / 1000, "ms") ..
        ValueText("frames          ", 1000000 / math.max(render, 1), "per second") ..
        ValueText("simulation time ", simulation / 1000, "ms") ..
        ValueText("simulation steps", 1000000 / math.max(total, 1), "per second"));
end

function GUI_UpdateUI(sandbox)
    GUI_UpdateCameraInformation(sandbox);
    GUI_UpdateProfileInformation(sandbox);
end

-- Places a panel in the world, parallel to the screen.
function GUI_OrientTowardCamera(sandbox, ui, position)
    UI.SetWorldPosition(ui, position);
    UI.SetWorldRotation(ui, Sandbox.GetCameraOrientation(sandbox));
end
