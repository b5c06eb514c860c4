# SPDX-License-Identifier: BSD-2-Clause
"""A client of the protocol between Soar kernels and debuggers, which uses only a socket and an XML parser."""
import socket
import struct
import time
import xml.etree.ElementTree as ElementTree
from xml.sax.saxutils import escape

ENTITIES = {'"': "&quot;", "'": "&apos;"}


def frame(document):
    """The bytes of a message: its length in four bytes, then the document."""
    data = document if isinstance(document, bytes) else document.encode("utf-8")
    return struct.pack(">I", len(data)) + data


class Refused(Exception):
    """The kernel answered a call with an error."""


class Client:
    """A connection. While it waits for a response, it answers incoming calls and stores events in `events` as (name, element)."""

    def __init__(self, port, limit_s=100.0):
        self.limit_s = limit_s
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=limit_s)
        self.buffer = b""
        self.next_id = 0
        self.events = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.socket.close()

    def send(self, data):
        self.socket.sendall(data)

    def receive(self, until):
        """The next document; None after `until`. Raises ConnectionError if the kernel has closed the connection."""
        while True:
            if len(self.buffer) >= 4:
                length = struct.unpack(">I", self.buffer[:4])[0]
                if len(self.buffer) >= 4 + length:
                    document, self.buffer = self.buffer[4:4 + length], self.buffer[4 + length:]
                    return ElementTree.fromstring(document.decode("utf-8"))
            left = until - time.monotonic()
            if left <= 0:
                return None
            self.socket.settimeout(left)
            try:
                data = self.socket.recv(1 << 16)
            except TimeoutError:
                return None
            if not data:
                raise ConnectionError("the kernel closed the connection")
            self.buffer += data

    def take(self, document):
        """Answers a call of the kernel, and stores it if it is an event."""
        if document.get("doctype") != "call":
            return
        self.send(frame(f'<sml ack="{document.get("id")}" doctype="response" id="{self.next_id}" smlversion="9.6.3"></sml>'))
        self.next_id += 1
        command = document.find("command")
        if command.get("name") == "event":
            self.events.append((argument(command, "eventid"), document))

    def call(self, command, structured=True, **arguments):
        """The response to a command, as an element; raises Refused for an error."""
        own = str(self.next_id)
        self.next_id += 1
        arguments = "".join(f'<arg param="{name}">{escape(str(value), ENTITIES)}</arg>' for name, value in arguments.items())
        form = "" if structured else ' output="raw"'
        self.send(frame(f'<sml doctype="call" id="{own}" smlversion="9.6.3"><command name="{command}"{form}>'
                        f"{arguments}</command></sml>"))
        until = time.monotonic() + self.limit_s
        while True:
            document = self.receive(until)
            if document is None:
                raise TimeoutError(f"no answer to {command}")
            if document.get("doctype") == "response" and document.get("ack") == own:
                error = document.find("error")
                if error is not None:
                    raise Refused(error.text)
                return document
            self.take(document)

    def text(self, command, **arguments):
        result = self.call(command, structured=False, **arguments).find("result")
        return "" if result is None else result.text or ""

    def line(self, agent, line):
        """Sends a command line as a debugger does, and returns the text of the answer."""
        return self.text("cmdline", agent=agent, line=line, echo="true", nofilter="false")

    def values(self, agent, line):
        """The named values of a structured answer."""
        response = self.call("cmdline", agent=agent, line=line)
        return {found.get("param"): found.text or "" for found in response.iter("arg")}

    def register(self, event, **arguments):
        self.call("register_for_event", eventid=event, **arguments)

    def listen(self, seconds):
        """Answers incoming messages for a while."""
        until = time.monotonic() + seconds
        while (document := self.receive(until)) is not None:
            self.take(document)

    def heard(self, event):
        return [document for name, document in self.events if name == event]

    def agents(self):
        return [name.text for name in self.call("get_agent_list").find("result").findall("name")]


def argument(command, name):
    return next((found.text or "" for found in command.findall("arg") if found.get("param") == name), None)


def debugger_start(client):
    """Sends the requests of the Java debugger when it connects."""
    client.register("after-agent-reinitialized")
    assert int(client.text("initial_time_tag")) < 0
    names = client.agents()
    for event in ("after-agent-created", "before-agent-destroyed", "interrupt-check", "after-all-output-phases",
                  "system-start", "system-stop", "system-property-changed"):
        client.register(event)
    client.call("set_interrupt_check_rate", value=50)
    client.call("set_connection_info", name="java-debugger", status="not-ready", **{"agent-status": "not-ready"})
    assert client.text("version") == "9.6.3"
    client.call("get_connections")
    client.call("set_connection_info", name="java-debugger", status="ready", **{"agent-status": "ready"})
    return names


def debugger_attach(client, agent):
    """Sends the requests of the Java debugger for the agent of a window."""
    for event in ("print", "echo", "xml-trace-output", "after-decision-cycle", "before-agent-reinitialized"):
        client.register(event, agent=agent)
    assert "watchdecisions" in client.values(agent, "watch")
    assert "directory" in client.values(agent, "pwd")
    assert "phase" in client.values(agent, "soar stop-phase")
    client.line(agent, "help")
    for what in ("phase", "decision", "runstate"):
        int(client.text("get_run_state", agent=agent, value=what))
