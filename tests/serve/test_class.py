# SPDX-License-Identifier: BSD-2-Clause
"""A class: raised hands, messages, mistakes, the arena; links to watch; pages of other sites."""
import csv
import io
import json
import os
import unittest

from web_client import ServeCase, WebSocket


class ClassCase(ServeCase):
    def begin(self, *names):
        (self.folder / "names.txt").write_text("".join(f"{name}\n" for name in names), encoding="utf-8")
        self.names = names
        return self.again()

    def again(self):
        server = self.serve("--class", self.folder / "names.txt")
        links = [server.process.stdout.readline().strip().rsplit(": ", 1)[1].removeprefix(server.origin) for _ in range(1 + len(self.names))]
        self.key, *self.places = [link.split("/")[2] for link in links]
        return server

    def post(self, server, path, **body):
        return server.json("POST", path, json.dumps(body).encode())

    def learners(self, server):
        return {learner["name"]: learner for learner in server.json("GET", f"/api/class/{self.key}")[1]["learners"]}

    def wait_for_learner(self, server, name, accepts, what):
        self.wait_for(lambda: accepts(self.learners(server)[name]), what)
        return self.learners(server)[name]


class Desk(ClassCase):
    def test_a_hand_is_raised_and_a_message_about_a_line_comes_and_is_read(self):
        server = self.begin("Ada", "Bob")
        ada, bob = self.places
        page = self.page(server, ada)
        self.assertEqual(page.until_message("class"), {"message": "class", "is_hand_up": False, "notes": []})
        self.assertEqual(self.post(server, f"/api/p/{ada}/hand", is_up=True)[0], 200)
        page.until(lambda message: message["message"] == "class" and message["is_hand_up"])
        learners = self.learners(server)
        self.assertGreaterEqual(learners["Ada"]["hand_s"], 0)
        self.assertIsNone(learners["Bob"]["hand_s"])
        text = "Look at the sign <s> & \"quotes\""
        self.assertEqual(self.post(server, f"/api/class/{self.key}/message", to=ada, text=text, file="/place/home/x/porter.soar", line=4)[0], 200)
        note = page.until(lambda message: message["message"] == "class" and message["notes"])["notes"][0]
        self.assertEqual((note["text"], note["file"], note["line"]), (text, "porter.soar", 4))
        self.assertEqual(self.learners(server)["Bob"]["notes"], [])
        self.post(server, f"/api/class/{self.key}/hand", place=ada)
        page.until(lambda message: message["message"] == "class" and not message["is_hand_up"])
        # A user who was away gets the message later, even after a restart of the server.
        self.post(server, f"/api/class/{self.key}/message", text="To all")
        self.assertEqual(server.stop(), 0)
        server = self.again()
        self.assertEqual((ada, bob), tuple(self.places))
        late = self.page(server, bob)
        self.assertEqual([each["text"] for each in late.until_message("class")["notes"]], ["To all"])
        self.assertEqual(self.post(server, f"/api/p/{bob}/notes/1")[0], 200)
        late.until(lambda message: message["message"] == "class" and not message["notes"])
        self.assertTrue(self.learners(server)["Bob"]["notes"][0]["is_read"])

    def test_what_cannot_be_is_refused_in_words(self):
        server = self.begin("Ada")
        ada, stranger = self.places[0], server.new_place()
        for path, body, word in ((f"/api/class/{self.key}/message", {"text": "  "}, "empty"),
                                 (f"/api/class/{self.key}/message", {"text": "x" * 2001}, "longer"),
                                 (f"/api/class/{self.key}/message", {"text": "x", "line": 3}, "needs the file"),
                                 (f"/api/class/{self.key}/message", {"text": "x", "to": stranger}, "nobody of the class"),
                                 (f"/api/class/{self.key}/arena/chess", {"seeds": 1}, "no game"),
                                 (f"/api/class/{self.key}/arena/eaters", {"seeds": 99}, "1 to 10 seeds"),
                                 (f"/api/class/{self.key}/arena/eaters", {"seeds": 1}, "two learners"),
                                 (f"/api/p/{ada}/arena/eaters", {"file": "worlds/eaters/scenario.toml"}, "not a file of rules"),
                                 (f"/api/p/{ada}/arena/eaters", {"file": "worlds/eaters/mine.soar"}, "no file of rules 'worlds"),
                                 (f"/api/p/{ada}/arena/eaters", {"file": "../../x.soar"}, "no file of rules"),
                                 (f"/api/p/{stranger}/hand", {"is_up": True}, "nobody in a class"),
                                 (f"/api/p/{ada}/notes/7", {}, "no message")):
            with self.subTest(path=path, body=body):
                status, told = self.post(server, path, **body)
                self.assertGreaterEqual(status, 400)
                self.assertIn(word, told["error"])
        self.assertEqual(server.json("POST", f"/api/class/{self.key}/message", b"[1]")[0], 400)
        self.assertEqual(self.post(server, "/api/class/wrong/message", text="x")[0], 404)

    def test_an_error_in_the_rules_is_named_with_its_line(self):
        server = self.begin("Ada")
        page = self.opened(server, self.places[0], "lesson:01-a-rule", "edit", "problems", "mission")
        page.ask(request="select", agent="porter")
        file = page.until_contents("edit", lambda edit: edit["files"])["files"][0]["file"]
        page.ask(request="edit", file=file)
        page.until_contents("edit", lambda edit: edit["edit"]["file"] == file)
        self.assertEqual(self.learners(server)["Ada"]["standing"], "works")
        text = "sp {greet\n   (state <s> ^io.input-link <in>\n-->\n   (write |hello|)}\n"
        page.ask(request="edit-text", what="check", text=text)
        # A watcher sees typed text before it is applied.
        watching = WebSocket(server, f"/api/p/{self.places[0]}/watch?key={self.key}")
        self.addCleanup(watching.close)
        watching.ask(request="look", panels=["edit"])
        shown = watching.until_contents("edit", lambda edit: edit["edit"]["text"] == text)
        self.assertTrue(shown["edit"]["is_unsaved"])
        page.ask(request="edit-text", what="apply", text=text)
        ada = self.wait_for_learner(server, "Ada", lambda one: one["standing"] == "mistake", "the mistake is known")
        self.assertRegex(ada["trouble"], r"^error in porter\.soar, line \d: ")
        for _ in range(3):
            page.ask(request="edit-text", what="check", text=text.replace("<in>\n", "<in>)\n"))
        self.wait_for_learner(server, "Ada", lambda one: one["standing"] == "works", "a mended text is not a mistake")

    def test_grades_are_a_row_for_each_learner_with_the_names_of_lessons(self):
        server = self.begin("Ada", "=1+1")
        _, headers, got = server.http("GET", f"/api/class/{self.key}.csv")
        self.assertIn("class.csv", headers["Content-Disposition"])
        rows = list(csv.DictReader(io.StringIO(got.decode())))
        self.assertEqual([row["learner"] for row in rows], ["Ada", "'=1+1"])
        titles = {lesson["title"] if not lesson["course"] else f'{lesson["course"]}: {lesson["title"]}' for lesson in server.json("GET", f"/api/class/{self.key}")[1]["lessons"]}
        self.assertEqual(set(rows[0]) - titles, {"learner", "passed", "tries", "hints", "last hint"})
        self.assertEqual(titles - set(rows[0]), set())
        page = self.opened(server, self.places[0], "lesson:01-a-rule", "mission")
        page.ask(request="lesson", what="hint")
        page.until_contents("mission", lambda mission: mission["lesson"]["hints"])
        _, headers, got = server.http("GET", f"/api/class/{self.key}-long.csv")
        rows = [row for row in csv.DictReader(io.StringIO(got.decode())) if row["hints"] != "0"]
        self.assertEqual([(row["learner"], row["lesson"], row["passed"], row["tries"], row["hints"]) for row in rows], [("Ada", "01-a-rule", "0", "0", "1")])


