# SPDX-License-Identifier: BSD-2-Clause
"""A real Chromium without a window, driven through chromedriver's protocol, for tests of pages."""
import base64
import json
import os
import pathlib
import shutil
import subprocess
import time
import urllib.error
import urllib.request

from soarbox_command import free_port

PROGRAMS = ("chromium", "chromedriver")


def missing():
    """Why there is no browser to test with; empty: there is one."""
    absent = [name for name in PROGRAMS if not shutil.which(name)]
    return "no browser to test pages with: " + " and ".join(absent) + " not installed" if absent else ""


class Browser:
    """One browser with one page. Use it as a context."""

    def __init__(self, folder, script=True, dark=False):
        self.folder = pathlib.Path(folder)
        port = free_port()
        self.address = f"http://127.0.0.1:{port}"
        self.driver = subprocess.Popen(["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            self._wait()
            arguments = ["--headless=new", "--disable-gpu", "--hide-scrollbars", "--disable-dev-shm-usage", "--no-first-run",
                         f"--user-data-dir={self.folder / 'browser'}"]
            if os.geteuid() == 0:
                arguments.append("--no-sandbox")  # Chromium refuses its sandbox to root, as in containers.
            if dark:
                arguments.append("--force-dark-mode")
            options = {"args": arguments}
            if not script:
                options["prefs"] = {"profile.managed_default_content_settings.javascript": 2}
            told = self._ask("POST", "/session", {"capabilities": {"alwaysMatch": {
                "browserName": "chrome", "goog:chromeOptions": options,
                "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}}})
            self.session = "/session/" + told["sessionId"]
        except Exception:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        if hasattr(self, "session"):
            try:
                self._ask("DELETE", self.session)
            except OSError:
                pass
        self.driver.terminate()
        try:
            self.driver.wait(10)
        except subprocess.TimeoutExpired:
            self.driver.kill()
            self.driver.wait()

    def _wait(self):
        end = time.monotonic() + 60
        while time.monotonic() < end:
            try:
                if self._ask("GET", "/status")["ready"]:
                    return
            except OSError:
                time.sleep(0.1)
        raise RuntimeError("chromedriver did not start")

    def _ask(self, method, path, body=None):
        data = json.dumps(body if body is not None else {}).encode() if method == "POST" else None
        request = urllib.request.Request(self.address + path, data=data, method=method, headers={"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(error.read().decode(errors="replace")) from error

    def size(self, width, height, phone=False):
        """As a screen of this size shows it; a window cannot be made as narrow as a phone."""
        self._ask("POST", self.session + "/goog/cdp/execute", {"cmd": "Emulation.setDeviceMetricsOverride", "params": {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": phone}})

    def scheme(self, name):
        """The user's colours: "light" or "dark"."""
        self._ask("POST", self.session + "/goog/cdp/execute", {"cmd": "Emulation.setEmulatedMedia", "params": {
            "features": [{"name": "prefers-color-scheme", "value": name}]}})

    def open(self, file):
        self._ask("POST", self.session + "/url", {"url": pathlib.Path(file).resolve().as_uri()})

    def run(self, script, *arguments):
        return self._ask("POST", self.session + "/execute/sync", {"script": script, "args": list(arguments)})

    def press(self, *keys):
        """Real key strokes, into whatever has the keyboard."""
        actions = [{"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")]
        self._ask("POST", self.session + "/actions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})

    def complaints(self):
        """What the page's console has said of errors and warnings."""
        return [entry["message"] for entry in self._ask("POST", self.session + "/se/log", {"type": "browser"})
                if entry["level"] in ("SEVERE", "WARNING")]

    def fetched(self):
        """Addresses that the page has asked the network for."""
        entries = [json.loads(entry["message"])["message"] for entry in self._ask("POST", self.session + "/se/log", {"type": "performance"})]
        addresses = [entry["params"]["request"]["url"] for entry in entries if entry["method"] == "Network.requestWillBeSent"]
        return [address for address in addresses if address.startswith(("http:", "https:", "ws:", "wss:"))]

    def picture(self, file):
        height = self.run("return document.documentElement.scrollHeight")
        shot = self._ask("POST", self.session + "/goog/cdp/execute", {"cmd": "Page.captureScreenshot", "params": {
            "captureBeyondViewport": True,
            "clip": {"x": 0, "y": 0, "width": self.run("return window.innerWidth"), "height": min(height, 6000), "scale": 1}}})
        pathlib.Path(file).write_bytes(base64.b64decode(shot["data"]))
