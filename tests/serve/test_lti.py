# SPDX-License-Identifier: BSD-2-Clause
"""Learning platforms open lessons and get grades: LTI 1.3 against a platform of its own (lti_platform.mjs), with the cryptography of Node.js."""
import base64
import concurrent.futures
import html
import json
import os
import pathlib
import re
import shutil
import socket
import subprocess
import time
import unittest
import urllib.error
import urllib.parse
import urllib.request

from web_client import LESSONS, PATIENCE_S, ServeCase

HERE = pathlib.Path(__file__).resolve().parent
CLAIM = "https://purl.imsglobal.org/spec/lti/claim/"


class Platform:
    """The test platform, as a process."""

    def __init__(self, case, *certificate):
        self.process = subprocess.Popen(["node", HERE / "lti_platform.mjs", *certificate], stdout=subprocess.PIPE, text=True)
        case.addCleanup(self.close)
        self.url = self.process.stdout.readline().strip()
        self.context = None

    def close(self):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()

    def ask(self, path, data=None):
        """Status and body of one request, sent like a browser."""
        try:
            with urllib.request.urlopen(urllib.request.Request(self.url + path, data), timeout=PATIENCE_S, context=self.context) as answer:
                return answer.status, answer.read().decode()
        except urllib.error.HTTPError as error:
            with error:
                return error.code, error.read().decode()

    def set(self, **order):
        assert self.ask("/control", json.dumps(order).encode())[0] == 200

    def noted(self):
        return json.loads(self.ask("/control")[1])


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


@unittest.skipUnless(shutil.which("node"), "node is not installed")
class LtiCase(ServeCase):
    options = ()

    def setUp(self):
        super().setUp()
        self.port = free_port()
        self.key = None
        self.platform = self.start_platform()

    def start_platform(self):
        return Platform(self)

    def begin(self, **changes):
        platform = {"name": "Test school", "issuer": self.platform.url, "client_id": "client-1", "auth_url": self.platform.url + "/auth",
                    "token_url": self.platform.url + "/token", "jwks_url": self.platform.url + "/jwks", "deployments": ["deployment-1"], **changes}
        (self.folder / "lti.json").write_text(json.dumps({"url": f"http://127.0.0.1:{self.port}", "platforms": [platform]}), encoding="utf-8")
        return self.again()

    def again(self):
        self.server = self.serve("--lti", self.folder / "lti.json", *self.options, listen=f"127.0.0.1:{self.port}")
        self.platform.set(tool=self.server.origin)
        return self.server

    def login(self, user, **fields):
        """The tool's answer to the beginning of a launch: status, location, cookie and text."""
        query = {"iss": self.platform.url, "login_hint": user, "target_link_uri": self.server.origin + "/lti/launch", "client_id": "client-1", "lti_deployment_id": "deployment-1", **fields}
        query = {name: value for name, value in query.items() if value is not None}
        status, headers, body = self.server.http("GET", "/lti/login?" + urllib.parse.urlencode(query))
        return status, headers["Location"], (headers["Set-Cookie"] or "").split(";")[0], body.decode()

    def form(self, user, **message):
        """The form that the platform sends through a browser, and the browser's cookie."""
        hint = base64.urlsafe_b64encode(json.dumps(message).encode()).decode().rstrip("=")
        status, location, cookie, body = self.login(user, lti_message_hint=hint)
        self.assertEqual(status, 302, body)
        self.assertTrue(location.startswith(self.platform.url + "/auth?"), location)
        status, page = self.platform.ask(location.removeprefix(self.platform.url))
        self.assertEqual(status, 200, page)
        self.assertEqual(re.search(r'action="([^"]*)"', page)[1], self.server.origin + "/lti/launch")
        return {name: html.unescape(value) for name, value in re.findall(r'name="(\w+)" value="([^"]*)"', page)}, cookie

    def send(self, fields, cookie):
        body = urllib.parse.urlencode(fields).encode()
        status, headers, got = self.server.http("POST", "/lti/launch", body, Cookie=cookie, Origin=self.platform.url, Content_Type="application/x-www-form-urlencoded")
        self.headers = headers
        return status, headers["Location"], html.unescape(got.decode())

    def launch(self, user, **message):
        return self.send(*self.form(user, **message))

    def place(self, user, **message):
        """The place that a launch opens."""
        status, location, body = self.launch(user, **message)
        self.assertEqual(status, 303, body)
        self.assertRegex(location, r"^/p/[0-9a-z]{26}/")
        return location.split("/")[2]

    def table(self):
        if self.key is None:
            status, location, body = self.launch("teacher")
            self.assertEqual(status, 303, body)
            self.assertRegex(location, r"^/class/[0-9a-z]{26}/$")
            self.key = location.split("/")[2]
        return self.server.json("GET", f"/api/class/{self.key}")[1]

    def grade(self, place, solution):
        """Applies the solution of the first lesson, or rules that do nothing, and grades them."""
        page = self.page(self.server, place)
        if page.until(lambda message: message["message"] in ("none", "hello"))["message"] == "none":
            page.ask(request="open", what="lesson:01-a-rule")
            page.until_message("hello")
        page.ask(request="look", panels=["edit", "mission"])
        file = page.until_contents("edit", lambda edit: edit["files"])["files"][0]["file"]
        page.ask(request="edit", file=file)
        page.until_contents("edit", lambda edit: edit["edit"]["text"])
        text = (LESSONS / "01-a-rule" / "solution" / "porter.soar").read_text(encoding="utf-8") if solution else "# Nothing yet.\n"
        page.ask(request="edit-text", what="apply", text=text)
        page.until_contents("edit", lambda edit: "Reloaded" in edit["edit"]["notice"])
        page.ask(request="edit-text", what="save", text=text)
        page.until_contents("edit", lambda edit: edit["edit"]["notice"] == "Saved.")
        page.ask(request="lesson", what="grade")
        # A running world shows the previous grade until the next one is finished.
        graded = lambda lesson: lesson["grade"] and not lesson["is_graded"] and lesson["is_passed"] == solution
        page.until_contents("mission", lambda mission: graded(mission["lesson"]))
        page.close()

    def scores(self, **fields):
        return [score for score in self.platform.noted()["scores"] if all(score[name] == value for name, value in fields.items())]


