"""Lamps, and switches as digital inputs, through a Player client."""

import struct
import unittest

from house import ACK, CMD, POSITION2D, Client, House, HouseTest, finish

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


DIO = 20
VALUES = 1  # the only data and the only command of dio
SWITCHES = """
interval_sim 100
define contact bumper( size [0.4 0.4 0.1] bcount 1 blength 0.5 update_interval 100 )
position( name "r0" size [0.4 0.4 0.2] localization "gps"
  contact( name "front" pose [0 0 -0.2 0] bpose[0] [0.21 0 0 0] )
  contact( name "back" pose [0 0 -0.2 0] bpose[0] [-0.21 0 0 180] )
  blinkenlight( name "lamp" enabled 0 ) lightindicator( name "light" ) )
model( name "wall" pose [1.3 0 0 0] size [0.2 4 1] )
"""
SWITCHES_CFG = """
driver ( name "stage" provides ["simulation:0"] worldfile "test.world" )
driver ( name "stage" provides ["position2d:0" "dio:0" "blinkenlight:0" "blinkenlight:1"] model "r0" )
"""


class Switches(HouseTest):
    def test_a_robot_that_drives_into_a_wall_presses_a_switch_and_a_client_lights_its_lamps(self):
        self.world(SWITCHES)
        with House("serve", self.write("test.cfg", SWITCHES_CFG), "--port", 0, "--headless", "--speed", 20) as house, \
                Client(house.port()) as client:
            for interf, index in ((POSITION2D, 0), (DIO, 0), (BLINKENLIGHT, 0), (BLINKENLIGHT, 1)):
                self.assertEqual(client.open(interf, index).type, ACK)
            self.assertEqual(self.inputs(client), (2, 0b00), "nothing is near")
            client.drive(0, 0.5)
            while self.inputs(client) != (2, 0b01):
                pass
            client.drive(0, -0.5)
            while self.inputs(client) != (2, 0b00):
                pass
            for count, bits, lit in ((2, 0b11, (1, 1)), (2, 0b10, (0, 1)), (1, 0b1, (1, 1)), (32, 0, (0, 0))):
                client.send(DIO, 0, CMD, VALUES, struct.pack(">II", count, bits))
                while tuple(state(client.next_data(BLINKENLIGHT, k))[0] for k in range(2)) != lit:
                    pass
        self.assertNotIn("warning", house.log())

    @staticmethod
    def inputs(client: Client) -> tuple[int, int]:
        return struct.unpack(">II", client.next_data(DIO, 0, VALUES).body)

    def test_a_model_without_contacts_or_lamps_has_none(self):
        self.world(SWITCHES)
        done = finish("check", self.write("test.cfg", SWITCHES_CFG.replace('model "r0"', 'model "wall"').replace('"position2d:0" ', "")))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn('model "wall" has nothing left for "dio:0"', done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
