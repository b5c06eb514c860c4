# SPDX-License-Identifier: BSD-2-Clause
"""Invalid requests from unknown clients: the server refuses them with a message, and continues."""
import io
import os
import socket
import struct
import unittest
import zipfile

from web_client import Gone, ServeCase, WebSocket


class Places(ServeCase):
    def test_files_are_kept_read_and_removed(self):
        server = self.serve()
        place = server.new_place()
        self.assertEqual(server.json("PUT", f"/api/p/{place}/files/notes/a%20b.txt", "grün".encode())[0], 200)
        self.assertEqual(server.http("GET", f"/api/p/{place}/files/notes/a%20b.txt")[2], "grün".encode())
        about = server.json("GET", f"/api/p/{place}")[1]
        self.assertEqual([file["path"] for file in about["files"]], ["notes/a b.txt"])
        self.assertEqual(server.json("DELETE", f"/api/p/{place}/files/notes/a%20b.txt")[0], 200)
        self.assertEqual(server.json("GET", f"/api/p/{place}/files/notes/a%20b.txt")[0], 404)

    def test_paths_name_nothing_outside(self):
        server = self.serve()
        place, other = server.new_place(), server.new_place()
        server.http("PUT", f"/api/p/{other}/files/secret.txt", b"secret")
        os.symlink("/etc", self.folder / "state" / "places" / place / "home" / "link")
        for path in (f"../../{other}/home/secret.txt", f"..%2f..%2f{other}%2fhome%2fsecret.txt", "%2e%2e/x", ".hidden", "a/.b", "a//b",
                     "%00", "a%0ab", "link/passwd", "x" * 300, "/".join("abcdefghijk"), "..%5c..%5cx", "%ff%fe"):
            for method, body in (("GET", None), ("PUT", b"mine"), ("DELETE", None)):
                status, answer = server.json(method, f"/api/p/{place}/files/{path}", body)
                if path == "%ff%fe":
                    continue
                self.assertIn(status, (400, 404), (method, path))
                self.assertNotIn("secret", str(answer))
        self.assertEqual(server.http("GET", f"/api/p/{other}/files/secret.txt")[2], b"secret")

    def test_a_place_holds_so_much_and_no_more(self):
        server = self.serve()
        place = server.new_place()
        for i in range(3):
            self.assertEqual(server.json("PUT", f"/api/p/{place}/files/{i}", b"x" * 1_300_000)[0], 200)
        status, answer = server.json("PUT", f"/api/p/{place}/files/4", b"x" * 1_300_000)
        self.assertEqual(status, 400)
        self.assertIn("no room", answer["error"])
        self.assertEqual(server.json("PUT", f"/api/p/{place}/files/0", b"less")[0], 200)
        try:
            status = server.http("PUT", f"/api/p/{place}/files/5", b"x" * 6_000_000)[0]
        except (BrokenPipeError, ConnectionResetError):
            status = 413
        self.assertEqual(status, 413)

    def test_a_folder_is_taken_home_and_brought_back(self):
        server = self.serve()
        place, other = server.new_place(), server.new_place()
        texts = {"a.soar": b"sp {a}", "deep/b.soar": b"x" * 100_000, "empty": b"", "gr\u00fcn.txt": b"green"}
        for path, text in texts.items():
            server.http("PUT", f"/api/p/{place}/files/{path.replace(chr(252), '%C3%BC')}", text)
        archive = server.http("GET", f"/api/p/{place}/zip")[2]
        with zipfile.ZipFile(io.BytesIO(archive)) as opened:
            self.assertIsNone(opened.testzip())
            self.assertEqual({name: opened.read(name) for name in opened.namelist()}, texts)
        self.assertEqual(server.json("POST", f"/api/p/{other}/zip", archive), (200, {"files": 4}))
        self.assertEqual(server.http("GET", f"/api/p/{other}/zip")[2], archive)

    def test_archives_of_strangers_do_no_harm(self):
        server = self.serve()
        place = server.new_place()

        def packed(entries, **options):
            out = io.BytesIO()
            with zipfile.ZipFile(out, "w", **options) as writing:
                for path, text in entries:
                    writing.writestr(path, text)
            return out.getvalue()
        good = packed([("a.txt", b"hello")])
        bad = [packed([("../up.txt", b"x")]), packed([("/etc/x", b"x")]), packed([("a/.b", b"x")]),
               packed([("bomb", b"\0" * 50_000_000)], compression=zipfile.ZIP_DEFLATED),
               packed([(str(i), b"") for i in range(1000)]), b"", b"PK", b"PK\5\6" + b"\xff" * 18, good[:-30],
               packed([("a", b"hello")], compression=zipfile.ZIP_BZIP2)]
        for at in range(0, len(good), 3):
            damaged = bytearray(good)
            damaged[at] ^= 0xFF
            bad.append(bytes(damaged))
        for archive in bad[:10]:
            self.assertEqual(server.json("POST", f"/api/p/{place}/zip", archive)[0], 400)
        for archive in bad[10:]:
            self.assertIn(server.json("POST", f"/api/p/{place}/zip", archive)[0], (200, 400))
        self.assertEqual(server.json("POST", f"/api/p/{place}/zip", good)[0], 200)


