"""The experiments of scenarios/, with scripted people: they end, count what happened, and run the same way twice."""

import json
import os
import subprocess
import sys
import unittest

from house import PROGRAM, ROOT, House, HouseTest


class Scenarios(HouseTest):
    def play(self, name: str, *options) -> dict:
        results = self.folder / "results.json"
        done = subprocess.run(
            [sys.executable, ROOT / f"scenarios/{name}/{name}.py", "--fast", "--results", results, *map(str, options)],
            env={**os.environ, "PLAYHOUSE_PROGRAM": PROGRAM}, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return json.loads(results.read_text())

    def test_robots_guard_and_people_try_to_get_in(self):
        record = self.folder / "perimeter.mcap"
        results = self.play("perimeter", "--stand-ins", 3, "--seconds", 40, "--record", record)
        events = [event["event"] for event in results["events"]]
        score = results["score"]
        self.assertEqual(score["guards"], events.count("was caught"))
        self.assertEqual(score["intruders"], events.count("reached the cargo"))
        self.assertGreater(score["guards"], 0)
        self.assertGreater(score["intruders"], 0)
        self.assertEqual(set(score["people"]), {"ann", "bo", "cy"})
        self.assertEqual(results["seconds"], 40)
        with House("run", "--again", record, "--headless", "--port", 0) as again:
            self.assertEqual(again.wait(), 0, again.log())
            again.wait_for_line("the same run to the bit")

    def test_people_and_robots_find_all_parcels(self):
        results = self.play("search", "--stand-ins", 2, "--seed", 2)
        self.assertEqual((results["score"]["found"], results["score"]["mistakes"]), (6, 0))
        self.assertEqual(sum(results["score"]["by"].values()), 6)
        self.assertEqual({event["what"] for event in results["events"]}, {f"parcel{i}" for i in range(6)})
        finders = {event["who"] for event in results["events"]}
        self.assertTrue(finders & {"robot0", "robot1"} and finders & {"ann", "bo"}, finders)

    def test_the_same_seed_gives_the_same_results(self):
        self.assertEqual(*(self.play("search", "--stand-ins", 1, "--seed", 5, "--seconds", 15) for _ in range(2)))

    def test_wrong_options_are_one_line(self):
        for options, why in (
            (["--fast"], "needs --stand-ins"), (["--stand-ins", "9"], "from 0 to 4"), (["--seconds", "0"], "more than 0"),
            (["--stand-ins", "1", "--program", "/nowhere"], "make build makes it"),
            (["--stand-ins", "1", "--results", "/nowhere/results.json"], "/nowhere/results.json: No such file"),
        ):
            done = subprocess.run([sys.executable, ROOT / "scenarios/perimeter/perimeter.py", *options],
                                  capture_output=True, text=True, check=False, cwd=self.folder)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(why, done.stderr.splitlines()[-1])
            self.assertNotIn("Traceback", done.stderr)


if __name__ == "__main__":
    unittest.main()