class Tournament(ClassCase):
    def test_learners_hand_in_and_all_pairs_play_each_match_a_replay(self):
        server = self.begin("Ada", "Bob", "Åsa <b>")
        for place, rules in zip(self.places, ("greedy", "wanderer", "broken")):
            page = self.opened(server, place, "scenario:eaters", "agents")
            page.until_contents("agents")
            page.close()
            if rules == "broken":
                server.http("PUT", f"/api/p/{place}/files/worlds/eaters/broken.soar", b"sp {lost\n")
            status, arena = self.post(server, f"/api/p/{place}/arena/eaters", file=f"/place/home/worlds/eaters/{rules}.soar")
            self.assertEqual(status, 200, arena)
            self.assertEqual(arena["games"][0]["mine"]["file"], f"{rules}.soar")
        self.assertEqual([game["name"] for game in arena["games"]], ["eaters", "tanksoar"])
        self.assertEqual(self.post(server, f"/api/class/{self.key}/arena/eaters", seeds=2)[0], 200)
        self.assertIn("being played", self.post(server, f"/api/class/{self.key}/arena/eaters", seeds=2)[1]["error"])
        played = lambda: server.json("GET", f"/api/class/{self.key}/arena")[1]["games"][0]["tournament"]
        self.wait_for(lambda: not played()["is_playing"], "all matches are played")
        told = played()
        self.assertEqual(len(told["matches"]), 6)
        self.assertEqual({(*sorted(match["learners"]), match["seed"]) for match in told["matches"]},
                         {(one, two, seed) for one, two in (("Ada", "Bob"), ("Ada", "Åsa <b>"), ("Bob", "Åsa <b>")) for seed in (1, 2)})
        self.assertEqual([row["learner"] for row in told["ladder"]], ["Ada", "Bob", "Åsa <b>"])
        self.assertEqual([(row["won"], row["lost"]) for row in told["ladder"]], [(4, 0), (2, 2), (0, 4)], told)
        # A match is a recording that everybody with its id can watch, with the reasons of both players.
        match = next(match for match in told["matches"] if match["learners"] == ["Ada", "Bob"])
        viewer = self.page(server, server.new_place())
        viewer.until_message("none")
        viewer.ask(request="open", what=f"match:{match['replay']}")
        hello = viewer.until(lambda message: message["message"] in ("hello", "error", "ended"))
        self.assertEqual((hello["message"], hello.get("is_recording"), hello.get("minds"), hello.get("seed")), ("hello", True, ["ada", "bob"], match["seed"]))
        viewer.ask(request="look", panels=["why", "memory"])
        viewer.ask(request="seek", tick=60)
        viewer.ask(request="select", agent="ada")
        viewer.ask(request="ask", about="doing")
        viewer.until_contents("why", lambda why: any(node["is"] == "tree" for node in why["document"]))
        # The working memory of that moment is recorded, too.
        viewer.until_contents("memory", lambda memory: "^operator" in json.dumps(memory))
        viewer.ask(request="open", what="match:" + "0" * 26)
        self.assertIn("nothing called", viewer.until_message("error")["error"])
        # The same matches have the same scores. Entries and matches are still there after a restart.
        self.assertEqual(server.stop(), 0)
        server = self.again()
        self.assertEqual(played(), told)
        self.post(server, f"/api/class/{self.key}/arena/eaters", seeds=2)
        self.wait_for(lambda: not played()["is_playing"], "all matches are played again")
        scores = lambda tournament: {(*match["learners"], match["seed"]): match["scores"] for match in tournament["matches"]}
        self.assertEqual(scores(played()), scores(told))
        self.assertEqual(len(os.listdir(self.folder / "state" / "arena" / "matches")), 6, "the matches before are gone")

    def test_tanks_fight_as_well(self):
        server = self.begin("Ada", "Bob")
        for place, rules in zip(self.places, ("hunter", "wanderer")):
            page = self.opened(server, place, "scenario:tanksoar", "agents")
            page.until_contents("agents")
            page.close()
            self.assertEqual(self.post(server, f"/api/p/{place}/arena/tanksoar", file=f"worlds/tanksoar/{rules}.soar")[0], 200)
        self.assertEqual(self.post(server, f"/api/class/{self.key}/arena/tanksoar", seeds=1)[0], 200)
        played = lambda: server.json("GET", f"/api/class/{self.key}/arena")[1]["games"][1]["tournament"]
        self.wait_for(lambda: not played()["is_playing"], "the match is played")
        self.assertEqual(played()["matches"][0]["trouble"], "")
        self.assertEqual(len(played()["matches"][0]["scores"]), 2)


