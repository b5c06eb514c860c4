#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Run the corpus with the drivers of one library and compare with the baseline.

usage: compare_bench.py FOLDER [options]

FOLDER contains run_bench and io_loop, built against the library to be measured.

  --instructions     count instructions with valgrind (callgrind) instead of taking
                     wall times: slow, but comparable between machines
  --only NAME,...    only these agents (io_loop selects all of its rows)
  --repeat N         wall times are the minimum of N runs (default: 3)
  --work FOLDER      folder for generated agents and profiles (default: a temporary folder)
  --baseline FILE    the baseline (default: baseline.json next to this script)
  --write FILE       also add the measurements to FILE, in the format of the baseline
  --keep-profiles    leave the callgrind profiles in the folder given with --work

An agent that fails is shown with the reason and not included in the means. The same
holds for an agent with another number of decisions than in the baseline, because it
has not done the same work.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
MODES = ["self", "all"]


def last_json(text):
    for line in reversed(text.splitlines()):
        line = line.strip()
        if line.startswith("{") and line.endswith("}"):
            return json.loads(line)
    return None


def execute(command, limit):
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              errors="replace", timeout=limit, cwd=HERE)
    except subprocess.TimeoutExpired:
        return None, f"no end after {limit} s", ""
    result = last_json(done.stdout)
    if done.returncode != 0 or result is None:
        reason = (done.stderr.strip().splitlines() or ["no output"])[-1]
        return None, f"status {done.returncode}: {reason}", done.stderr
    return result, None, done.stderr


