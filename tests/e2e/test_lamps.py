"""Lamps through a Player client."""

import struct
import unittest

from house import ACK, CMD, Client, HouseTest

BLINKENLIGHT = 33
STATE, POWER, COLOR, FLASH = 1, 2, 3, 4

WORLD = """
interval_sim 100
position( name "r0" blinkenlight( name "lamp" period 500 dutycycle 0.5 color "blue" ) )
"""


def state(message) -> tuple:
    """enable, period, dutycycle, (alpha, red, green, blue)"""
    enable, period, share, *color = struct.unpack(">IffIIII", message.body)
    return enable, period, share, tuple(color)


class Lamps(HouseTest):
    def open(self, world: str, *devices: int) -> Client:
        house = self.run_house("--fast", world=self.world(world))
        self.addCleanup(house.__exit__)
        client = Client(house.port())
        self.addCleanup(client.close)
        for index in devices:
            self.assertEqual(client.open(BLINKENLIGHT, index).type, ACK)
        return client

    def command(self, client: Client, subtype: int, form: str, *values, index=0):
        client.send(BLINKENLIGHT, index, CMD, subtype, struct.pack(">" + form, *values))

    def wait_for(self, client: Client, index: int, done) -> tuple:
        while not done(now := state(client.next_data(BLINKENLIGHT, index, STATE))):
            pass
        return now

    def test_a_lamp_is_switched_coloured_and_made_to_flash(self):
        client = self.open(WORLD, 0)
        self.assertIn((BLINKENLIGHT, 0), client.devices())
        self.assertEqual(state(client.next_data(BLINKENLIGHT, 0)), (1, 0.5, 0.5, (255, 0, 0, 255)))
        self.command(client, POWER, "II", 0, 0)
        self.command(client, COLOR, "IIIII", 0, 0, 255, 0, 0)
        self.command(client, FLASH, "Iff", 0, 2, 0.25)
        self.assertEqual(self.wait_for(client, 0, lambda now: now[1] == 2), (0, 2, 0.25, (255, 255, 0, 0)))
        self.command(client, STATE, "IIffIIII", 0, 1, 0, 1, 0, 0, 0, 255)
        self.assertEqual(self.wait_for(client, 0, lambda now: now[0] == 1), (1, 0, 1, (255, 0, 0, 255)))


if __name__ == "__main__":
    unittest.main()
