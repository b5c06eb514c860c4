#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Packs the modules of a build into a wheel, with the client library, the command and all that both need.

usage: wheel.py BUILD_DIR FOLDER

The wheel is for the Python that it was built with, and for a C library that is not older than the one it was built with. All other
libraries are in it, with their licences: a new virtual environment needs no package of the system. The command has no window and
serves no pages.
"""
import base64
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile


def digest(content):
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def cached(build, name):
    found = re.search(rf"^{name}:\w+=(.*)$", (build / "CMakeCache.txt").read_text(encoding="utf-8"), re.M)
    return found[1] if found else ""


ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = "soarbox/_program"
# The C library, which belongs to the system, and what loads it.
SYSTEMS_OWN = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util))\.so")

# Starts the program with the wheel's libraries.
STARTER = """#!/bin/sh
here=$(dirname "$(readlink -f "$0")")/..
LD_LIBRARY_PATH=$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export LD_LIBRARY_PATH
exec "$here/libexec/soarbox" "$@"
"""
# Loads the libraries that the client library needs, before it is loaded.
PRELOAD = """# The libraries of the wheel.
def _load_libraries():
    import ctypes
    import pathlib
    for name in {names!r}:
        ctypes.CDLL(str(pathlib.Path(__file__).parent / "{program}" / "lib" / name), ctypes.RTLD_GLOBAL)


_load_libraries()
"""


def libraries_of(binary):
    """The libraries that a program or library needs, by name; each follows the libraries that need it."""
    printed = subprocess.run(["ldd", str(binary)], check=True, capture_output=True, text=True).stdout
    found = re.findall(r"^\s*(\S+) => (/\S+)", printed, re.M)
    return {name: pathlib.Path(path).resolve() for name, path in found if not SYSTEMS_OWN.match(name)}


def licence_of(library):
    """The package of a library and the text of its licence; nothing if the system does not know it."""
    for path in (str(library), str(library).removeprefix("/usr")):
        owner = subprocess.run(["dpkg", "-S", path], capture_output=True, text=True, check=False) if shutil.which("dpkg") else None
        if owner and owner.returncode == 0:
            package = owner.stdout.split(":")[0]
            text = pathlib.Path("/usr/share/doc") / package / "copyright"
            return (package, text.read_bytes()) if text.exists() else None
    return None


def stripped(file, folder):
    """The content of a binary without symbols for debuggers."""
    to = pathlib.Path(folder) / "stripped"
    done = subprocess.run(["strip", "-o", to, file], check=False, capture_output=True) if shutil.which("strip") else None
    return (to if done and done.returncode == 0 else file).read_bytes()


def program_of(build, library, folder):
    """The command with its data, and the libraries that it and the client library need: files by name, and the libraries'
    names."""
    command = build / "bin" / "soarbox"
    if not command.exists():
        sys.exit(f"wheel: the command is not built yet: ninja -C {build} soarbox")
    files = {f"{PROGRAM}/bin/soarbox": STARTER.encode(), f"{PROGRAM}/libexec/soarbox": stripped(command, folder)}
    for part in ("scenarios", "media", "lessons"):
        for path in sorted((ROOT / part).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts:
                files[f"{PROGRAM}/share/soarbox/{path.relative_to(ROOT).as_posix()}"] = path.read_bytes()
    needed = libraries_of(library)
    for name, path in (libraries_of(command) | needed).items():
        files[f"{PROGRAM}/lib/{name}"] = path.read_bytes()
        licence = licence_of(path)
        if licence is not None:
            files[f"{PROGRAM}/licences/{licence[0]}"] = licence[1]
    # A library is loaded after those that it needs: it needs none of those that need it.
    order = sorted(needed, key=lambda name: len(libraries_of(needed[name])))
    return files, order


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    build, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    minor, version = cached(build, "SOARBOX_PYTHON_MINOR"), cached(build, "CMAKE_PROJECT_VERSION")
    library = build / "src/sml/libsoarbox-sml.so.0"
    if cached(build, "SOARBOX_HAS_PYTHON") != "ON" or not library.exists():
        sys.exit(f"wheel: {build} has no binding for Python; install swig and python3-dev, and build it again")
    files = {}
    with tempfile.TemporaryDirectory() as prefix:
        subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", prefix], check=True,
                       stdout=subprocess.DEVNULL)
        modules = pathlib.Path(prefix) / "lib/python3/dist-packages"
        for path in sorted(modules.rglob("*")):
            if path.is_file():
                files[path.relative_to(modules).as_posix()] = path.read_bytes()
        if not any(name.startswith("_Python_sml_ClientInterface.") for name in files):
            sys.exit(f"wheel: the binding is not built yet: ninja -C {build} soarbox_python")
        program, needed = program_of(build, library, prefix)
        files["LICENSE"] = (pathlib.Path(prefix) / "share/doc/python3-soarbox/copyright").read_bytes()
    machine = next(re.search(r"-(\w+)-linux-gnu", name)[1] for name in files if name.startswith("_Python_sml"))
    tag = f"cp3{minor}-cp3{minor}-linux_{machine}"
    about = f"soarbox-{version}.dist-info"
    files["libsoarbox-sml.so.0"] = library.read_bytes()
    client = "Python_sml_ClientInterface.py"
    files[client] = PRELOAD.format(names=tuple(needed), program=PROGRAM).encode() + files[client]
    files |= program
    files[f"{about}/entry_points.txt"] = b"[console_scripts]\nsoarbox = soarbox.command:main\n"
    files[f"{about}/LICENSE"] = files.pop("LICENSE")
    files[f"{about}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: soarbox\nRoot-Is-Purelib: false\nTag: {tag}\n").encode()
    files[f"{about}/METADATA"] = (f"Metadata-Version: 2.1\nName: soarbox\nVersion: {version}\n"
                                  "Summary: Soar agents and Soarbox's worlds from Python\nLicense: BSD-2-Clause\n"
                                  f"Requires-Python: ==3.{minor}.*\n").encode()
    record = "".join(f"{name},{digest(content)},{len(content)}\n" for name, content in files.items())
    files[f"{about}/RECORD"] = (record + f"{about}/RECORD,,\n").encode()
    folder.mkdir(parents=True, exist_ok=True)
    wheel = folder / f"soarbox-{version}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            # A fixed date: the same files make the same wheel.
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            is_program = name.startswith((f"{PROGRAM}/bin/", f"{PROGRAM}/libexec/"))
            entry.external_attr = (0o100755 if is_program else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    print(wheel)


if __name__ == "__main__":
    main()