class WatchLinks(ServeCase):
    def refused(self, server, path):
        socket = WebSocket(server, path)
        self.addCleanup(socket.close)
        return socket.status

    def test_a_link_shows_the_run_and_not_the_place_until_it_is_withdrawn(self):
        server = self.serve()
        place = server.new_place()
        page = self.opened(server, place, "scenario:soar_hallway", "agents")
        self.assertEqual(server.json("GET", f"/api/p/{place}/watch")[1], {"link": ""})
        link = server.json("POST", f"/api/p/{place}/watch", b"")[1]["link"]
        self.assertEqual(server.json("POST", f"/api/p/{place}/watch", b"")[1]["link"], link, "a place has one link")
        identity = link.split("/")[2]
        self.assertEqual(server.http("GET", link)[0], 200)
        status, _, about = server.http("GET", f"/api/w/{identity}")
        self.assertEqual(status, 200)
        watching = WebSocket(server, f"/api/w/{identity}/watch")
        self.addCleanup(watching.close)
        hello = watching.until_message("hello")
        self.assertFalse(hello["may_edit"])
        watching.ask(request="look", panels=["mind", "edit"])
        watching.until_contents("mind")
        watching.until(lambda message: len(watching.blocks) > 2)
        watching.ask(request="flow", what="pause")
        self.assertIn("only watch", watching.until_message("error")["error"])
        told = json.dumps([hello, watching.contents, watching.messages]) + about.decode() + watching.head
        self.assertNotIn(place, told, "the link of the place stays a secret")
        self.assertEqual(server.http("GET", f"/api/w/{place}")[0], 404)
        refused = lambda path: self.refused(server, path)
        self.assertEqual(refused(f"/api/w/{identity}/run"), 404)
        server.json("DELETE", f"/api/p/{place}/watch")
        self.assertEqual(server.json("GET", f"/api/w/{identity}")[0], 404)
        self.assertEqual(refused(f"/api/w/{identity}/watch"), 404)
        self.assertNotEqual(server.json("POST", f"/api/p/{place}/watch", b"")[1]["link"], link)
        page.ask(request="flow", what="pause")
        page.until(lambda message: message["message"] == "flow" and message["paused"])


