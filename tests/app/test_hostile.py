# SPDX-License-Identifier: BSD-2-Clause
"""An untrusted scenario may try anything: the process survives, the world continues, and refusals are reported."""
import os
import signal
import subprocess
import time

from soarbox_command import COMMAND, WALKER, ScenarioCase, run_json

SANDBOX = """
function Sandbox_Initialize(sandbox)
    Sandbox.CreatePlane(sandbox, 200, 200);
    Agent.SetPosition(Sandbox.CreateAgent(sandbox, "Walker.lua"), Vector.new(0, 0.8, -50));
    %s
end
%s
"""
# Calls each function of the API with all kinds of values as each argument.
ANYTHING = """
    local box = Sandbox.CreateBox(sandbox, 1, 1, 1)
    local gone = Core.CreateBox(sandbox, 1, 1, 1)
    Core.Remove(gone)
    local values = { sandbox, Sandbox.GetAgents(sandbox)[1], box, gone, Core.CreateBox(sandbox, 1, 1, 1), 0 / 0, 1e300, -1, "",
        ("x"):rep(70000), Vector.new(0 / 0), Vector.new(1e38), {}, { {} }, print, true, Sandbox.CreateUIComponent(sandbox, 0) }
    math.randomseed(7)
    for _, group in ipairs({ "Agent", "Animation", "Core", "Sandbox", "UI", "Vector" }) do
        for name, f in pairs(_G[group]) do
            for round = 1, 40 do
                local arguments = {}
                for i = 1, math.random(0, 8) do arguments[i] = values[math.random(#values)] end
                if round > 10 then
                    arguments[1] = group == "Agent" and values[2] or group == "UI" and values[#values] or sandbox
                end
                if not name:find("^CreateAgent") then pcall(f, unpack(arguments, 1, 8)) end
            end
        end
    end
"""
HOSTILE_LINES = {
    "recursive coroutine.wrap": "local function f() return coroutine.wrap(f)() end f()",
    "recursive coroutine.resume": "local function f() return assert(coroutine.resume(coroutine.create(f))) end f()",
    "gsub within gsub": "local function f() return (string.gsub('x', 'x', f)) end f()",
    "gsub through a metamethod": "local t = setmetatable({}, { __index = function(t) return (string.gsub('x', 'x', t)) end }) string.gsub('x', 'x', t)",
    "sort within sort": "local function f() table.sort({1, 2, 3}, f) return true end f()",
    "sort through a metamethod": "local m = {} m.__lt = function(a, b) table.sort({setmetatable({}, m), setmetatable({}, m)}) return true end table.sort({setmetatable({}, m), setmetatable({}, m)})",
    "tostring of tostring": "local t = setmetatable({}, { __tostring = tostring }) tostring(t)",
    "print of print": "local t t = setmetatable({}, { __tostring = function() print(t) return '' end }) print(t)",
    "format of format": "local t t = setmetatable({}, { __tostring = function() return string.format('%s', t) end }) tostring(t)",
    "load within load": "local function f() load(f) return nil end f()",
    "foreach within foreach": "local function f() table.foreach({1}, f) end f()",
    "foreachi within foreachi": "local function f() table.foreachi({1}, f) end f()",
    "pcall of pcall": "local function f() return pcall(f) end print(f())",
    "xpcall of xpcall": "local function f() return xpcall(f, f) end f()",
    "errors in handlers": "local function h() error(h) end xpcall(error, h) xpcall(h, h)",
    "index chain": "local t = {} for i = 1, 100000 do t = setmetatable({}, { __index = t }) end print(t.x)",
    "call chain": "local t = {} t = setmetatable(t, { __call = function(s) return s() end }) t()",
    "concat chain": "local t = setmetatable({}, {}) getmetatable(t).__concat = function(a, b) return a .. b end print(t .. t)",
    "deep source": "local s = ('('):rep(100000) .. '1' .. (')'):rep(100000) assert(loadstring('return ' .. s))",
    "deep tables in source": "assert(loadstring('return ' .. ('{'):rep(100000) .. ('}'):rep(100000)))",
    "deep table as an event": "local t = {} for i = 1, 1000000 do t = { t } end Sandbox.AddEvent(sandbox, 'x', { t = t })",
    "unpack of a million": "print(unpack({}, 1, 1e8))",
    "byte of a million": "print(#{string.byte(('x'):rep(1e7), 1, -1)})",
    "rep": "local s = ('x'):rep(1e10)",
    "rep of nothing": "for i = 1, 1000 do local s = (''):rep(1e15) end",
    "doubling": "local s = 'x' while true do s = s .. s end",
    "large format": "print(#string.format(('%99.99f'):rep(200000), 1))",
    "endless pattern": "string.find(('a'):rep(50), ('a?'):rep(50) .. ('a'):rep(50) .. 'b')",
    "deep pattern": "string.find(('a'):rep(200000), ('(a*)'):rep(30) .. 'b') string.match(('('):rep(200000), ('%b()'):rep(2000))",
    "long pattern": "string.find('x', ('['):rep(1000000)) string.find(('x'):rep(1e6), ('x-'):rep(1e5))",
    "shifting": "local t = {} for i = 1, 1e6 do t[i] = i end for i = 1, 1e9 do table.insert(t, 1, i) table.remove(t, 1) end",
    "sorting": "local t = {} for i = 1, 1e6 do t[i] = -i end while true do table.sort(t) end",
    "bad order": "local t = {} for i = 1, 1000 do t[i] = i end table.sort(t, function() return true end)",
    "joining": "local t = {} for i = 1, 1e6 do t[i] = 'x' end while true do table.concat(t) end",
    "pairs": "local t = {} for i = 1, 1e6 do t[{}] = i end while true do for k in pairs(t) do break end end",
    "next": "local t = {} for i = 1, 1e6 do t[{}] = i end while true do next(t) end",
    "endless loop": "while true do end",
    "caught endless loop": "while true do pcall(function() while true do end end) end",
    "endless coroutine": "coroutine.wrap(function() while true do coroutine.yield() end end)() while true do end",
    "changed metatables": "getmetatable('').__index = nil setmetatable(_G, { __index = function() error('no') end })",
    "no globals": "for k in pairs(_G) do _G[k] = nil end",
    "errors that are not strings": "error(setmetatable({}, { __tostring = function() error('x') end }))",
    "nil error": "error(nil)",
    "no number": "local a = Sandbox.CreateBox(sandbox, 0/0, 1/0, -1/0) Core.SetPosition(a, Vector.new(0/0, 1/0, 1e308)) Core.ApplyImpulse(a, Vector.new(1/0, 0, 0))",
    "foreign handles": "Core.SetMass(sandbox, 1) Agent.SetMass({}, 1) Core.SetPosition(print, Vector.new())",
    "endless creation": "while true do Sandbox.CreateBox(sandbox, 1, 1, 1) end",
    "endless agents": "while true do Sandbox.CreateAgent(sandbox, 'Walker.lua') end",
    "files": "assert(not io and not os and not debug and not ffi and not dofile and not loadfile) require('../../../etc/passwd')",
    "absolute script": "Sandbox.CreateAgent(sandbox, '/etc/passwd')",
    "bytecode": "assert(loadstring(string.char(27) .. 'LJ' .. ('x'):rep(100)))",
    "bytecode in pieces": "local i = 0 assert(load(function() i = i + 1 return ({ '\\27', 'LJ', ('x'):rep(100) })[i] end))",
    "finalisers": "for i = 1, 1e5 do setmetatable({}, { __gc = function() while true do end end, __mode = 'kv' }) end collectgarbage()",
    "index of itself": "local t = {} setmetatable(t, { __index = t, __newindex = t }) print(pcall(function() t.x = 1 end), t.x)",
    "metatables of handles": "for _, v in ipairs({ Vector.new(), sandbox, walker or sandbox }) do print(getmetatable(v), pcall(setmetatable, v, {})) end",
    "yield across calls": "Sandbox.AddEventCallback(sandbox, sandbox, function() coroutine.yield() end) Sandbox.AddEvent(sandbox, 'x', {}) coroutine.yield()",
    "callbacks of dead coroutines": "for i = 1, 100 do coroutine.wrap(function() Sandbox.AddEventCallback(sandbox, sandbox, function() while true do end end) error('x') end)() end",
    "callbacks that add callbacks": "local function f() Sandbox.AddEventCallback(sandbox, sandbox, f) Sandbox.AddEvent(sandbox, 'x', {}) end f()",
    "text of 100 MB": "local s = ('x'):rep(1e8) print(#s:upper():lower():reverse():gsub('x', 'yy'))",
    "format of 100 MB": "local s = ('x'):rep(1e8) print(#string.format('%s%s%q', s, s, s))",
    "wide format": "print(pcall(string.format, '%' .. ('9'):rep(99) .. 'd', 1), pcall(string.format, '%99.999f', 1), pcall(string.format, '%'))",
    "error of 100 MB": "error(('x'):rep(1e8))",
    "doors": "print(pcall(require, 'ffi'), pcall(require, 'debug'), pcall(require, 'jit')) package.loaded = nil package.preload = { x = print } package.loaders = {} package.loadlib = print require('x')",
    "other environments": "for i = 0, 20 do pcall(setfenv, i, {}) end pcall(setfenv, Sandbox.CreateBox, {}) pcall(setfenv, print, setmetatable({}, { __index = error })) getfenv(0).x = 1",
    "set-up within set-up": "Sandbox_Initialize(sandbox)",
    "deep scene": "local node = sandbox pcall(function() for i = 1, 90000 do node = Core.CreateBox(node, 1, 1, 1) end end) print(Core.GetRadius(node))",
    "deep scene that goes": "local first = Core.CreateBox(sandbox, 1, 1, 1) local node = first pcall(function() for i = 1, 30000 do node = Core.CreateBox(node, 1, 1, 1) end end) Core.Remove(first) print(pcall(Core.GetPosition, node))",
    "deep panels": "local ui = Sandbox.CreateUIComponent(sandbox, 1) for i = 1, 1900 do ui = UI.CreateChild(ui) UI.SetPosition(ui, 1e30, -1e30) end print(UI.GetScreenPosition(ui).x)",
    "bones in circles": "local m = {} for i = 1, 3 do m[i] = Core.CreateMesh(sandbox, 'models/soarbox/soldier.mesh') end for i = 1, 3 do for j = 1, 3 do Animation.AttachToBone(m[i], 'b_Head1', m[j]) end end",
    "animations of what is gone": "local m = Core.CreateMesh(sandbox, 'models/soarbox/soldier.mesh') local a = Animation.GetAnimation(m, 'stand_idle_aim') Core.Remove(m) for _, f in pairs(Animation) do print(pcall(f, a, 1), pcall(f, m, 'b_Head1')) end",
    "animation without an end": "local m = Core.CreateMesh(sandbox, 'models/soarbox/soldier.mesh') local a = Animation.GetAnimation(m, 'stand_idle_aim') for _, v in ipairs({ 1e30, -1e30, 0 / 0, 1 / 0 }) do for _, f in pairs(Animation) do pcall(f, a, v) end end Animation.GetBonePosition(m, 'b_Head1')",
    "absurd ways": "for _, v in ipairs({ 1e30, -1, 0 / 0, 1 / 0, 1e-30 }) do for _, k in ipairs({ 'WalkableHeight', 'WalkableRadius', 'WalkableClimbHeight', 'WalkableSlopeAngle', 'MinimumRegionArea', 'MergeRegionArea', 'CellSize' }) do print(pcall(Sandbox.CreateNavigationMesh, sandbox, 'x', { [k] = v })) end end",
    "absurd influence": "local box = Sandbox.CreateBox(sandbox, 50, 1, 50) Core.SetMass(box, 0) Sandbox.CreateNavigationMesh(sandbox, 'x') for _, v in ipairs({ 1e30, -1, 0 / 0, 1e-30, 0.02 }) do print(pcall(Sandbox.CreateInfluenceMap, sandbox, 'x', { CellWidth = v, CellHeight = v }), pcall(Sandbox.CreateInfluenceMap, sandbox, 'x', { CellWidth = 1, CellHeight = 1, BoundaryMaxOffset = Vector.new(v) })) end",
    "ways on what is gone": "local box = Sandbox.CreateBox(sandbox, 50, 1, 50) Core.SetMass(box, 0) Sandbox.CreateNavigationMesh(sandbox, 'x') Sandbox.CreateInfluenceMap(sandbox, 'x', { CellWidth = 1, CellHeight = 1 }) Sandbox.RemoveObject(sandbox, box) for i = 1, 20 do pcall(Sandbox.CreateNavigationMesh, sandbox, 'x') pcall(Sandbox.FindPath, sandbox, 'x', Vector.new(1e30), Vector.new(0 / 0)) end Sandbox.SpreadInfluenceMap(sandbox, 0)",
    "odd numbers": "print(pcall(math.random, -1e308, 1e308), pcall(math.random, 0 / 0), pcall(math.randomseed, 1 / 0), pcall(string.char, -1), pcall(table.concat, {}, 'x', 1, 1e9), pcall(select, -1e9, 1), bit.lshift(0 / 0, 1e30), pcall(string.sub, 'x', -1e308, 1e308), pcall(unpack, {}, -1e9, 1e9))",
    "odd names": "Sandbox.AddEvent(sandbox, ('x'):rep(60000), { ['\\0'] = '\\0', [('k'):rep(1e6)] = 1 }) print(pcall(Sandbox.CreateAgent, sandbox, '\\0'), pcall(require, ('x'):rep(1e6)), pcall(Sandbox.CreateObject, sandbox, ('../'):rep(1000)))",
    "everything with anything": ANYTHING,
}


