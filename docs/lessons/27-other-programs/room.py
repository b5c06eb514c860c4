# SPDX-License-Identifier: BSD-2-Clause
"""A room with a heater, and a mind that decides when to heat. Complete the three places with a number."""

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

    # 1. What the mind perceives at the beginning: ^temperature, a number, and ^heating, yes or no, on the input link.

    for _ in range(minutes):
        temperature += 0.4 if heating else -0.2
        temperatures.append(temperature)

        # 2. Update the two elements, so that there is one of each. Then let the mind decide until it gives a command.

        # 3. Each command is ^heat with ^to on or off. Carry it out, and answer it.

    return temperatures
