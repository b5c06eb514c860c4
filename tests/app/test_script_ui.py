# SPDX-License-Identifier: BSD-2-Clause
"""Scripts' user interface and media: buttons, bars, images, models, gamepads, sounds."""
import json
import pathlib
import shutil
import subprocess
import sys

from soarbox_command import Run, ScenarioCase

SOURCE = pathlib.Path(__file__).resolve().parents[2]

SANDBOX = """
function Sandbox_Initialize(sandbox)
    local ui = Sandbox.CreateUIComponent(sandbox, 1);
    UI.SetImage(ui, "badge.png");
    UI.SetBar(ui, 0.5);
    UI.SetButton(ui, "start", function(sandbox, panel)
        print("pressed " .. UI.GetButton(panel) .. " " .. tostring(panel == ui));
        UI.SetBar(panel, UI.GetBar(panel) / 2);
        Sandbox.PlaySound(sandbox, "click.wav");
    end);
    local hidden = UI.CreateChild(ui);
    UI.SetVisible(hidden, false);
    UI.SetButton(hidden, "hidden", function() print("never"); end);
end
function Sandbox_HandleEvent(sandbox, event)
    if (event.source ~= "gamepad") then return; end
    print(event.pad, event.button, event.pressed, event.axis, event.value and string.format("%.2f", event.value));
end
"""
INPUTS = """
2 panel start
3 panel hidden
4 panel strat
5 pad 2 a_button press
6 pad 1 left_x -0.5
"""