def callgrind(command, profile, limit):
    """Instructions inside bench_load, bench_run and bench_init, and the driver's line of output."""
    wrapped = ["valgrind", "--tool=callgrind", "--collect-atstart=no", "--toggle-collect=bench_load*",
               "--toggle-collect=bench_run*", "--toggle-collect=bench_init*",
               f"--callgrind-out-file={profile}"] + command
    result, error, _ = execute(wrapped, limit)
    if error:
        return None, error
    # Only instructions inside these functions are counted. The calls of bench_run and
    # bench_init have their inclusive costs; the rest is the cost of loading.
    total, inclusive, names, called = 0, {}, {}, None
    with open(profile, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            match = re.match(r"c?fn=(\(\d+\))(?: (\S+))?", line)
            if match:
                number, function = match.groups()
                if function:
                    names[number] = function
                called = number if line.startswith("c") else None
            elif line.startswith("totals:"):
                total = int(line.split()[1])
            elif called and not line.startswith("calls="):
                inclusive[called] = inclusive.get(called, 0) + int(line.split()[-1])
                called = None
    run, init = (sum(cost for number, cost in inclusive.items() if names.get(number, "").startswith(function))
                 for function in ("bench_run", "bench_init"))
    return {"result": result, "load": total - run - init, "run": run + init, "init": init}, None


def read_corpus():
    return json.loads((HERE / "corpus.json").read_text(encoding="utf-8"))


def rows(corpus, only):
    for agent in corpus["agents"]:
        if not only or agent["name"] in only:
            yield agent["name"], agent
    if not only or "io_loop" in only:
        for entry in corpus["io_loop"]:
            for mode in MODES:
                yield f"io_loop {entry['n']} {mode}", {**entry, "mode": mode, "group": "io_loop", "metric": "run"}


def command_for(folder, work, row, counting):
    if "mode" in row:
        ticks = row["count_ticks"] if counting else row["ticks"]
        return [str(folder / "io_loop"), str(row["n"]), str(ticks), row["mode"], str(HERE / "agents" / "io-seeker.soar")]
    if "generate" in row:
        path = work / (row["generate"] + ".soar")
        if not path.exists():
            subprocess.run([sys.executable, str(HERE / "generate.py"), str(work), row["generate"]], check=True)
    else:
        path = HERE / row["file"]
    decisions = row["count_decisions"] if counting else row["decisions"]
    rounds = row.get("count_rounds" if counting else "rounds")
    return ([str(folder / "run_bench"), str(path)] + ([str(decisions or 0)] if decisions or rounds else []) +
            ([str(rounds)] if rounds else []))


def measure_instructions(folder, work, name, row):
    profile = work / ("callgrind." + name.replace(" ", "-"))
    measured, error = callgrind(command_for(folder, work, row, True), profile, 3600)
    if error:
        return None, error
    result = measured["result"]
    out = {"run_instructions": measured["run"]}
    if "mode" in row:
        steps = result["n"] * result["ticks"]
        out.update(agent_ticks=steps, commands=result["commands"], instructions_per_agent_tick=round(measured["run"] / steps))
    else:
        out.update(decisions=result["decisions"], load_instructions=measured["load"],
                   instructions_per_decision=round(measured["run"] / max(1, result["decisions"])))
        if "rounds" in result:
            out.update(rounds=result["rounds"], init_instructions=measured["init"])
    return out, None


def measure_wall(folder, work, name, row, repeat):
    best, load = None, None
    for _ in range(repeat):
        result, error, _ = execute(command_for(folder, work, row, False), 1800)
        if error:
            return None, error
        if "load_seconds" in result:
            load = min(load or result["load_seconds"], result["load_seconds"])
        if best is None or result["seconds"] < best["seconds"]:
            best = result
    if "mode" in row:
        out = {key: best[key] for key in ("ticks", "commands", "seconds", "cpu_seconds", "us_per_agent_tick", "peak_rss_mb")}
    else:
        out = {key: best[key] for key in ("decisions", "halted", "seconds", "cpu_seconds", "us_per_decision", "peak_rss_mb")}
        out["load_seconds"] = load
        out.update({key: best[key] for key in ("rounds", "init_seconds") if key in best})
    return out, None


def figure(row, values, counting):
    if counting:
        return values["load_instructions" if row["metric"] == "load" else "run_instructions"]
    return values["load_seconds" if row["metric"] == "load" else "seconds"]


def work_done(values):
    return values.get("decisions", values.get("commands"))


def short(number, counting):
    if number is None:
        return "-"
    return f"{number / 1e6:,.1f} M" if counting else f"{number:.3f} s"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--instructions", action="store_true")
    parser.add_argument("--only", type=lambda text: text.split(","))
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--baseline", type=pathlib.Path, default=HERE / "baseline.json")
    parser.add_argument("--write", type=pathlib.Path)
    parser.add_argument("--keep-profiles", action="store_true")
    options = parser.parse_args()

    folder = options.folder.resolve()
    for program in ("run_bench", "io_loop"):
        if not (folder / program).exists():
            parser.error(f"no {program} in {options.folder}")
    corpus = read_corpus()
    baseline = json.loads(options.baseline.read_text())["results"] if options.baseline.exists() else {}
    written = json.loads(options.write.read_text()) if options.write and options.write.exists() else {"results": {}}

    temporary = None
    if options.work:
        work = options.work.resolve()
        work.mkdir(parents=True, exist_ok=True)
    else:
        temporary = tempfile.TemporaryDirectory(prefix="soar-bench-")
        work = pathlib.Path(temporary.name)

    counting = options.instructions
    kind = "instructions" if counting else "wall"
    unit = "instructions" if counting else "seconds"
    print(f"{'agent':<20} {'baseline':>14} {'this':>14} {'ratio':>8}   {unit}; ratio is baseline / this")
    groups, skipped = {}, []
    for name, row in rows(corpus, options.only):
        if counting:
            values, error = measure_instructions(folder, work, name, row)
            if not options.keep_profiles:
                for left in work.glob("callgrind.*"):
                    left.unlink()
        else:
            values, error = measure_wall(folder, work, name, row, options.repeat)
        known = baseline.get(name, {}).get(kind)
        before = figure(row, known, counting) if known else None
        if error:
            print(f"{name:<20} {short(before, counting):>14} {'failed':>14} {'-':>8}   {error}", flush=True)
            skipped.append(name)
            continue
        written["results"].setdefault(name, {})[kind] = values
        if options.write:
            options.write.write_text(json.dumps(written, indent=1) + "\n")
        now = figure(row, values, counting)
        if before is None:
            print(f"{name:<20} {'-':>14} {short(now, counting):>14} {'-':>8}", flush=True)
        elif work_done(known) != work_done(values):
            print(f"{name:<20} {short(before, counting):>14} {short(now, counting):>14} {'-':>8}   "
                  f"other work: {work_done(values)} instead of {work_done(known)}", flush=True)
            skipped.append(name)
        else:
            ratio = before / now if now else float("inf")
            groups.setdefault(row["group"], []).append(ratio)
            note = ""
            if not counting:
                rss = known["peak_rss_mb"]
                note = f"   peak RSS {rss:.1f} -> {values['peak_rss_mb']:.1f} MB"
            print(f"{name:<20} {short(before, counting):>14} {short(now, counting):>14} {ratio:>8.2f}{note}", flush=True)

    everything = [ratio for ratios in groups.values() for ratio in ratios]
    if everything:
        print()
        for group, ratios in list(groups.items()) + [("all", everything)]:
            mean = math.exp(sum(math.log(ratio) for ratio in ratios) / len(ratios))
            print(f"geometric mean, {group:<9} {mean:>8.2f}   of {len(ratios)}")
    if skipped:
        print("left out: " + ", ".join(skipped))
    if not counting:
        print("wall times: not comparable with the baseline unless measured on the same idle machine")
    if temporary:
        temporary.cleanup()
    return 1 if skipped else 0


if __name__ == "__main__":
    sys.exit(main())
