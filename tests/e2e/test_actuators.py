"""Actuators through a Player client."""

import struct
import unittest

from house import ACK, CMD, NACK, POSITION2D, ROOT, Client, HouseTest

ACTARRAY = 53
GET_GEOM, POWER = 3, 1
POS, SPEED, STATE = 1, 3, 1

WORLD = """
interval_sim 100
model( name "wall" size [0.1 2 1] pose [2 0 0 0] )
position( name "r0" size [0.4 0.4 0.2]
  actuator( name "arm" pose [0.2 0 0 0] size [0.2 0.1 0.1] max_position 3 start_position 0.1 )
  actuator( name "joint" type "rotational" max_position 1.5 size [0.1 0.1 0.1] obstacle_return 0 ) )
"""
IDLE, STALLED = 1, 8


def state(message) -> tuple:
    """position, velocity, state, motors on; there is one joint"""
    count, _, position, velocity, _, current, what, motors = struct.unpack(">IIffffII", message.body)
    assert count == 1 and current == -1
    return position, velocity, what, motors


class Actuators(HouseTest):
    def connect(self, world=None):
        house = self.run_house("--speed", 20, world=world or self.world(WORLD))
        self.addCleanup(house.__exit__)
        self.client = Client(house.port())
        self.addCleanup(self.client.close)

    def wait_for(self, index: int, done) -> tuple:
        while not done(now := state(self.client.next_data(ACTARRAY, index, STATE))):
            pass
        return now

    def test_a_slide_and_a_joint_go_where_they_are_told(self):
        self.connect()
        for index in (0, 1):
            self.assertEqual(self.client.open(ACTARRAY, index).type, ACK)
        self.assertAlmostEqual(state(self.client.next_data(ACTARRAY, 0))[0], 0.1)
        self.client.send(ACTARRAY, 0, CMD, POS, struct.pack(">if", 0, 0.75))
        self.client.send(ACTARRAY, 1, CMD, SPEED, struct.pack(">if", 0, 0.5))
        self.assertAlmostEqual(self.wait_for(0, lambda now: now[0] > 0.7499 and now[2] == IDLE)[0], 0.75, places=5)
        self.assertAlmostEqual(self.wait_for(1, lambda now: now[0] > 1.4999)[0], 1.5, places=5)

    def test_a_wall_stops_it(self):
        self.connect()
        self.client.open(ACTARRAY, 0)
        self.client.send(ACTARRAY, 0, CMD, SPEED, struct.pack(">if", 0, 0.5))
        position, velocity, _, _ = self.wait_for(0, lambda now: now[2] == STALLED)
        self.assertEqual(velocity, 0)
        self.assertTrue(1.6 < position <= 1.65 + 1e-6, position)

    def test_it_tells_its_geometry_and_refuses_what_it_cannot(self):
        self.connect()
        self.client.open(ACTARRAY, 0)
        geom = self.client.request(ACTARRAY, 0, GET_GEOM)
        self.assertEqual(geom.type, ACK)
        self.assertEqual(struct.unpack(">II", geom.body[:8])[0], 1)
        self.assertEqual(self.client.request(ACTARRAY, 0, POWER, struct.pack(">I", 1)).type, ACK)
        self.assertEqual(self.client.request(ACTARRAY, 0, 5, struct.pack(">if", 1, 1)).type, NACK, "there is no joint 1")

    def test_a_gate_that_rises_lets_a_robot_through(self):
        self.connect(ROOT / "worlds/gate.world")
        for interf, index in ((ACTARRAY, 1), (POSITION2D, 0)):
            self.assertEqual(self.client.open(interf, index).type, ACK)
        self.client.drive(0, 0.4)
        while not self.client.next_data(POSITION2D, 0).body[-1]:
            pass
        self.assertLess(self.client.pose("r0")[0], -0.1)
        self.client.send(ACTARRAY, 1, CMD, POS, struct.pack(">if", 0, 0.7))
        while self.client.pose("r0")[0] < 1:
            pass


if __name__ == "__main__":
    unittest.main()
