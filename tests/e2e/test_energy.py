"""Batteries, as a client of the protocol sees them: a robot drives, becomes empty of some of its energy, and charges."""

import struct
import unittest

from house import ACK, NACK, POSITION2D, Client, HouseTest

POWER = 2
CHARGING_POLICY = 1
MASK_JOULES = 4

WORLD = """
interval_sim 100
define station model( size [0.4 0.4 0.3] joules -1 give_watts 500 alwayson 1 obstacle_return 0 )
position( name "r0" size [0.4 0.4 0.2] mass 5 joules 1000 joules_capacity 1010 take_watts 200 obstacle_return 0 )
position( name "r1" pose [0 5 0 0] )
station( name "s" pose [1 0 0 0] )
"""


class State:
    def __init__(self, body: bytes):
        self.valid, self.volts, self.percent, self.joules, self.watts, self.charging = struct.unpack(">Iffffi", body)


class Energy(HouseTest):
    def test_a_robot_pays_for_its_way_to_a_station_and_is_charged_there(self):
        with self.run_house("--speed", 20, world=self.world(WORLD)) as house, Client(house.port()) as client:
            devices = [index for interf, index in client.devices() if interf == POWER]
            self.assertEqual(devices, [0, 2], "of the robot, and of the station behind all robots; of no other robot")
            self.assertEqual(client.open(POWER, 0).type, ACK)
            state = lambda: State(client.next_data(POWER, 0).body)
            at_rest = state()
            self.assertTrue(at_rest.valid & MASK_JOULES)
            self.assertEqual((at_rest.watts, at_rest.charging), (0, 0), "who reads draws nothing")
            self.assertEqual(client.open(POSITION2D, 0).type, ACK)
            client.drive(0, 0.5)
            while (driving := state()).watts < 2:
                pass
            self.assertEqual(driving.watts, 1 + 10 * 5 * 0.5)
            self.assertLess(driving.joules, at_rest.joules)
            while state().charging == 0:
                pass
            client.drive(0, 0)
            while (full := state()).percent < 100:
                self.assertEqual(full.charging, 1)
            self.assertEqual(full.joules, 1010)

            self.assertEqual(client.request(POWER, 0, CHARGING_POLICY, b"").type, NACK)
            self.assertEqual(client.request(POWER, 0, CHARGING_POLICY, struct.pack(">II", 0, 1)).type, ACK)
            while state().charging != -1:
                pass
            self.assertLess(state().joules, 1010)


if __name__ == "__main__":
    unittest.main()
