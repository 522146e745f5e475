"""Where somebody who joins by the page comes into the world: beside what is in the way, and not far from everything."""

import math
import unittest

from house import Client, House, HouseTest
from viewer import Viewer

WORLD = """
include "person.inc"
interval_sim 50
person( name "guide" pose [-4 0 0 0] )
define crate model( size [0.8 0.8 0.8] mass 12 gripper_return 1 )
crate( name "crate" pose [2 0 0 0] )
model( name "wall" pose [0 -5 0 0] size [12 0.2 1.2] )
model( name "rock" pose [20 0 0 0] size [9 9 1] )
"""


class Joining(HouseTest):
    def start(self, engine: str):
        self.house = House("run", self.world(WORLD), "--port", 0, "--web", 0, "--engine", engine)
        self.addCleanup(self.house.__exit__)
        self.client = Client(self.house.port())
        self.addCleanup(self.client.close)

    def join(self, name: str, x: float, y: float) -> str | tuple[float, float]:
        """Where somebody is who asked for this place, or what they are told instead."""
        viewer = Viewer(int(self.house.wait_for_line(r"^web page: http://127\.0\.0\.1:(\d+)/").group(1)))
        self.addCleanup(viewer.close)
        viewer.send(do="join", name=name, x=x, y=y, a=0)
        viewer.turn_until(lambda: viewer.came or viewer.notices)
        if viewer.notices:
            return viewer.notices[0]
        return self.client.pose(viewer.models[viewer.came[0]]["name"])[:2]

    def test_somebody_comes_beside_what_is_in_the_way(self):
        # A person is 0.3 m by 0.5 m, looking along x.
        for engine in ("stage", "arena"):
            with self.subTest(engine):
                self.start(engine)
                x, y = self.join("Ada", 2.3, 0)
                self.assertLessEqual(math.hypot(x - 2.3, y), 0.25 + 0.051, "beside the crate, at its nearer side")
                self.assertGreaterEqual(x, 2 + 0.4 + 0.15)
                self.assertLess(math.dist(self.client.pose("crate")[:2], (2, 0)), 0.01, "it is not thrown")
                x, y = self.join("Bob", 0, -4.95)
                self.assertLessEqual(math.hypot(x, y + 4.95), 0.3 + 0.051, "the nearest, to a step")
                self.assertTrue(-4.9 + 0.25 <= y <= -4.9 + 0.25 + 0.06, f"on the nearer side of the wall: {y}")

    def test_somebody_does_not_come_into_a_rock_or_far_from_everything(self):
        for engine in ("stage", "arena"):
            with self.subTest(engine):
                self.start(engine)
                self.assertIn("there is no free place within 2 m of 20.00 0.00", self.join("Ada", 20, 0))
                self.assertIn("900000.00 0.00 is more than 1000 m from everything in the world", self.join("Bob", 900e3, 0))


if __name__ == "__main__":
    unittest.main()
