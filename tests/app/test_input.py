# SPDX-License-Identifier: BSD-2-Clause
"""All inputs reach a run in the same way, also from a file."""

from soarbox_command import WALKER, ScenarioCase, run_json

LISTENER = """
local function Tell(who, event)
    local words = { who, event.source };
    for _, name in ipairs({ "key", "button", "pressed", "x", "y", "dx", "dy", "wheel", "width", "height" }) do
        if event[name] ~= nil then words[#words + 1] = name .. "=" .. tostring(event[name]) end
    end
    print(table.concat(words, " "));
end
function Sandbox_Initialize(sandbox)
    Sandbox.CreatePlane(sandbox, 200, 200);
    Sandbox.CreateAgent(sandbox, "Walker.lua");
    Sandbox.AddEventCallback(sandbox, sandbox, function(_, _, kind, event)
        print(kind .. " " .. Agent.GetId(event.agent) .. " " .. event.order);
    end);
end
function Sandbox_HandleEvent(sandbox, event) Tell("sandbox", event); end
"""
HEARING = WALKER + """
function Agent_HandleEvent(agent, event) if event.key then print("agent " .. event.key); end end
"""


class Inputs(ScenarioCase):
    def run_(self, inputs, *more):
        self.write("Sandbox.lua", LISTENER)
        self.write("Walker.lua", HEARING)
        return run_json(self.folder, "--seconds", 2, "--input", self.write("keys.txt", inputs), *more)

    def said(self, run):
        return [(event["tick"], event["text"].split(": ", 1)[1]) for event in run.of("log")]

    def test_each_input_arrives_at_its_tick_with_all_that_it_says(self):
        run = self.run_("10 key numpad_3_key press\n"
                        "20 button left_button click 500 300\n"
                        "21 pointer 510 290\n"
                        "22 wheel -1\n"
                        "23 screen 640 480\n"
                        "23 pointer 1 2 3 4\n")
        self.assertEqual(run.code, 0, run.err)
        size = "width=1280 height=720"
        self.assertEqual(self.said(run), [
            (10, "sandbox keyboard key=numpad_3_key pressed=true"), (10, "agent numpad_3_key"),
            (10, "sandbox keyboard key=numpad_3_key pressed=false"), (10, "agent numpad_3_key"),
            (20, f"sandbox mouse button=left_button pressed=true x=500 y=300 dx=0 dy=0 wheel=0 {size}"),
            (20, f"sandbox mouse button=left_button pressed=false x=500 y=300 dx=0 dy=0 wheel=0 {size}"),
            (21, f"sandbox mouse x=510 y=290 dx=10 dy=-10 wheel=0 {size}"),
            (22, f"sandbox mouse x=510 y=290 dx=0 dy=0 wheel=-1 {size}"),
            (23, "sandbox mouse x=1 y=2 dx=3 dy=4 wheel=0 width=640 height=480")])

    def test_scripts_read_the_camera_that_comes_in(self):
        run = self.run_('4 script sandbox "function Sandbox_Update(s) print(tostring(Sandbox.GetCameraPosition(s))) end"\n'
                        "5 camera 1 2 3\n")
        self.assertIn((5, "{ x=1.000000, y=2.000000, z=3.000000 }"), self.said(run))

    def test_orders_and_edits_of_scripts_take_effect(self):
        run = self.run_("5 order Walker-1 go home\n"
                        '9 script Walker-1 "function Agent_Update() print(\\"new\\") end"\n')
        self.assertIn((5, "Order 2 go home"), self.said(run))
        self.assertEqual([tick for tick, text in self.said(run) if text == "new"], list(range(9, 61)))

    def test_an_agent_that_is_not_there_is_told_with_the_near_one(self):
        run = self.run_("5 order Walker-2 go home\n5 command Walker-1 print\n")
        self.assertEqual(run.code, 1, run.out)
        self.assertIn("did you mean 'Walker-1'?", run.out)
        self.assertIn("there is no Soar agent 'Walker-1'", run.out)

    def test_the_same_inputs_give_the_same_run_and_others_another(self):
        self.assertEqual(self.run_("9 key a_key press\n").out, self.run_("9 key a_key press\n").out)
        self.assertNotEqual(self.run_('9 script Walker-1 Agent_Update = nil\n').of("end"), self.run_("").of("end"))

    def test_lines_that_are_wrong_are_told_with_their_place(self):
        run = self.run_("# keys\n5 key f1key press\n6 button left_button down 5\n")
        self.assertEqual(run.code, 3)
        self.assertIn("keys.txt:2:7: error: 'f1key' is not a key", run.err)
        self.assertIn("did you mean 'f1_key'?", run.err)
        self.assertIn("keys.txt:3:", run.err)

    def test_a_file_that_is_not_there_is_named(self):
        run = run_json("thesis", "--seconds", 1, "--input", self.folder / "none.txt", code=3)
        self.assertIn("none.txt", run.err)

    def test_inputs_after_the_end_are_told(self):
        run = self.run_("500 key a_key press\n")
        self.assertIn("the run ended before 2 of its inputs", run.err)


class Minds(ScenarioCase):
    def test_commands_reach_a_mind_and_edit_its_rules(self):
        inputs = self.write("in.txt", '20 command follower-1 "sp {shout (state <s> ^superstate nil) --> (<s> ^edited yes)}"\n'
                            "30 command follower-1 print s1\n")
        run = run_json("thesis", "--seconds", 2, "--input", inputs, code=0)
        answers = [event["text"] for event in run.of("answer", agent="follower-1")]
        self.assertTrue(any("^edited yes" in text for text in answers), answers)
