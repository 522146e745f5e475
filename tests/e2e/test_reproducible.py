"""The same world and seed give the same bits: twice, with any number of workers, in debug and release programs."""

import json
import os
import unittest

from house import RELEASE, ROOT, HouseTest, finish

SWARM = """
interval_sim 100
define robot position( size [0.44 0.38 0.22] localization "odom"
  ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 60 noise [0.01 0.01 0] ) ) ctrl "wander" )
model( name "walls" size [20 20 1] boundary 1 noblocks 1 )
"""


def swarm() -> str:
    robots = (f"robot( name \"r{i}\" pose [{-8 + i % 8 * 2.1} {-8 + i // 8 * 2.1} 0 {i * 37 % 360}] )" for i in range(64))
    return SWARM + "\n".join(robots)


class Reproducible(HouseTest):
    def hash_of(self, *arguments, world=None, program=None) -> str:
        done = finish("run", world or self.world(swarm()), "--port", 0, "--headless", "--fast", "--duration", 10,
                      "--json", *arguments, program=program)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["hash"]

    def test_twice_the_same(self):
        self.assertEqual(self.hash_of(), self.hash_of())

    def test_the_same_with_one_two_and_four_workers(self):
        self.assertEqual({self.hash_of("--workers", workers) for workers in (1, 2, 4)}, {self.hash_of()})

    def test_another_seed_is_another_run(self):
        self.assertNotEqual(self.hash_of("--seed", 1), self.hash_of("--seed", 2))

    def test_the_release_program_computes_the_same_bits(self):
        if not os.path.exists(RELEASE):
            self.skipTest("there is no release program; `make build` makes it")
        self.assertEqual(self.hash_of(), self.hash_of(program=RELEASE))

    def test_the_worlds_of_this_tree_run_alike(self):
        worlds = sorted((ROOT / "worlds").glob("*.world"))
        self.assertTrue(worlds)
        for world in worlds:
            with self.subTest(world=world.name):
                self.assertEqual(self.hash_of("--workers", 1, world=world), self.hash_of("--workers", 4, world=world))


if __name__ == "__main__":
    unittest.main()
