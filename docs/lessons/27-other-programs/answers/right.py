# SPDX-License-Identifier: BSD-2-Clause
"""A right answer to room.py."""

HEATER = """
sp {heater*propose*on
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^temperature < 19 ^heating no)
-->
   (<s> ^operator <o> +)
   (<o> ^name switch ^to on)
}
sp {heater*propose*off
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^temperature > 21 ^heating yes)
-->
   (<s> ^operator <o> +)
   (<o> ^name switch ^to off)
}
sp {heater*apply*switch
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name switch ^to <to>)
-->
   (<out> ^heat <command>)
   (<command> ^to <to>)
}
sp {heater*propose*forget
   (state <s> ^superstate nil ^io.output-link.heat <command>)
   (<command> ^status)
-->
   (<s> ^operator <o> + >)
   (<o> ^name forget ^command <command>)
}
sp {heater*apply*forget
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name forget ^command <command>)
-->
   (<out> ^heat <command> -)
}
"""


def run(kernel, minutes):
    """Runs the room for this many minutes, and returns the temperature of each."""
    agent = kernel.CreateAgent("heater")
    agent.ExecuteCommandLine(HEATER)
    temperature, heating, temperatures = 17.0, False, []

    agent.SetOutputLinkChangeTracking(True)
    link = agent.GetInputLink()
    felt = agent.CreateFloatWME(link, "temperature", temperature)
    seen = agent.CreateStringWME(link, "heating", "no")

    for _ in range(minutes):
        temperature += 0.4 if heating else -0.2
        temperatures.append(temperature)

        agent.Update(felt, temperature)
        agent.Update(seen, "yes" if heating else "no")
        agent.RunSelfTilOutput()

        for number in range(agent.GetNumberCommands()):
            command = agent.GetCommand(number)
            to = command.GetParameterValue("to")
            if command.GetCommandName() == "heat" and to in ("on", "off"):
                heating = to == "on"
                command.AddStatusComplete()
            else:
                command.AddStatusError()
        agent.ClearOutputLinkChanges()

    return temperatures