class OtherSites(ServeCase):
    def test_only_named_sites_may_show_worlds_in_a_frame(self):
        server = self.serve("--embed", "https://school.example", "--embed", "http://127.0.0.1:9999")
        (self.folder / "page" / "assets").mkdir(exist_ok=True)
        policy = lambda path: server.http("GET", path)[1]["Content-Security-Policy"]
        self.assertIn("frame-ancestors https://school.example http://127.0.0.1:9999;", policy("/embed"))
        for path in ("/", f"/p/{server.new_place()}/", "/w/x/", "/class/x/", "/api/places"):
            self.assertIn("frame-ancestors 'none';", policy(path))
        # The page of another site may load only the script.
        self.assertEqual(server.http("GET", "/")[1]["Cross-Origin-Resource-Policy"], "same-origin")
        self.assertEqual(server.json("POST", "/api/places", b"", Origin="https://school.example")[0], 403)

    def test_without_embed_no_site_may(self):
        server = self.serve()
        status, told = server.json("GET", "/embed")
        self.assertEqual(status, 404)
        self.assertIn("--embed", told["hint"])
        for odd in ("school.example", "https://school.example/course", "https://*", "https://a;script-src *", "https://"):
            with self.subTest(odd=odd), self.assertRaisesRegex(AssertionError, "is not a site"):
                self.serve("--embed", odd)


if __name__ == "__main__":
    unittest.main()
