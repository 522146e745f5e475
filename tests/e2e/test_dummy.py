"""Driver "dummy": a client of the Python library uses every interface of the wire, of one program."""

import sys
import unittest

from house import ROOT, House, HouseTest

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Mode, RequestRefused, connect  # noqa: E402
from playhouse_client.generated import INTERFACES, find_message  # noqa: E402
from playhouse_client.wire import Kind  # noqa: E402

DUMMY = ROOT / "worlds/dummy.cfg"
NAMES = {name: code for code, name in INTERFACES.items() if name != "player"}


def messages(interface: str, kind: Kind) -> list:
    """Those of the interface alone, without the requests that all have."""
    found = (find_message(NAMES[interface], kind, subtype) for subtype in range(1, 247))
    return [message for message in found if message is not None]


class EveryInterface(HouseTest):
    def setUp(self):
        super().setUp()
        self.house = self.enterContext(House("serve", DUMMY, "--port", 0, "--headless"))

    def connect(self):
        return self.enterContext(connect(f":{self.house.port()}", mode=Mode.PUSH, timeout=20))

    def test_sends_its_data(self):
        client = self.connect()
        self.assertEqual({(each.name, each.driver) for each in client.devices()}, {(f"{name}:0", "dummy") for name in NAMES})
        devices = {name: client.device(name) for name in NAMES}
        missing = {(name, message.subtype) for name in NAMES for message in messages(name, Kind.DATA)}
        self.assertGreater(len(missing), 50)
        while missing:
            client.read()
            missing = {(name, subtype) for name, subtype in missing
                       if devices[name].latest(find_message(NAMES[name], Kind.DATA, subtype)) is None}
        self.assertEqual(client.skipped_count, 0)

    def test_answers_its_requests_and_takes_its_commands(self):
        client = self.connect()
        asked = 0
        for name in NAMES:
            with client.device(name) as device:
                for message in messages(name, Kind.CMD):
                    device.command(message, message.payload() if message.payload else None)
                for message in messages(name, Kind.REQ):
                    with self.subTest(message.name, interface=name):
                        answer = device.request(message)
                        self.assertIsInstance(answer, message.payload or type(None))
                        self.assertTrue(device.has_capability(message))
                        asked += 1
                with self.assertRaises(RequestRefused):
                    device.get_property("gain", int)
                device.set_property("gain", 7)
                self.assertEqual(device.get_property("gain", int), 7)
        self.assertGreater(asked, 100)

    def test_begins_anew_for_who_opens_it(self):
        for _ in range(2):
            with connect(f":{self.house.port()}", mode=Mode.PUSH, timeout=20) as client:
                laser = client.device("laser")
                laser.next_data()
                scan = laser.latest(find_message(laser.code, Kind.DATA, 1))
                self.assertEqual((scan.id, len(scan.ranges)), (1, 181))

    def test_the_documented_section_is_one_that_runs(self):
        documented = (ROOT / "docs/drivers.md").read_text().split('## driver "dummy"')[1].split("```")[1]
        with House("serve", self.write("documented.cfg", documented), "--port", 0, "--headless") as house, \
                connect(f":{house.port()}", mode=Mode.PUSH, timeout=20) as client:
            self.assertEqual(len(client.devices()), 4)
            client.device("rfid").next_data()


if __name__ == "__main__":
    unittest.main()
