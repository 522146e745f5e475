"""Custom models and clients from outside the tree: examples/custom is built with the installed package, and its world
runs."""

import json
import os
import re
import shutil
import sys
import unittest
from pathlib import Path
from unittest import mock

from house import ROOT, House, finish
from installed import InstalledTest, tool

EXAMPLE = ROOT / "examples" / "custom"

PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(outside LANGUAGES CXX)
find_package({package} 0.2 REQUIRED)
add_executable(listen listen.cc)
target_link_libraries(listen PRIVATE playhouse::client)
"""


class Libraries(InstalledTest):
    @classmethod
    def setUpClass(cls):
        """The example, built with the package alone."""
        super().setUpClass()
        cls.libraries = cls.place / "build"
        shutil.copytree(EXAMPLE, cls.place / "custom")
        cls.build(cls.place / "custom", cls.libraries)
        cls.yard = cls.place / "custom" / "yard.world"

    def setUp(self):
        super().setUp()
        self.enterContext(mock.patch.dict(os.environ, PLAYHOUSE_PATH=str(self.libraries)))

    def result_of(self, *arguments) -> dict:
        done = finish("run", *arguments, "--port", 0, "--headless", "--fast", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def run_beside(self, world, client, *arguments) -> str:
        """What a client, a program or one in Python, prints beside a run of the world."""
        environment = os.environ | {"PYTHONPATH": str(ROOT / "clients" / "python")}
        command = [sys.executable, client] if Path(client).suffix == ".py" else [client]
        with self.run_house(*arguments, world=world) as house:
            return tool(*command, f"127.0.0.1:{house.port()}", env=environment)

    def test_the_example_reads_the_counter_and_opens_the_gate_in_both_languages(self):
        for client in (EXAMPLE / "watch.py", self.libraries / "watch"):
            with self.subTest(client.name):
                told = self.run_beside(self.yard, client, "--speed", 5).splitlines()
                self.assertEqual(told[0], "the gate is open")
                counted = [(float(line.split()[0]), int(line.split()[3])) for line in told[1:]]
                self.assertGreaterEqual(counted[-1][0], 2.5, "it came past the gate")
                nearest = [counts for x, counts in counted if x > 1.5]
                farthest = [counts for x, counts in counted if x < -1]
                self.assertGreater(sum(nearest) / len(nearest), sum(farthest) / len(farthest) + 3)

    def test_a_client_is_built_by_the_packages_name_and_by_its_own(self):
        program = re.search(r"```cpp\n(.*?)```", (ROOT / "docs" / "radios.md").read_text(), re.DOTALL).group(1)
        for package in ("playhouse", "playhouse_client"):
            with self.subTest(package):
                folder = self.folder / package
                folder.mkdir()
                (folder / "CMakeLists.txt").write_text(PROJECT.format(package=package))
                (folder / "listen.cc").write_text(program)
                self.build(folder, folder / "build")
                self.assertTrue((folder / "build" / "listen").is_file())

    def test_runs_are_the_same_with_any_number_of_workers(self):
        world = self.write("many.world", self.yard.read_text() + self.many())
        runs = [self.result_of(world, "--duration", 20, "--workers", workers) for workers in (1, 2)]
        self.assertEqual(runs[0]["hash"], runs[1]["hash"])
        self.assertEqual(runs[0]["sensed_hash"], runs[1]["sensed_hash"])
        another = self.result_of(world, "--duration", 20, "--seed", 9)
        self.assertNotEqual(runs[0]["sensed_hash"], another["sensed_hash"], "counts are drawn from the seed")

    @staticmethod
    def many() -> str:
        """Counters that measure, and robots that make barriers move."""
        lines = ["define drone rover( alwayson 1 velocity [0.3 0 0 25] )"]
        for k in range(40):
            lines.append(f"geiger( pose [{k % 8} {5 + k // 8} 0 0] alwayson 1 )")
            lines.append(f"barrier( pose [{3 * (k % 8)} {-5 - 3 * (k // 8)} 0 {40 * k % 360}] alwayson 1 )")
        lines += [f"drone( pose [{3 * k} -6.5 0 {50 * k}] )" for k in range(8)]
        return "\n".join(lines)

    def test_a_saved_run_goes_on_the_same(self):
        world = self.write("many.world", self.yard.read_text() + self.many())
        saved = self.folder / "half.run"
        whole = self.result_of(world, "--duration", 20, "--save-at", 10, saved)
        rest = self.result_of("--from", saved, "--duration", 20)
        self.assertEqual(whole["hash"], rest["hash"])

    def test_no_file_and_no_peer_names_the_folder_of_a_library(self):
        """Code beside the world, which a saved run and a recording made of it name."""
        there, here = self.folder / "there", self.folder / "here"
        for folder in (there, here):
            folder.mkdir()
        libraries = [Path(shutil.copy(file, there)) for file in self.libraries.glob("*.so")]
        world = Path(shutil.copy(self.yard, there))
        with mock.patch.dict(os.environ, PLAYHOUSE_PATH=""):
            run, film = here / "half.run", here / "film.mcap"
            whole = self.result_of(world, "--duration", 2, "--save-at", 1, run, "--record", film)
            allowed = [word for library in libraries for word in ("--allow-library", library)]
            for begin in (("--from", run, "--duration", 2, "--port", 0, "--headless", "--fast"), ("--again", film)):
                with self.subTest(begin[0]):
                    done = finish("run", *begin)
                    self.assertEqual(done.returncode, 2, done.stderr)
                    self.assertRegex(done.stderr, rf'"\w+\.so" is not in {here}, .*--allow-library')
                    self.assertNotIn("loads", done.stderr + done.stdout)
                    done = finish("run", *begin, "--json", *allowed)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertEqual(json.loads(done.stdout)["hash"], whole["hash"])
            done = finish("replay", film, "--web", 0)
            self.assertEqual(done.returncode, 2, done.stderr)
            with House("run", world, "--cluster", 0, "--port", 0, "--headless", "--speed", 1) as head:
                done = finish("node", head.wait_for_line(r"^cluster nodes: (127\.0\.0\.1:\d+)$").group(1))
                self.assertNotEqual(done.returncode, 0, done.stderr)
                self.assertIn("is not in", done.stderr)

    def test_the_walk_of_the_documentation_leads_to_what_it_says(self):
        walk = self.build_walk("libraries.md", {"crowd.cc", "CMakeLists.txt", "crowd.world", "read.py"})
        with mock.patch.dict(os.environ, PLAYHOUSE_PATH=str(self.folder / "build")):
            told = self.run_beside(self.folder / "crowd.world", self.folder / "read.py")
        self.assertIn(f"It prints `{told.strip()}`:", walk)

    def test_check_finds_libraries_and_loads_none(self):
        done = finish("check", self.yard)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f'custom model "geiger" is {self.libraries}/geiger.so, which is there and not checked', done.stdout)

    def test_what_is_wrong_is_told_with_its_line(self):
        for library, told in (
                ("geiger", '"geiger": needs two arguments: BACKGROUND SOURCE'),
                ("geiger -1 2", '"geiger": BACKGROUND is at least 0, SOURCE not 0'),
                ("geigre 1 2", 'no custom model "geigre" (did you mean "geiger"?)')):
            world = self.write("bad.world", f'model( )\ncustom( library "{library}" )\n')
            done = finish("run", world, "--port", 0, "--headless", "--duration", 1)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, re.escape("bad.world:2: ") + ".*" + re.escape(told))


if __name__ == "__main__":
    unittest.main()