class Launches(LtiCase):
    def test_a_launch_opens_the_lesson_in_a_place_of_ones_own(self):
        server = self.begin()
        status, location, body = self.launch("ada")
        self.assertEqual(status, 303, body)
        self.assertTrue(location.endswith("/#lesson=01-a-rule"), location)
        ada = location.split("/")[2]
        self.assertEqual(server.json("GET", f"/api/p/{ada}")[1]["learner"], "Ada Lovelace")
        self.assertEqual(self.place("ada", lesson="02-operators", link="link-2"), ada, "the same place again")
        self.assertNotEqual(self.place("bob"), ada)
        self.assertNotEqual(self.place("ada", course="course-2"), ada, "each course has its own places")
        zoe = self.place("zoe")
        table = self.table()
        self.assertEqual([learner["name"] for learner in table["learners"]], ["Ada Lovelace", "Bob <b>Stone</b>", "Learner 3"])
        # Places and the course's key are the same after a restart.
        key = self.launch("teacher")[1]
        self.assertEqual(server.stop(), 0)
        self.again()
        self.assertEqual((self.place("ada"), self.place("zoe")), (ada, zoe))
        self.assertEqual(self.launch("teacher")[1], key)
        self.assertNotEqual(self.launch("teacher", course="course-2")[1], key)

    def test_a_world_or_the_start_page_can_be_opened_too(self):
        self.begin()
        self.assertTrue(self.launch("ada", set={CLAIM + "custom": {"world": "eaters"}})[1].endswith("/#world=eaters"))
        self.assertRegex(self.launch("ada", remove=[CLAIM + "custom"])[1], r"^/p/\w+/$")
        target = self.server.origin + "/lti/launch?lesson=03-choices"
        self.assertTrue(self.launch("ada", remove=[CLAIM + "custom"], set={CLAIM + "target_link_uri": target})[1].endswith("/#lesson=03-choices"))
        status, _, body = self.launch("ada", lesson="no-such")
        self.assertEqual(status, 404)
        self.assertIn("no lesson called 'no-such'", body)

    def test_a_forged_launch_opens_nothing(self):
        server = self.begin()
        now = int(time.time())
        refused = {
            "signature": [{"forge": "wrong-key"}, {"forge": "changed"}, {"forge": "no-signature"}, {"forge": "hmac-as-rs256"}],
            "RS256": [{"forge": "none"}, {"forge": "hs256"}, {"forge": "rs512"}, {"forge": "no-kid"}],
            "does not publish": [{"forge": "unknown-key"}],
            "expired": [{"set": {"exp": now - 120}}],
            "begins and ends": [{"remove": ["exp"]}, {"remove": ["iat"]}],
            "too old": [{"set": {"iat": now - 7200}}],
            "future": [{"set": {"iat": now + 600, "exp": now + 900}}],
            "another tool": [{"set": {"aud": "client-2"}}, {"set": {"aud": ["client-2", "client-3"]}}, {"remove": ["aud"]}],
            "several tools": [{"set": {"aud": ["client-1", "client-2"], "azp": "client-2"}}, {"set": {"aud": ["client-1", "client-2"]}}],
            "another platform": [{"set": {"iss": "https://evil.example"}}],
            "question": [{"set": {"nonce": "0" * 26}}, {"remove": ["nonce"]}],
            "deployment": [{"set": {CLAIM + "deployment_id": "deployment-2"}}, {"remove": [CLAIM + "deployment_id"]}],
            "LTI 1.3": [{"set": {CLAIM + "version": "1.1"}}],
            "kind of message": [{"set": {CLAIM + "message_type": "LtiStartProctoring"}}],
            "who you are": [{"remove": ["sub"]}],
            "which link": [{"remove": [CLAIM + "resource_link"]}],
            "only a teacher": [{"chooses": True}],
        }
        for words, messages in refused.items():
            for message in messages:
                with self.subTest(words=words, message=message):
                    status, location, body = self.launch("ada", **message)
                    self.assertEqual(status, 403, body)
                    self.assertIsNone(location)
                    self.assertIn(words, body)
        self.assertEqual(os.listdir(self.folder / "state" / "places"), [], "no place was made")
        self.assertEqual(self.launch("ada")[0], 303)
        self.assertEqual(server.http("GET", "/")[0], 200)

    def test_a_launch_can_be_used_once_by_the_browser_that_began_it(self):
        self.begin()
        fields, cookie = self.form("ada")
        self.assertIn("another browser", self.send(fields, "")[2])
        self.assertIn("another browser", self.send(fields, self.form("ada")[1])[2])
        self.assertIn("did not begin here", self.send({**fields, "state": fields["state"][:-2] + "AA"}, cookie)[2])
        self.assertIn("did not begin here", self.send({"id_token": fields["id_token"]}, cookie)[2])
        # The token of another login has another nonce.
        self.assertIn("question", self.send({**fields, "id_token": self.form("ada")[0]["id_token"]}, cookie)[2])
        self.assertEqual(self.send(fields, cookie)[0], 303)
        status, _, body = self.send(fields, cookie)
        self.assertEqual(status, 403)
        self.assertIn("used before", body)
        # It is also refused after a restart.
        self.assertEqual(self.server.stop(), 0)
        self.again()
        self.assertEqual(self.send(fields, cookie)[0], 403)

    def test_a_platform_that_changes_its_keys_is_asked_again_but_not_for_every_token(self):
        self.begin()
        self.place("ada")
        self.platform.set(rotate=True)
        self.place("ada")
        self.assertEqual(self.platform.noted()["jwks"], 2)
        for _ in range(12):
            self.assertEqual(self.launch("ada", forge="unknown-key")[0], 403)
        self.assertLessEqual(self.platform.noted()["jwks"], 5)
        self.place("ada")

    def test_a_login_of_strangers_leads_nowhere(self):
        self.begin()
        for fields, words in (({"iss": "https://evil.example"}, "does not know the learning platform"), ({"client_id": "client-2"}, "does not know"),
                              ({"login_hint": None}, "not a login"), ({"iss": None}, "not a login"), ({"target_link_uri": "https://evil.example/x"}, "another server")):
            with self.subTest(fields=fields):
                status, location, _, body = self.login(**{"user": "ada", **{("user" if name == "login_hint" else name): value for name, value in fields.items()}})
                self.assertIn(status, (400, 403))
                self.assertIsNone(location)
                self.assertIn(words, body)
        self.assertEqual(self.login("ada", client_id=None)[0], 302, "the issuer has one registration")
        body = urllib.parse.urlencode({"iss": self.platform.url, "login_hint": "ada", "target_link_uri": self.server.origin + "/lti/launch"}).encode()
        self.assertEqual(self.server.http("POST", "/lti/login", body)[0], 302)
        fields, cookie = self.form("ada")
        refusal = self.send({"state": fields["state"], "error": "login_required", "error_description": "<script>"}, cookie)
        self.assertIn("Test school refuses the launch: login_required", refusal[2])

    def test_odd_bytes_are_refused_and_others_are_served_meanwhile(self):
        server = self.begin()
        fields, cookie = self.form("ada")
        token = fields["id_token"]
        odd = ["", ".", "..", "....", "a.b.c", "A" * 60_000, token + ".", "." + token, token[:-1] + "!", "\0" * 50, "%00%ff", "{}", base64.urlsafe_b64encode(b"[" * 20_000).decode() * 2 + ".e30.AA"]
        odd += [token[:cut] for cut in range(0, len(token), 97)]
        for each in odd:
            status, _, body = self.send({**fields, "id_token": each}, cookie)
            self.assertIn(status, (400, 403), each[:40])
            self.assertIn("</html>", body)
        self.assertEqual(server.http("POST", "/lti/launch", b"x" * 200_000)[0], 413)
        for path in ("/lti/", "/lti/launch", "/lti/none", "/lti/login"):
            self.assertGreaterEqual(server.http("GET", path)[0], 400)
        self.assertEqual(server.http("GET", "/lti/jwks", Host="evil.example")[0], 421)
        self.assertEqual(self.send(fields, cookie)[0], 303)


