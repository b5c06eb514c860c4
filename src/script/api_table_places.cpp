// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

// Sandbox: navigation meshes and the influence map.

namespace soarbox::script {
namespace {

constexpr ApiFunction kPlacesFunctions[] = {
    {"Sandbox.ClearInfluenceMap", "sandbox: Sandbox, layer: number", "", "Sets all cells of a layer to 0.",
     R"(Sandbox.ClearInfluenceMap(sandbox, 0))"},
    {"Sandbox.CreateInfluenceMap", "sandbox: Sandbox, mesh: string, settings: table = none", "",
     "Lays a grid with ten layers, 0 to 9, over a navigation mesh, and replaces the previous grid. Settings: CellWidth "
     "and CellHeight (m; both are required), BoundaryMinOffset and BoundaryMaxOffset (vectors, m, added to the corners "
     "of the mesh's bounding box).",
     R"(Sandbox.CreateInfluenceMap(sandbox, "default", {CellWidth = 2, CellHeight = 1}))"},
    {"Sandbox.CreateNavigationMesh", "sandbox: Sandbox, name: string, settings: table = none", "",
     "Builds a mesh of the places where agents can walk on the present fixed objects (mass 0), except planes. It "
     "replaces a mesh with the same name. The mesh is built while the script continues; the first use waits for it. "
     "Settings, with their units and defaults: WalkableHeight (m; 1.6), WalkableRadius (m; 0.375), WalkableClimbHeight "
     "(m; 0.15), WalkableSlopeAngle (degrees; 45), MinimumRegionArea and MergeRegionArea (sides of squares in cells; "
     "50 and 100), CellSize (m; 0.1), KeepsPoints (if true, FindClosestPoint returns its argument, as in the first "
     "sandbox). Everything further than 100 m from the origin is ignored.",
     R"(Sandbox.CreateNavigationMesh(sandbox, "default", {WalkableRadius = 0.4, MinimumRegionArea = 10}))"},
    {"Sandbox.DrawInfluenceMap", "sandbox: Sandbox, layer: number, positive: table, neutral: table, negative: table",
     "",
     "Colours the cells by their present values, until the next call. The three colours are those of the values 1, 0 "
     "and -1: {red, green, blue, alpha}.",
     R"(Sandbox.DrawInfluenceMap(sandbox, 0, {1, 0, 0, 0.9}, {0, 0, 0, 0.75}, {0, 0, 1, 0.9}))"},
    {"Sandbox.End", "sandbox: Sandbox, name: string", "",
     "Reports that the run has reached this end, like an [[end]] of a scenario file. A run without a window ends; "
     "otherwise the world and the scripts continue. Missions refer to the end by this name.",
     R"(Sandbox.End(sandbox, "all is eaten"))", true},
    {"Sandbox.FindClosestPoint", "sandbox: Sandbox, mesh: string, point: Vector [m]", "Vector [m]",
     "The nearest point on the mesh within 0.5 m sideways and 2 m up or down; the point itself if there is none.",
     R"(local floor = Sandbox.FindClosestPoint(sandbox, "default", agent:GetPosition())
print(floor.y < 0.2)  --> true)"},
    {"Sandbox.FindPath", "sandbox: Sandbox, mesh: string, from: Vector [m], to: Vector [m]", "table of Vector [m]",
     "The shortest path on the mesh, with a point at each border between two polygons that it crosses. {} if there is "
     "no path, or if an end is more than 2 m sideways or 5 m up or down from the mesh.",
     R"(local path = Sandbox.FindPath(sandbox, "default", Vector.new(-5, 0, 0), Vector.new(-5, 0, 9))
agent:SetPath(path)
print(#path > 1)  --> true)"},
    {"Sandbox.GetInertia", "sandbox: Sandbox, layer: number, position: Vector [m]", "number",
     "The same as GetInfluence: its name in the first sandbox.",
     R"(print(Sandbox.GetInertia(sandbox, 0, Vector.new()))  --> 0)"},
    {"Sandbox.GetInfluence", "sandbox: Sandbox, layer: number, position: Vector [m]", "number",
     "The value of the cell at a place, -1 to 1; 0 off the map.",
     R"(Sandbox.SetInfluence(sandbox, 0, agent:GetPosition(), 0.5)
print(Sandbox.GetInfluence(sandbox, 0, agent:GetPosition()))  --> 0.5)",
     true},
    {"Sandbox.RandomPoint", "sandbox: Sandbox, mesh: string", "Vector [m]",
     "A random point on the mesh. All places are equally likely, even those that no path leads to.",
     R"(agent:SetTarget(Sandbox.RandomPoint(sandbox, "default")))"},
    {"Sandbox.ReadText", "sandbox: Sandbox, name: string", "string",
     "The content of a text file in the scenario's folder or the library's. A file that cannot be read is an error.",
     R"(local text = Sandbox.ReadText(sandbox, "Quiet.lua"))", true},
    {"Sandbox.SetDebugNavigationMesh", "sandbox: Sandbox, name: string, show: boolean", "", "Shows or hides a mesh.",
     R"(Sandbox.SetDebugNavigationMesh(sandbox, "default", true))"},
    {"Sandbox.SetDrawInfluenceMap", "sandbox: Sandbox, show: boolean", "",
     "Shows or hides the cells that DrawInfluenceMap coloured.", R"(Sandbox.SetDrawInfluenceMap(sandbox, false))"},
    {"Sandbox.SetFalloff", "sandbox: Sandbox, layer: number, falloff: number 0..1", "",
     "The fraction of an influence that is lost from cell to cell, 0 to 1; initially 0.",
     R"(Sandbox.SetFalloff(sandbox, 0, 0.2))"},
    {"Sandbox.SetInertia", "sandbox: Sandbox, layer: number, inertia: number 0..1", "",
     "The fraction of its value that a cell keeps while influences spread, 0 to 1; initially 0.",
     R"(Sandbox.SetInertia(sandbox, 0, 0.5))"},
    {"Sandbox.SetInfluence", "sandbox: Sandbox, layer: number, position: Vector [m], value: number -1..1", "",
     "Sets the cell at a place to a value from -1 to 1. Places off the mesh are ignored; FindClosestPoint finds one on "
     "the mesh.",
     R"(local place = Sandbox.FindClosestPoint(sandbox, "default", agent:GetPosition())
Sandbox.SetInfluence(sandbox, 0, place, 1))"},
    {"Sandbox.SpreadInfluenceMap", "sandbox: Sandbox, layer: number", "",
     "Spreads the influences of a layer to the surrounding cells, weaker with each cell.",
     R"(Sandbox.SetFalloff(sandbox, 0, 0.2)
Sandbox.SetInfluence(sandbox, 0, Vector.new(-5, 0.5, 5), 1)
Sandbox.SpreadInfluenceMap(sandbox, 0)
print(Sandbox.GetInfluence(sandbox, 0, Vector.new(-7, 0.5, 5)) > 0.7)  --> true)"},
};

}  // namespace

std::span<const ApiFunction> SandboxPlacesApi() {
  return kPlacesFunctions;
}

}  // namespace soarbox::script
