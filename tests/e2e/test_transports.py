"""Player clients by Unix sockets, by UDP and by multicast, and with a key. The other ends are plain sockets, and our clients through a
line that loses what the test says."""

import json
import os
import select
import signal
import socket
import ssl
import stat
import subprocess
import sys
import threading
import unittest
import urllib.request

from house import (ACK, DATA, LASER, NACK, PATIENCE, PLAYER, PROGRAM, REQ, ROOT, Client, House, HouseTest,
                   Message, frame, free_ports, text)
from test_without_world import CFG, PageSocket

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import ConnectionLost, InvalidValue, Mode, RequestRefused, RequestTimeout, RunEnded, WireError, connect  # noqa: E402
from playhouse_client.generated import laser, opaque  # noqa: E402


class Line:
    """Datagrams between clients and a server; `passes(number)` says which data messages of the server get through, by their
    place in the order they come."""

    def __init__(self, server: int, passes):
        self.server, self.passes = ("127.0.0.1", server), passes
        self.inner = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.outer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.inner.bind(("127.0.0.1", 0))
        self.outer.bind(("127.0.0.1", 0))
        self.port = self.outer.getsockname()[1]
        self.data = self.dropped = 0
        self.stopped, self.stop_line = socket.socketpair()
        self.thread = threading.Thread(target=self._carry, daemon=True)
        self.thread.start()

    def _carry(self):
        client = None
        while True:
            ready, _, _ = select.select([self.inner, self.outer, self.stopped], [], [])
            if self.stopped in ready:
                return
            if self.outer in ready:
                datagram, client = self.outer.recvfrom(65536)
                self.inner.sendto(datagram, self.server)
            if self.inner in ready:
                datagram = self.inner.recv(65536)
                if len(datagram) >= 40 and int.from_bytes(datagram[16:20], "big") == DATA:
                    self.data += 1
                    if not self.passes(self.data):
                        self.dropped += 1
                        continue
                self.outer.sendto(datagram, client)

    def close(self):
        self.stop_line.send(b"x")
        self.thread.join(PATIENCE)
        for each in (self.inner, self.outer, self.stopped, self.stop_line):
            each.close()


def port_of(house: House, ways: str) -> int:
    return int(house.wait_for_line(rf"^Player clients: 127\.0\.0\.1:(\d+) \({ways}\)$").group(1))


