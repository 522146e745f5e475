"""A server without a world: its page, its status, access by tokens, recording, and options that only a world has."""

import base64
import json
import os
import socket
import ssl
import urllib.error
import urllib.request
import unittest

from house import ACK, DATA, LASER, NACK, PATIENCE, PLAYER, POSITION2D, REQ, Client, House, HouseTest, finish, frame, wait_until

CFG = 'driver( name "dummy" provides ["laser:0" "position2d:0" "gps:0"] rate 20 )'
GUESTS = """
admin    the-admin-1 Ada
observer watcher-001
"""


class PageSocket:
    """A WebSocket to a page's Player port, as browsers open it; see RFC 6455."""

    def __init__(self, port: int, path: str = "/player", more: str = "", tls: ssl.SSLContext | None = None):
        self.socket = socket.create_connection(("127.0.0.1", port), PATIENCE)
        if tls is not None:
            self.socket = tls.wrap_socket(self.socket, server_hostname="127.0.0.1")
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                             f"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n{more}\r\n").encode())
        self.buffer = b""
        while b"\r\n\r\n" not in self.buffer:
            self.buffer += self.socket.recv(65536)
        self.head, self.buffer = self.buffer.split(b"\r\n\r\n", 1)

    def send(self, data: bytes):
        assert len(data) < 126
        self.socket.sendall(bytes([0x82, 0x80 | len(data)]) + b"\0\0\0\0" + data)

    def frame(self) -> bytes:
        """A frame of Player, which messages may cut."""
        content = self.receive()
        while len(content) < 40 + int.from_bytes(content[36:40], "big"):
            content += self.receive()
        return content

    def receive(self) -> bytes:
        """The content of one message."""
        self._need(2)
        size, head = self.buffer[1] & 0x7F, 2
        if size >= 126:
            head = 4 if size == 126 else 10
            self._need(head)
            size = int.from_bytes(self.buffer[2:head], "big")
        self._need(head + size)
        content, self.buffer = self.buffer[head:head + size], self.buffer[head + size:]
        return content

    def _need(self, count: int):
        while len(self.buffer) < count:
            more = self.socket.recv(65536)
            assert more, "the server closed the connection"
            self.buffer += more


class WithoutWorld(HouseTest):
    def serve(self, *options, cfg=CFG) -> House:
        return self.enterContext(House("serve", self.write("lab.cfg", cfg), "--port", 0, "--web", 0, *options))

    def open(self, *where) -> PageSocket:
        page = PageSocket(*where)
        self.addCleanup(page.socket.close)
        return page

    def page(self, house: House) -> int:
        return int(house.wait_for_line(r"^web page: http://127\.0\.0\.1:(\d+)/").group(1))

    def get(self, port: int, path: str) -> bytes:
        return urllib.request.urlopen(f"http://127.0.0.1:{port}{path}", timeout=PATIENCE).read()

    def test_a_websocket_carries_the_bytes_of_tcp(self):
        house = self.serve()
        page = self.open(self.page(house))
        self.assertTrue(page.head.startswith(b"HTTP/1.1 101"), page.head)
        with Client(house.port()) as client:
            self.assertEqual(page.receive(), client.banner.ljust(32, b"\0")[:32])
            page.send(frame(PLAYER, 0, REQ, 1))   # the list of devices
            answer = page.frame()
            self.assertEqual(answer[40:], client.request(PLAYER, 0, 1).body)

    def test_pages_of_others_and_other_paths_are_refused(self):
        port = self.page(self.serve())
        for path, more in (("/player", "Origin: http://evil.example\r\n"), ("/live", ""), ("/player/x", ""), ("/playerx", "")):
            self.assertTrue(self.open(port, path, more).head.startswith(b"HTTP/1.1 403"), (path, more))
        self.assertTrue(self.open(port, "/player/7").receive().endswith(b"this server has no port 7"))

    def test_the_status_tells_who_is_connected(self):
        house = self.serve()
        port = self.page(house)
        self.assertEqual(json.loads(self.get(port, "/status.json")), {"ports": [house.port()], "clients": [], "drives": True})
        with Client(house.port()) as client:
            client.open(LASER, 0)
            (one,) = json.loads(self.get(port, "/status.json"))["clients"]
            self.assertEqual((one["port"], one["devices"]), (house.port(), ["laser:0"]))
            self.assertEqual(one["peer"], "%s:%s" % client.socket.getsockname())

    def test_tokens_decide_as_in_a_world(self):
        house = self.serve("--guests", self.write("guests.txt", GUESTS))
        port = self.page(house)
        house.wait_for_line(f"Ada .admin.: http://127.0.0.1:{port}/#the-admin-1")
        with Client(house.port()) as client:
            self.assertEqual(client.open(POSITION2D, 0).type, NACK)
        with self.assertRaises(urllib.error.HTTPError) as refused:
            self.get(port, "/status.json")
        self.assertEqual(refused.exception.code, 403)
        refused.exception.close()
        watched = json.loads(self.get(port, "/status.json?token=watcher-001"))
        self.assertEqual((watched["clients"], watched["drives"]), ([], False))
        self.assertTrue(json.loads(self.get(port, "/status.json?token=the-admin-1"))["drives"])

    def test_a_recording_opens_all_devices_and_grows(self):
        file = self.folder / "lab.mcap"
        house = self.serve("--record", file)
        port = self.page(house)
        recording = lambda: json.loads(self.get(port, "/status.json"))["recording"]  # noqa: E731
        wait_until(lambda: recording()["messages"] > 20, "data are recorded, though no client is there")
        self.assertEqual((recording()["file"], recording()["dropped"]), (str(file), 0))
        self.assertEqual(house.end(), 128 + 15)
        content = file.read_bytes()
        self.assertTrue(content.startswith(b"\x89MCAP0\r\n") and content.endswith(b"\x89MCAP0\r\n"))
        for command in (("replay", file, "--web", 0), ("run", "--again", file), ("export", file, "--changes"), ("export", file, "--csv")):
            done = finish(*command)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            self.assertRegex(done.stderr, f"^{file}: error: is a recording of devices, without a world: it has no .*docs/recording.md.\n$")
        self.assertFalse((self.folder / "lab").exists(), "no folder without tables")

    def test_what_only_a_world_has_is_an_error(self):
        cfg = self.write("lab.cfg", CFG)
        for options in (("--speed", 2), ("--fast",), ("--duration", 1), ("--engine", "arena"), ("--observers", 0), ("--paused",)):
            done = finish("serve", cfg, "--port", 0, "--headless", *options)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr, f"{cfg}: error: invalid option {options[0]}: the file has no world\n")

    def test_a_page_that_nobody_asked_for_is_left_out_where_its_port_is_in_use(self):
        cfg = self.write("lab.cfg", CFG)
        try:
            taken = socket.create_server(("127.0.0.1", 8080))
        except OSError:
            taken = None    # in use already
        try:
            with House("serve", cfg, "--port", 0) as house, Client(house.port()) as client:
                house.wait_for_line("no web page: .*8080.* in use; --web takes another port")
                self.assertEqual(client.open(LASER, 0).type, ACK)
                self.assertEqual(client.next_data(LASER, 0).type, DATA)
            self.assertEqual(finish("serve", cfg, "--port", 0, "--web", 8080).returncode, 1)
        finally:
            if taken:
                taken.close()


if __name__ == "__main__":
    unittest.main()
