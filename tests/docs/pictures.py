#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Takes the pictures for the documents from the current program.

usage: pictures.py SOARBOX [NAME...]     (./dev pictures [NAME...] builds the program and calls this)
       pictures.py --shrink FILE...      reduces pictures that another script has taken

Without a name it takes all pictures, on a virtual display (Xvfb). They are reduced to 256 colours to make the files small. Some pictures
need a browser and have other scripts: site_pictures.mjs takes those of the site (./dev pictures site), `SOARBOX_PICTURES=FOLDER npm run
e2e` in web/ writes report_docs.png, which is report.png here, and web/side_by_side.mjs writes side_by_side.png.
"""
import collections
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "app"))

from png_picture import Picture

IMAGES = ROOT / "docs" / "images"
SMALL, WIDE, WINDOW = (640, 360), (960, 540), (1280, 720)
PANELS = ("--panels", "default", "--detail", "full")


def scene(world, at, size=SMALL, *more):
    """The picture alone, at this second."""
    return {"world": world, "size": size, "at": at, "more": ("--detail", "full", *more)}


def behaviour(world, at):
    """A scenario's row in docs/scenarios.md."""
    return scene(world, at, SMALL, "--show", "labels,shots,messages,trails,paths")


def window(world, script, seed=1):
    """The window after these inputs."""
    return {"world": world, "size": WINDOW, "script": script, "seed": seed, "more": PANELS}


PICTURES = {
    "soar_seek": behaviour("soar_seek", 14),
    "soar_path": behaviour("soar_path", 14),
    "soar_wander": behaviour("soar_wander", 14),
    "soar_follow": behaviour("soar_follow", 14),
    "soar_flee": behaviour("soar_flee", 6),
    "soar_evade": behaviour("soar_evade", 8),
    "soar_pursue": behaviour("soar_pursue", 6.5),
    "soar_obstacles": behaviour("soar_obstacles", 12),
    "soar_hide": behaviour("soar_hide", 12),
    "soar_crates": behaviour("soar_crates", 12),
    "soar_hallway": behaviour("soar_hallway", 5),
    "soar_skirmish": behaviour("soar_skirmish", 6),
    "soar_town": behaviour("soar_town", 20),
    "soar_reward": behaviour("soar_reward", 20),
    "soar_ambush": behaviour("soar_ambush", 8),
    "soar_remember": behaviour("soar_remember", 20),
    "animation": scene("animation", 4, WIDE),
    "scene_belief": scene("soar_skirmish", 11, WIDE, "--select", "blue-1", "--show", "labels,shots,senses,belief"),
    "eaters": scene("eaters/four.toml", 8, (860, 484)),
    "tanksoar": scene("tanksoar/four.toml", 8, (860, 484)),
    "window": scene("soar_skirmish", 6, WINDOW, "--panels", "agents,mind,timeline", "--select", "blue-3"),
    "window_why": scene("soar_skirmish", 6, WINDOW, "--panels", "agents,why,timeline", "--select", "blue-3"),
    "window_rules": window("soar_skirmish", """
        until 6
        key P
        expect "Paused"
        click "blue-1"
        click "Rules"
        click "Filter by name"
        type "take-cover"
        click "fighter*propose*take-cover"
        expect "stops at condition"
        """),
    "window_futures": window("soar_skirmish", """
        until 12
        key P
        expect "Paused"
        click "blue-leader"
        drag 700 704 420 704
        expect "Resume here"
        expect-not "Rebuilding"
        click "Console"
        click "a Soar command"
        type "excise fighter*propose*shoot"
        key Return
        expect "excised"
        click "Resume here"
        until 11
        key Escape
        key P
        expect "Paused"
        click "Futures"
        expect "First other decision"
        """),
    "learning_values": window("soar_reward", """
        click "learner"
        click "Max"
        until 400
        key P
        expect "Paused"
        key Alt+N
        click "Values"
        expect "Updates"
        """),
    "learning_rule": window("soar_town", """
        click "learner"
        click "Max"
        until 120
        key P
        expect "Paused"
        key Alt+N
        click "chunk"
        """),
}


