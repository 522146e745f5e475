"""Lamps through a Player client."""

import struct
import unittest

from house import ACK, CMD, Client, HouseTest

BLINKENLIGHT = 33
STATE, POWER, COLOR, FLASH = 1, 2, 3, 4

WORLD = """
interval_sim 100
position( name "r0" blinkenlight( name "lamp" period 500 dutycycle 0.5 color "blue" ) )
lightindicator( name "light" color "red" )
"""


def state(message) -> tuple:
    """enable, period, dutycycle, (alpha, red, green, blue)"""
    enable, period, share, *color = struct.unpack(">IffIIII", message.body)
    return enable, period, share, tuple(color)


class Lamps(HouseTest):
    def open(self, index: int) -> Client:
        house = self.run_house("--speed", 20, world=self.world(WORLD))
        self.addCleanup(house.__exit__)
        client = Client(house.port())
        self.addCleanup(client.close)
        self.assertEqual([d for d in client.devices() if d[0] == BLINKENLIGHT], [(BLINKENLIGHT, 0), (BLINKENLIGHT, 1)])
        self.assertEqual(client.open(BLINKENLIGHT, index).type, ACK)
        return client

    def command(self, client: Client, index: int, subtype: int, form: str, *values):
        client.send(BLINKENLIGHT, index, CMD, subtype, struct.pack(">" + form, *values))

    def wait_for(self, client: Client, index: int, done) -> tuple:
        while not done(now := state(client.next_data(BLINKENLIGHT, index, STATE))):
            pass
        return now

    def test_a_lamp_is_switched_coloured_and_made_to_flash(self):
        client = self.open(0)
        self.assertEqual(state(client.next_data(BLINKENLIGHT, 0)), (1, 0.5, 0.5, (255, 0, 0, 255)))
        self.command(client, 0, POWER, "II", 0, 0)
        self.command(client, 0, COLOR, "IIIII", 0, 0, 255, 0, 0)
        self.command(client, 0, FLASH, "Iff", 0, 2, 0.25)
        self.assertEqual(self.wait_for(client, 0, lambda now: now[1] == 2), (0, 2, 0.25, (255, 255, 0, 0)))
        self.command(client, 0, STATE, "IIffIIII", 0, 1, 0, 1, 0, 0, 0, 255)
        self.assertEqual(self.wait_for(client, 0, lambda now: now[0] == 1), (1, 0, 1, (255, 0, 0, 255)))

    def test_a_light_is_off_until_it_is_switched_on(self):
        client = self.open(1)
        self.assertEqual(state(client.next_data(BLINKENLIGHT, 1)), (0, 0, 1, (255, 255, 0, 0)))
        self.command(client, 1, POWER, "II", 0, 1)
        self.command(client, 1, COLOR, "IIIII", 0, 255, 0, 255, 0)
        self.assertEqual(self.wait_for(client, 1, lambda now: now[3] != (255, 255, 0, 0)), (1, 0, 1, (255, 0, 255, 0)))


if __name__ == "__main__":
    unittest.main()
