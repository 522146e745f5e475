"""Drivers that use devices of other drivers: a chain of them in a configuration file, from a scan to the wheels."""

import json
import math
import struct
import unittest

from house import ACK, CMD, POSITION2D, ROOT, SIMULATION, Client, House, HouseTest

GOAL = (6.5, 0.0, 0.0)  # behind a crate and a wall with a gap, which are right ahead
PAUSE = 1               # command of simulation: a paused world goes on


class Chain(HouseTest):
    """worlds/avoid.cfg: ranger -> rangertolaser -> vfh -> position2d."""

    def drive(self, *arguments) -> tuple[dict, list[tuple[float, ...]]]:
        """One run as fast as possible, in which the robot is given its goal before the first tick. The result, and what
        its STATE said: x, y, heading, their velocities, stall."""
        with House("serve", ROOT / "worlds/avoid.cfg", "--port", 0, "--headless", "--fast", "--paused", "--duration", 60,
                   "--json", *arguments) as house, Client(house.port()) as client:
            self.assertEqual(client.open(POSITION2D, 1).type, ACK)
            client.send(POSITION2D, 1, CMD, 2, struct.pack(">ddddddI", *GOAL, 0, 0, 0, 1))
            client.send(SIMULATION, 0, CMD, PAUSE)
            states = []
            with self.assertRaises(ConnectionError):  # the end of the run
                while True:
                    states.append(struct.unpack(">ddddddI", client.next_data(POSITION2D, 1).body))
            self.assertEqual(house.wait(), 0, house.log())
            return json.loads(house.output()), states

    def test_a_robot_drives_round_what_is_in_its_way_to_the_same_bits_each_time(self):
        result, states = self.drive()
        self.assertLess(math.dist(states[-1][:2], GOAL[:2]), 0.25)
        self.assertLess(abs(states[-1][2] - GOAL[2]), math.radians(12))
        self.assertEqual(states[-1][3:6], (0, 0, 0), "it stands at its goal")
        self.assertFalse(any(state[6] for state in states), "it touches nothing")
        self.assertGreater(max(abs(state[1]) for state in states), 0.8, "straight ahead there is a crate")
        for arguments in ((), ("--workers", 4)):
            again, _ = self.drive(*arguments)
            for word in ("ticks", "hash", "sensed_hash"):
                self.assertEqual(again[word], result[word])

    def test_the_documented_section_is_that_of_the_example(self):
        documented = (ROOT / "docs/drivers.md").read_text().split('## driver "vfh"')[1].split("```")[1]
        self.assertIn(documented.strip(), (ROOT / "worlds/avoid.cfg").read_text())


if __name__ == "__main__":
    unittest.main()
