"""The same world and seed give the same bits: twice, with any number of workers, in debug and release programs."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

from house import (ACK, FIDUCIAL, PATIENCE, POSITION2D, PROGRAM, RANGER, ROOT, SONAR, Client, House, HouseTest,
                   finish)

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import connect  # noqa: E402

SWARM = """
interval_sim 100
define robot position( size [0.44 0.38 0.22] localization "odom"
  ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 60 noise [0.01 0.01 0] ) ) ctrl "wander" )
model( name "walls" size [20 20 1] boundary 1 noblocks 1 )
"""


def swarm() -> str:
    robots = (f"robot( name \"r{i}\" pose [{-8 + i % 8 * 2.1} {-8 + i // 8 * 2.1} 0 {i * 37 % 360}] )" for i in range(64))
    return SWARM + "\n".join(robots)


# A robot with a controller, which reads its scanner, and sensors that only clients read.
WATCHED = """
interval_sim 100
position( name "r0" size [0.44 0.38 0.22] fiducial_return 1 ctrl "wander"
  ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 60 noise [0.01 0.01 0] ) )
  ranger( size [0.1 0.1 0.1] sensor( range [0 5] fov 10 noise [0 0.05 0.1] ) sensor( pose [0 0 0 90] range [0 5] fov 10 ) )
  fiducial( range_max 8 fov 360 ) )
