#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Writes random agents with long-term memory as cases for trace_case.

usage: generate_memory.py semantic|episodic SEED COUNT FOLDER

semantic: graphs with skewed values and cycles, cues that are made from an object by dropping, replacing and negating
elements, all modes of activation, stores between queries. episodic: worlds in which things are added, removed and changed,
and cues that are parts of an earlier state with errors, negations and bounds. A rule prints each answer, so that
transcripts of two kernels can be compared:

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
    """One of the values; the first ones are the most frequent."""
    return values[min(int(draw.expovariate(1.2)), len(values) - 1)]


def spreads(draw, lines):
    """Lines that switch spreading on."""
    lines += [f"smem --set spreading-depth-limit {draw.randint(1, 6)}",
              f"smem --set spreading-limit {draw.choice([5, 30, 300])}",
              f"smem --set spreading-continue-probability {draw.choice([0.5, 0.9])}"]
    for name in ("spreading-loop-avoidance", "spreading-wma-source", "spreading-edge-updating", "base-inhibition"):
        if draw.random() < 0.3:
            lines.append(f"smem --set {name} on")
    lines.append("smem --set spreading on")


def semantic(draw):
    """An agent that queries, retrieves and stores, in two states, and the commands that run it."""
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
    if draw.random() < 0.3:
        lines.append("wm activation --set activation on")
    if mode == "base-level" and draw.random() < 0.5:
        spreads(draw, lines)
    if draw.random() < 0.2:
        lines.append("smem --set activate-on-query off")
    for number, thing in enumerate(objects, 1):
        weight = f" ({draw.randint(1, 9) / 10})" if draw.random() < 0.1 else ""
        links = "".join(f" ^next @{draw.randint(1, count)}{weight}" for _ in range(draw.randint(0, 3)))
        text = " ".join(f"^{name} {value}" for name, value in thing.items() if name == "tag" or draw.random() < 0.9)
        lines.append(f"smem --add {{ (@{number} {text}{links}) }}")
    lines.append(STEP)
    lines.append("sp {keep (state <s> ^superstate nil ^operator.name step ^smem.result.retrieved <r>) --> (<s> ^kept <r>)}")
    steps = draw.randint(5, 25)
    below = draw.random() < 0.3
    where = "(state <s> ^superstate.n {step} ^smem.command <c>)" if below else "(state <s> ^superstate nil ^n {step} ^smem.command <c>)"
    if below:
        lines[-2] = lines[-2].replace("(<o> ^name step ^n <n>)}\nsp {step*apply (state <s>", "(<o> ^name step ^n <n>)}\nsp {done (state <s> ^superstate <t> ^waited 1) (<t> ^n <n> ^operator.name step) --> (<s> ^operator <o> + >) (<o> ^name done ^n <n> ^t <t>)}\nsp {done*apply (state <s> ^operator <o>) (<o> ^name done ^n <n> ^t <t>) --> (<t> ^n <n> - (+ <n> 1))}\nsp {wait (state <s> ^superstate.operator.name step -^waited) --> (<s> ^operator <o> +) (<o> ^name wait)}\nsp {wait*apply (state <s> ^operator.name wait) --> (<s> ^waited 1)}\nsp {never (state <s> ^never 1")
    for step in range(1, steps + 1):
        here = where.replace("{step}", str(step))
        roll = draw.random()
        if roll < 0.15:
            kind = draw.choice(["store", "store", "store-new"])
            link = " ^next <k>" if draw.random() < 0.4 else ""
            kept = "(<s> ^superstate nil ^kept <k>)" if link and not below else ""
            link = link if kept else ""
            lines.append(f"sp {{store*{step} {here} {kept} --> (<c> ^{kind} <x>)"
                         f" (<x> ^tag stored-{step} ^kind {skewed(draw, kinds)} ^size {draw.randint(1, 6)}{link})}}")
            continue
        if roll < 0.25 and not below:
            lines.append(f"sp {{again*{step} {here} (<s> ^kept <k>) (<k> ^next <l>) --> (<c> ^retrieve <l>)}}")
            continue
        if roll < 0.32 and not below:
            lines.append(f"sp {{change*{step} {here} (<s> ^kept <k>) (<k> ^tag <tag> ^size <size>) -->"
                         f" (<c> ^store <k>) (<k> ^size <size> - {draw.randint(1, 6)})}}")
            continue
        thing = draw.choice(objects)
        cue = []
        for name in ("kind", "color", "size"):
            roll = draw.random()
            if roll < 0.45:
                cue.append(f"^{name} {thing[name]}")
            elif roll < 0.55:
                cue.append(f"^{name} <any-{name}>")
        kept = ""
        if draw.random() < 0.1:
            cue.append(draw.choice(["^kind nothing", "^absent yes", "^next <any-next>"]))
        if draw.random() < 0.15 and not below:
            kept = "(<s> ^kept <k>)"
            cue.append("^next <k>")
        cue = cue or [f"^kind {thing['kind']}"]
        more = ""
        if draw.random() < 0.3:
            more += f" (<c> ^neg-query <no>) (<no> ^{draw.choice(['color red', 'size 3', 'kind kind-0', 'absent yes', 'next <an>'])})"
        if draw.random() < 0.25:
            test = draw.choice(["max <m>", "min <m>", f"less {draw.randint(1, 7)}", f"greater-or-equal {draw.randint(1, 7)}"])
            more += f" (<c> ^math-query <q2>) (<q2> ^size <q3>) (<q3> ^{test})"
        if draw.random() < 0.2:
            more += f" (<c> ^depth {draw.randint(1, 4)})"
        if draw.random() < 0.2 and not below:
            kept = kept or "(<s> ^kept <k>)"
            more += " (<c> ^prohibit <k>)"
        lines.append(f"sp {{ask*{step} {here} {kept} --> (<c> ^query <q>)"
                     f" (<q> {' '.join(cue)}){more}}}")
    state = "(state <s> ^superstate.n <n> ^smem.result.{sign} <r>)" if below else "(state <s> ^superstate nil ^n <n> ^smem.result.{sign} <r>)"
    for sign, tail in (("retrieved", "(<r> ^tag <t>)"), ("failure", ""), ("bad-cmd", "")):
        shown = "<t>" if tail else f"|{sign}|"
        lines.append(f"sp {{show*{sign} {state.replace('{sign}', sign)} {tail} -->"
                     f" (write (crlf) <n> | | {shown})}}")
    commands = ["source agent.soar", "trace 0"]
    half = draw.randint(2, steps)
    commands.append(f"run {half}")
    for _ in range(draw.randint(0, 2)):
        victim = draw.randint(1, count)
        commands.append(draw.choice([f"smem --remove {{(@{victim} ^next)}}", f"smem --remove {{(@{victim} ^color)}}",
                                     f"smem --add {{(@{victim} ^next @{draw.randint(1, count)})}}",
                                     f"smem --query {{(<q> ^kind {skewed(draw, kinds)})}} 3",
                                     f"smem --query {{(<q> ^next @{draw.randint(1, count)})}} 2"]))
    commands += [f"run {steps + 2 - half}", "print @"]
    if draw.random() < 0.3:
        commands += ["init-soar", f"run {steps}", "print @"]
    return lines, commands


