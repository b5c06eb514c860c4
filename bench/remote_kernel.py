# SPDX-License-Identifier: BSD-2-Clause
"""Measures how much faster than real time a fight runs if its minds run in a kernel in another process.

    remote_kernel.py SOARBOX [SCENARIO] [SECONDS]"""
import re
import subprocess
import sys
import time


def timed(command):
    begun = time.monotonic()
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(done.stderr)
    return time.monotonic() - begun


def main():
    soarbox = sys.argv[1]
    scenario = sys.argv[2] if len(sys.argv) > 2 else "soar_skirmish"
    seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 10
    run = [soarbox, "run", scenario, "--headless", "--seconds", str(seconds)]
    with subprocess.Popen([soarbox, "kernel", "--port", "0"], stdout=subprocess.PIPE, text=True) as kernel:
        port = re.search(r"127\.0\.0\.1:(\d+)", kernel.stdout.readline()).group(1)
        far = timed([*run, "--kernel", f"127.0.0.1:{port}"])
        kernel.terminate()
    near = timed(run)
    print(f"{scenario}, {seconds:g} s: in another process {far:.2f} s ({seconds / far:.1f} times real time), "
          f"in this one {near:.2f} s ({seconds / near:.1f} times)")


if __name__ == "__main__":
    main()
