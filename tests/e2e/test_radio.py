"""Messages between radios, as Player clients of interface opaque see them."""

import json
import struct
import unittest

from house import ACK, CMD, NACK, Client, HouseTest, finish

OPAQUE, DATA = 51, 1

WORLD = """
position( name "r0" wifi( ip "10.1.0.1" model "simple" range 3 ) )
position( name "r1" pose [2 0 0 0] wifi( ip "10.1.0.2" model "simple" range 3 ) )
position( name "r2" pose [4 0 0 0] wifi( ip "10.1.0.3" model "simple" range 3 ) )
"""


def body(message: bytes) -> bytes:
    return struct.pack(">II", len(message), len(message)) + message + b"\0" * (-len(message) % 4)


class Radio(HouseTest):
    def start(self, *arguments) -> tuple[Client, ...]:
        """A client for each robot, with its radio open."""
        house = self.run_house("--speed", 5, *arguments, world=self.world(WORLD))
        self.addCleanup(house.__exit__)
        self.house = house
        clients = tuple(Client(house.port()) for _ in range(3))
        for index, client in enumerate(clients):
            self.addCleanup(client.close)
            self.assertEqual(client.open(OPAQUE, index).type, ACK)
        return clients

    def heard(self, client: Client, index: int) -> bytes:
        data = client.next_data(OPAQUE, index).body
        size, = struct.unpack(">I", data[:4])
        self.assertEqual(data, body(data[8:8 + size]))
        return data[8:8 + size]

    def test_two_clients_talk_to_each_other_and_a_third_hears_whom_it_can(self):
        first, second, third = self.start()
        first.send(OPAQUE, 0, CMD, DATA, body(b"is anybody there?"))
        self.assertEqual(self.heard(second, 1), b"is anybody there?")
        second.send(OPAQUE, 1, CMD, DATA, body(b"yes\0\xff"))
        self.assertEqual(self.heard(first, 0), b"yes\0\xff")
        self.assertEqual(self.heard(third, 2), b"yes\0\xff", "the first was out of its range")

    def test_a_message_to_one_address_reaches_that_robot_alone(self):
        first, second, third = self.start()
        self.assertEqual(second.request(OPAQUE, 1, DATA, body(b"10.1.0.3\0for you")).type, ACK)
        second.send(OPAQUE, 1, CMD, DATA, body(b"for all"))
        self.assertEqual(self.heard(third, 2), b"for you")
        self.assertEqual(self.heard(third, 2), b"for all")
        self.assertEqual(self.heard(first, 0), b"for all")
        self.assertEqual(first.request(OPAQUE, 0, DATA, body(b"10.1.0.9\0hello")).type, NACK)
        self.assertEqual(first.request(OPAQUE, 0, DATA, body(b"no address")).type, NACK)

    def test_what_is_too_long_is_dropped_with_a_line_in_the_log(self):
        first, second, _ = self.start()
        first.send(OPAQUE, 0, CMD, DATA, body(b"x" * 2305))
        self.house.wait_for_line("opaque:0.*or not with these values")
        first.send(OPAQUE, 0, CMD, DATA, body(b"x" * 2304))
        self.assertEqual(self.heard(second, 1), b"x" * 2304)

    def test_more_than_a_radio_sends_in_a_tick_is_refused_and_told(self):
        first, second, _ = self.start("--paused")
        for _ in range(65):
            first.send(OPAQUE, 0, CMD, DATA, body(b"x"))
        self.house.wait_for_line("r0.wifi:0 has 64 messages to send in one tick")
        self.assertEqual(first.request(OPAQUE, 0, DATA, body(b"\0y")).type, NACK)

    def test_a_recorded_run_with_messages_is_made_again_to_the_bit(self):
        file = self.folder / "talk.mcap"
        first, second, _ = self.start("--json", "--record", file)
        for number in range(5):
            first.send(OPAQUE, 0, CMD, DATA, body(b"number %d" % number))
            self.assertEqual(self.heard(second, 1), b"number %d" % number)
        self.house.end()
        again = finish("run", "--again", file, "--json")
        self.assertEqual(again.returncode, 0, again.stderr)
        recorded, made = json.loads(self.house.output()), json.loads(again.stdout)
        for key in ("ticks", "hash", "sensed_hash"):
            self.assertEqual(recorded[key], made[key], key)


if __name__ == "__main__":
    unittest.main()
