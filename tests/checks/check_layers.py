#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Checks that includes follow the module order of docs/dev/architecture.md.

usage: check_layers.py SOURCE_DIR

Every module may include itself and the modules listed for it; libraries that belong to one module only
(Ogre, ImGui, SDL: viewer; Bullet, Recast and Detour: world; Lua: script; SQLite: journal and sweep) may be included nowhere else.
Inside the kernel the folders have an order, too, and a list, to which nothing may be added, contains the files that may include the core.
The exit status is 1 if an include is not allowed; each is printed.
"""
import pathlib
import re
import sys

ALLOWED = {
    "diagnostics": set(),
    # Conversion of values to bytes.
    "bytes": set(),
    # Pixels, shapes and their files, without a display.
    "picture": set(),
    # Called by the names of C functions, so it is never included.
    "numerics": set(),
    "kernel": {"bytes", "diagnostics"},
    # Data about minds as types, and their sentences: neither depends on the kernel.
    "mind": {"bytes"},
    "wording": {"diagnostics", "mind"},
    # Rules as plain data, from the kernel's own parser: only here explain uses the kernel's parser.
    "rule_reading": {"kernel", "mind"},
    # Percepts and commands, as data.
    "vocabulary": {"diagnostics"},
    "journal": {"bytes", "diagnostics", "kernel"},
    "cli": {"bytes", "diagnostics", "kernel", "journal"},
    "sml": {"diagnostics", "kernel", "mind", "cli", "rule_reading"},
    # explain reaches the kernel through the public client API only, so that an official Soar can replace it.
    "explain": {"diagnostics", "mind", "rule_reading", "wording", "vocabulary"},
    "world": {"diagnostics"},
    # Models from files, as triangles.
    "model": {"bytes", "diagnostics", "picture", "world"},
    "stream": {"bytes", "world"},
    "script": {"diagnostics", "picture", "world", "model"},
    # sim, too, reaches the kernel through the public client API only.
    "sim": {"diagnostics", "mind", "wording", "vocabulary", "explain", "world", "script"},
    "dis": {"diagnostics", "world", "sim"},
    "record": {"bytes", "diagnostics", "mind", "wording", "world", "model", "script", "sim"},
    "mission": {"diagnostics", "mind", "wording", "vocabulary", "explain", "world", "sim", "record"},
    "sweep": {"diagnostics", "sim", "record", "mission"},
    "report": {"diagnostics", "picture", "world", "sim", "record", "mission", "sweep"},
    "debugger": {"diagnostics", "mind", "wording", "vocabulary", "explain", "world", "script", "sim", "record"},
    # Editors use the kernel's own parser; a build with an official Soar has neither module.
    "language": {"diagnostics", "kernel", "rule_reading", "cli", "vocabulary", "explain", "sim", "debugger"},
    "editors": {"bytes", "diagnostics", "mind", "wording", "vocabulary", "explain", "world", "script", "sim", "record", "debugger", "language"},
    # Contents and requests for all views of a run: it draws nothing.
    "workbench": {"diagnostics", "mind", "wording", "explain", "world", "sim", "record", "debugger"},
    # HTTP and WebSockets: it starts engines, and does not depend on panels or worlds.
    "serve": {"bytes", "diagnostics"},
    "viewer": {"diagnostics", "picture", "world", "model", "sim", "record", "debugger", "workbench"},
    "app": {"bytes", "diagnostics", "picture", "kernel", "mind", "wording", "vocabulary", "cli", "sml", "explain", "world", "stream", "script", "sim", "dis", "record", "mission", "sweep",
            "report", "debugger", "language", "editors", "workbench", "serve", "viewer"},
}
# The folders of the kernel in their order: each may include those before it.
KERNEL_FOLDERS = ["base", "rules", "match", "memory", "io", "decide", "learn", "longterm", "imagery"]
# The files in src/kernel itself, and the folders that may include them: the events, and the library's interface.
KERNEL_HEADERS = {"observer.h": {"decide", "learn", "longterm"}, "agent.h": {"decide"}}
# AgentCore contains the parts of an agent: only it depends on all of them.
ENGINE = "kernel/decide/agent_core.h"
ASSEMBLY = re.compile(r"^kernel/decide/agent_core\.(h|cpp)$")
# Files that reach other parts through AgentCore. All other files get what they use from their creator. Do not add files to this list.
USERS_OF_CORE = {"kernel/agent.cpp"} | {
    f"kernel/decide/{name}.cpp"
    for name in ("agent_rules", "decision", "agent_core", "elaboration", "firing", "goal_changes", "handle_check", "invariants",
                 "preference_changes", "rule_context", "run_control")
}
TEST = re.compile(r"(_test|_test_support)\.(h|cpp)$")
ONLY_IN = {
    re.compile(r"^(Ogre|OGRE/|imgui|SDL)"): {"viewer"},
    re.compile(r"^(bt[A-Z]|bullet/|Bullet|LinearMath/)"): {"world"},
    re.compile(r"^(Recast|Detour)"): {"world"},
    re.compile(r"^(lua|lauxlib|lualib)"): {"script"},
    re.compile(r"^asio"): {"sml"},
    re.compile(r"^(boost|openssl)/"): {"serve"},
    re.compile(r"^sqlite3"): {"journal", "sweep"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
INCLUDE_LINE = re.compile(INCLUDE.pattern, re.MULTILINE)


def goes_up(file, target):
    """Whether an include inside the kernel violates the order of its folders. Paths are relative to src."""
    places, targets = file.split("/"), target.split("/")
    if len(places) == 2 or ASSEMBLY.match(file) or TEST.search(file):
        return False
    if len(targets) == 2:
        return places[1] not in KERNEL_HEADERS.get(targets[1], set())
    return KERNEL_FOLDERS.index(targets[1]) > KERNEL_FOLDERS.index(places[1])


def strangers_to_core(root):
    """Files of the list that do not use the core. They must be removed from the list."""
    for file in sorted(USERS_OF_CORE):
        path = root / file
        includes = INCLUDE_LINE.findall(path.read_text(encoding="utf-8")) if path.exists() else []
        if ENGINE not in includes:
            yield f"{path}: does not include {ENGINE}: take it from the list of check_layers.py"


def offences(root):
    for path in sorted(root.rglob("*")):
        if path.suffix not in {".h", ".cpp"}:
            continue
        module = path.relative_to(root).parts[0]
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            target = match.group(1)
            first = target.split("/")[0]
            if first in ALLOWED and "/" in target and first != module and first not in ALLOWED[module]:
                yield f"{path}:{number}: {module} may not include {first} ({target})"
            if module == "kernel" and first == "kernel" and goes_up(str(path.relative_to(root)), target):
                yield f"{path}:{number}: {path.parent.relative_to(root)} may not include {target}"
            if target == ENGINE and str(path.relative_to(root)) not in USERS_OF_CORE:
                yield f"{path}:{number}: may not include {ENGINE}: name what it uses, and get it from whoever makes it"
            for pattern, owners in ONLY_IN.items():
                if pattern.match(target) and module not in owners:
                    yield f"{path}:{number}: only {', '.join(sorted(owners))} may include {target}"


def main(arguments):
    if len(arguments) != 1:
        print(__doc__)
        return 2
    root = pathlib.Path(arguments[0])
    found = [*offences(root), *strangers_to_core(root)]
    print("\n".join(found) or "all includes follow the module order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