class OfSilentPlatform(LtiCase):
    def test_a_platform_that_does_not_answer_delays_only_its_own_launches(self):
        with socket.socket() as silent:
            silent.bind(("127.0.0.1", 0))
            silent.listen(8)
            server = self.begin(jwks_url=f"http://127.0.0.1:{silent.getsockname()[1]}/jwks")
            with concurrent.futures.ThreadPoolExecutor(8) as pool:
                launches = [pool.submit(self.launch, "ada") for _ in range(8)]
                place = server.new_place()
                waits, _ = silent.accept()
                self.addCleanup(waits.close)
                for _ in range(5):
                    self.assertEqual(server.http("GET", f"/api/p/{place}")[0], 200)
                self.assertFalse(any(launch.done() for launch in launches), "they wait for the keys")
                waits.close()
                for launch in launches:
                    status, _, body = launch.result()
                    self.assertEqual(status, 502)
                    self.assertIn("keys of Test school cannot be read", body)


class Teachers(LtiCase):
    options = ("--token", "secret")

    def test_the_token_of_the_server_comes_along(self):
        server = self.begin()
        ada = self.launch("ada")[1]
        self.assertTrue(ada.endswith("/#token=secret&lesson=01-a-rule"), ada)
        teacher = self.launch("teacher")[1]
        self.assertRegex(teacher, r"^/class/\w+/#token=secret$")
        key = teacher.split("/")[2]
        self.assertEqual(server.http("GET", f"/api/class/{key}")[0], 401)
        status, told = server.json("GET", f"/api/class/{key}", Authorization="Bearer secret")
        self.assertEqual((status, [learner["name"] for learner in told["learners"]]), (200, ["Ada Lovelace"]))
        sent = server.json("POST", f"/api/class/{key}/message", b'{"text":"hello"}', Authorization="Bearer secret")
        self.assertEqual(sent[0], 200)
        told = server.json("GET", f"/api/class/{key}", Authorization="Bearer secret")[1]
        self.assertEqual([note["text"] for note in told["learners"][0]["notes"]], ["hello"])

    def test_a_teacher_chooses_a_lesson_for_the_course(self):
        self.begin()
        status, location, body = self.launch("teacher", chooses=True)
        self.assertEqual((status, location), (200, None), body)
        policy = self.headers["Content-Security-Policy"]
        forms = re.findall(r'<form method="post" action="([^"]*)"><input type="hidden" name="JWT" value="([^"]*)"><button>([^<]*)</button>', body)
        lessons = self.server.json("GET", f"/api/p/{self.place('ada')}", Authorization="Bearer secret")[1]["lessons"]
        self.assertEqual(len(forms), len(lessons) + 1)
        self.assertEqual({action for action, _, _ in forms}, {self.platform.url + "/chosen"})
        for index in (1, -1):
            status, told = self.platform.ask("/chosen", urllib.parse.urlencode({"JWT": forms[index][1]}).encode())
            self.assertEqual(status, 200, told)
        one, all_of_them = self.platform.noted()["choices"]
        self.assertEqual([item["custom"]["lesson"] for item in one], [lessons[1]["name"]])
        self.assertEqual([item["title"] for item in all_of_them], [lesson["title"] for lesson in lessons])
        self.assertIn(f"form-action {self.platform.url};", policy)
        self.assertIn(f"frame-ancestors 'self' {self.platform.url}", policy)
        self.assertNotIn("script", policy.replace("default-src 'none'", ""))

    def test_canvas_can_read_its_configuration(self):
        server = self.begin()
        status, told = server.json("GET", "/lti/canvas.json")
        self.assertEqual(status, 200)
        self.assertEqual(told["oidc_initiation_url"], server.origin + "/lti/login")
        keys = server.json("GET", "/lti/jwks")[1]["keys"]
        self.assertEqual([sorted(key) for key in keys], [["alg", "e", "kid", "kty", "n", "use"]])
        self.assertEqual((self.folder / "state" / "lti_keys.json").stat().st_mode & 0o077, 0, "only the server reads its keys")


