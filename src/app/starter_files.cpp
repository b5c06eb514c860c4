// SPDX-License-Identifier: BSD-2-Clause
#include "app/starter_files.h"

#include <initializer_list>
#include <string>

namespace soarbox::app {
namespace {

constexpr std::string_view kWalkerRules = R"TEXT(# NAME: walk from waypoint to waypoint.
#
# An agent makes one decision after the other. Each time, rules propose operators, one is selected, and rules that
# match the selected operator apply it. What the agent perceives is below ^io.input-link (docs/percepts.md);
# its commands go below ^io.output-link (docs/commands.md).

# Propose: for each waypoint where the agent is not, going there is possible.
# `+` proposes, `=` says that it does not matter which of several is selected.
sp {NAME*propose*move-to
   (state <s> ^superstate nil ^io.input-link.waypoint <w>)
   (<w> ^name <name> ^here no)
-->
   (<s> ^operator <o> + =)
   (<o> ^name move-to ^waypoint <name>)
}

# Apply: give the command. The world answers below it with ^status complete, or ^status error and a ^reason.
sp {NAME*apply*move-to
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name move-to ^waypoint <name>)
-->
   (<out> ^move-to <command>)
   (<command> ^waypoint <name>)
   (write |I go to | <name> (crlf))
}
)TEXT";

constexpr std::string_view kForget = R"TEXT(
# Remove commands that the world has answered, so that the output link stays tidy.
sp {WHO*apply*forget-answered-command
   (state <s> ^superstate nil ^operator <o> ^io.output-link <out>)
   (<out> ^<name> <command>)
   (<command> ^status)
-->
   (<out> ^<name> <command> -)
}
)TEXT";

/// Appends the rule that each agent has to the rules.
std::string Rules(std::string_view rules, std::string_view agent) {
  std::string forget(kForget);
  forget.replace(forget.find("WHO"), 3, agent);
  return std::string(rules) + forget;
}

constexpr std::string_view kSoarScenario =
    R"TEXT(# NAME: the world of this scenario. All distances are in metres; positions are [x, z].
description = "An agent that walks from waypoint to waypoint"
seconds = 60          # how long a headless run lasts

[[agent]]
name = "NAME"
rules = "NAME.soar"
body = "walker"       # or "soldier", "runner", "sentry"
position = [0, 0]
# senses = { sight = 40, view = 200, hearing = 15, memory = 15, noise = 0, rate = 10 }

[[waypoint]]
name = "north"
position = [0, -12]

[[waypoint]]
name = "south"
position = [6, 12]

[[obstacle]]
name = "wall"
position = [0, -5]
size = [5, 2, 0.5]    # width, height, length

[[region]]
name = "goal"
position = [6, 12]
radius = 2

# A goal is reported when it is reached; with [[end]] instead, the run ends there.
[[goal]]
name = "the agent has been in the south"
agent = "NAME"
region = "goal"

# What `soarbox test` checks, with each of these seeds (docs/missions.md).
[mission]
seeds = "1..5"

[[check]]
name = "it comes to the south"
agent = "NAME"
inside = "goal"
by = 60

[[check]]
name = "no way fails"
agent = "NAME"
command = "move-to"
status = "error"
never = true
)TEXT";

constexpr std::string_view kLuaWorld = R"TEXT(-- NAME: a world made by a script, with an agent whose mind is Soar rules.
require "SoarWorld";

local PlainInitialize = Sandbox_Initialize;

function Sandbox_Initialize(sandbox)
    PlainInitialize(sandbox);
    -- A body that comes with the program carries out the commands of docs/commands.md.
    Sandbox.CreateSoarAgent(sandbox, {
        name = "NAME", rules = "NAME.soar", body = "walker", team = "blue", position = Vector.new(0, 0, 0),
        senses = { sight = 40 },
    });
    -- A body of your own: its script gets each command with its parameters.
    Sandbox.CreateSoarAgent(sandbox, "Lamp.lua", "lamp.soar", { name = "lamp" });
end
)TEXT";

constexpr std::string_view kLuaWalker = R"TEXT(# NAME: strolls about as long as it lives.

sp {NAME*propose*wander
   (state <s> ^superstate nil ^io.input-link.self.health > 0)
-->
   (<s> ^operator <o> + =)
   (<o> ^name wander)
}

sp {NAME*apply*wander
   (state <s> ^operator.name wander ^io.output-link <out>)
-->
   (<out> ^wander <command>)
}
)TEXT";

constexpr std::string_view kLamp = R"TEXT(-- The script of an agent with its own body: a lamp that counts seconds.
local seconds = 0;

function Agent_Initialize(agent)
    Core.CreateCapsule(agent, agent:GetHeight(), agent:GetRadius());
    agent:SetPosition(Vector.new(5, 0, 5));
end

-- What is returned here appears on the agent's input link: ^counter <c> (<c> ^seconds 3).
function Agent_Sense(agent)
    seconds = math.floor(Sandbox.GetTimeInSeconds(agent:GetSandbox()));
    return { counter = { seconds = seconds } };
end

-- Called once for each command: its name and its parameters.
function Agent_Update(agent, deltaTimeInMillis, command, parameters)
    if (command == "shine") then
        print("shines for the " .. parameters.number .. ". time");
    end
end
)TEXT";

constexpr std::string_view kLampRules = R"TEXT(# lamp: shine once in each second.

sp {lamp*propose*shine
   (state <s> ^superstate nil ^io.input-link.counter.seconds <n>)
-->
   (<s> ^operator <o> + =)
   (<o> ^name shine ^number <n>)
}

