# SPDX-License-Identifier: BSD-2-Clause
"""A server behind nginx, and two servers that share the work: a place stays on one of them, and survives the end of its server."""
import pathlib
import shutil
import socket
import subprocess
import unittest

from web_client import Server, ServeCase, WebSocket

CONFIG = """
daemon off;
worker_processes 1;
pid {folder}/nginx.pid;
error_log {folder}/nginx.log;
events {{ worker_connections 256; }}
http {{
  log_format all '$request';
  access_log {folder}/access.log all;
  client_body_temp_path {folder}/body; proxy_temp_path {folder}/proxy; fastcgi_temp_path {folder}/fastcgi;
  uwsgi_temp_path {folder}/uwsgi; scgi_temp_path {folder}/scgi;
  # The place, anywhere in the path; a client without one goes to any server.
  map $uri $place {{ ~^(?:/api)?/p/(?<id>[0-9a-z]+) $id; default $request_id; }}
  upstream soarbox {{ hash $place consistent; {upstreams} }}
  server {{
    listen 127.0.0.1:{port};
    location / {{
      proxy_pass http://soarbox;
      proxy_http_version 1.1;
      proxy_set_header Host $http_host;
      proxy_set_header X-Forwarded-For $remote_addr;
      proxy_set_header Upgrade $http_upgrade;
      proxy_set_header Connection $http_connection;
      proxy_read_timeout 1h;
    }}
  }}
}}
"""


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Proxy(Server):
    """An nginx in front of servers."""

    def __init__(self, folder, servers):
        self.port = free_port()
        self.host = f"soar.school:{self.port}"
        self.origin = "http://" + self.host
        config = pathlib.Path(folder) / "nginx.conf"
        config.write_text(CONFIG.format(folder=folder, port=self.port,
                                        upstreams=" ".join(f"server 127.0.0.1:{server.port} max_fails=1;" for server in servers)),
                          encoding="utf-8")
        self.process = subprocess.Popen(["nginx", "-c", config, "-p", folder], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def is_ready(self):
        try:
            return self.http("GET", "/")[0] == 200
        except OSError:
            return False


@unittest.skipUnless(shutil.which("nginx"), "nginx is not installed")
class BehindNginx(ServeCase):
    def proxy(self, servers):
        proxy = Proxy(self.folder, servers)
        self.addCleanup(proxy.process.wait)
        self.addCleanup(proxy.process.terminate)
        self.wait_for(proxy.is_ready, "nginx answers")
        return proxy

    def test_runs_are_shown_through_a_proxy(self):
        server = self.serve("--host", "soar.school", "--proxy", "127.0.0.1")
        proxy = self.proxy([server])
        place = proxy.new_place(Origin=proxy.origin)
        page = self.opened(proxy, place, "scenario:soar_hallway", "agents")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 5)
        self.assertEqual(self.page(proxy, place, origin="http://evil.example").status, 403)

    def test_wrong_tokens_count_for_those_who_send_them_not_for_the_proxy(self):
        server = self.serve("--host", "soar.school", "--proxy", "127.0.0.1", "--token", "sesame")
        for _ in range(12):
            server.http("POST", "/api/places", b"", X_Forwarded_For="10.0.0.1", Authorization="Bearer wrong")
        for address, status in (("10.0.0.1", 429), ("10.0.0.2", 401)):
            self.assertEqual(server.http("POST", "/api/places", b"", X_Forwarded_For=address, Authorization="Bearer wrong")[0], status, address)
        self.assertEqual(server.http("POST", "/api/places", b"", X_Forwarded_For="10.0.0.1", Authorization="Bearer sesame")[0], 200)

    def test_the_log_of_a_proxy_holds_places_and_no_token(self):
        """As docs/serve.md states, the id of a place is in the path, and the token is in a header or a subprotocol."""
        server = self.serve("--host", "soar.school", "--proxy", "127.0.0.1", "--token", "sesame")
        proxy = self.proxy([server])
        place = proxy.new_place(Authorization="Bearer sesame")
        page = WebSocket(proxy, f"/api/p/{place}/run", protocol="soarbox.sesame", origin=proxy.origin)
        self.addCleanup(page.close)
        self.assertEqual(page.status, 101)
        page.ask(request="open", what="scenario:soar_hallway")
        page.until_message("hello")
        page.close()
        log = self.folder / "access.log"
        self.wait_for(lambda: f"/api/p/{place}/run" in log.read_text(encoding="utf-8"), "the connection is in the log")
        self.assertNotIn("sesame", log.read_text(encoding="utf-8"))

    def test_two_servers_share_the_work_and_a_place_outlives_its_server(self):
        # Both servers use the same folder.
        servers = [self.serve("--host", "soar.school") for _ in range(2)]
        proxy = self.proxy(servers)
        places, pages, counts = [], [], [0, 0]
        # Ids of places and ports are random: eight places are now and then on one server.
        while len(places) < 8 or (len(places) < 40 and 0 in counts):
            places.append(proxy.new_place())
            pages.append(self.opened(proxy, places[-1], "scenario:soar_hallway", "agents"))
            counts = [len(server.engines()) for server in servers]
        self.assertEqual(sum(counts), len(places))
        self.assertGreater(min(counts), 0, "both have some")
        # A client that returns comes to the same server and to the same run.
        again = self.page(proxy, places[0])
        again.until_message("hello")
        proxy.http("PUT", f"/api/p/{places[0]}/files/mine.txt", b"mine")
        servers[0].kill()
        for place in places:
            page = self.page(proxy, place)
            if page.until(lambda message: message["message"] in ("hello", "none"))["message"] == "none":
                page.ask(request="open", what="scenario:soar_hallway")
                page.until_message("hello")
        self.assertEqual(proxy.http("GET", f"/api/p/{places[0]}/files/mine.txt")[2], b"mine")
        self.assertEqual(len(servers[1].engines()), 8)
        del pages


if __name__ == "__main__":
    unittest.main()
