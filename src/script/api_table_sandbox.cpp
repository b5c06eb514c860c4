// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

// Sandbox: the contents of the world, camera, time, events, user interface. Navigation meshes and the influence map are
// in api_table_places.cpp.

namespace soarbox::script {
namespace {

constexpr ApiFunction kSandboxFunctions[] = {
    {"Sandbox.AddCollisionCallback", "sandbox: Sandbox, object: Object, callback: function", "",
     "Calls callback(sandbox, collision) after each step in which an agent or another body touches the object. The "
     "collision has the fields objectA (this object), objectB (the other object or agent), pointA, pointB and "
     "normalOnB.",
     R"(Sandbox.AddCollisionCallback(sandbox, object, function(sandbox, collision)
  Sandbox.RemoveObject(sandbox, collision.objectA)
end))"},
    {"Sandbox.AddEvent", "sandbox: Sandbox, type: string, event: value", "",
     "Sends an event to all listeners at the beginning of the next step. The fields of the table may be numbers, "
     "strings, booleans, vectors, agents, objects and the sandbox; others are left out.",
     R"(Sandbox.AddEvent(sandbox, "Noise", {position = agent:GetPosition(), loudness = 3}))"},
    {"Sandbox.AddEventCallback", "sandbox: Sandbox, listener: value, callback: function", "",
     "Adds a listener, which is an agent, an object or the sandbox: callback(sandbox, listener, type, event) is called "
     "for all events. A second callback of the same listener replaces the first.",
     R"(Sandbox.AddEventCallback(sandbox, agent, function(sandbox, agent, type, event)
  if type == "Noise" then agent:SetTarget(event.position) end
end))"},
    {"Sandbox.CreateAgent", "sandbox: Sandbox, script: string", "Agent",
     "Creates an agent at the origin that this script controls, and calls the script's Agent_Initialize.",
     R"(local walker = Sandbox.CreateAgent(sandbox, "Quiet.lua")
walker:SetPosition(Vector.new(2, 0.8, 0)))"},
    {"Sandbox.CreateBox",
     "sandbox: Sandbox, width: number 0.001..100000 [m], height: number 0.001..100000 [m], length: number "
     "0.001..100000 [m], u_tiles: number = 1, v_tiles: number = 1",
     "Object",
     "A box with a body of 1 kg at the origin. u_tiles and v_tiles are the numbers of times that the texture is "
     "repeated on each side.",
     R"(local floor = Sandbox.CreateBox(sandbox, 20, 1, 20, 10, 10)
Core.SetMass(floor, 0)
Core.SetPosition(floor, Vector.new(0, -0.5, 0)))"},
    {"Sandbox.CreateCapsule", "sandbox: Sandbox, height: number 0.001..100000 [m], radius: number 0.001..100000 [m]",
     "Object", "An upright capsule with a body of 1 kg at the origin; the height includes the caps.",
     R"(local pillar = Sandbox.CreateCapsule(sandbox, 3, 0.5))"},
    {"Sandbox.CreateObject", "sandbox: Sandbox, mesh: string", "Object",
     "A mesh of the media library, or a model from a .glb or .gltf file of the scenario's folder (docs/lua/models.md), "
     "with a box-shaped body of 1 kg at the origin.",
     R"(local block = Sandbox.CreateObject(sandbox, "models/nobiax_modular/modular_block.mesh"))"},
    {"Sandbox.CreatePhysicsCapsule",
     "sandbox: Sandbox, height: number 0.001..100000 [m], radius: number 0.001..100000 [m]", "Object",
     "An invisible capsule with a body of 1 kg.",
     R"(local bullet = Sandbox.CreatePhysicsCapsule(sandbox, 0.3, 0.01)
Core.SetMass(bullet, 0.1))"},
    {"Sandbox.CreatePhysicsSphere", "sandbox: Sandbox, radius: number 0.001..100000 [m]", "Object",
     "An invisible ball with a body of 1 kg.", R"(local ball = Sandbox.CreatePhysicsSphere(sandbox, 0.2))"},
    {"Sandbox.CreatePlane", "sandbox: Sandbox, length: number 0..1e6 [m], width: number 0..1e6 [m]", "Object",
     "A visible plane at y = 0 on an endless fixed floor. Navigation meshes ignore it.",
     R"(local ground = Sandbox.CreatePlane(sandbox, 200, 200)
Core.SetMaterial(ground, "Ground2"))"},
    {"Sandbox.CreateSkyBox", "sandbox: Sandbox, material: string, rotation: Vector [deg] = none", "",
     "Creates a sky around the world, which replaces the previous one.",
     R"(Sandbox.CreateSkyBox(sandbox, "ThickCloudsWaterSkyBox", Vector.new(0, 180, 0)))"},
    {"Sandbox.CreateSensor",
     "sandbox: Sandbox, width: number 0.001..100000 [m], height: number 0.001..100000 [m], length: number "
     "0.001..100000 [m]",
     "Object",
     "Creates an invisible box that nothing collides with. When an agent or a movable object enters or leaves it, it "
     "sends the event \"SensorEntered\" or \"SensorLeft\" to all listeners (Sandbox.AddEventCallback). The event has "
     "the field sensor, and the field agent or object with the one that entered or left. Agents without physics are "
     "not detected.",
     R"(local goal = Sandbox.CreateSensor(sandbox, 4, 3, 4)
Sandbox.AddEventCallback(sandbox, goal, function(sandbox, goal, type, event)
  if type == "SensorEntered" and event.sensor == goal then print("goal!") end
end))",
     true},
    {"Sandbox.CreateSoarAgent", "sandbox: Sandbox, script: value, rules: string = none, options: table = none", "Agent",
     "Creates an agent whose body is a script and whose mind is a file of Soar rules. Agent_Update(agent, "
     "milliseconds, command, parameters) runs once for each command of its mind, or over several ticks if it returns "
     "\"running\"; Agent_Tick(agent, milliseconds) runs in each tick. If you pass a table of options "
     "instead of the script ({rules = \"scout.soar\", body = \"soldier\", team = \"blue\", position = Vector.new(0, 0, "
     "3)}), the agent needs no script: its body knows the commands of docs/commands.md.",
     R"(local thinker = Sandbox.CreateSoarAgent(sandbox, "Quiet.lua", "walk.soar"))", true},
    {"Sandbox.CreateSoarFollowerAgent",
     "sandbox: Sandbox, script: string, rules: string = followeragent.soar, options: table = none", "Agent",
     "Creates an agent whose mind perceives the distance to its leader (Agent.SetLeader) and commands \"follow\" or "
     "\"stop\".",
     R"(local follower = Sandbox.CreateSoarFollowerAgent(sandbox, "Quiet.lua")
follower:SetLeader(agent))",
     true},
    {"Sandbox.CreateSoarSeekingAgent",
     "sandbox: Sandbox, script: string, rules: string = seekingagent.soar, options: table = none", "Agent",
     "Creates an agent whose mind perceives the distance to its target and commands \"newtarget\" or \"sametarget\".",
     R"(local seeker = Sandbox.CreateSoarSeekingAgent(sandbox, "Quiet.lua"))", true},
    {"Sandbox.CreateSoarWaypointAgent",
     "sandbox: Sandbox, script: string, rules: string = waypointagent.soar, options: table = none", "Agent",
     "Creates an agent whose mind perceives the distance to its target and commands \"nextwaypoint\" or "
     "\"samewaypoint\".",
     R"(local guard = Sandbox.CreateSoarWaypointAgent(sandbox, "Quiet.lua"))", true},
    {"Sandbox.CreateUIComponent", "sandbox: Sandbox, layer: number", "UI",
     "A panel of 100 by 100 pixels at the top left of the window. Layers go from 0 to 15, with 15 on top.",
     R"(local panel = Sandbox.CreateUIComponent(sandbox, 1)
UI.SetText(panel, "hello"))"},
    {"Sandbox.CreateUIComponent3d", "sandbox: Sandbox, position: Vector [m]", "UI",
     "A panel in the world, with 0.005 m per pixel.",
     R"(local sign = Sandbox.CreateUIComponent3d(sandbox, Vector.new(0, 2, 0))
UI.SetText(sign, "exit"))"},
    {"Sandbox.GetAgents", "sandbox: Sandbox", "table of Agent",
     "All agents in the order of their creation, including dead ones.", R"(print(#Sandbox.GetAgents(sandbox))  --> 2)"},
    {"Sandbox.GetCameraForward", "sandbox: Sandbox", "Vector",
     "The direction in which the camera looks, with length 1.",
     R"(print(Sandbox.GetCameraForward(sandbox).z < 0)  --> true)"},
    {"Sandbox.GetCameraLeft", "sandbox: Sandbox", "Vector", "The direction to the camera's left, with length 1.",
     R"(print(Sandbox.GetCameraLeft(sandbox).x < 0)  --> true)"},
    {"Sandbox.GetCameraOrientation", "sandbox: Sandbox", "Vector [deg]", "The camera's rotation.",
     R"(Sandbox.SetCameraOrientation(sandbox, Sandbox.GetCameraOrientation(sandbox)))"},
    {"Sandbox.GetCameraPosition", "sandbox: Sandbox", "Vector [m]", "The camera's position.",
     R"(Sandbox.SetCameraPosition(sandbox, Vector.new(0, 5, -10))
print(Sandbox.GetCameraPosition(sandbox).y)  --> 5)"},
    {"Sandbox.GetCameraUp", "sandbox: Sandbox", "Vector", "The camera's up direction, with length 1.",
     R"(print(Sandbox.GetCameraUp(sandbox).y > 0)  --> true)"},
    {"Sandbox.GetDrawPhysicsWorld", "sandbox: Sandbox", "boolean", "Whether the bodies are drawn as wires.",
     R"(print(Sandbox.GetDrawPhysicsWorld(sandbox))  --> false)"},
    {"Sandbox.GetMarkupColor", "sandbox: Sandbox, index: number", "number, table",
     "The index and the colour of a code %0 to %9 in markup texts: {red, green, blue, alpha} by name.",
     R"(local _, color = Sandbox.GetMarkupColor(sandbox, 0)
print(color.red)  --> 1)"},
    {"Sandbox.GetObjects", "sandbox: Sandbox", "table of Object",
     "All objects in ascending order of their numbers, without agents.",
     R"(for _, object in ipairs(Sandbox.GetObjects(sandbox)) do Core.GetMass(object) end)"},
    {"Sandbox.GetRenderTime", "sandbox: Sandbox", "number [us]", "The time between the last two frames of the window.",
     R"(print(Sandbox.GetRenderTime(sandbox) > 0)  --> true)"},
    {"Sandbox.GetScreenHeight", "sandbox: Sandbox", "number [px]", "The height of the window; 800 without a window.",
     R"(print(Sandbox.GetScreenHeight(sandbox))  --> 800)"},
    {"Sandbox.GetScreenWidth", "sandbox: Sandbox", "number [px]", "The width of the window; 1280 without a window.",
     R"(print(Sandbox.GetScreenWidth(sandbox))  --> 1280)"},
    {"Sandbox.GetSimulationTime", "sandbox: Sandbox", "number [us]", "The real time that the last step took.",
     R"(print(Sandbox.GetSimulationTime(sandbox) >= 0)  --> true)"},
    {"Sandbox.GetTimeInMillis", "sandbox: Sandbox", "number [ms]", "The scripts' clock: 33 for each step.",
     R"(local now = Sandbox.GetTimeInMillis(sandbox)
print(now)  --> 0)"},
    {"Sandbox.GetTimeInSeconds", "sandbox: Sandbox", "number [s]", "The scripts' clock.",
     R"(print(Sandbox.GetTimeInSeconds(sandbox))  --> 0)"},
    {"Sandbox.GetTotalSimulationTime", "sandbox: Sandbox", "number [us]", "The time between the last two steps.",
     R"(print(Sandbox.GetTotalSimulationTime(sandbox) > 0)  --> true)"},
    {"Sandbox.PlaySound", "sandbox: Sandbox, file: string, volume: number 0..1 = 1, position: Vector [m] = everywhere",
     "",
     "Plays a sound in the window and in pages: a WAV file of the scenario's folder with 8 or 16 bits, one or two "
     "channels and up to 8 MB. A sound with a position has a direction, and gets softer with distance. Nothing in the "
     "world depends on sounds. A file that cannot be used is an error that states the reason.",
     R"(Sandbox.PlaySound(sandbox, "bell.wav", 0.5, agent:GetPosition()))", true},
    {"Sandbox.RayCastToObject", "sandbox: Sandbox, from: Vector [m], to: Vector [m]", "table",
     "Finds the first body on a line: {result, hitPoint, object}, the last two only if result is true. A ray that "
     "starts inside a body does not hit that body.",
     R"(local hit = Sandbox.RayCastToObject(sandbox, Vector.new(5, 10, 5), Vector.new(5, -1, 5))
print(hit.result, hit.hitPoint.y)  --> true	1)"},
    {"Sandbox.RemoveAgent", "sandbox: Sandbox, agent: value", "",
     "Removes an agent, with everything attached to it, at the beginning of the next step. Until then it acts as "
     "before; then Agent_Cleanup of its script is called and its mind ends. A second call has no effect.",
     R"(Sandbox.RemoveAgent(sandbox, agent))", true},
    {"Sandbox.RemoveObject", "sandbox: Sandbox, object: value", "",
     "Removes an object from the world at the beginning of the next step. A second call has no effect.",
     R"(Sandbox.RemoveObject(sandbox, object))"},
    {"Sandbox.SetAmbientLight", "sandbox: Sandbox, color: Vector", "",
     "Sets the ambient light, which has no direction; initially there is none.",
     R"(Sandbox.SetAmbientLight(sandbox, Vector.new(0.3)))"},
    {"Sandbox.SetCameraFixed", "sandbox: Sandbox, fixed: boolean", "",
     "If true, the window shows the view of this camera until the user moves the camera. If false, the window keeps "
     "the agents in view.",
     R"(Sandbox.SetCameraFixed(sandbox, true))", true},
    {"Sandbox.SetCameraForward", "sandbox: Sandbox, direction: Vector", "",
     "Makes the camera look in the opposite of this direction, as in the first sandbox.",
     R"(Sandbox.SetCameraForward(sandbox, Vector.new(0, 0, -1))
print(Sandbox.GetCameraForward(sandbox).z)  --> 1)"},
    {"Sandbox.SetCameraOrientation", "sandbox: Sandbox, rotation: Vector [deg]", "", "Turns the camera.",
     R"(Sandbox.SetCameraOrientation(sandbox, Vector.new(-160, 0, -180)))"},
    {"Sandbox.SetCameraPosition", "sandbox: Sandbox, position: Vector [m]", "", "Moves the camera.",
     R"(Sandbox.SetCameraPosition(sandbox, Vector.new(7, 5, -18)))"},
    {"Sandbox.SetDrawPhysicsWorld", "sandbox: Sandbox, draw: boolean", "", "Shows or hides all bodies as wires.",
     R"(Sandbox.SetDrawPhysicsWorld(sandbox, true))"},
    {"Sandbox.SetMarkupColor",
     "sandbox: Sandbox, index: number, red: number 0..1, green: number 0..1, blue: number 0..1, alpha: number 0..1 = 1",
     "", "Changes the colour of a code %0 to %9 in markup texts; 0 to 1 per channel.",
     R"(Sandbox.SetMarkupColor(sandbox, 1, 1, 0, 0))"},
};

}  // namespace

std::span<const ApiFunction> SandboxApi() {
  return kSandboxFunctions;
}

}  // namespace soarbox::script