sp {lamp*apply*shine
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name shine ^number <n>)
-->
   (<out> ^shine <command>)
   (<command> ^number <n>)
}
)TEXT";

constexpr std::string_view kTeamScenario = R"TEXT(# NAME: two teams of two. Both use the same rules.
description = "Two teams of two that shoot at each other"
seconds = 120

[[agent]]
name = "blue"
rules = "fighter.soar"
body = "soldier"
team = "blue"
count = 2
position = [-3, 18]
heading = 180

[[agent]]
name = "red"
rules = "fighter.soar"
body = "soldier"
team = "red"
count = 2
position = [-3, -18]
heading = 0

[[obstacle]]
name = "wall"
position = [0, 0]
size = [6, 2, 0.6]

[[waypoint]]
name = "middle"
position = [8, 0]

[[end]]
name = "red wins"
team_down = "blue"

[[end]]
name = "blue wins"
team_down = "red"
)TEXT";

constexpr std::string_view kFighterRules =
    R"TEXT(# A fighter: go to the middle; shoot at enemies in view; reload when the magazine is empty.

sp {fighter*propose*advance
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^waypoint <w> -^path.command move-to)
   (<w> ^name middle ^here no)
-->
   (<s> ^operator <o> +)
   (<o> ^name move-to ^waypoint middle)
}

sp {fighter*propose*shoot
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^self.weapon ready ^agent <a>)
   (<a> ^relation enemy ^visible yes ^alive yes ^name <name>)
-->
   (<s> ^operator <o> + =)
   (<o> ^name shoot ^agent <name>)
}

sp {fighter*propose*reload
   (state <s> ^superstate nil ^io.input-link.self.weapon empty)
-->
   (<s> ^operator <o> +)
   (<o> ^name reload)
}

# What should be done first: reloading, then shooting, then walking.
sp {fighter*prefer*reload
   (state <s> ^operator <a> + ^operator <b> +)
   (<a> ^name reload)
   (<b> ^name << shoot move-to >>)
-->
   (<s> ^operator <a> > <b>)
}

sp {fighter*prefer*shoot
   (state <s> ^operator <a> + ^operator <b> +)
   (<a> ^name shoot)
   (<b> ^name move-to)
-->
   (<s> ^operator <a> > <b>)
}

sp {fighter*apply*move-to
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name move-to ^waypoint <name>)
-->
   (<out> ^move-to <command>)
   (<command> ^waypoint <name>)
}

sp {fighter*apply*shoot
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name shoot ^agent <name>)
-->
   (<out> ^shoot <command>)
   (<command> ^agent <name>)
}

sp {fighter*apply*reload
   (state <s> ^operator.name reload ^io.output-link <out>)
-->
   (<out> ^reload <command>)
}
)TEXT";

/// A text that the output of a run must contain; else `fault` is printed.
struct Check {
  std::string_view printed, fault;
};

/// A script that runs the scenario with three seeds. `seconds` is the option for the duration; may be empty.
std::string Test(std::string_view seconds, std::initializer_list<Check> checks) {
  std::string text = R"TEXT(#!/bin/sh
# Runs the scenario headless with three seeds and checks what a viewer would see.
# SOARBOX=/path/to/soarbox sh test.sh takes another soarbox than the installed one.
soarbox=${SOARBOX:-soarbox}
command -v "$soarbox" >/dev/null || { echo "there is no $soarbox; name it: SOARBOX=/path/to/soarbox sh test.sh"; exit 1; }
cd "$(dirname "$0")" || exit 1
for seed in 1 2 3; do
  "$soarbox" run . --headless)TEXT";
  text.append(seconds);
  text.append(R"TEXT( --seed $seed --json > run.json || { echo "seed $seed: the run failed"; exit 1; }
)TEXT");
  for (const Check& check : checks) {
    text.append("  grep -q '").append(check.printed).append("' run.json || { echo \"seed $seed: ");
    text.append(check.fault).append("\"; exit 1; }\n");
  }
  text.append(R"TEXT(done
rm -f run.json
echo "passed"
)TEXT");
  return text;
}

}  // namespace

std::vector<StarterFile> SoarStarter() {
  return {{"scenario.toml", "the world: bodies, places, obstacles, goals", std::string(kSoarScenario)},
          {"NAME.soar", "the agent's rules", Rules(kWalkerRules, "NAME")},
          {"test.sh", "runs it with three seeds and checks that the goal is reached",
           Test(" --seconds 60", {{R"("event":"reached")", "no goal was reached in 60 s"}})}};
}

std::vector<StarterFile> LuaStarter() {
  return {{"Sandbox.lua", "the script that sets up the world", std::string(kLuaWorld)},
          {"NAME.soar", "the rules of an agent whose body comes with the program", std::string(kLuaWalker)},
          {"Lamp.lua", "the script of an agent that has its own body, percept and command", std::string(kLamp)},
          {"lamp.soar", "the rules of that agent", Rules(kLampRules, "lamp")},
          {"test.sh", "runs it with three seeds and checks what the agents do",
           Test(" --seconds 10",
                {{"shines for the 5. time", "the lamp did not shine"}, {R"("command":"wander")", "nobody wandered"}})}};
}

std::vector<StarterFile> TeamStarter() {
  return {{"scenario.toml", "the world: two teams, a wall, two ends", std::string(kTeamScenario)},
          {"fighter.soar", "the rules of all four", Rules(kFighterRules, "fighter")},
          {"test.sh", "runs it with three seeds and checks that a team wins",
           Test("", {{R"("news":"shoots")", "nobody shot"}, {R"( wins")", "nobody won"}})}};
}

}  // namespace soarbox::app