model( name "beacon" pose [3 1 0 0] size [0.2 0.2 1] fiducial_return 7 )
model( name "walls" size [10 10 1] boundary 1 noblocks 1 )
"""


class Reproducible(HouseTest):
    def result_of(self, *arguments, world=None, program=None) -> dict:
        done = finish("run", world or self.world(swarm()), "--port", 0, "--headless", "--fast", "--duration", 10,
                      "--json", *arguments, program=program)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def hashes_of(self, *arguments, **more) -> tuple[str, str]:
        result = self.result_of(*arguments, **more)
        return result["hash"], result["sensed_hash"]

    def test_twice_the_same(self):
        self.assertEqual(self.hashes_of(), self.hashes_of())

    def test_the_same_with_one_two_and_four_workers(self):
        self.assertEqual({self.hashes_of("--workers", workers) for workers in (1, 2, 4)}, {self.hashes_of()})

    def test_another_seed_is_another_run(self):
        for first, second in zip(self.hashes_of("--seed", 1), self.hashes_of("--seed", 2)):
            self.assertNotEqual(first, second)

    def test_whoever_watches_changes_what_is_sensed_and_nothing_that_robots_do(self):
        world = self.world(WATCHED)
        alone = self.result_of(world=world)
        with House("run", world, "--port", 0, "--headless", "--speed", 5, "--duration", 10, "--json") as house, \
                Client(house.port()) as client:
            for interf, index in ((POSITION2D, 0), (RANGER, 0), (RANGER, 1), (SONAR, 0), (FIDUCIAL, 0)):
                self.assertEqual(client.open(interf, index).type, ACK)
                client.next_data(interf, index)
            self.assertEqual(house.wait(), 0, house.log())
            watched = json.loads(house.output())
        self.assertEqual((watched["ticks"], watched["hash"]), (alone["ticks"], alone["hash"]))
        self.assertNotEqual(watched["sensed_hash"], alone["sensed_hash"])

    def hash_with_readers(self, world: Path, engine: str, opens: bool) -> str:
        """Of a run of 20 ticks, of which a client of another connection has every device open but for the first."""
        with House("run", world, "--engine", engine, "--port", 0, "--headless", "--lock-step", "--duration", 1000, "--json",
                   program=self.release()) as house:
            with connect(f":{house.port()}", timeout=PATIENCE) as stepper, Client(house.port()) as reader:
                stepper.simulation(0).step(1)
                for interf, index in reader.devices()[:500] if opens else ():
                    self.assertEqual(reader.open(interf, index).type, ACK)
                stepper.simulation(0).step(19)
            self.assertEqual(house.end(signal.SIGINT), 130, house.log())
            result = json.loads(house.output())
        self.assertEqual(result["ticks"], 20)
        return result["hash"]

    def test_whoever_opens_every_device_of_an_example_world_changes_nothing(self):
        worlds = self.folder / "worlds"
        shutil.copytree(ROOT / "worlds", worlds)
        for file in [*worlds.glob("*.world"), *worlds.glob("*.inc")]:  # batteries for all robots
            file.write_text(re.sub(r"\bposition\s*\(", "position( joules 5000 ", file.read_text()))
        for world in sorted(worlds.glob("*.world")):
            for engine in ("stage", "arena") if world.stem == "gripper" else ("stage",):
                with self.subTest(world.stem, engine=engine):
                    self.assertEqual(self.hash_with_readers(world, engine, True), self.hash_with_readers(world, engine, False))

    def test_the_release_program_computes_the_same_bits(self):
        self.assertEqual(self.hashes_of(), self.hashes_of(program=self.release()))

    def bench(self, program, instruction_set, engine="stage"):
        with mock.patch.dict(os.environ, PLAYHOUSE_INSTRUCTION_SET=instruction_set):
            return finish("bench", "laser", "--engine", engine, "--robots", 50, "--duration", 2, program=program)

    def test_all_instruction_sets_compute_the_same_bits(self):
        for engine in ("stage", "arena"):
            with self.subTest(engine=engine):
                self.check_instruction_sets(engine)

    def check_instruction_sets(self, engine):
        flags = Path("/proc/cpuinfo").read_text()
        if "avx2" not in flags:
            self.skipTest("this processor has no AVX2: THE AVX2 VERSIONS ARE NOT TESTED HERE")
        sets = ["plain", "avx2", "avx512-emulated"]
        if all(flag in flags for flag in ("avx512f", "avx512dq", "avx512vl")):
            sets.append("avx512")
        hashes = set()
        for program in (PROGRAM, self.release()):
            for instruction_set in sets:
                done = self.bench(program, instruction_set, engine)
                self.assertEqual(done.returncode, 0, done.stderr)
                result = json.loads(done.stdout)
                self.assertEqual(result["instruction_set"], instruction_set)
                hashes.add((result["hash"], result["sensed_hash"]))
        self.assertEqual(len(hashes), 1)

    def test_an_instruction_set_that_nobody_has_is_an_error(self):
        done = self.bench(PROGRAM, "avx3")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertEqual(done.stderr, 'error: PLAYHOUSE_INSTRUCTION_SET: there is no instruction set "avx3" '
                                      '(did you mean "avx2"?)\n')

    def test_the_worlds_of_this_tree_run_alike(self):
        worlds = sorted((ROOT / "worlds").glob("*.world"))
        self.assertTrue(worlds)
        for world in worlds:
            with self.subTest(world=world.name):
                self.assertEqual(self.hashes_of("--workers", 1, world=world), self.hashes_of("--workers", 4, world=world))


# All robots of the program share its speed, so that the second run is another.
FORGETFUL = """
#include "playhouse/controllers/controller.h"
namespace pc = playhouse::controllers;
class Forgetful : public pc::Controller {
  void decide(pc::Robot& robot) override {
    static int calls = 0;
    robot.drive(0.001 * ++calls, 0);
  }
};
PLAYHOUSE_CONTROLLER(Forgetful)
"""


class Saved(HouseTest):
    """What is saved goes on as what ran through."""

    def setUp(self):
        super().setUp()
        self.saved = Path(self.world("")).parent / "saved.run"

    def run_of(self, *arguments) -> tuple[dict, str]:
        done = finish("run", *arguments, "--port", 0, "--headless", "--fast", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout.splitlines()[-1]), done.stderr

    def refused(self, *arguments) -> str:
        done = finish("run", *arguments, "--port", 0, "--headless", "--fast")
        self.assertNotEqual(done.returncode, 0)
        errors = [line for line in done.stderr.splitlines() if "error" in line]
        self.assertEqual(len(errors), 1, done.stderr)
        return errors[0]

    def test_a_saved_run_goes_on_to_the_same_end(self):
        for world in (self.world(swarm()), self.write("watched.world", WATCHED), ROOT / "worlds/cave.world"):
            through, _ = self.run_of(world, "--duration", 12, "--seed", 9, "--save-at", 5.05, self.saved)
            for workers in (1, 3):
                on, _ = self.run_of("--from", self.saved, "--duration", 12, "--workers", workers)
                self.assertEqual((on["ticks"], on["hash"]), (through["ticks"], through["hash"]), world)

    def test_the_scene_is_in_the_file(self):
        world = Path(self.world(swarm()))
        through, _ = self.run_of(world, "--duration", 3, "--save-at", 1, self.saved)
        world.unlink()
        on, _ = self.run_of("--from", self.saved, "--duration", 3)
        self.assertEqual(on["hash"], through["hash"])

    def test_a_run_is_saved_again_and_at_its_first_tick(self):
        world, second = self.world(swarm()), self.saved.with_name("second.run")
        through, _ = self.run_of(world, "--duration", 4, "--save-at", 0, self.saved)
        self.run_of("--from", self.saved, "--duration", 3, "--save-at", 2, second)
        on, _ = self.run_of("--from", second, "--duration", 4)
        self.assertEqual(on["hash"], through["hash"])

    def test_a_file_that_is_no_saved_run_is_refused_in_one_line(self):
        self.run_of(self.world(swarm()), "--duration", 1, "--save-at", 1, self.saved)
        whole = self.saved.read_bytes()
        other = self.saved.with_name("other.run")
        for content, why in ((b"", "not a saved run"), (b"name \"x\"", "not a saved run"), (whole[:15], "not a saved run"),
                             (whole[:40], "cut"), (whole[:-1], "cut"), (whole + b"x", "damaged"),
                             (whole.replace(b"saved run 5\n", b"saved run 4\n", 1), 'format "4"; this program reads format 5'),
                             (whole[:200] + bytes([whole[200] ^ 1]) + whole[201:], "damaged")):
            other.write_bytes(content)
            line = self.refused("--from", other)
            self.assertIn(str(other), line)
            self.assertIn(why, line)
        self.assertIn("cannot be opened: no such file", self.refused("--from", other.with_name("none.run")))

    def test_a_save_that_fails_is_an_error(self):
        self.assertIn("before 9 s", self.refused(self.world(swarm()), "--duration", 1, "--save-at", 9, self.saved))
        nowhere = self.saved.parent / "none" / "x.run"
        self.assertIn("cannot be written", self.refused(self.world(swarm()), "--duration", 1, "--save-at", 1, nowhere))

    def test_verify_finds_runs_the_same(self):
        done = finish("verify", self.world(swarm()), "--ticks", 30, "--workers", "1,2,4")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("30 ticks are the same with 1, 2, 4 workers", done.stdout)

    def test_verify_names_what_differs(self):
        release = self.release()
        source = self.write("forgetful.cc", FORGETFUL)
        folder = source.parent
        built = subprocess.run(["g++", "-std=c++20", "-shared", "-fPIC", "-I", ROOT, "-o", folder / "forgetful.so", source],
                               capture_output=True, text=True)
        self.assertEqual(built.returncode, 0, built.stderr)
        world = self.world('position( name "a" alwayson 1 )\nposition( name "b" alwayson 1 ctrl "forgetful" )\n')
        done = finish("verify", world, "--ticks", 20, program=release)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn('model "b" (id 1), column models.X_PM', done.stdout)
        done = finish("run", world, "--port", 0, "--headless", "--fast", "--duration", 1, "--save-at", 1, self.saved,
                      program=release)
        self.assertEqual(done.returncode, 1)
        self.assertIn('controller "forgetful" of "b" cannot be saved', done.stderr)


if __name__ == "__main__":
    unittest.main()