class ScriptUi(ScenarioCase):
    def prepare(self, sandbox=SANDBOX):
        for name in ("badge.png", "click.wav", "crystal.glb"):
            shutil.copy(SOURCE / "scenarios/rover" / name, self.folder / name)
        self.write("Sandbox.lua", sandbox)

    def test_presses_and_gamepads_reach_the_functions_of_the_script(self):
        self.prepare()
        run = Run("run", self.folder, "--headless", "--seconds", 1, "--input", self.write("in.txt", INPUTS))
        self.assertIn("pressed start true", run.out)
        self.assertNotIn("never", run.out)
        self.assertIn("2\ta_button\ttrue\tnil\tnil", run.out)
        self.assertIn("2\ta_button\tfalse\tnil\tnil", run.out)
        self.assertIn("1\tnil\tnil\tleft_x\t-0.50", run.out)
        self.assertIn("no script has put a button 'strat' on the screen", run.err)
        self.assertIn("did you mean 'start'?", run.err)

    def test_a_recording_holds_the_presses_and_is_the_same_run(self):
        recording = self.folder / "rover.soarrec"
        inputs = self.write("in.txt", "2 panel start\n40 panel autopilot\n41 pad 1 left_y -1\n90 pad 1 left_x 0.4\n")
        run = Run("run", "rover", "--headless", "--seconds", 6, "--input", inputs, "--record", recording)
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(Run("verify", recording).code, 0)
        exported = Run("replay", recording, "--headless").out
        self.assertNotIn("error", exported)
        still = Run("run", "rover", "--headless", "--seconds", 6)
        self.assertNotEqual(self.hash_of(run), self.hash_of(still))
        again = Run("run", "rover", "--headless", "--seconds", 6, "--input", inputs)
        self.assertEqual(self.hash_of(run), self.hash_of(again))

    @staticmethod
    def hash_of(run):
        return [line for line in (run.out + run.err).splitlines() if "state" in line][-1]

    def test_a_file_that_cannot_be_used_is_named_with_the_reason(self):
        cases = {
            'UI.SetImage(Sandbox.CreateUIComponent(sandbox, 1), "click.wav")': "Sandbox.lua:2: error: click.wav: this is not a PNG file",
            'UI.SetImage(Sandbox.CreateUIComponent(sandbox, 1), "bagde.png")': 'no such image file: "bagde.png": did you mean "badge.png"?',
            'UI.SetImage(Sandbox.CreateUIComponent(sandbox, 1), "../badge.png")': "an image is named relative",
            'Sandbox.PlaySound(sandbox, "badge.png")': "Sandbox.lua:2: error: badge.png: this is not a WAV file",
            'Core.CreateMesh(sandbox, "cut.glb")': "Sandbox.lua:2: error: cut.glb: the file is cut off",
            'Sandbox.CreateObject(sandbox, "cut.glb")': "Sandbox.lua:2: error: cut.glb: the file is cut off",
        }
        for call, reason in cases.items():
            with self.subTest(call):
                self.prepare(f"function Sandbox_Initialize(sandbox)\n{call}\nend\n")
                (self.folder / "cut.glb").write_bytes((self.folder / "crystal.glb").read_bytes()[:-7])
                self.assertIn(reason, Run("run", self.folder, "--headless", "--seconds", 0.1).err)

    def test_a_model_has_a_body_of_its_size(self):
        self.prepare("""
function Sandbox_Initialize(sandbox)
    Sandbox.CreatePlane(sandbox, 20, 20);
    one = Sandbox.CreateObject(sandbox, "crystal.glb");
    Core.SetPosition(one, Vector.new(0, 3, 0));
end
function Sandbox_Cleanup() print(string.format("%.2f", Core.GetPosition(one).y)); end
""")
        # It lies on the ground: its origin is at the lower end of the box around it.
        self.assertRegex(Run("run", self.folder, "--headless", "--seconds", 3).out, r"(?m)\b-?0\.0\d$")
        scene = json.loads(Run("inspect", "rover", "--at", 1, "--view", "agents", "--json").out)
        self.assertEqual(scene[0]["name"], "Rover-1")

    def test_animations_of_a_model_are_the_same_in_each_run_and_in_its_recording(self):
        recording = self.folder / "ponies.soarrec"
        inputs = self.write("in.txt", "60 panel whistle\n")
        run = Run("run", "ponies", "--headless", "--seconds", 12, "--input", inputs, "--record", recording)
        self.assertEqual(run.code, 0, run.err)
        again = Run("run", "ponies", "--headless", "--seconds", 12, "--input", inputs)
        self.assertEqual(self.hash_of(run), self.hash_of(again))
        self.assertEqual(Run("verify", recording).code, 0)
        # The world also hashes the animations: without a blend, the run is another one.
        copy = shutil.copytree(SOURCE / "scenarios/ponies", self.folder / "ponies")
        script = copy / "Pony.lua"
        script.write_text(script.read_text().replace("loops, 1, blend)", "loops, 1, 0)"))
        other = Run("run", copy, "--headless", "--seconds", 12, "--input", inputs)
        self.assertNotEqual(self.hash_of(run), self.hash_of(other))

    def test_an_unknown_animation_is_named_with_those_that_the_model_has(self):
        self.prepare("""
function Sandbox_Initialize(sandbox)
    Animation.Play(Core.CreateMesh(sandbox, "pony.gltf"), "gallop");
end
""")
        shutil.copy(SOURCE / "scenarios/ponies/pony.gltf", self.folder)
        self.assertIn('there is no animation "gallop" here; there are idle, graze, walk, trot, rear',
                      Run("run", self.folder, "--headless", "--seconds", 0.1).err)

    def test_the_pony_is_what_its_script_writes(self):
        copy = shutil.copytree(SOURCE / "scenarios/ponies", self.folder / "ponies")
        subprocess.run([sys.executable, copy / "make_pony.py"], check=True, capture_output=True)
        self.assertEqual((copy / "pony.gltf").read_text(), (SOURCE / "scenarios/ponies/pony.gltf").read_text())

    def test_two_buttons_of_one_name_are_refused(self):
        self.prepare("""
function Sandbox_Initialize(sandbox)
    for i = 1, 2 do UI.SetButton(Sandbox.CreateUIComponent(sandbox, 1), "go", function() end); end
end
""")
        self.assertIn("another button has this name", Run("run", self.folder, "--headless", "--seconds", 0.1).err)
