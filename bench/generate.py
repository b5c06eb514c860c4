#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Write the large agents of the corpus into a folder.

usage: generate.py FOLDER [NAME ...]

NAME is one of many-rules, load, smem-lookup, learners-311, learners-3011; all of them
by default. The output depends only on this script and the agents next to it, not on
random numbers or the clock.
"""
import pathlib
import sys

WAYS = ["north", "east", "south", "west"]
BANDS = ["void", "low", "medium", "high", "peak"]


# ---------------------------------------------------------------- many-rules

SENSORS, MISSIONS, TASKS, ACTIONS = 100, 10, 8, 6


def many_rules(out):
    """8,000 rules: sensors, bands, situations, missions, tasks, actions, monitors."""
    rules = []

    def sp(text):
        rules.append("sp {" + text.strip() + "\n}\n")

    sp("""tactic*propose*set-up
   (state <s> ^superstate nil -^clock)
-->
   (<s> ^operator <o> + =)
   (<o> ^name set-up)""")
    sp("""tactic*apply*set-up
   (state <s> ^operator.name set-up)
-->
   (<s> ^clock 0 ^sensors <x> ^log <l>)
   (<l> ^last none)""")
    sp("""tactic*elaborate*top
   (state <s> ^superstate nil ^clock)
-->
   (<s> ^top <s> ^rank mission)""")
    sp("""tactic*elaborate*substate
   (state <s> ^superstate <ss> ^impasse no-change ^attribute operator)
   (<ss> ^top <top> ^operator <o>)
   (<o> ^rank <r> ^below <b> ^name <name> ^code <c>)
-->
   (<s> ^top <top> ^rank <b> ^name <name> ^code <c>)""")

    # 100 sensors follow the clock; 25 of them slowly, 75 in every decision.
    for i in range(SENSORS):
        period = 60 + (i * 7) % 41
        if i % 4 == 0:
            value = f"(mod (div <t> {3 + i % 5}) {period})"
        else:
            value = f"(mod (+ (* <t> {1 + i % 6}) {(i * 13) % period}) {period})"
        sp(f"""tactic*sensor*s{i}
   (state <s> ^superstate nil ^clock <t> ^sensors <x>)
-->
   (<x> ^s{i} {value})""")

    # 20 intervals per sensor, named by band, with a step inside the band.
    for i in range(SENSORS):
        for j in range(20):
            low = j * 5
            band = BANDS[j // 4]
            sp(f"""tactic*band*s{i}*{band}*{j}
   (state <s> ^superstate nil ^sensors <x>)
   (<x> ^s{i} {{ >= {low} < {low + 5} }})
