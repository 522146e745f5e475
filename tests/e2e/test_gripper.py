"""A client that has a robot take a puck elsewhere, as a Player program does."""

import math
import struct
import unittest

from house import ACK, CMD, POSITION2D, Client, HouseTest

GRIPPER = 3
OPEN, CLOSE, STOP = 1, 2, 3                          # commands
IS_OPEN, IS_CLOSED, IS_MOVING, IS_STOPPED = 1, 2, 3, 4
INNER_BEAM, OUTER_BEAM = 0x04, 0x08

WORLD = """
position( name "r0" size [0.4 0.4 0.2] gripper( pose [0.3 0 -0.2 0] ) )
model( name "puck" pose [1 0 0 30] size [0.08 0.08 0.1] gripper_return 1 obstacle_return 0 )
"""


class Gripper(HouseTest):
    def start(self):
        house = self.enterContext(self.run_house("--speed", 20, world=self.world(WORLD)))
        self.client = self.enterContext(Client(house.port()))
        for interf in (POSITION2D, GRIPPER):
            self.assertEqual(self.client.open(interf, 0).type, ACK)

    def command(self, subtype):
        self.client.send(GRIPPER, 0, CMD, subtype)

    def wait(self, good) -> tuple[int, int, int]:
        """State, beams and what is stored, once they are good."""
        while True:
            told = struct.unpack(">III", self.client.next_data(GRIPPER, 0).body)
            if good(*told):
                return told

    def drive_to(self, x, y, a=0.0) -> tuple[float, float, float]:
        """Its pose when it stands there."""
        self.client.send(POSITION2D, 0, CMD, 2, struct.pack(">ddddddI", x, y, a, 0, 0, 0, 1))
        while True:
            self.client.data = [each for each in self.client.data if each.interf != POSITION2D]
            at = struct.unpack(">ddddddI", self.client.next_data(POSITION2D, 0).body)[:3]
            if math.dist(at, (x, y, a)) < 0.03:
                self.client.drive(0, 0)
                return self.client.pose("r0")

    def test_a_puck_is_taken_along_and_put_down_elsewhere(self):
        self.start()
        self.assertEqual(self.wait(lambda *_: True), (IS_OPEN, 0, 0))
        self.drive_to(0.62, 0)
        self.wait(lambda state, beams, _: state == IS_OPEN and beams == OUTER_BEAM)
        self.command(CLOSE)
        self.wait(lambda state, *_: state == IS_MOVING)
        self.wait(lambda state, *_: state == IS_CLOSED)
        self.assertEqual(self.client.pose("puck"), (0, 0, 0), "in the gripper")
        self.drive_to(-0.5, 0.8, 1.0)
        self.command(OPEN)
        self.wait(lambda state, beams, _: state == IS_OPEN and beams == INNER_BEAM)
        x, y, a = self.client.pose("r0")
        puck = self.client.pose("puck")
        self.assertLess(math.dist(puck, (x + 0.3 * math.cos(a), y + 0.3 * math.sin(a), a)), 1e-9)
        self.drive_to(-1.5, 0, 0)
        self.assertEqual(self.client.pose("puck"), puck, "it stays")
        self.assertEqual(self.wait(lambda *_: True)[0], IS_OPEN)

    def test_it_stops_where_it_is_and_tells_its_size_and_place(self):
        self.start()
        answer = self.client.request(GRIPPER, 0, 1)
        self.assertEqual(answer.type, ACK)
        geometry = struct.unpack(">12dII", answer.body)
        for found, expected in zip(geometry, (0.3, 0, 0, 0, 0, 0, 0.3, 0.2, 0.2, 0.24, 0.132, 0.08, 2, 0)):
            self.assertAlmostEqual(found, expected)
        self.command(CLOSE)
        self.wait(lambda state, *_: state == IS_MOVING)
        self.command(STOP)
        self.wait(lambda state, *_: state == IS_STOPPED)
        self.command(OPEN)
        self.wait(lambda state, *_: state == IS_OPEN)


if __name__ == "__main__":
    unittest.main()
