"""Messages between radios, as Player clients of interface opaque see them."""

import json
import struct
import sys
import unittest

from house import ACK, CMD, NACK, ROOT, Client, HouseTest, finish

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Mode, RequestRefused, connect  # noqa: E402
from playhouse_client.generated import wsn  # noqa: E402

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


# The stove is 30 K warmer than the air, and 4 m from the first mote: 20 + 30 * 0.5 / 4 degC there.
MOTES = """
interval_sim 20
mote( name "base" base 1 node_id 1 range 10 update_interval 20 )
mote( name "warm" pose [4 0 0.09 0] node_id 2 node_type 5 update_interval 20 )
mote( name "far" pose [40 0 0 0] node_id 3 update_interval 20 )
mote( name "other" pose [0 4 0 0] node_id 4 group 1 update_interval 20 )
model( name "stove" pose [8 0 0 0] size [0.2 0.2 0.2] heat 30 heat_radius 0.5 )
"""


class Motes(HouseTest):
    def test_a_base_station_tells_what_the_motes_in_reach_measure_and_commands_them(self) -> None:
        for engine in ("stage", "arena"):
            with self.subTest(engine), self.run_house("--speed", 5, "--engine", engine, world=self.world(MOTES)) as house, \
                    connect(f":{house.port()}", mode=Mode.PUSH) as client:
                heard: list[wsn.Data] = []
                base = client.device("wsn", 0)
                base.on_data(lambda _message, data, _time: heard.append(data))
                while len(heard) < 3:
                    client.read(30)
                self.assertEqual({(data.node_id, data.node_type, data.node_parent_id) for data in heard}, {(2, 5, 1)})
                packet = heard[-1].data_packet
                self.assertAlmostEqual(packet.temperature, 20 + 30 * 0.5 / 4, delta=0.01)
                self.assertAlmostEqual(packet.accel_z, 9.81, delta=0.05)
                self.assertAlmostEqual(packet.battery, 3, 3)
                base.request(wsn.REQ_DATATYPE, wsn.DatatypeConfig(0))
                while heard[-1].data_packet.battery != 1023:
                    client.read(30)
                base.request(wsn.REQ_DATAFREQ, wsn.DatafreqConfig(2, -1, 10.0))
                base.request(wsn.REQ_POWER, wsn.PowerConfig(-1, -1, 0))
                with self.assertRaises(RequestRefused):
                    base.request(wsn.REQ_POWER, wsn.PowerConfig(3, -1, 0))
                # The other group has no base station, but a cable, which tells that time goes on.
                told: list[int] = []
                client.device("wsn", 3).on_data(lambda _message, data, _time: told.append(data.node_id))
                while len(told) < 2:
                    client.read(30)
                quiet = len(heard)
                while len(told) < 20:
                    client.read(30)
                self.assertEqual(set(told), {4})
                self.assertEqual(len(heard), quiet)
                base.request(wsn.REQ_POWER, wsn.PowerConfig(2, 0, 1))
                while len(heard) == quiet:
                    client.read(30)



if __name__ == "__main__":
    unittest.main()