-->
   (<x> ^b{i} {band} ^d{i} {j % 4})""")

    # 1,600 situations: conjunctions of three bands, sometimes with an exception.
    for k in range(1600):
        a, b, c = (k * 3) % SENSORS, (k * 7 + 31) % SENSORS, (k * 11 + 57) % SENSORS
        if b == a:
            b = (b + 1) % SENSORS
        if c in (a, b):
            c = (c + 17) % SENSORS
        exception = f"\n  -(<x> ^b{(c + 5) % SENSORS} {BANDS[(k // 5) % 5]})" if k % 3 == 0 else ""
        sp(f"""tactic*situation*{k}
   (state <s> ^superstate nil ^sensors <x>)
   (<x> ^b{a} {BANDS[k % 5]} ^b{b} {BANDS[(k // 2) % 5]} ^b{c} {BANDS[(k // 7) % 4]} ^d{c} <> {k // 100 % 4} ^d{a} <> {k // 400 % 4}){exception}
-->
   (<s> ^situation sit-{k % 200})""")

    # Missions: one is always proposed, the others depend on slow sensors.
    for m in range(MISSIONS):
        if m == 0:
            condition = ""
        else:
            condition = f"\n   (<x> ^b{4 * m} {BANDS[m % 5]})"
        sp(f"""tactic*mission*{m}*propose
   (state <s> ^superstate nil ^rank mission ^sensors <x>){condition}
-->
   (<s> ^operator <o> + =)
   (<o> ^name mission-{m} ^rank mission ^below task ^code {m})""")
        for n in range(m):
            sp(f"""tactic*mission*{m}*over*{n}
   (state <s> ^superstate nil ^operator <a> + ^operator <b> +)
   (<a> ^name mission-{m})
   (<b> ^name mission-{n})
-->
   (<s> ^operator <a> > <b>)""")

    # Tasks of a mission.
    for m in range(MISSIONS):
        for t in range(TASKS):
            sensor = (m * 9 + t * 4) % SENSORS // 4 * 4
            condition = "" if t == 0 else f"\n   (<x> ^b{sensor} {BANDS[(m + t) % 5]})"
            code = m * TASKS + t
            sp(f"""tactic*mission-{m}*task*{t}*propose
   (state <s> ^name mission-{m} ^rank task ^top.sensors <x>){condition}
-->
   (<s> ^operator <o> + =)
   (<o> ^name task-{code} ^rank task ^below action ^code {code} ^weight {t})""")
        sp(f"""tactic*mission-{m}*task*prefer
   (state <s> ^name mission-{m} ^rank task ^operator <a> + ^operator <b> +)
   (<a> ^rank task ^weight <w>)
   (<b> ^rank task ^weight < <w>)
-->
   (<s> ^operator <a> > <b>)""")

    # Actions of a task: proposal, parameters, exception, order and effect.
    for code in range(MISSIONS * TASKS):
        for a in range(ACTIONS):
            s1, s2 = (code * 5 + a * 3 + 1) % SENSORS, (code * 3 + a * 17 + 2) % SENSORS
            name = f"act-{code}-{a}"
            condition = "" if a == 0 else f" ^b{s1} {BANDS[(code + a) % 5]}"
            sp(f"""tactic*task-{code}*action*{a}*propose
   (state <s> ^name task-{code} ^rank action ^top <top>)
   (<top> ^clock <t> ^sensors <x>)
   (<x> ^s{s2} <v>{condition})
-->
   (<s> ^operator <o> + =)
   (<o> ^name {name} ^rank action ^at <t> ^reading <v> ^weight {a})""")
            sp(f"""tactic*task-{code}*action*{a}*parameter
   (state <s> ^name task-{code} ^operator <o> +)
   (<o> ^name {name} ^reading {{ <v> > {10 + (code + a) % 30} }})
-->
   (<o> ^power (+ <v> {code % 9}) ^direction {WAYS[(code + a) % 4]})""")
            sp(f"""tactic*task-{code}*action*{a}*parameter*default
   (state <s> ^name task-{code} ^operator <o> +)
   (<o> ^name {name} ^reading <= {10 + (code + a) % 30})
-->
   (<o> ^power {code % 9} ^direction {WAYS[(code + a + 1) % 4]})""")
            if a > 0:
                sp(f"""tactic*task-{code}*action*{a}*not-when
   (state <s> ^name task-{code} ^operator <o> + ^top.situation sit-{(code * 3 + a * 29) % 200})
   (<o> ^name {name})
-->
   (<s> ^operator <o> -)""")
                sp(f"""tactic*task-{code}*action*{a}*prefer
   (state <s> ^name task-{code} ^operator <o> + ^operator <p> +)
   (<o> ^name {name})
   (<p> ^rank action ^weight < {a})
-->
   (<s> ^operator <o> > <p>)""")
            sp(f"""tactic*task-{code}*action*{a}*effect
   (state <s> ^name task-{code} ^operator <o> ^top.log <l>)
   (<o> ^name {name} ^direction <d> ^power <p>)
   (<l> ^last {{ <old> <> {name} }})
-->
   (<l> ^last <old> - {name})""")

    sp("""tactic*action*tick
   (state <s> ^rank action ^operator <o> ^top <top>)
   (<o> ^rank action ^at <t>)
   (<top> ^clock <t>)
-->
   (<top> ^clock <t> - (+ <t> 1))""")

    # Monitors, up to 8,000 rules in total: alarms of a mission, by situation, band and step.
    k = 0
    while len(rules) < 8000:
        m = k % MISSIONS
        a, b = (k * 13 + 7) % SENSORS, (k * 29 + 3) % SENSORS
        sp(f"""tactic*monitor*{k}
   (state <s> ^superstate nil ^operator.name mission-{m} ^situation sit-{(k * 7) % 200} ^sensors <x>)
   (<x> ^b{a} {BANDS[k % 5]} ^d{a} <> {k % 4} ^s{b} > {k * 3 % 47})
-->
   (<s> ^alarm alarm-{k % 301})""")
        k += 1

    out.write("# Stresses many rules at once: 8,000 generated rules in the way of a tactical agent.\n"
              "# 100 sensor values follow an internal clock, most of them new in every decision;\n"
              "# bands, situations and alarms hang on them; missions, tasks and actions are a\n"
              "# three-level operator hierarchy. Runs for a given number of decisions.\n\n"
              "chunk never\nsoar max-elaborations 1000\n\n")
    out.write("\n".join(rules))


# ---------------------------------------------------------------------- load

def load(out):
    """20,000 rules of eight shapes for the parser, the reorderer and network building."""
    out.write("# Stresses loading: 20,000 generated rules of eight shapes, sharing little. The\n"
              "# agent halts in its first decision.\n\nchunk never\n\n")
    out.write("sp {load*propose*finish\n   (state <s> ^superstate nil)\n-->\n   (<s> ^operator <o> + =)\n   (<o> ^name finish)\n}\n\n"
              "sp {load*apply*finish\n   (state <s> ^operator.name finish)\n-->\n   (halt)\n}\n")
    load_rules(out, 19998)


def load_rules(out, count):
    """Rules of eight shapes that do not match."""
    for k in range(count):
        shape, a, b, c = k % 8, k % 211, (k // 8) % 173, (k * 7) % 89
        head = f"\nsp {{load*rule*{k}\n"
        if shape == 0:
            body = (f"   (state <s> ^task task-{a} ^mode mode-{b})\n-->\n"
                    f"   (<s> ^operator <o> + =)\n   (<o> ^name op-{k} ^code {k})\n")
        elif shape == 1:
            body = (f"   (state <s> ^operator <o> ^world <w>)\n   (<o> ^name op-{k - 1})\n"
                    f"   (<w> ^object <x> ^limit-{a} <lim>)\n   (<x> ^size {{ <z> < <lim> }} ^colour colour-{b})\n-->\n"
                    f"   (<x> ^size <z> - (+ <z> {c}) ^marked-by op-{k - 1})\n")
        elif shape == 2:
            body = (f"   (state <s> ^world <w>)\n   (<w> ^object <x> ^object {{ <y> <> <x> }})\n"
                    f"   (<x> ^kind kind-{a} ^at-row <r>)\n   (<y> ^kind kind-{b} ^at-row > <r>)\n"
                    f"  -(<x> ^hidden yes)\n-->\n   (<x> ^above-{c} <y>)\n")
        elif shape == 3:
            body = (f"   (state <s> ^world <w> ^time {{ <t> > {k % 997} }})\n   (<w> ^agent <g>)\n   (<g> ^plan.step.name step-{a})\n"
                    f"  -{{ (<w> ^agent {{ <h> <> <g> }})\n     (<h> ^plan.step.name step-{b} ^ready yes) }}\n-->\n"
                    f"   (<g> ^may-do step-{a} ^since (* <t> 0.5))\n")
        elif shape == 4:
            body = (f"   (state <s> ^superstate.operator <so> ^name sub-{a})\n   (<so> ^name << op-{a} op-{b} op-{c} >>)\n"
                    f"-->\n   (<s> ^operator <o> +)\n   (<o> ^name inner-{k} ^for <so>)\n")
        elif shape == 5:
            body = (f"   (state <s> ^operator <o> + ^operator <p> +)\n   (<o> ^name op-{a} ^cost <c>)\n"
                    f"   (<p> ^name op-{b} ^cost > <c>)\n-->\n   (<s> ^operator <o> > <p>)\n")
        elif shape == 6:
            body = (f"   (state <s> ^io.input-link <in>)\n   (<in> ^reading-{a} {{ <v> >= {c} <= {c + 10} }} ^source |unit {b}|)\n"
                    f"-->\n   (<s> ^observed <n>)\n   (<n> ^what reading-{a} ^value <v> ^label (concat |r-| <v>))\n")
        else:
            body = (f"   (state <s> ^note <n> -^closed)\n   (<n> ^topic topic-{a} ^weight <v1> ^link <m>)\n"
                    f"   (<m> ^topic {{ <> topic-{b} <tp> }} ^weight {{ <v2> >= <v1> }} ^link <q>)\n   (<q> ^weight > <v2>)\n"
                    f"-->\n   (<n> ^chain-{c} <tp>)\n   (<s> ^score (- (* <v1> 2) <v2>))\n")
        out.write(head + body + "}\n")


# --------------------------------------------------------------- smem-lookup

def smem_lookup(out):
    """10,000 long-term objects in chains of ten, and an agent that queries them."""
    out.write("""# Stresses semantic memory: 10,000 long-term objects are added while loading, then
# every decision asks for one by two of its values, and every fourth also follows a
# link of what came back. Runs 20,000 decisions of asking, then halts.

chunk never
smem --enable

""")
    for base in range(0, 10000, 500):
        out.write("smem --add {\n")
        for n in range(base, base + 500):
            link = f" ^next @{n + 2}" if n % 10 != 9 else ""
            out.write(f"   (@{n + 1} ^kind kind-{n % 50} ^code {n // 50} ^name |item {n}| ^weight {(n * 37) % 1000 / 8}{link})\n")
        out.write("}\n")
    out.write("""
sp {lookup*propose*set-up
   (state <s> ^superstate nil -^count)
-->
   (<s> ^operator <o> + =)
   (<o> ^name set-up)
}

sp {lookup*apply*set-up
   (state <s> ^operator.name set-up)
-->
   (<s> ^count 0)
}

sp {lookup*propose*ask
   (state <s> ^count { <n> < 20000 })
-->
   (<s> ^operator <o> + =)
   (<o> ^name ask ^count <n> ^kind (concat |kind-| (mod (* <n> 7) 50)) ^code (mod (* <n> 11) 200))
}

sp {lookup*apply*ask*new
   (state <s> ^operator <o> ^count <n> ^smem.command <c>)
   (<o> ^name ask ^count <n> ^kind <k> ^code <x>)
-->
   (<c> ^query <q>)
   (<q> ^kind <k> ^code <x>)
   (<s> ^count <n> - (+ <n> 1))
}

sp {lookup*apply*ask*forget-query
   (state <s> ^operator.name ask ^count <n> ^smem.command <c>)
   (<c> ^query <q>)
   (<q> ^<attribute>)
-->
   (<c> ^query <q> -)
}

sp {lookup*apply*ask*forget-retrieve
   (state <s> ^operator.name ask ^smem.command <c>)
   (<c> ^retrieve <q>)
-->
   (<c> ^retrieve <q> -)
}

# Every fourth answer has its link followed.
sp {lookup*propose*follow
   (state <s> ^turn 3 ^smem <m>)
   (<m> ^command.query ^result.retrieved <r>)
   (<r> ^code ^next <l>)
-->
   (<s> ^operator <o> + >)
   (<o> ^name follow ^link <l>)
}

sp {lookup*elaborate*turn
   (state <s> ^count <n>)
-->
   (<s> ^turn (mod <n> 4))
}

sp {lookup*propose*prefer-follow
   (state <s> ^operator <o> + ^operator <p> +)
   (<o> ^name follow)
   (<p> ^name ask)
-->
   (<s> ^operator <o> > <p>)
}

sp {lookup*apply*follow
   (state <s> ^operator <o> ^smem.command <c>)
   (<o> ^name follow ^link <l>)
   (<c> ^query <q>)
-->
   (<c> ^query <q> - ^retrieve <l>)
}

sp {lookup*finish
   (state <s> ^count 20000)
-->
   (halt)
}
""")


# ------------------------------------------------------------------ learners

def learners(out, more):
    """The 11 rules of learning-scale, and more that never match."""
    out.write((pathlib.Path(__file__).resolve().parent / "agents" / "learning-scale.soar").read_text(encoding="ascii"))
    load_rules(out, more)


GENERATORS = {"many-rules": many_rules, "load": load, "smem-lookup": smem_lookup,
              "learners-311": lambda out: learners(out, 300), "learners-3011": lambda out: learners(out, 3000)}


def main(arguments):
    if not arguments or any(name not in GENERATORS for name in arguments[1:]):
        print(__doc__, file=sys.stderr)
        return 2
    folder = pathlib.Path(arguments[0])
    folder.mkdir(parents=True, exist_ok=True)
    for name in arguments[1:] or GENERATORS:
        with open(folder / f"{name}.soar", "w", encoding="ascii", newline="\n") as out:
            GENERATORS[name](out)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
