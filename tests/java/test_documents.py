# SPDX-License-Identifier: BSD-2-Clause
"""The programs of docs/java.md compile and run as they are printed: test_documents.py JAVA JAR."""
import pathlib
import re
import subprocess
import sys
import tempfile

PAGE = pathlib.Path(__file__).parents[2] / "docs/java.md"


def main():
    java, jar = sys.argv[1:]
    blocks = re.findall(r"^```java\n(.*?)^```", PAGE.read_text(encoding="utf-8"), re.M | re.S)
    if not blocks:
        sys.exit(f"{PAGE} has no program")
    for block in blocks:
        name = re.search(r"^public class (\w+)", block, re.M)[1]
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / f"{name}.java"
            file.write_text(block, encoding="utf-8")
            subprocess.run([java, "-ea", "-cp", jar, str(file)], check=True)
        print(f"ok {name}")


main()