class UnixSockets(HouseTest):
    def run_here(self, *options) -> tuple[House, int]:
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", "off", "--unix", self.folder, *options))
        return house, port_of(house, rf"also {self.folder}/\d+")

    def test_the_same_bytes_as_by_tcp(self):
        _, port = self.run_here()
        path = self.folder / str(port)
        self.assertTrue(stat.S_ISSOCK(os.stat(path).st_mode))
        with socket.socket(socket.AF_UNIX) as unix:
            unix.settimeout(PATIENCE)
            unix.connect(str(path))
            unix.sendall(frame(PLAYER, 0, REQ, 1, seq=7))
            got = b""
            while len(got) < 32 + 40:
                got += unix.recv(65536)
            size = int.from_bytes(got[68:72], "big")
            while len(got) < 72 + size:
                got += unix.recv(65536)
        tcp = Client(port)
        self.addCleanup(tcp.socket.close)
        tcp.send(PLAYER, 0, REQ, 1, seq=7)
        self.assertEqual(got[:32], tcp.banner)
        self.assertEqual(got[72:], tcp.receive().body)

    def test_clients_in_python_and_commands_of_the_program_take_its_address(self):
        house, port = self.run_here()
        with connect(f"{self.folder}:{port}") as client:
            with client.laser() as laser:
                self.assertEqual(len(next(laser.updates()).ranges), 181)
        listed = subprocess.run([PROGRAM, "devices", f"{self.folder}:{port}"], capture_output=True, text=True, timeout=PATIENCE)
        self.assertIn("laser:0", listed.stdout, listed.stderr)
        wrong = subprocess.run([PROGRAM, "devices", f"{self.folder}:1"], capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(wrong.returncode, 1)
        self.assertIn("cannot connect: No such file or directory", wrong.stderr)
        house.end()
        self.assertFalse((self.folder / str(port)).exists(), "the socket is removed at the end")

    def test_a_passthrough_comes_by_one(self):
        _, port = self.run_here()
        relay = self.write("relay.cfg", f'driver ( name "passthrough" requires ["{self.folder}:{port}:laser:0"] provides ["laser:0"] )')
        with House("serve", relay, "--port", 0, "--web", "off") as near:
            with connect(f"127.0.0.1:{near.port()}") as client, client.laser() as laser:
                client.read()
                self.assertEqual(len(laser.ranges), 181)

    def test_a_folder_that_is_missing_is_said(self):
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", "off", "--unix", self.folder / "none"))
        self.assertEqual(house.wait(), 2)
        self.assertRegex(house.log(), r"--unix: invalid folder \".*/none\": one that exists is valid")


class Udp(HouseTest):
    def run_here(self, *options) -> tuple[House, int]:
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", "off", "--udp", *options))
        return house, port_of(house, "also UDP")

    def line(self, port: int, passes) -> Line:
        line = Line(port, passes)
        self.addCleanup(line.close)
        return line

    def udp(self, port: int) -> socket.socket:
        made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        made.settimeout(PATIENCE)
        made.connect(("127.0.0.1", port))
        self.addCleanup(made.close)
        return made

    def test_a_session_byte_for_byte(self):
        _, port = self.run_here()
        client = self.udp(port)
        client.send(b"")
        banner = client.recv(65536)
        self.assertEqual((len(banner), banner[:9]), (32, b"Player v."))
        opening = frame(PLAYER, 0, REQ, 3, b"".join(value.to_bytes(4, "big") for value in (0, 0, LASER, 0, 1, 0, 0)), seq=5)
        client.send(opening[:20])  # a message may be cut anywhere
        client.send(opening[20:])
        answer = client.recv(65536)
        message = Message(answer[:40], answer[40:])
        self.assertEqual((message.type, message.seq), (ACK, 5))
        numbers = []
        while len(numbers) < 5:
            datagram = client.recv(65536)
            message = Message(datagram[:40], datagram[40:])
            self.assertEqual((message.interf, message.type, message.size), (LASER, DATA, len(datagram) - 40))
            numbers.append(message.seq)
        self.assertEqual(numbers, [1, 2, 3, 4, 5])

    def test_a_client_that_is_gone_is_noticed_and_the_others_go_on(self):
        house = self.enterContext(House("serve", self.write("lab.cfg", CFG), "--port", 0, "--web", 0, "--udp"))
        port = port_of(house, "also UDP")
        page = house.wait_for_line(r"^web page: (http://127\.0\.0\.1:\d+/)").group(1)

        def clients() -> list[str]:
            status = json.loads(urllib.request.urlopen(f"{page}status.json", timeout=PATIENCE).read())
            return [each["peer"] for each in status["clients"]]

        with connect(f"udp:127.0.0.1:{port}", mode=Mode.PUSH) as stays, stays.laser():
            gone = self.udp(port)
            gone.send(b"")
            gone.recv(65536)
            gone.send(frame(PLAYER, 0, REQ, 3, b"".join(value.to_bytes(4, "big") for value in (0, 0, LASER, 0, 1, 0, 0))))
            gone.recv(65536)
            self.assertEqual(len(clients()), 2)
            gone.close()
            while len(clients()) == 2:
                stays.read()
            for _ in range(5):
                stays.read()

    def test_data_that_go_astray_are_counted_by_their_reader(self):
        _, port = self.run_here("--speed", 20)
        line = self.line(port, lambda number: number % 3 != 0)
        with connect(f"udp:127.0.0.1:{line.port}", mode=Mode.PUSH) as client, client.laser() as laser:
            for _ in range(40):
                client.read()
            client.set_mode(Mode.PULL)  # so that nothing is on its way but what was asked for
            lost = client.lost_count()
            self.assertEqual(len(laser.ranges), 181)
        self.assertGreaterEqual(lost, 10)
        self.assertLessEqual(abs(lost - line.dropped), 1, "the last one may be known as lost by the next alone")

    def test_rounds_of_data_come_by_pull(self):
        _, port = self.run_here("--speed", 20)
        with connect(f"udp:127.0.0.1:{port}") as client:
            with client.position2d() as wheels, client.laser() as laser:
                wheels.drive(0.5)
                client.read()
                while wheels.pose.x < 0.3:
                    client.read()
                self.assertEqual(len(laser.ranges), 181)
            self.assertEqual(client.lost_count(), 0)

    def test_commands_arrive_after_requests_that_had_no_answer_in_time(self):
        house, port = self.run_here()
        with connect(f"udp:127.0.0.1:{port}") as client, client.position2d() as wheels, client.laser() as scanner:
            house.process.send_signal(signal.SIGSTOP)
            os.waitpid(house.process.pid, os.WUNTRACED)  # all of its threads have stopped
            for _ in range(5):
                with self.assertRaises(RequestTimeout):
                    scanner.request(laser.REQ_GET_GEOM, timeout=0.05)
            house.process.send_signal(signal.SIGCONT)
            client.devices()
            wheels.drive(0.5)
            client.read()
            while wheels.pose.x < 0.1:
                client.read()

    def test_the_end_of_the_run_and_another_server_in_its_place_are_noticed(self):
        house, port = self.run_here()
        with connect(f"udp:127.0.0.1:{port}", mode=Mode.PUSH) as client, client.laser():
            client.read()
            house.end()
            with self.assertRaises(RunEnded):
                while True:
                    client.read()
        (port,) = free_ports()
        first = self.enterContext(House("run", self.world(), "--port", port, "--web", "off", "--udp"))
        port_of(first, "also UDP")
        with connect(f"udp:127.0.0.1:{port}") as client, client.laser():
            client.read()
            first.process.kill()
            first.process.wait()
            second = self.enterContext(House("run", self.world(), "--port", port, "--web", "off", "--udp"))
            port_of(second, "also UDP")
            with self.assertRaises(ConnectionLost):
                while True:
                    client.read()

    def test_a_message_that_no_datagram_holds_is_refused_here(self):
        _, port = self.run_here()
        with connect(f"udp:127.0.0.1:{port}") as client:
            with self.assertRaises(WireError):
                client.device("laser").command(opaque.CMD_DATA, opaque.Data(bytes(70000)))
            client.devices()

    def test_a_server_for_others_asks_for_a_key(self):
        house = self.enterContext(House("run", self.world(), "--udp", "--bind", "0.0.0.0", "--insecure"))
        self.assertEqual(house.wait(), 2)
        self.assertIn("senders of datagrams can be forged", house.log())

    def test_answers_come_from_the_address_that_was_spoken_to(self):
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", "off", "--udp", "--bind", "0.0.0.0", "--key", "open-sesame"))
        port = int(house.wait_for_line(r"^Player clients: [\d.]+:(\d+) \(also UDP\)$").group(1))
        for host in ("127.0.0.1", "127.0.0.2"):
            with connect(f"udp:{host}:{port}", token="open-sesame") as client, client.laser() as laser:
                client.read()
                self.assertEqual(len(laser.ranges), 181)

    def test_what_was_lost_is_told(self):
        house, port = self.run_here()
        with connect(f"udp:127.0.0.1:{port}") as client:
            client.devices()
        house.end()
        self.assertRegex(house.log(), r"info: UDP: \d+ datagrams received, 0 of them dropped, 0 commands overtaken; \d+ messages sent")

    def test_nobody_is_there(self):
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", "off"))
        with self.assertRaises(ConnectionLost) as refused:
            connect(f"udp:127.0.0.1:{house.port()}")
        self.assertIn("refused", str(refused.exception))

    def test_tls_does_not_go_with_it(self):
        house = self.enterContext(House("run", self.world(), "--udp", "--tls-cert", "a", "--tls-key", "b"))
        self.assertEqual(house.wait(), 2)
        self.assertIn("--tls-cert excludes --udp", house.log())


class Multicast(HouseTest):
    def run_here(self, *options) -> tuple[House, int]:
        (port,) = free_ports()
        group = f"239.255.66.65:{port}"
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", "off", "--multicast", group, *options))
        return house, port_of(house, f"(?:also UDP, )?data also to {group}")

    def test_two_clients_get_the_same_messages_each_of_which_is_sent_once(self):
        house, port = self.run_here("--speed", 10)
        one, two = (self.enterContext(connect(f"127.0.0.1:{port}", multicast=True)) for _ in range(2))
        times = [[], []]
        for client, seen in zip((one, two), times):
            client.laser().on_data(lambda _message, _value, at, seen=seen: seen.append(at))
        while len(times[1]) < 30:
            two.read()
        while times[0][-1:] < times[1][-1:]:
            one.read()
        self.assertEqual([at for at in times[0] if times[1][0] <= at <= times[1][-1]], times[1])
        self.assertEqual((one.lost_count(), two.lost_count()), (0, 0))
        for client in (one, two):
            client.close()
        with connect(f"127.0.0.1:{port}") as after, after.laser() as laser:
            after.read()
            ticks = round((laser.timestamp - times[0][0]) / min(b - a for a, b in zip(times[0], times[0][1:])))
        house.end()
        sent = int(house.wait_for_line(r"multicast: (\d+) messages sent, 0 not sent").group(1))
        self.assertGreaterEqual(sent, 30)
        self.assertLessEqual(sent, ticks + 1, "once, not for each")

    def test_requests_commands_and_the_end_come_by_the_connection(self):
        house, port = self.run_here("--udp", "--speed", 10)
        for way in ("", "udp:"):
            with connect(f"{way}127.0.0.1:{port}", multicast=True) as client, client.position2d() as wheels:
                self.assertIn("laser:0", [each.name for each in client.devices()])
                start = next(wheels.updates()).pose.x
                wheels.drive(0.5)
                while wheels.pose.x < start + 0.1:
                    client.read()
                wheels.drive(0)
        with connect(f"127.0.0.1:{port}", multicast=True) as client, client.laser():
            client.read()
            house.end()
            with self.assertRaises(RunEnded):
                while True:
                    client.read()

    def test_a_client_that_does_not_ask_and_one_in_pull_mode_read_as_ever(self):
        _, port = self.run_here()
        with connect(f"127.0.0.1:{port}") as client, client.laser() as laser:
            client.read()
            self.assertEqual(len(laser.ranges), 181)
        with connect(f"127.0.0.1:{port}", multicast=True) as client, self.assertRaises(InvalidValue):
            client.set_mode(Mode.PULL)

    def test_a_server_without_a_group_says_so(self):
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", "off"))
        with self.assertRaises(RequestRefused) as refused:
            connect(f"127.0.0.1:{house.port()}", multicast=True)
        self.assertIn("--multicast GROUP", str(refused.exception))

    def test_what_does_not_go_with_it_is_said(self):
        group = ("--multicast", "239.255.0.1")
        for options, why in (
            (("--multicast", "10.0.0.1"), 'invalid group "10.0.0.1": a multicast address, 224.0.0.0 to 239.255.255.255, is valid'),
            (("--multicast", "239.255.0.1:0"), 'invalid group "239.255.0.1:0"'),
            (("--multicast", "ff02::1"), 'invalid group "ff02::1"'),
            ((*group, "--tls-cert", "a", "--tls-key", "b"), "excludes"),
            ((*group, "--guests", "a"), "excludes"),
            ((*group, "--key", "open-sesame"), "excludes"),
            ((*group, "--bind", "::1"), "a group of IPv4 is reached from an IPv4 address"),
        ):
            with self.subTest(options):
                house = self.enterContext(House("run", self.world(), *options))
                self.assertEqual(house.wait(), 2)
                self.assertIn(why, house.log())


class WebSockets(HouseTest):
    """Of the page of a world, which has a thread of its own. A server without one: test_without_world.py."""

    def open(self, *where, **more) -> PageSocket:
        page = PageSocket(*where, **more)
        self.addCleanup(page.socket.close)
        return page

    def run_here(self, *options) -> tuple[House, int, int]:
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", 0, *options))
        return house, house.port(), int(house.wait_for_line(r"^web page: http://127\.0\.0\.1:(\d+)/").group(1))

    def test_the_bytes_of_tcp(self):
        _, port, web = self.run_here()
        with Client(port) as client:
            for path in ("/player", f"/player/{port}"):
                page = self.open(web, path)
                self.assertTrue(page.head.startswith(b"HTTP/1.1 101"), page.head)
                self.assertEqual(page.receive(), client.banner.ljust(32, b"\0")[:32])
                page.send(frame(PLAYER, 0, REQ, 1))
                self.assertEqual(page.frame()[40:], client.request(PLAYER, 0, 1).body)
                page.socket.close()
        self.assertTrue(self.open(web, "/player/7").receive().endswith(b"this server has no port 7"))

    def test_pages_of_others_and_other_paths_are_refused(self):
        _, _, web = self.run_here()
        for path, more in (("/player", "Origin: http://evil.example\r\n"), ("/player/x", ""), ("/playerx", "")):
            self.assertTrue(self.open(web, path, more).head.startswith(b"HTTP/1.1 403"), (path, more))
        self.assertTrue(self.open(web, "/live").head.startswith(b"HTTP/1.1 101"))

    def test_many_come_and_go_while_the_world_runs_and_one_at_the_end(self):
        house, _, web = self.run_here("--speed", 20)
        for _ in range(50):
            page = self.open(web)
            page.receive()
            page.socket.close()
        last = self.open(web)
        last.receive()
        self.assertEqual(house.end(), 143)
        self.assertNotIn("error", house.log())

    def test_hundreds_shut_out_nobody(self):
        house, port, web = self.run_here()
        lab = self.enterContext(House("serve", self.write("lab.cfg", CFG), "--port", 0, "--web", 0))
        ports = (web, port), (int(lab.wait_for_line(r"^web page: http://127\.0\.0\.1:(\d+)/").group(1)), lab.port())
        for page, players in ports:
            for _ in range(300):
                self.assertEqual(self.open(page).receive()[:9], b"Player v.")
            urllib.request.urlopen(f"http://127.0.0.1:{page}/", timeout=PATIENCE).read()
            with Client(players) as client:
                self.assertEqual(client.request(PLAYER, 0, 1).type, ACK)

    def test_tokens_are_those_of_other_clients(self):
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", 0, "--key", "open-sesame"))
        house.port()
        page = self.open(int(house.wait_for_line(r"^web page: http://127\.0\.0\.1:(\d+)/").group(1)))
        page.receive()
        page.send(frame(PLAYER, 0, REQ, 1))
        self.assertEqual(Message(page.frame()[:40], b"").type, NACK)
        page.send(frame(PLAYER, 0, REQ, 7, text("open-sesame")))
        self.assertEqual(Message(page.frame()[:40], b"").type, ACK)

    def test_by_tls(self):
        certificate, key = self.folder / "server.crt", self.folder / "server.key"
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-days", "2", "-nodes",
                        "-subj", "/CN=robots", "-addext", "subjectAltName=IP:127.0.0.1", "-keyout", key, "-out", certificate],
                       check=True, capture_output=True)
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", 0, "--tls-cert", certificate, "--tls-key", key))
        page = self.open(int(house.wait_for_line(r"^web page: https://127\.0\.0\.1:(\d+)/").group(1)),
                         tls=ssl.create_default_context(cafile=str(certificate)))
        self.assertEqual(page.receive()[:9], b"Player v.")
        page.send(frame(PLAYER, 0, REQ, 1))
        self.assertEqual(Message(page.frame()[:40], b"").type, ACK)