class Scores(LtiCase):
    def test_a_graded_lesson_sends_a_score(self):
        self.begin()
        ada = self.place("ada", item="7")
        self.grade(ada, solution=False)
        self.wait_for(lambda: len(self.scores()) == 1, "the try that failed is sent")
        first = self.scores()[0]
        self.assertEqual((first["item"], first["userId"], first["scoreGiven"], first["scoreMaximum"], first["activityProgress"], first["gradingProgress"]),
                         ("7", "user-ada", 0, 1, "InProgress", "FullyGraded"))
        self.assertIn("1 try", first["comment"])
        self.grade(ada, solution=True)
        self.wait_for(lambda: len(self.scores()) == 2, "the pass is sent")
        second = self.scores()[1]
        self.assertEqual((second["scoreGiven"], second["activityProgress"]), (1, "Completed"))
        noted = self.platform.noted()
        self.assertEqual((noted["tokens"], noted["refused"]), (1, []), "one access token serves several scores")
        self.assertEqual(self.table()["scores"], {"sent": 1, "waiting": 0, "refused": 0, "trouble": ""})

    def test_a_score_waits_for_a_platform_that_fails_and_survives_a_killed_server(self):
        self.begin()
        self.platform.set(failures=[503, 429, 500])
        bob = self.place("bob")
        self.grade(bob, solution=True)
        self.wait_for(lambda: self.platform.noted()["attempts"] >= 1, "it was tried once")
        self.wait_for(lambda: "status 503" in self.table().get("scores", {}).get("trouble", ""), "the teacher sees why")
        self.server.kill()
        self.again()
        self.wait_for(lambda: self.scores(userId="user-bob"), "it is sent at last")
        self.assertEqual(self.scores(userId="user-bob")[0]["scoreGiven"], 1)
        self.wait_for(lambda: self.table()["scores"]["sent"] == 1, "and not again")
        self.assertEqual(len(self.scores()), 1)

    def test_an_access_token_that_was_withdrawn_is_asked_for_again(self):
        self.begin()
        self.platform.set(failures=[401])
        self.grade(self.place("ada"), solution=True)
        self.wait_for(lambda: self.scores(), "the second try has a new token")
        self.assertEqual(self.platform.noted()["tokens"], 2)

    def test_a_score_that_the_platform_refuses_is_not_sent_again_until_the_next_launch(self):
        self.begin()
        self.platform.set(failures=[404])
        ada = self.place("ada")
        self.grade(ada, solution=True)
        self.wait_for(lambda: self.table().get("scores", {}).get("refused") == 1, "the platform does not want it")
        self.assertIn("404", self.table()["scores"]["trouble"])
        self.assertEqual(self.platform.noted()["attempts"], 1)
        self.place("ada")
        self.wait_for(lambda: len(self.scores()) == 1, "it is offered again")

    def test_what_was_reached_before_the_link_had_a_grade_is_sent_with_the_next_launch(self):
        self.begin()
        endpoint = "https://purl.imsglobal.org/spec/lti-ags/claim/endpoint"
        ada = self.place("ada", remove=[endpoint])
        self.grade(ada, solution=True)
        self.assertNotIn("scores", self.table())
        self.assertEqual(self.place("ada"), ada)
        self.wait_for(lambda: len(self.scores()) == 1, "the pass is sent")


