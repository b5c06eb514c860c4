# SPDX-License-Identifier: BSD-2-Clause
"""A program that drives agents of a `soarbox kernel`, for tests in other languages. usage: kernel_client.py PORT

It reads lines of JSON: ["create", AGENT] creates an agent; [AGENT, LINE] sends it a command line. For each, it prints the text of the kernel's
answer as a line of JSON.
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "app"))

from protocol_client import Client, Refused  # noqa: E402


def main():
    with Client(int(sys.argv[1])) as client:
        for line in sys.stdin:
            first, second = json.loads(line)
            try:
                answer = client.text("create_agent", name=second) if first == "create" else client.line(first, second)
            except Refused as refused:
                answer = f"refused: {refused}"
            print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
