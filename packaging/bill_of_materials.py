#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Writes a bill of materials in CycloneDX 1.5: what a build of Soarbox contains of others.

usage: bill_of_materials.py BUILD_DIR [-o FILE]

npm packages come from web/package-lock.json, without those for development. Debian packages are those that own a shared library
that the programs in BUILD_DIR/bin are linked with, and the packages of headers that ./dev installs for the build.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def version():
    return re.search(r"project\(Soarbox VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)


def npm_packages():
    lock = json.loads((ROOT / "web" / "package-lock.json").read_text(encoding="utf-8"))
    for path, entry in sorted(lock["packages"].items()):
        if not path or entry.get("dev") or entry.get("optional"):
            continue
        name = path.rsplit("node_modules/", 1)[-1]
        component = {"type": "library", "name": name, "version": entry["version"],
                     "purl": f"pkg:npm/{name.replace('@', '%40')}@{entry['version']}"}
        if "license" in entry:
            component["licenses"] = [{"license": {"id": entry["license"]}}]
        yield component


def asked(*words):
    """What a command prints; empty if it fails."""
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 else ""


def linked_packages(build):
    """Debian packages of the libraries that ldd finds for the programs of this build."""
    files = set()
    for program in sorted((build / "bin").glob("soarbox*")):
        if program.is_file():
            files |= set(re.findall(r"=> (/\S+)", asked("ldd", program)))
    paths = set()
    for file in files:
        real = str(pathlib.Path(file).resolve())
        # dpkg lists the files under /usr/lib, also if /lib is a link to it.
        paths |= {real, real.removeprefix("/usr")}
    # The command fails if one of the paths is unknown, but still prints the owners of the others.
    done = subprocess.run(["dpkg", "-S", *sorted(paths)], capture_output=True, text=True, check=False) if paths and shutil.which("dpkg") else None
    for line in done.stdout.splitlines() if done else ():
        yield line.split(": ")[0].split(":")[0]


def header_packages():
    script = (ROOT / "dev").read_text(encoding="utf-8")
    for group in ("build_packages", "window_packages"):
        for name in re.search(rf"^{group}=\((.*?)\)", script, re.MULTILINE | re.DOTALL).group(1).split():
            if name.endswith("-dev"):
                yield name


def debian_packages(build):
    names = sorted({*linked_packages(build), *header_packages()})
    # A library may be installed for several architectures; a package that is not installed has no line.
    found = subprocess.run(["dpkg-query", "-W", "-f=${Package} ${Version} ${Architecture}\n", *names], capture_output=True, text=True,
                           check=False).stdout if shutil.which("dpkg-query") else ""
    seen = set()
    for name, number, architecture in (line.split() for line in found.splitlines() if len(line.split()) == 3):
        if name not in seen:
            seen.add(name)
            yield {"type": "library", "name": name, "version": number,
                   "purl": f"pkg:deb/debian/{name}@{number.replace('+', '%2B').replace(':', '%3A')}?arch={architecture}"}


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path)
    options = parser.parse_args(arguments)
    if not (options.build / "bin" / "soarbox").exists():
        print(f"{options.build}: no soarbox was built here; ./dev build release builds it", file=sys.stderr)
        return 1
    bill = {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
            "metadata": {"component": {"type": "application", "name": "soarbox", "version": version(),
                                       "licenses": [{"license": {"id": "BSD-2-Clause"}}]}},
            "components": [*npm_packages(), *debian_packages(options.build)]}
    text = json.dumps(bill, indent=2) + "\n"
    if options.output:
        options.output.write_text(text, encoding="utf-8")
    else:
        sys.stdout.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
