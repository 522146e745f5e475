"""TLS on the ports of Player clients and of pages. The other ends are Python's ssl, by OpenSSL, and its http client."""

import re
import socket
import ssl
import struct
import subprocess
import sys
import unittest
import urllib.request

from house import ACK, LASER, PATIENCE, PLAYER, POSITION2D, REQ, ROOT, Client, House, HouseTest, finish, frame
from test_without_world import CFG, PageSocket

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import ConnectionLost, connect  # noqa: E402

JOIN = """
interval_sim 100
define scout position( size [0.4 0.4 0.2] ranger( sensor( samples 3 ) ) )
robot_types [ "scout" ]
model( name "wall" pose [9 0 0 0] size [0.2 4 1] )
"""
HANDSHAKES = 256  # that may be pending; net/tls/asio_tls.h


class Tls(HouseTest):
    def setUp(self):
        super().setUp()
        self.certificate, self.key = self.identity("server")
        self.trust = ssl.create_default_context(cafile=self.certificate)

    def identity(self, name: str, *options, key_type=("ec", "-pkeyopt", "ec_paramgen_curve:prime256v1")):
        certificate, key = self.folder / f"{name}.crt", self.folder / f"{name}.key"
        subprocess.run(["openssl", "req", "-x509", "-newkey", *key_type, "-days", "2",
                        "-subj", "/CN=robots", "-addext", "subjectAltName=IP:127.0.0.1", "-keyout", key, "-out", certificate,
                        *(options or ("-nodes",))], check=True, capture_output=True)
        return str(certificate), str(key)

    def options(self):
        return "--tls-cert", self.certificate, "--tls-key", self.key

    def world_with_tls(self, *options) -> House:
        return self.enterContext(House("run", self.world(), "--port", 0, "--web", 0, *self.options(), *options))

    def devices_with_tls(self) -> House:
        return self.enterContext(House("serve", self.write("lab.cfg", CFG), "--port", 0, "--web", 0, *self.options()))

    @staticmethod
    def port(house: House) -> int:
        return int(house.wait_for_line(r"^Player clients: 127\.0\.0\.1:(\d+) \(TLS\)$").group(1))

    @staticmethod
    def page(house: House) -> int:
        return int(house.wait_for_line(r"^web page: https://127\.0\.0\.1:(\d+)/$").group(1))

    def socket(self, port: int) -> socket.socket:
        made = socket.create_connection(("127.0.0.1", port), PATIENCE)
        self.addCleanup(made.close)
        return made

    def test_a_client_drives_and_reads_as_in_the_clear(self):
        port = self.port(self.world_with_tls())
        with connect(f":{port}", tls=self.trust, timeout=PATIENCE) as client:
            wheels, laser = client.position2d(0), client.laser(0)
            client.read()
            while wheels.state.pose.x < 0.2:
                wheels.drive(0.5, 0)
                client.read()
            self.assertAlmostEqual(laser.ranges[90], 2.9 - wheels.state.pose.x, delta=0.2)

    def test_who_trusts_another_server_sends_it_nothing(self):
        port = self.port(self.world_with_tls())
        other, _ = self.identity("other")
        with self.assertRaisesRegex(ConnectionLost, "CERTIFICATE_VERIFY_FAILED|certificate verify failed"):
            connect(f":{port}", tls=ssl.create_default_context(cafile=other), timeout=PATIENCE)

    def test_who_does_not_speak_tls_is_closed_and_each_cause_is_told(self):
        house = self.world_with_tls()
        port = self.port(house)
        plain = self.socket(port)
        plain.sendall(frame(PLAYER, 0, REQ, 1))
        self.assertNotIn(b"Player", plain.recv(100))
        first = house.wait_for_line(rf"port {port}: 127\.0\.0\.1:\d+ refused: invalid TLS handshake: (.*)").group(1)
        other, _ = self.identity("other")
        with self.assertRaises(ConnectionLost):
            connect(f":{port}", tls=ssl.create_default_context(cafile=other), timeout=PATIENCE)
        house.wait_for_lines("invalid TLS handshake", 2)
        causes = re.findall("invalid TLS handshake: (.*)", house.log())
        self.assertEqual(causes[0], first)
        self.assertNotEqual(causes[1], first)
        with connect(f":{port}", tls=self.trust, timeout=PATIENCE) as client:
            self.assertIn("laser:0", [each.name for each in client.devices()])

    def test_handshakes_without_end_keep_nobody_out(self):
        port = self.port(self.world_with_tls())
        silent = [self.socket(port) for _ in range(HANDSHAKES + 10)]
        with connect(f":{port}", tls=self.trust, timeout=PATIENCE) as client:
            self.assertIn("laser:0", [each.name for each in client.devices()])
        self.assertEqual(silent[0].recv(1), b"", "the oldest is given up")

    def test_a_client_that_never_reads_does_not_hold_up_the_end(self):
        house = self.world_with_tls("--fast")
        line = self.trust.wrap_socket(self.socket(self.port(house)), server_hostname="127.0.0.1")
        self.addCleanup(line.close)
        line.sendall(frame(PLAYER, 0, REQ, 2, bytes.fromhex("00000000 0000190a 00000006 00000000 00000001 00000000")))
        self.assertTrue(line.recv(32).startswith(b"Player v."))
        self.assertEqual(house.end(), 128 + 15)

    def test_the_page_is_at_https_and_controlled_from_there_alone(self):
        port = self.page(self.world_with_tls())
        with urllib.request.urlopen(f"https://127.0.0.1:{port}/", context=self.trust, timeout=PATIENCE) as page:
            self.assertIn(b"<html", page.read())
        for origin, code in ((f"https://127.0.0.1:{port}", b"101"), (f"http://127.0.0.1:{port}", b"403")):
            self.assertEqual(self.upgrade(port, "/live", origin).head.split()[1], code, origin)

    def upgrade(self, port: int, path: str, origin: str) -> PageSocket:
        page = PageSocket(port, path, f"Origin: {origin}\r\n", self.trust)
        self.addCleanup(page.socket.close)
        return page

    def test_devices_without_a_world_have_tls_on_tcp_and_websockets(self):
        house = self.devices_with_tls()
        page = self.page(house)
        socket_of_page = self.upgrade(page, "/player", f"https://127.0.0.1:{page}")
        self.assertTrue(socket_of_page.receive().startswith(b"Player v."))
        socket_of_page.send(frame(PLAYER, 0, REQ, 1))
        with connect(f":{self.port(house)}", tls=self.trust, timeout=PATIENCE) as client:
            names = sorted(each.name for each in client.devices())
        self.assertEqual(names, ["gps:0", "laser:0", "position2d:0"])
        self.assertEqual(socket_of_page.frame()[40:48], bytes([0, 0, 0, 3, 0, 0, 0, 3]))

    def relay(self, port: int, more: str, host="127.0.0.1") -> House:
        return self.enterContext(House("serve", self.write("relay.cfg", (
            f'driver( name "passthrough" provides ["laser:0"] requires ["{host}:{port}:laser:0"] {more} )')),
            "--port", 0, "--headless"))

    def test_old_clients_reach_the_server_through_a_passthrough(self):
        port = self.port(self.world_with_tls("--guests", self.write("guests.txt", "observer watcher-001\n")))
        with Client(self.relay(port, f'token "watcher-001" tls_ca "{self.certificate}"').port()) as client:
            self.assertEqual(client.open(LASER, 0).type, ACK)
            max_range = client.next_data(LASER, 0).body[12:16]
        self.assertEqual(struct.unpack(">f", max_range)[0], 8)

    def test_a_passthrough_trusts_nobody_else(self):
        port = self.port(self.world_with_tls())
        other, _ = self.identity("other")
        for certificate, host in ((other, "127.0.0.1"), (self.certificate, "localhost")):
            house = self.relay(port, f'tls_ca "{certificate}"', host)
            with Client(house.port()) as client:
                self.assertEqual(client.open(LASER, 0).body[19], 3, "cannot be opened")
            house.wait_for_line("invalid TLS handshake: certificate verify failed")

    def test_who_comes_in_the_clear_is_told_what_the_server_may_speak(self):
        port = self.port(self.world_with_tls())
        with self.assertRaisesRegex(ConnectionLost, "no banner in time; the server may speak TLS"):
            connect(f":{port}", timeout=0.2)
        self.assertRegex(finish("devices", f":{port}").stderr, "nothing heard from it; it may speak TLS")
        house = self.relay(port, "")
        with Client(house.port()) as client:
            self.assertEqual(client.open(LASER, 0).body[19], 3, "cannot be opened")
        house.wait_for_line("does not answer within 3 s; if it speaks TLS, tls_ca says whom to trust")

    def test_robots_join_a_world_with_tls(self):
        port = self.port(self.enterContext(House("run", self.write("join.world", JOIN), "--port", 0, "--headless", *self.options())))
        robot = self.write("bob.toml", 'name = "bob"\ntype = "scout"\npose = [2, 0, 0]\n')
        with House("robot", robot, "--server", f"127.0.0.1:{port}", "--port", 0, "--tls-ca", self.certificate) as bob:
            here = int(bob.wait_for_line(r"^Player clients: 127\.0\.0\.1:(\d+) \(bob: ").group(1))
            with Client(here) as client:
                self.assertEqual(client.open(POSITION2D, 0).type, ACK)
        with House("robot", robot, "--server", f"127.0.0.1:{port}", "--tls-ca", robot) as bob:
            self.assertEqual(bob.wait(), 2)
            self.assertIn(f"{robot}: error: invalid certificate", bob.log())

    def test_files_that_are_no_identity_are_one_line(self):
        _, other_key = self.identity("other")
        _, secret_key = self.identity("secret", "-passout", "pass:word")
        world = self.world()
        _, rsa_key = self.identity("rsa", key_type=["rsa:2048"])
        for certificate, key, fault in (
                *((self.certificate, each, f"{each}: error: invalid private key.*: that of the certificate, PEM, without a passphrase, is valid")
                  for each in (other_key, secret_key, rsa_key)),
                (world, self.key, f"{world}: error: invalid certificate \\(.+\\): PEM, beginning with .+ is valid"),
                (self.certificate, "none.key", "none.key: error: cannot be opened: no such file")):
            done = finish("run", world, "--port", 0, "--web", "off", "--tls-cert", certificate, "--tls-key", key)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, rf"\A{fault}\n\Z")
        self.assertEqual(finish("run", world, "--tls-cert", self.certificate).returncode, 2)


if __name__ == "__main__":
    unittest.main()
