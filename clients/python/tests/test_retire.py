"""What a program sees of devices that the real server retires."""

import os
import subprocess
import unittest
from typing import List

import package  # noqa: F401
from playhouse_client import Client, DeviceGone, Mode, RequestRefused, connect

PROGRAM = os.environ.get("PLAYHOUSE_RETIRING_SERVER", "")
LONG = 30.0  # an answer is not waited for: it comes, or something hangs


class RetiringServer:
    """The server of clients/tests/retiring_server.cc, as a `with` block."""

    def __enter__(self) -> "RetiringServer":
        self._process = subprocess.Popen([PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.address = self._line()
        return self

    def __exit__(self, *_: object) -> None:
        self._process.communicate(timeout=LONG)

    def do(self, *lines: str) -> None:
        for line in lines:
            assert self._process.stdin is not None
            self._process.stdin.write(line + "\n")
            self._process.stdin.flush()
            assert self._line() == "done"

    def _line(self) -> str:
        assert self._process.stdout is not None
        return self._process.stdout.readline().strip()


@unittest.skipUnless(os.access(PROGRAM, os.X_OK), "PLAYHOUSE_RETIRING_SERVER names no program")
class RetiredDevice(unittest.TestCase):
    def both_modes(self) -> List[Mode]:
        return [Mode.PUSH, Mode.PULL]

    def connected(self, server: RetiringServer, mode: Mode) -> Client:
        server.do("add 0", "add 3")
        return connect(server.address, mode=mode, timeout=LONG)

    def test_it_gives_its_last_data_and_fails_at_once_from_then_on(self) -> None:
        for mode in self.both_modes():
            with self.subTest(mode=mode), RetiringServer() as server, self.connected(server, mode) as client:
                gone, other = client.position2d(3), client.position2d(0)
                server.do("publish 3 1", "retire 3", "publish 0 2")
                while not (gone.gone and other.has_data):
                    client.read()
                self.assertEqual(gone.pose.x, 1.0)
                port = server.address.split(":")[1]
                gone.next_data()  # its last
                for use in (lambda: gone.drive(1.0), gone.geometry, gone.next_data):
                    with self.assertRaisesRegex(DeviceGone, f"^{port}:position2d:3 is gone: the server retired it$"):
                        use()
                gone.close()
                self.assertFalse(gone.is_open)
                other.geometry()

    def test_next_data_of_it_does_not_wait(self) -> None:
        for mode in self.both_modes():
            with self.subTest(mode=mode), RetiringServer() as server, self.connected(server, mode) as client:
                gone = client.position2d(3)
                server.do("retire 3")
                with self.assertRaises(DeviceGone):
                    gone.next_data()
                self.assertTrue(client.connected)

    def test_it_leaves_its_address_to_another_and_does_not_become_it(self) -> None:
        for mode in self.both_modes():
            with self.subTest(mode=mode), RetiringServer() as server, self.connected(server, mode) as client:
                gone = client.position2d(3)
                server.do("publish 3 1", "retire 3", "add 3")
                following = client.position2d(3)
                self.assertTrue(gone.gone)
                server.do("publish 3 2")
                while not following.has_data:
                    client.read()
                self.assertEqual(following.pose.x, 2.0)
                self.assertFalse(following.gone)
                self.assertFalse(gone.has_data and gone.pose.x == 2.0)
                gone.close()
                following.geometry()

    def test_a_request_before_it_is_told_is_refused(self) -> None:
        with RetiringServer() as server, self.connected(server, Mode.PULL) as client:
            gone = client.position2d(3)
            server.do("retire 3")
            with self.assertRaises(RequestRefused):
                gone.geometry()
            client.read()
            with self.assertRaises(DeviceGone):
                gone.geometry()


if __name__ == "__main__":
    unittest.main()
