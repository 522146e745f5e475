"""Access control of the Player port: what a token of `--guests` opens for clients, tools and robots that join."""

import re
import struct
import sys
import unittest
from pathlib import Path

from house import ACK, NACK, PLAYER, POSITION2D, ROOT, Client, House, HouseTest, finish
from viewer import Viewer

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Mode, RequestRefused, connect  # noqa: E402

WORLD = """
interval_sim 100
define scout position( size [0.4 0.4 0.2] ranger( sensor( samples 3 ) ) )
robot_types [ "scout" ]
scout( name "r0" pose [0 0 0 0] )
"""
GUESTS = """
admin    the-admin-1 Ada
driver   a-driver-01
observer watcher-001
"""
AUTH = 7


def auth(token: str) -> bytes:
    key = token.encode()
    return struct.pack(">II", len(key), len(key)) + key + b"\0" * (-len(key) % 4)


class Guests(HouseTest):
    def house(self, guests=GUESTS, *arguments):
        house = self.enterContext(self.run_house("--guests", self.write("guests.txt", guests), *arguments,
                                                 world=self.world(WORLD)))
        self.address = f":{house.port()}"
        return house

    def test_a_client_of_2005_gets_what_guests_without_a_token_get(self):
        with Client(self.house().port()) as client:
            self.assertEqual(client.request(PLAYER, 0, 1).type, NACK, "the list of devices")
            self.assertEqual(client.open(POSITION2D, 0).type, NACK)
        with Client(self.house(GUESTS + "driver *\n").port()) as client:
            self.assertEqual(client.open(POSITION2D, 0).type, ACK)
            client.drive(0, 0.5)
            while struct.unpack(">d", client.next_data(POSITION2D, 0).body[24:32])[0] == 0:
                pass

    def test_roles_decide(self):
        self.house()
        with self.assertRaisesRegex(RequestRefused, "the token is refused"):
            connect(self.address, token="watcher-002")
        with connect(self.address, token="watcher-001", mode=Mode.PUSH, timeout=60) as watcher, \
                connect(self.address, token="a-driver-01", mode=Mode.PUSH, timeout=60) as driver, \
                connect(self.address, token="the-admin-1", timeout=60) as admin:
            self.assertIn("position2d:0", [f"{each.interface}:{each.index}" for each in watcher.devices()])
            base, world = watcher.position2d(0), watcher.simulation(0)
            world.pose("r0")
            base.drive(0.5, 0.0)  # dropped
            for refused in (lambda: base.reset_odometry(), lambda: world.set_pose("r0", 1, 1, 0),
                            lambda: world.spawn("r0", 1, 1, 0)):
                self.assertRaises(RequestRefused, refused)
            own = driver.position2d(0)
            own.reset_odometry()
            for refused in (lambda: driver.simulation(0).set_pose("r0", 1, 1, 0), lambda: driver.simulation(0).step()):
                self.assertRaises(RequestRefused, refused)
            driver.read(), watcher.read()
            self.assertEqual(base.velocity.x, 0.0)
            own.drive(0.5, 0.0)
            self.assertTrue(any(watcher.read() and base.velocity.x > 0 for _ in range(600)))
            admin.simulation(0).spawn("r0", 3, 3, 0)
            admin.simulation(0).set_pose("r0", 1, 1, 0)

    def test_drivers_take_part_in_lock_step(self):
        self.house(GUESTS, "--lock-step")
        with connect(self.address, token="a-driver-01", timeout=60) as driver:
            world = driver.simulation(0)
            world.step(3)
            self.assertRaises(RequestRefused, lambda: world.reset(4))
        with connect(self.address, token="the-admin-1", timeout=60) as admin:
            admin.simulation(0).reset(4)

    def test_tools_and_robots_that_join_have_tokens(self):
        house = self.house()
        server = f"127.0.0.1:{house.port()}"
        refused = finish("devices", server)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("refused: player.req.devlist to player:0; it may need a token (docs/guests.md)", refused.stderr)
        self.assertIn("it may need a token", finish("watch", server, "position2d:0", "--count", 1).stderr)
        absent = finish("watch", server, "laser:9", "--token", "watcher-001")
        self.assertNotIn("token", absent.stderr)
        self.assertIn("position2d:0", finish("devices", server, "--token", "watcher-001").stdout)
        self.assertIn("the token is refused", finish("devices", server, "--token", "watcher-002").stderr)
        self.assertIn("1 to 32 letters", finish("devices", server, "--token", "x" * 33).stderr)
        seen = finish("watch", server, "position2d:0", "--count", 1, "--token", "watcher-001")
        self.assertEqual(seen.returncode, 0, seen.stderr)
        robot = self.write("robot.toml", 'type = "scout"\nname = "mine"\npose = [2, 2, 0]\n')
        late = finish("robot", robot, "--server", server, "--port", 0, "--token", "watcher-001")
        self.assertEqual(late.returncode, 1, late.stderr)

    def test_a_relay_says_what_opens_the_other_server(self):
        port = self.house().port()
        for token, why in (("", "it may need a token"), ('token "watcher-002"', "the token does not admit this")):
            relay = self.enterContext(House("serve", self.write("relay.cfg", (
                f'driver( name "passthrough" provides ["position2d:0"] requires ["127.0.0.1:{port}:position2d:0"] {token} )')),
                "--port", 0, "--headless"))
            with Client(relay.port()) as client:
                self.assertEqual(client.open(POSITION2D, 0).body[19], 3, "cannot be opened")
            relay.wait_for_line(rf"127\.0\.0\.1:{port} does not open position2d:0: {why}")

    def test_who_guesses_is_logged_and_has_to_wait(self):
        house = self.house()
        with Client(house.port()) as client:
            for _ in range(25):
                self.assertEqual(client.request(PLAYER, 0, AUTH, auth("the-admin-2")).type, NACK)
            self.assertEqual(client.request(PLAYER, 0, AUTH, auth("the-admin-1")).type, NACK, "also the right one")
        house.wait_for_line(r"guests: .* gave a wrong token")
        self.assertLessEqual(len(re.findall("gave a wrong token", house.log())), 24)

    def test_who_is_sent_out_loses_player_connections_too(self):
        guests = self.write("guests.txt", GUESTS)
        house = self.enterContext(House("run", self.world(WORLD), "--port", 0, "--web", 0, "--guests", guests))
        page = int(house.wait_for_line(r"http://127\.0\.0\.1:(\d+)/").group(1))
        with Client(house.port()) as other, Client(house.port()) as client, Viewer(page, "the-admin-1") as admin, \
                Viewer(page, "a-driver-01") as driver:
            self.assertEqual(other.request(PLAYER, 0, AUTH, auth("watcher-001")).type, ACK)
            self.assertEqual(client.request(PLAYER, 0, AUTH, auth("a-driver-01")).type, ACK)
            self.assertEqual(client.open(POSITION2D, 0).type, ACK)
            admin.turn_until(lambda: len(admin.people) == 2)
            out = next(person["viewer"] for person in admin.people if person["role"] == "driver")
            admin.send(do="kick", viewer=out)
            with self.assertRaises(ConnectionError):
                driver.turn_until(lambda: False)
            with self.assertRaises((ConnectionError, EOFError)):
                while True:
                    client.next_data(POSITION2D, 0)
            self.assertEqual(other.request(PLAYER, 0, 1).type, ACK, "others stay")
            with Client(house.port()) as again:
                self.assertEqual(again.request(PLAYER, 0, AUTH, auth("a-driver-01")).type, NACK)

    def with_page(self, *arguments) -> tuple[House, int]:
        house = self.enterContext(House("run", self.world(WORLD), "--port", 0, "--web", 0, *arguments))
        return house, int(house.wait_for_line(r"http://127\.0\.0\.1:(\d+)/").group(1))

    def send_out(self, admin: Viewer, role: str, others: int):
        admin.turn_until(lambda: len(admin.people) == others + 1)
        admin.send(do="kick", viewer=next(person["viewer"] for person in admin.people[::-1] if person["role"] == role))
        admin.turn_until(lambda: len(admin.people) == others)

    def test_who_is_sent_out_does_not_come_back_without_the_token(self):
        guests = self.write("guests.txt", GUESTS + "observer *\n")
        house, page = self.with_page("--guests", guests)
        with Viewer(page, "the-admin-1") as admin, Viewer(page, "a-driver-01", "127.0.0.7"), \
                Client(house.port(), "127.0.0.7") as plain:
            self.assertEqual(plain.request(PLAYER, 0, 1).type, ACK)
            self.send_out(admin, "driver", 1)
            with self.assertRaises((ConnectionError, EOFError)):
                while True:
                    plain.receive()
            for token in ("a-driver-01", ""):
                with self.assertRaisesRegex(ConnectionError, "an admin has sent you out"):
                    Viewer(page, token, "127.0.0.7")
            with Client(house.port(), "127.0.0.7") as again, Client(house.port(), "127.0.0.8") as other:
                self.assertEqual(again.request(PLAYER, 0, 1).type, NACK)
                self.assertEqual(other.request(PLAYER, 0, 1).type, ACK)
                self.assertEqual(again.request(PLAYER, 0, AUTH, auth("a-driver-01")).type, NACK)
                self.assertEqual(again.request(PLAYER, 0, AUTH, auth("watcher-001")).type, ACK, "as another guest")
                self.assertEqual(again.request(PLAYER, 0, 1).type, ACK)
            with Viewer(page, "watcher-001", "127.0.0.7"), Viewer(page, "", "127.0.0.8"):
                pass
            admin.turn_until(lambda: len(admin.people) == 1)
            with Viewer(page, "", "127.0.0.1"):
                self.send_out(admin, "observer", 1)
            with self.assertRaisesRegex(ConnectionError, "an admin has sent you out"):
                Viewer(page, "", "127.0.0.1")
            with Viewer(page, "the-admin-1", "127.0.0.1"):
                pass

    def test_who_is_sent_out_observes_no_more(self):
        guests = self.write("guests.txt", GUESTS)
        house, page = self.with_page("--guests", guests, "--observers", 0)
        observers = house.wait_for_line(r"^observers: (127\.0\.0\.1:\d+)$").group(1)
        with Viewer(page, "the-admin-1") as admin, Viewer(page, "a-driver-01"), \
                House("observe", observers, "--token", "a-driver-01") as observer, \
                House("observe", observers, "--token", "watcher-001") as other:
            house.wait_for_line(r"observes as driver")
            house.wait_for_line(r"observes as observer")
            self.send_out(admin, "driver", 1)
            self.assertEqual(observer.wait(), 1)
            self.assertIn("an admin has sent you out", observer.log())
            again = finish("observe", observers, "--token", "a-driver-01", "--seconds", 1)
            self.assertEqual(again.returncode, 1)
            self.assertIn("an admin has sent you out", again.stderr)
            self.assertNotIn("sent", other.log())

    def test_who_is_sent_out_of_a_run_without_guests_is_no_player_client_either(self):
        house, page = self.with_page()
        with Viewer(page) as admin, Viewer(page, "", "127.0.0.7"), Client(house.port(), "127.0.0.7") as client:
            self.assertEqual(client.request(PLAYER, 0, 1).type, ACK)
            self.send_out(admin, "admin", 1)
            with self.assertRaises((ConnectionError, EOFError)):
                while True:
                    client.receive()
            for token in ("", "invented-01"):
                with self.assertRaisesRegex(ConnectionError, "an admin has sent you out"):
                    Viewer(page, token, "127.0.0.7")
            with Client(house.port(), "127.0.0.7") as again, Client(house.port()) as other:
                self.assertEqual(again.request(PLAYER, 0, 1).type, NACK)
                self.assertEqual(again.request(PLAYER, 0, AUTH, auth("invented-01")).type, NACK)
                self.assertEqual(again.open(POSITION2D, 0).type, NACK)
                self.assertEqual(other.open(POSITION2D, 0).type, ACK)

    def test_clients_of_a_trusted_proxy_are_sent_out_one_by_one(self):
        """A proxy is whoever sends the header."""
        guests = self.write("guests.txt", GUESTS + "observer *\n")
        of = "X-Forwarded-For: 203.0.113.{}\r\n".format
        house, page = self.with_page("--guests", guests, "--trusted-proxy", "127.0.0.7")
        with Viewer(page, "the-admin-1") as admin, Viewer(page, "", "127.0.0.7", of(5)), Viewer(page, "", "127.0.0.7", of(6)):
            self.send_out(admin, "observer", 2)
            house.wait_for_line(r"web: 203\.0\.113\.6:\d+ left: an admin has sent them out")
            with self.assertRaisesRegex(ConnectionError, "an admin has sent you out"):
                Viewer(page, "", "127.0.0.7", of(6))
            with Viewer(page, "", "127.0.0.7", of(7)):
                pass
        house, page = self.with_page("--guests", guests)
        with Viewer(page, "", more=of(5)), Viewer(page, "", more=of(6)):
            house.wait_for_line(r"forwards requests of others \(X-Forwarded-For\).* --trusted-proxy with its address")
        self.assertEqual(len(re.findall("--trusted-proxy", house.log())), 1)

    def cupboard(self) -> Path:
        """It is 129 models: 31 of them fit into the share of one."""
        boxes = "".join(f"model( pose [0 0 0 {k}] size [0.1 0.1 0.1] ) " for k in range(128))
        return self.write("cupboard.world", f'interval_sim 100 model( name "c" size [0.2 0.2 0.2] {boxes})')

    def test_on_the_machine_itself_each_connection_has_a_share_of_what_may_be_brought(self):
        house = self.enterContext(self.run_house(world=self.cupboard()))
        with connect(f":{house.port()}", timeout=60) as first, connect(f":{house.port()}", timeout=60) as other:
            for client in (first, other):
                for k in range(31):
                    client.simulation(0).spawn("c", k, 0, 0)
                with self.assertRaisesRegex(RequestRefused, "your share of the run is full: you brought 3999 models"):
                    client.simulation(0).spawn("c", 0, 1, 0)

    def test_a_token_has_one_share_of_what_may_be_brought(self):
        guests = self.write("guests.txt", "admin the-admin-1 Ada\nadmin the-admin-2 Bea\n")
        world = self.cupboard()
        house = self.enterContext(self.run_house("--guests", guests, world=world))
        address = f":{house.port()}"
        with connect(address, token="the-admin-1", timeout=60) as first, connect(address, token="the-admin-2", timeout=60) as other:
            names = [first.simulation(0).spawn("c", k, 0, 0) for k in range(31)]
            refused = "your share of the run is full: you brought 3999 models with 0 sensors and 0 beams"
            with self.assertRaisesRegex(RequestRefused, refused):
                first.simulation(0).spawn("c", 0, 1, 0)
            with connect(address, token="the-admin-1", timeout=60) as again:
                with self.assertRaisesRegex(RequestRefused, refused):
                    again.simulation(0).spawn("c", 0, 1, 0)
                other.simulation(0).spawn("c", 0, 2, 0)
                other.simulation(0).remove(names[7])
                again.simulation(0).spawn("c", 0, 1, 0)


if __name__ == "__main__":
    unittest.main()
