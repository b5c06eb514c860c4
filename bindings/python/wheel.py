#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Packs the modules of a build into a wheel, with the client library beside them.

usage: wheel.py BUILD_DIR FOLDER

The wheel is for the Python and the distribution that it was built on: the library needs what it was linked with.
"""
import base64
import hashlib
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile


def digest(content):
    return "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def cached(build, name):
    found = re.search(rf"^{name}:\w+=(.*)$", (build / "CMakeCache.txt").read_text(encoding="utf-8"), re.M)
    return found[1] if found else ""


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
        files["LICENSE"] = (pathlib.Path(prefix) / "share/doc/python3-soarbox/copyright").read_bytes()
    if not any(name.startswith("_Python_sml_ClientInterface.") for name in files):
        sys.exit(f"wheel: the binding is not built yet: ninja -C {build} soarbox_python")
    machine = next(re.search(r"-(\w+)-linux-gnu", name)[1] for name in files if name.startswith("_Python_sml"))
    tag = f"cp3{minor}-cp3{minor}-linux_{machine}"
    about = f"soarbox-{version}.dist-info"
    files["libsoarbox-sml.so.0"] = library.read_bytes()
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
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    print(wheel)


if __name__ == "__main__":
    main()