# Simulated seconds of the worlds for which one second takes too long.
CROWDED = {"endless creation": 0.3, "endless agents": 0.07}


class OneLiners(ScenarioCase):
    def test_none_ends_the_process_or_the_world(self):
        self.write("Walker.lua", WALKER)
        for name, line in HOSTILE_LINES.items():
            with self.subTest(name):
                self.write("Sandbox.lua", SANDBOX % (line, ""))
                # Thousands of bodies at one place move slowly: a few steps show that they do.
                seconds = CROWDED.get(name, 1)
                run = run_json(self.folder, "--seconds", seconds, "--report", 0.03, limit_s=300, memory_bytes=self.memory())
                self.assertIn(run.code, (0, 1), run.err[-500:])
                last = run.of("state")[-1]
                self.assertGreater(last["time"], seconds * 0.9)
                if seconds == 1:
                    self.assertGreater(last["agents"][0]["position"][0], 0.1)

    def memory(self):
        return None if os.environ.get("SOARBOX_SANITIZE") else 6 << 30


class Worlds(ScenarioCase):
    """Limits for many scripts together, and over time."""

    def run_(self, setup="", update="", agent=None, seconds=1.0, limit_s=100, **more):
        self.write("Walker.lua", WALKER)
        if agent:
            self.write("Bad.lua", agent)
        self.write("Sandbox.lua", SANDBOX % (setup, update))
        start = time.monotonic()
        run = run_json(self.folder, "--seconds", seconds, "--report", 0.1, limit_s=limit_s, **more)
        self.took_s = time.monotonic() - start
        self.assertIn(run.code, (0, 1), run.err[-500:])
        last = run.of("state")[-1]
        self.assertGreater(last["time"], seconds * 0.9)
        self.assertGreater(last["agents"][0]["position"][0], 0.1, "the good agent walks")
        return run

    def told(self, run, text):
        found = [d["message"] for d in run.diagnostics() if text in d["message"]]
        self.assertTrue(found, [d["message"] for d in run.diagnostics()])
        return found

    def test_memory_bombs_of_a_hundred_agents(self):
        run = self.run_('for i = 1, 100 do Sandbox.CreateAgent(sandbox, "Bad.lua") end',
                        agent="local t = {} function Agent_Update() while true do t[#t + 1] = ('x'):rep(1000) .. #t end end",
                        seconds=0.5, memory_bytes=None if os.environ.get("SOARBOX_SANITIZE") else 6 << 30)
        self.told(run, "memory")

    def test_two_thousand_boxes_per_tick(self):
        run = self.run_(update="function Sandbox_Update(s) for i = 1, 2000 do Sandbox.SetPosition = nil local b = Sandbox.CreateBox(s, 1, 1, 1) "
                               "Core.SetPosition(b, Vector.new(i * 2, 1000, Sandbox.GetTimeInMillis(s))) end end", seconds=0.4)
        self.told(run, "this world already has 5000 objects")

    def test_events_that_double(self):
        run = self.run_("Sandbox.AddEventCallback(sandbox, sandbox, function(s, _, kind) Sandbox.AddEvent(s, kind, {}) Sandbox.AddEvent(s, kind, {}) end) "
                        "Sandbox.AddEvent(sandbox, 'x', {})")
        self.told(run, "this world already has 10000 waiting events")

    def test_events_with_large_texts(self):
        run = self.run_(update="local text = ('x'):rep(1e6) function Sandbox_Update(s) for i = 1, 1000 do Sandbox.AddEvent(s, 'x', { text = text }) end end")
        self.told(run, "waiting events of this world already hold")

    def test_a_flood_of_print(self):
        run = self.run_(update="function Sandbox_Update(s) for i = 1, 1e5 do print(('x'):rep(1000)) end end")
        self.told(run, "scripts print more than")
        self.told(run, "lines that scripts printed were left out")
        self.assertLess(len(run.out), 3 << 20)

    def test_loops_in_the_set_up_of_many_agents(self):
        run = self.run_('for i = 1, 60 do Sandbox.CreateAgent(sandbox, "Bad.lua") end',
                        agent="function Agent_Initialize() while true do end end", seconds=0.3)
        self.told(run, "endless loop")

    def test_a_looping_update_of_the_sandbox_is_given_up(self):
        run = self.run_(update="function Sandbox_Update(s) while true do end end", seconds=0.3)
        self.told(run, "was stopped after")

    def test_many_agents_that_each_stay_below_their_limit(self):
        run = self.run_('for i = 1, 50 do Sandbox.CreateAgent(sandbox, "Bad.lua") end',
                        agent="function Agent_Update() for i = 1, 6e6 do end for i = 1, 6e6 do end end", seconds=0.3)
        self.told(run, "was stopped after")

    def test_thousands_of_panels_lights_nodes_and_callbacks(self):
        run = self.run_(update="""
            local function Many(f, ...) for i = 1, 5000 do f(...) end end
            function Sandbox_Update(s)
                pcall(Many, Sandbox.CreateUIComponent, s, 1)
                local _, panels = pcall(Many, Sandbox.CreateUIComponent, s, 1)
                local _, lights = pcall(Many, Core.CreatePointLight, s, Vector.new())
                local _, shapes = pcall(Many, Core.DrawSphere, Vector.new(), 1, Vector.new())
                print(panels, lights)
                local box = Sandbox.CreateBox(s, 1, 1, 1)
                Many(Sandbox.AddCollisionCallback, s, box, function() end)
            end""", seconds=0.3)
        said = " ".join(event["text"] for event in run.of("log"))
        self.assertIn("this world already has 2000 panels", said)
        self.assertIn("this world already has 256 lights", said)
        self.told(run, "this world already has 20000 callbacks")

    def test_ways_and_influence_anew_in_each_step(self):
        run = self.run_("local floor = Sandbox.CreateBox(sandbox, 190, 1, 190) Core.SetMass(floor, 0) Core.SetPosition(floor, Vector.new(0, -0.5, 0))",
                        update="function Sandbox_Update(s) for i = 1, 1000 do Sandbox.CreateNavigationMesh(s, 'x' .. i, { CellSize = 0.2 }) "
                               "Sandbox.CreateInfluenceMap(s, 'x' .. i, { CellWidth = 1, CellHeight = 1 }) end end", seconds=0.1)
        self.told(run, "was stopped after")

    def test_callbacks_that_remove_what_they_are_about(self):
        run = self.run_("""
            local function Hit(s, collision)
                for _, object in ipairs(Sandbox.GetObjects(s)) do Sandbox.RemoveObject(s, object) end
                Sandbox.CreateAgent(s, "Bad.lua")
                Sandbox.AddCollisionCallback(s, Sandbox.CreateBox(s, 1, 1, 1), Hit)
            end
            for i = 1, 3 do Sandbox.AddCollisionCallback(sandbox, Sandbox.CreateBox(sandbox, 1, 1, 1), Hit) end""",
                        agent="function Agent_Update(a) a:RemovePhysics() a:SetHealth(0) error('gone') end", seconds=0.5)
        self.assertGreater(run.of("state")[-1]["time"], 0.4)

    def test_long_texts_stay_outside(self):
        run = self.run_("Agent.SetTeam(Sandbox.GetAgents(sandbox)[1], ('x'):rep(1e6))")
        self.told(run, "65536 bytes")

    def test_a_limit_is_reached_at_the_same_place_in_every_run(self):
        def once():
            return self.run_('for i = 1, 30 do Sandbox.CreateAgent(sandbox, "Bad.lua") end',
                             agent="count = 0 function Agent_Update(a) for i = 1, 1e9 do count = count + 1 end end\n"
                                   "function Agent_Cleanup() print(count) end", seconds=0.2).out
        self.assertEqual(once(), once())