class Doors(ServeCase):
    def test_the_page_comes_with_a_policy_and_compressed(self):
        server = self.serve()
        status, headers, body = server.http("GET", "/")
        self.assertEqual((status, headers["Content-Type"]), (200, "text/html; charset=utf-8"))
        self.assertIn("default-src 'self'", headers["Content-Security-Policy"])
        self.assertEqual(headers["Referrer-Policy"], "no-referrer")
        packed = server.http("GET", "/", Accept_Encoding="gzip")
        self.assertEqual(packed[1]["Content-Encoding"], "gzip")
        self.assertLess(len(packed[2]), len(body))
        self.assertEqual(server.http("GET", "/", If_None_Match=headers["ETag"])[0], 304)
        self.assertEqual(server.http("GET", "/p/" + server.new_place() + "/")[2], body)
        self.assertEqual(server.http("GET", "/assets/../../../etc/passwd")[0], 404)

    def test_places_of_others_cannot_be_guessed(self):
        server = self.serve()
        for place in ("0" * 26, "x", "", "..", "%2e%2e", "A" * 26):
            self.assertEqual(server.json("GET", f"/api/p/{place}")[0], 404)
        self.assertNotEqual(server.new_place(), server.new_place())
        self.assertEqual(self.page(server, "0" * 26).status, 404)

    def test_pages_of_other_sites_are_refused(self):
        server = self.serve()
        place = server.new_place()
        for origin in ("http://evil.example", "null", "http://127.0.0.1:1", "http://127.0.0.1:" + str(server.port) + ".evil"):
            self.assertEqual(server.json("POST", "/api/places", b"", Origin=origin)[0], 403, origin)
            self.assertEqual(self.page(server, place, origin=origin).status, 403, origin)
        # The host name of another site that resolves to this address.
        self.assertEqual(server.json("GET", f"/api/p/{place}", Host=f"evil.example:{server.port}")[0], 421)
        named = self.page(server, place, host="evil.example", origin="http://evil.example")
        self.assertEqual(named.status, 421)

    def test_a_server_that_is_called_by_a_name_knows_it(self):
        server = self.serve("--host", "soar.school")
        self.assertEqual(server.json("POST", "/api/places", b"", Host="soar.school", Origin="http://soar.school")[0], 200)

    def test_a_token_is_asked_for_and_cannot_be_tried(self):
        server = self.serve("--token", "open-sesame")
        self.assertIn("#token=open-sesame", server.lines[0])
        self.assertEqual(server.json("POST", "/api/places", b"")[0], 401)
        place = server.new_place(Authorization="Bearer open-sesame")
        self.assertEqual(self.page(server, place).status, 401)
        self.assertEqual(server.http("GET", "/")[0], 200, "the page itself is no secret")
        for _ in range(10):
            self.assertEqual(server.json("POST", "/api/places", b"", Authorization="Bearer wrong")[0], 401)
        status, answer = server.json("POST", "/api/places", b"", Authorization="Bearer wrong")
        self.assertEqual(status, 429)
        self.assertIn("wait a minute", answer["hint"])

    def test_a_page_may_show_the_token_as_its_protocol(self):
        server = self.serve("--token", "sesame")
        place = server.new_place(Authorization="Bearer sesame")
        page = self.page(server, place, protocol="soarbox.sesame")
        self.assertEqual(page.status, 101)
        self.assertIn("soarbox.sesame", page.head)
        page.until_message("none")

    def test_beyond_this_machine_a_token_is_needed(self):
        with self.assertRaisesRegex(AssertionError, "--token SECRET"):
            self.serve(listen="0.0.0.0:0")

    def test_noise_hurts_nobody(self):
        server = self.serve()
        place = server.new_place()
        page = self.opened(server, place, "scenario:soar_hallway", "agents")
        noise = [b"\0" * 1000, b"GET / HTTP/9.9\r\n\r\n", b"GET " + b"/" * 40_000 + b" HTTP/1.1\r\n\r\n",
                 b"GET / HTTP/1.1\r\n" + b"X: y\r\n" * 10_000 + b"\r\n", b"POST /api/places HTTP/1.1\r\nContent-Length: -1\r\n\r\n",
                 b"POST /api/places HTTP/1.1\r\nContent-Length: 99999999999999999999\r\n\r\n",
                 b"POST /api/places HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nffffffffffffffff\r\n", b"\x16\x03\x01" + os.urandom(200)]
        for bytes_ in noise:
            with socket.create_connection(("127.0.0.1", server.port), timeout=60) as connection:
                try:
                    connection.sendall(bytes_)
                    connection.shutdown(socket.SHUT_WR)
                    while connection.recv(65536):
                        pass
                except OSError:
                    pass
        self.assertEqual(server.http("GET", "/")[0], 200)
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 3)

    def test_connections_that_stay_silent_leave_room_for_others(self):
        server = self.serve()
        silent = [socket.create_connection(("127.0.0.1", server.port), timeout=60) for _ in range(300)]
        for connection in silent[::2]:
            connection.sendall(b"GET / HT")
        self.assertEqual(server.http("GET", "/")[0], 200)
        more = [socket.create_connection(("127.0.0.1", server.port), timeout=60) for _ in range(150)]
        status, answer = server.json("GET", "/")
        self.assertEqual(status, 503)
        self.assertIn("the maximum number of connections", answer["error"])
        for connection in silent + more:
            connection.close()
        self.wait_for(lambda: server.http("GET", "/")[0] == 200, "there is room again")

    def test_frames_that_are_too_long_or_broken_end_their_connection_alone(self):
        server = self.serve()
        place = server.new_place()
        page = self.opened(server, place, "scenario:soar_hallway", "agents")
        for frame in (bytes([0x81, 0xFF]) + struct.pack(">Q", 2**63) + b"mask", bytes([0x81, 0xFF]) + struct.pack(">Q", 2**62) + b"mask",
                      bytes([0x8F, 0x80]) + b"mask", bytes([0x81, 0x05]) + b"plain", bytes([0xF1, 0x80]) + b"mask",
                      bytes([0x81, 0x82]) + b"\0\0\0\0\xff\xff"):
            other = self.page(server, place)
            other.until_message("hello")
            other.socket.sendall(frame)
            with self.assertRaises((Gone, OSError)):
                while True:
                    other.receive()
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 3)

    def test_requests_that_make_no_sense_are_refused_one_by_one(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:soar_hallway", "agents")
        texts = ["", "null", "[]", "{", "[" * 100_000, '{"request":1}', '{"request":"seek"}', '{"request":"seek","tick":-1}',
                 '{"request":"seek","tick":1e999}', '{"request":"flow","what":[]}', '{"request":"presence","pages":0}',
                 '{"request":"look","panels":["no-such"]}', '{"request":"input","kind":"bomb"}', '{"request":"open"}']
        for text in texts:
            page.send_frame(1, text.encode())
            page.until_message("error")
        page.send_frame(2, b"bytes")
        page.until_message("error")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 3)

    def test_who_asks_too_fast_is_told(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:soar_hallway", "agents")
        for _ in range(2000):
            page.ask(request="live")
        page.until(lambda message: message["message"] == "error" and "faster" in message["error"])


class Class(ServeCase):
    def begin(self):
        names = self.folder / "names.txt"
        names.write_text("# my class\nAda\n<img src=x onerror=alert(1)>\n=1+1\n", encoding="utf-8")
        server = self.serve("--class", names)
        links = [server.process.stdout.readline().strip() for _ in range(4)]
        return server, [link.rsplit(": ", 1)[1].removeprefix(server.origin) for link in links]

    def test_a_teacher_sees_the_class_and_watches(self):
        server, links = self.begin()
        key, ada = links[0].split("/")[2], links[1].split("/")[2]
        status, table = server.json("GET", f"/api/class/{key}")
        self.assertEqual(status, 200)
        self.assertEqual([learner["name"] for learner in table["learners"]], ["Ada", "<img src=x onerror=alert(1)>", "=1+1"])
        self.assertEqual(len([lesson for lesson in table["lessons"] if lesson["course"] == ""]), 27)
        self.assertIn("eaters", {lesson["course"] for lesson in table["lessons"]})
        page = self.opened(server, ada, "lesson:02-operators", "mission")
        self.assertEqual(server.json("GET", f"/api/p/{ada}")[1]["learner"], "Ada")
        table = server.json("GET", f"/api/class/{key}")[1]
        self.assertEqual([learner["is_here"] for learner in table["learners"]], [True, False, False])
        self.assertEqual(table["learners"][0]["doing"], "lesson:02-operators")
        watching = WebSocket(server, f"/api/p/{ada}/watch?key={key}")
        self.addCleanup(watching.close)
        watching.until_message("hello")
        watching.ask(request="flow", what="pause", id=1)
        self.assertIn("only watch", watching.until_message("error")["error"])
        page.ask(request="flow", what="pause")
        watching.until(lambda message: message["message"] == "flow" and message["paused"])
        # A teacher chooses panels. This does not change the learner's panels, and unknown names are ignored.
        watching.ask(request="look", panels=["rules", "nowhere"])
        watching.until_contents("rules", lambda rules: any(node["is"] == "tabs" for node in rules["document"]))
        for odd in ("rules", [7], ["x" * 100], ["why"] * 200):
            watching.ask(request="look", panels=odd, id=2)
            self.assertIn("look needs panels", watching.until_message("error")["error"])
        watching.ask(request="select", agent="")
        self.assertIn("only watch", watching.until_message("error")["error"])
        page.ask(request="lesson", what="hint")
        page.until_contents("mission", lambda mission: mission["lesson"]["hints"])
        hint = page.contents["mission"]["lesson"]["hints"][0]
        self.assertEqual(server.json("GET", f"/api/class/{key}")[1]["learners"][0]["last_hint"], hint)
        self.assertEqual(server.json("GET", f"/api/class/{key}")[1]["learners"][1]["last_hint"], "")
        self.assertNotIn("error", {message["message"] for message in page.messages})
        refused = WebSocket(server, f"/api/p/{ada}/watch?key=wrong")
        self.addCleanup(refused.close)
        self.assertEqual(refused.status, 403)
        self.assertEqual(server.json("GET", "/api/class/wrong")[0], 404)
        _, headers, csv = server.http("GET", f"/api/class/{key}.csv")
        self.assertIn("text/csv", headers["Content-Type"])
        self.assertIn(hint[:20].encode(), csv)
        self.assertIn(b"\"'=1+1\"", csv, "a spreadsheet takes no name for a formula")

    def test_links_stay_the_same(self):
        server, links = self.begin()
        server.stop()
        self.assertEqual([link.split("/")[1:3] for link in self.begin()[1]], [link.split("/")[1:3] for link in links])

    def test_a_list_that_cannot_be_used_is_told_with_its_line(self):
        names = self.folder / "names.txt"
        for text, said in (("Ada\nBob\nAda\n", "names.txt:3: error: this name is there twice"), ("", "holds no name"),
                           ("x" * 200 + "\n", "names.txt:1")):
            names.write_text(text, encoding="utf-8")
            with self.assertRaisesRegex(AssertionError, said):
                self.serve("--class", names)


if __name__ == "__main__":
    unittest.main()