def episodic(draw):
    """An agent in a changing world that asks for earlier states of it."""
    colors, boxes = ["red", "green", "blue"], [f"box-{n}" for n in range(1, draw.randint(2, 4))]
    lines = ["epmem --enable", "epmem --set trigger " + draw.choice(["dc", "dc", "dc", "output"]), STEP]
    if draw.random() < 0.2:
        lines.append("epmem --set graph-match off")
    if draw.random() < 0.2:
        lines.append("epmem --set phase selection")
    if draw.random() < 0.2:
        lines.append(f"epmem --set exclusions {draw.choice(['light', 'operator', 'at', 'inside'])}")
    if draw.random() < 0.3:
        lines += ["wm activation --set activation on", f"epmem --set balance {draw.choice([0, 0.5])}"]
    first = " ".join(f"(<s> ^box <{box}>) (<{box}> ^id {box} ^color {draw.choice(colors)} ^at spot-{draw.randint(1, 3)})"
                     for box in boxes)
    if draw.random() < 0.6:
        first += " (<s> ^shelf <shelf>) (<shelf> ^holds " + " ".join(f"<{box}>" for box in boxes if draw.random() < 0.7) + ")"
        first = first.replace("^holds )", "^empty yes)")
    if draw.random() < 0.4 and len(boxes) > 1:
        first += f" (<{boxes[0]}> ^on <{boxes[1]}>)"
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
            elif roll < 0.65:
                new = draw.choice(["on", "off"])
                lines.append(f"sp {{{name} {where} (<s> ^light {{ <old> <> {new} }}) --> (<s> ^light <old> - {new})}}")
            elif roll < 0.75:
                lines.append(f"sp {{{name} {where} (<s> ^box <b>) (<b> ^id {draw.choice(boxes)}) -->"
                             f" (<s> ^box <b> -) (<s> ^attic <b>)}}")
            elif roll < 0.82:
                lines.append(f"sp {{{name} {where} (<s> ^attic <b>) --> (<s> ^attic <b> -) (<s> ^box <b>)}}")
            elif roll < 0.9:
                lines.append(f"sp {{{name} {where} (<s> ^io.output-link <out>) --> (<out> ^say <say>) (<say> ^n {step})}}")
            else:
                lines.append(f"sp {{{name} {where} (<s> ^count <old>) --> (<s> ^count <old> - (+ <old> 1))}}")
        if step < asked_from:
            continue
        ask = f"sp {{ask*{step} (state <s> ^superstate nil ^n {step} ^epmem.command <c>) -->"
        roll = draw.random()
        if roll < 0.1:
            lines.append(f"{ask} (<c> ^retrieve {draw.randint(1, steps)})}}")
            continue
        if roll < 0.2:
            lines.append(f"{ask} (<c> ^{draw.choice(['next', 'previous'])} <x>)}}")
            continue
        parts = []
        for number in range(draw.randint(1, 2)):
            box = f"<q{number}>"
            inner = [f"^color {draw.choice(colors)}", f"^at spot-{draw.randint(1, 3)}", f"^id {draw.choice(boxes)}"]
            above = draw.choice(["<q> ^box", "<q> ^box", "<q> ^attic", "<shelf> ^holds"])
            if above.startswith("<shelf>") and "(<q> ^shelf <shelf>)" not in parts:
                parts.append("(<q> ^shelf <shelf>)")
            parts.append(f"({above} {box})")
            if draw.random() < 0.9:
                parts.append(f"({box} {' '.join(draw.sample(inner, draw.randint(1, 3)))})")
        if draw.random() < 0.15:
            parts.append("(<q0> ^on <q9>)" + draw.choice(["", " (<q9> ^color red)", " (<q9> ^id box-2)"]))
        if draw.random() < 0.2 and "<shelf>" in " ".join(parts):
            parts.append("(<shelf> ^holds <q0>)")
        if draw.random() < 0.5:
            parts.append(f"(<q> ^light {draw.choice(['on', 'off'])})")
        if draw.random() < 0.3:
            parts.append(f"(<q> ^count {draw.randint(0, 2)})")
        more = ""
        if draw.random() < 0.25:
            negative = draw.choice(["^light on", "^light off", "^box.color red", "^attic <anything>"])
            more += f" (<c> ^neg-query <no>) (<no> {negative})"
        if draw.random() < 0.25:
            more += f" (<c> ^before {draw.randint(2, step)})"
        if draw.random() < 0.2:
            more += f" (<c> ^after {draw.randint(0, step)})"
        for _ in range(draw.choice([0, 0, 0, 0, 1, 1, 2, 3])):
            more += f" (<c> ^prohibit {draw.randint(1, steps)})"
        lines.append(f"{ask} (<c> ^query <q>) {' '.join(parts)}{more}}}")
    lines.append("sp {show*found (state <s> ^superstate nil ^n <n> ^epmem.result <r>) (<r> ^memory-id <id> ^match-score <m>"
                 " ^match-cardinality <c> ^graph-match <g>) --> (write (crlf) <n> | episode | <id> | score | <m> | of | <c>"
                 " | graph | <g>)}")
    lines.append("sp {show*failure (state <s> ^superstate nil ^n <n> ^epmem.result.failure <q>) -->"
                 " (write (crlf) <n> | failure|)}")
    lines.append("sp {show*status (state <s> ^superstate nil ^n <n> ^epmem.result.status <q>) -->"
                 " (write (crlf) <n> | status | <q>)}")
    lines.append("sp {show*number (state <s> ^superstate nil ^n <n> ^epmem.result <r>) (<r> ^memory-id <id> -^match-score) -->"
                 " (write (crlf) <n> | number | <id>)}")
    lines.append("sp {show*box (state <s> ^superstate nil ^n <n> ^epmem.result.mapping.node <m>) (<m> ^retrieved.id <id>) -->"
                 " (write (crlf) <n> | box | <id>)}")
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