class Key(HouseTest):
    def test_who_has_it_comes_in_by_the_originals_request_and_nobody_else(self):
        house = self.enterContext(House("run", self.world(), "--port", 0, "--web", "off", "--key", "open-sesame"))
        port = house.port()
        with connect(f"127.0.0.1:{port}") as stranger, self.assertRaises(RequestRefused):
            stranger.devices()
        with self.assertRaises(RequestRefused):
            connect(f"127.0.0.1:{port}", token="open-barley")
        with connect(f"127.0.0.1:{port}", token="open-sesame") as client, client.position2d() as wheels:
            wheels.drive(0.5)
            client.read()
            while wheels.pose.x < 0.05:
                client.read()

    def test_a_server_without_a_world_has_one_and_may_be_bound_wider_then(self):
        cfg = self.write("lab.cfg", CFG)
        house = self.enterContext(House("serve", cfg, "--port", 0, "--web", "off", "--bind", "0.0.0.0", "--key", "open-sesame"))
        port = int(house.wait_for_line(r"^Player clients: [\d.]+:(\d+)$").group(1))
        client = Client(port)
        self.addCleanup(client.socket.close)
        self.assertEqual(client.request(PLAYER, 0, 1).type, NACK)
        self.assertEqual(client.request(PLAYER, 0, 7, text("open-sesame")).type, ACK)
        self.assertEqual(client.request(PLAYER, 0, 1).type, ACK)

    def test_one_that_is_too_short_is_refused(self):
        house = self.enterContext(House("run", self.world(), "--key", "short"))
        self.assertEqual(house.wait(), 2)
        self.assertIn("invalid key: 8 to 32 letters, digits, - and _ are valid", house.log())


if __name__ == "__main__":
    unittest.main()