def take(program, name, picture):
    """Runs the program in a separate display and returns the problem, or nothing."""
    width, height = picture["size"]
    target = IMAGES / f"{name}.png"
    with tempfile.TemporaryDirectory() as folder:
        command = ["xvfb-run", "-a", "-s", f"-screen 0 {width}x{height}x24", program, "run", picture["world"], "--no-record",
                   "--seed", str(picture.get("seed", 1)), "--width", str(width), "--height", str(height), *picture["more"]]
        if "script" in picture:
            script = pathlib.Path(folder) / "script"
            lines = [line.strip() for line in picture["script"].strip().splitlines()]
            script.write_text("\n".join([*lines, 'hover "Paused"', "wait 30", f"picture {target}", ""]), encoding="utf-8")
            command += ["--ui-script", str(script)]
        else:
            command += ["--screenshot", str(target), "--at", str(picture["at"])]
        done = subprocess.run(command, env={**os.environ, "HOME": folder, "XDG_CONFIG_HOME": folder, "XDG_STATE_HOME": folder},
                              capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return done.stdout[-600:] + done.stderr[-600:]
    shrink(target)
    return ""


def spread(box):
    """The largest difference between colours of a box."""
    return max(max(c[part] for c, _ in box) - min(c[part] for c, _ in box) for part in range(3))


def halves(box):
    """Splits a box of counted colours at the median of its longest side."""
    side = max(range(3), key=lambda part: max(c[part] for c, _ in box) - min(c[part] for c, _ in box))
    box = sorted(box, key=lambda one: one[0][side])
    total, passed = sum(count for _, count in box), 0
    for at, (_, count) in enumerate(box[:-1], 1):
        passed += count
        if passed * 2 >= total:
            return box[:at], box[at:]
    return box[:-1], box[-1:]


def palette(counts):
    """At most 256 colours, and the number of the nearest one for each colour (median cut)."""
    boxes = [list(counts.items())]
    while len(boxes) < 256:
        # Weighs the number of pixels, which keeps the ground smooth, and the distance of colours, which keeps small signs.
        widest = max((box for box in boxes if len(box) > 1), key=lambda box: spread(box) ** 2 * sum(n for _, n in box) ** 0.3, default=None)
        if widest is None:
            break
        boxes.remove(widest)
        boxes += halves(widest)
    colours, number = [], {}
    for place, box in enumerate(boxes):
        pixels = sum(count for _, count in box)
        colours.append(tuple(sum(c[part] * count for c, count in box) // pixels for part in range(3)))
        number.update({colour: place for colour, _ in box})
    return colours, number


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def shrink(file):
    """Replaces the picture by one with 256 colours."""
    picture = Picture(file)
    rows = [[tuple(part & 0xfc for part in picture.at(x, y)) for x in range(picture.width)] for y in range(picture.height)]
    colours, number = palette(collections.Counter(colour for row in rows for colour in row))
    raw = b"".join(b"\0" + bytes(number[colour] for colour in row) for row in rows)
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", picture.width, picture.height, 8, 3, 0, 0, 0))
                     + chunk(b"PLTE", bytes(part for colour in colours for part in colour)) + chunk(b"IDAT", zlib.compress(raw, 9))
                     + chunk(b"IEND", b""))


def main(arguments):
    if arguments[:1] == ["--shrink"]:
        for file in arguments[1:]:
            shrink(pathlib.Path(file))
        return 0
    if not arguments or arguments[0].startswith("-"):
        print(__doc__)
        return 2
    program, names = str(pathlib.Path(arguments[0]).resolve()), arguments[1:] or list(PICTURES)
    unknown = [name for name in names if name not in PICTURES]
    if unknown:
        print(f"there is no picture {unknown[0]}; there are {', '.join(PICTURES)}")
        return 2
    failed = False
    for name in names:
        wrong = take(program, name, PICTURES[name])
        print(f"{name}: {wrong or 'taken'}", flush=True)
        failed |= bool(wrong)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