@unittest.skipUnless(shutil.which("openssl"), "openssl is not installed")
class OverTls(LtiCase):
    def start_platform(self):
        import ssl
        self.certificate = self.folder / "certificate.pem"
        subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost",
                        "-keyout", self.folder / "key.pem", "-out", self.certificate], check=True, capture_output=True)
        platform = Platform(self, self.certificate, self.folder / "key.pem")
        platform.context = ssl.create_default_context(cafile=str(self.certificate))
        return platform

    def trust(self, file):
        before = os.environ.get("SSL_CERT_FILE")
        os.environ["SSL_CERT_FILE"] = str(file)
        self.addCleanup(lambda: os.environ.pop("SSL_CERT_FILE") if before is None else os.environ.update(SSL_CERT_FILE=before))

    def test_a_platform_whose_certificate_is_trusted_is_asked(self):
        self.trust(self.certificate)
        self.begin()
        self.grade(self.place("ada"), solution=True)
        self.wait_for(lambda: len(self.scores()) == 1, "the score is sent over TLS")

    def test_one_whose_certificate_is_not_trusted_is_not(self):
        self.trust("/dev/null")
        self.begin()
        status, _, body = self.launch("ada")
        self.assertEqual(status, 502)
        self.assertIn("no certificate that this machine trusts", body)

    def test_one_whose_certificate_has_another_name_is_not(self):
        self.trust(self.certificate)
        self.begin(jwks_url=self.platform.url.replace("localhost", "127.0.0.1") + "/jwks")
        status, _, body = self.launch("ada")
        self.assertEqual(status, 502)
        self.assertIn("certificate", body)


class Files(ServeCase):
    def test_a_file_with_a_mistake_is_named_with_its_place(self):
        file = self.folder / "lti.json"
        for text, words in (("{", "this is not JSON"), ("{}", "needs the field 'url'"), ('{"url": "http://soar.example", "platforms": []}', "needs https://")):
            file.write_text(text, encoding="utf-8")
            with self.subTest(text=text), self.assertRaisesRegex(AssertionError, words):
                self.serve("--lti", file)

    def test_without_platforms_nobody_may_launch(self):
        status, told = self.serve().json("GET", "/lti/jwks")
        self.assertEqual(status, 404)
        self.assertIn("--lti", told["hint"])


if __name__ == "__main__":
    unittest.main()