class Signals(ScenarioCase):
    """A run that would last for days can be ended at any moment, and its output is complete up to then."""

    def end(self, sandbox, number, told="begun"):
        """Ends the run after it has printed this text."""
        self.write("Walker.lua", WALKER)
        self.write("Sandbox.lua", sandbox)
        with subprocess.Popen([COMMAND, "run", str(self.folder), "--headless", "--seconds", "1e7"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            begun = ""
            while told not in begun and process.poll() is None:
                begun += process.stdout.readline()
            process.send_signal(number)
            out, err = process.communicate(timeout=60)
        return process.returncode, begun + out, err

    def test_in_the_middle_of_ticks(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            code, out, _ = self.end(SANDBOX % ("print('begun')", ""), number)
            self.assertEqual(code, 0)
            self.assertIn("begun", out)
            self.assertIn("state ", out.splitlines()[-1])

    def test_in_the_middle_of_a_set_up_that_loops(self):
        code, out, _ = self.end(SANDBOX % ("print('begun') for i = 1, 1e6 do pcall(Sandbox.CreateAgent, sandbox, 'Bad.lua') end", "") +
                                "", signal.SIGTERM, "scenario")
        self.assertIn(code, (0, 1, 143))

    def test_in_the_middle_of_scripts_that_loop(self):
        code, out, _ = self.end(SANDBOX % ("print('begun')", "function Sandbox_Update() pcall(function() while true do end end) while true do end end"),
                                signal.SIGTERM)
        self.assertIn(code, (0, 1))
        self.assertIn("begun", out)
