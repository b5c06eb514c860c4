# SPDX-License-Identifier: BSD-2-Clause
"""Talks to `soarbox lsp` and `soarbox dap` as editors do: messages with a Content-Length on standard input and output."""
import json
import os
import select
import subprocess

COMMAND = os.environ["SOARBOX"]


class Channel:
    """A process that exchanges framed JSON messages."""

    def __init__(self, *arguments, cwd=None):
        self.process = subprocess.Popen([COMMAND, *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, cwd=cwd)
        self.buffer = b""

    def send(self, message):
        body = json.dumps(message).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))

    def send_bytes(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def receive(self, limit_s=60):
        """The next message; None if none comes, or the process ends."""
        while True:
            head, found, rest = self.buffer.partition(b"\r\n\r\n")
            if found:
                length = int(head.split(b":")[1])
                if len(rest) >= length:
                    self.buffer = rest[length:]
                    return json.loads(rest[:length])
            if not select.select([self.process.stdout], [], [], limit_s)[0]:
                return None
            data = os.read(self.process.stdout.fileno(), 1 << 16)
            if not data:
                return None
            self.buffer += data

    def close(self):
        for stream in (self.process.stdin, self.process.stdout, self.process.stderr):
            stream.close()
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()


class Editor:
    """A client of the language server."""

    def __init__(self, cwd=None, folders=None):
        self.channel = Channel("lsp", cwd=cwd)
        self.number = 0
        self.diagnostics = {}
        self.published = 0
        self.messages = []
        named = folders and [{"uri": folder.as_uri(), "name": folder.name} for folder in folders]
        self.capabilities = self.ask("initialize", {"processId": None, "rootUri": None, "capabilities": {},
                                                    "workspaceFolders": named})["capabilities"]
        self.tell("initialized", {})

    def tell(self, method, params):
        self.channel.send({"jsonrpc": "2.0", "method": method, "params": params})

    def take(self, message):
        if message.get("method") == "textDocument/publishDiagnostics":
            self.diagnostics[message["params"]["uri"]] = message["params"]["diagnostics"]
            self.published += 1
        if message.get("method") == "window/showMessage":
            self.messages.append(message["params"]["message"])

    def answer(self, method, params):
        """The complete answer to a request, including an error."""
        self.number += 1
        self.channel.send({"jsonrpc": "2.0", "id": self.number, "method": method, "params": params})
        while (message := self.channel.receive()) is not None:
            if message.get("id") == self.number and "method" not in message:
                return message
            self.take(message)
        raise AssertionError(f"no answer to {method}")

    def ask(self, method, params):
        answer = self.answer(method, params)
        if "error" in answer:
            raise AssertionError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def open(self, path):
        uri = path.resolve().as_uri()
        self.tell("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": "soar", "version": 1,
                                                            "text": path.read_text(encoding="utf-8")}})
        return uri

    def change(self, uri, *changes):
        self.tell("textDocument/didChange", {"textDocument": {"uri": uri, "version": 2}, "contentChanges": list(changes)})

    def wait_for(self, uri, holds, limit_s=60):
        """Waits until `holds` is true for the diagnostics of a file, and returns them."""
        while not (uri in self.diagnostics and holds(self.diagnostics[uri])):
            message = self.channel.receive(limit_s)
            if message is None:
                raise AssertionError(f"diagnostics stay {self.diagnostics.get(uri)}")
            self.take(message)
        return self.diagnostics[uri]

    def end(self):
        self.ask("shutdown", None)
        self.tell("exit", None)
        code = self.channel.process.wait(30)
        self.channel.close()
        return code


def at(text, word, nth=0, offset=0):
    """The position of a word in a text, in UTF-16."""
    place = -1
    for _ in range(nth + 1):
        place = text.index(word, place + 1)
    before = text[:place + offset]
    line = before.count("\n")
    return {"line": line, "character": len(before[before.rfind("\n") + 1:].encode("utf-16-le")) // 2}


def applied(text, edits):
    """A text with the edits of the protocol."""
    lines = text.split("\n")

    def offset(position):
        line = lines[position["line"]]
        units = line.encode("utf-16-le")[:position["character"] * 2].decode("utf-16-le")
        return sum(len(one) + 1 for one in lines[:position["line"]]) + len(units)

    for edit in sorted(edits, key=lambda one: offset(one["range"]["start"]), reverse=True):
        begin, end = offset(edit["range"]["start"]), offset(edit["range"]["end"])
        text = text[:begin] + edit["newText"] + text[end:]
        lines = text.split("\n")
    return text
