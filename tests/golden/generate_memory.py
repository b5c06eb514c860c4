#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Writes random agents with long-term memory as cases for trace_case.

usage: generate_memory.py semantic|episodic SEED COUNT FOLDER

semantic: graphs with skewed values and cycles, cues grown from an object by dropping, replacing and negating, all modes
of activation, stores between queries. episodic: worlds whose things come, go and change, cues cut from what was there
once and spoilt, negated, bounded. Each answer is written by a rule, so that transcripts of two kernels can be compared:

    python3 tests/golden/generate_memory.py semantic 1 50 /tmp/memory
    for case in /tmp/memory/*; do (cd $case && build/dev/bin/trace_case case.cmd); done
"""
import pathlib
import random
import sys

STEP = """sp {begin (state <s> ^superstate nil -^n) --> (<s> ^operator <o> +) (<o> ^name begin)}
sp {begin*apply (state <s> ^operator.name begin) --> (<s> ^n 1)}
sp {step (state <s> ^superstate nil ^n <n>) --> (<s> ^operator <o> +) (<o> ^name step ^n <n>)}
sp {step*apply (state <s> ^operator <o> ^n <n>) (<o> ^name step ^n <n>) --> (<s> ^n <n> - (+ <n> 1))}
"""


def skewed(draw, values):
    """The first values come most often."""
    return values[min(int(draw.expovariate(1.2)), len(values) - 1)]


def semantic(draw):
    """An agent that queries and stores, and the commands that run it."""
    count = draw.randint(4, 30)
    kinds, colors = [f"kind-{n}" for n in range(5)], ["red", "green", "blue", "grey"]
    objects = [{"tag": f"thing-{n}", "kind": skewed(draw, kinds), "color": skewed(draw, colors), "size": draw.randint(1, 6)}
               for n in range(1, count + 1)]
    mode = draw.choice(["recency", "frequency", "base-level"])
    lines = ["smem --enable", f"smem --set activation-mode {mode}"]
    if mode == "base-level":
        lines.append("smem --set base-update-policy " + draw.choice(["stable", "naive", "incremental"]))
    if draw.random() < 0.3:
        lines.append(f"smem --set thresh {draw.randint(1, 6)}")
    for number, thing in enumerate(objects, 1):
        links = "".join(f" ^next @{draw.randint(1, count)}" for _ in range(draw.randint(0, 2)))
        text = " ".join(f"^{name} {value}" for name, value in thing.items() if name == "tag" or draw.random() < 0.9)
        lines.append(f"smem --add {{ (@{number} {text}{links}) }}")
    lines.append(STEP)
    steps = draw.randint(5, 25)
    for step in range(1, steps + 1):
        if draw.random() < 0.15:
            lines.append(f"sp {{store*{step} (state <s> ^superstate nil ^n {step} ^smem.command <c>) --> (<c> ^store <x>)"
                         f" (<x> ^tag stored-{step} ^kind {skewed(draw, kinds)} ^size {draw.randint(1, 6)})}}")
            continue
        thing = draw.choice(objects)
        cue = []
        for name in ("kind", "color", "size"):
            roll = draw.random()
            if roll < 0.45:
                cue.append(f"^{name} {thing[name]}")
            elif roll < 0.55:
                cue.append(f"^{name} <any-{name}>")
        if draw.random() < 0.1:
            cue.append(draw.choice(["^kind nothing", "^absent yes", "^next <any-next>"]))
        cue = cue or [f"^kind {thing['kind']}"]
        more = ""
        if draw.random() < 0.3:
            more += f" (<c> ^neg-query <no>) (<no> ^{draw.choice(['color red', 'size 3', 'kind kind-0', 'absent yes'])})"
        if draw.random() < 0.25:
            test = draw.choice(["max <m>", "min <m>", f"less {draw.randint(1, 7)}", f"greater-or-equal {draw.randint(1, 7)}"])
            more += f" (<c> ^math-query <q2>) (<q2> ^size <q3>) (<q3> ^{test})"
        lines.append(f"sp {{ask*{step} (state <s> ^superstate nil ^n {step} ^smem.command <c>) --> (<c> ^query <q>)"
                     f" (<q> {' '.join(cue)}){more}}}")
    for sign, tail in (("retrieved", "(<r> ^tag <t>)"), ("failure", ""), ("bad-cmd", "")):
        shown = "<t>" if tail else f"|{sign}|"
        lines.append(f"sp {{show*{sign} (state <s> ^superstate nil ^n <n> ^smem.result.{sign} <r>) {tail} -->"
                     f" (write (crlf) <n> | | {shown})}}")
    commands = ["source agent.soar", "trace 0", f"run {steps + 2}", "print @"]
    return lines, commands


def episodic(draw):
    """An agent whose world changes, and that asks when it was how."""
    colors, boxes = ["red", "green", "blue"], [f"box-{n}" for n in range(1, draw.randint(2, 4))]
    lines = ["epmem --enable", "epmem --set trigger dc", STEP]
    first = " ".join(f"(<s> ^box <{box}>) (<{box}> ^id {box} ^color {draw.choice(colors)} ^at spot-{draw.randint(1, 3)})"
                     for box in boxes)
    lines.append(f"sp {{world (state <s> ^operator.name begin) --> (<s> ^light on ^count 0) {first}}}")
    steps = draw.randint(6, 24)
    asked_from = steps // 2
    for step in range(1, steps + 1):
        where = f"(state <s> ^operator <o> ^n {step}) (<o> ^name step ^n {step})"
        for number in range(draw.randint(0, 2)):
            roll = draw.random()
            name = f"change*{step}*{number}"
            if roll < 0.5:
                what, value = draw.choice([("color", draw.choice(colors)), ("at", f"spot-{draw.randint(1, 3)}")])
                lines.append(f"sp {{{name} {where} (<s> ^box <b>) (<b> ^id {draw.choice(boxes)} ^{what} {{ <old> <> {value} }})"
                             f" --> (<b> ^{what} <old> - {value})}}")
            elif roll < 0.8:
                new = draw.choice(["on", "off"])
                lines.append(f"sp {{{name} {where} (<s> ^light {{ <old> <> {new} }}) --> (<s> ^light <old> - {new})}}")
            else:
                lines.append(f"sp {{{name} {where} (<s> ^count <old>) --> (<s> ^count <old> - (+ <old> 1))}}")
        if step < asked_from:
            continue
        parts = []
        for number in range(draw.randint(1, 2)):
            box = f"<q{number}>"
            inner = [f"^color {draw.choice(colors)}", f"^at spot-{draw.randint(1, 3)}", f"^id {draw.choice(boxes)}"]
            parts.append(f"(<q> ^box {box}) ({box} {' '.join(draw.sample(inner, draw.randint(1, 3)))})")
        if draw.random() < 0.5:
            parts.append(f"(<q> ^light {draw.choice(['on', 'off'])})")
        if draw.random() < 0.3:
            parts.append(f"(<q> ^count {draw.randint(0, 2)})")
        more = ""
        if draw.random() < 0.25:
            more += f" (<c> ^neg-query <no>) (<no> ^light {draw.choice(['on', 'off'])})"
        if draw.random() < 0.25:
            more += f" (<c> ^before {draw.randint(2, step)})"
        if draw.random() < 0.2:
            more += f" (<c> ^prohibit {draw.randint(1, steps)})"
        lines.append(f"sp {{ask*{step} (state <s> ^superstate nil ^n {step} ^epmem.command <c>) --> (<c> ^query <q>)"
                     f" {' '.join(parts)}{more}}}")
    lines.append("sp {show*found (state <s> ^superstate nil ^n <n> ^epmem.result <r>) (<r> ^memory-id <id> ^match-score <m>"
                 " ^match-cardinality <c> ^graph-match <g>) --> (write (crlf) <n> | episode | <id> | score | <m> | of | <c>"
                 " | graph | <g>)}")
    lines.append("sp {show*failure (state <s> ^superstate nil ^n <n> ^epmem.result.failure <q>) -->"
                 " (write (crlf) <n> | failure|)}")
    commands = ["source agent.soar", "trace 0", f"run {steps + 2}"]
    commands += [f"epmem --print {draw.randint(1, steps)}" for _ in range(2)]
    return lines, commands


def main(arguments):
    makers = {"semantic": semantic, "episodic": episodic}
    if len(arguments) != 4 or arguments[0] not in makers:
        print(__doc__)
        return 2
    kind, seed, count, folder = arguments[0], int(arguments[1]), int(arguments[2]), pathlib.Path(arguments[3])
    for number in range(seed, seed + count):
        lines, commands = makers[kind](random.Random(f"{kind} {number}"))
        case = folder / f"{kind}-{number}"
        case.mkdir(parents=True, exist_ok=True)
        (case / "agent.soar").write_text("\n".join(lines) + "\n", encoding="utf-8")
        (case / "case.cmd").write_text("\n".join(commands) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
