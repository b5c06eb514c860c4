# SPDX-License-Identifier: BSD-2-Clause
"""A program that ends in a handler has the exit status that it set: test_ends.py COMMAND..."""
import subprocess
import sys

status = subprocess.run(sys.argv[1:], check=False).returncode
if status != 7:
    sys.exit(f"expected the exit status 7, is {status}")
