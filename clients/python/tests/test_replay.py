"""The same operations as in the recorded sessions send the same bytes, in every language."""

import os
import subprocess
import sys
import threading
import unittest
from typing import List, Sequence

import languages
import recordings
from fake_server import FakeServer, Peer
from playhouse_client.connection import Message
from playhouse_client.wire import HEADER_BYTES, Header, Kind
from scenarios import SCENARIOS

CLOSE_ALL = "our clients close their devices, the recorded program just ended"
# Beside header timestamps, and the port in the header of device messages, this is all that differs.
DIFFERENCES = {
    "11_cxxtest_laser": CLOSE_ALL,
    "13_raw_map": CLOSE_ALL,
    "14_raw_simulation": CLOSE_ALL,
    "15_raw_properties": CLOSE_ALL,
}


def replay(name: str, peer: Peer) -> None:
    """Feeds what was recorded: after a request up to its answer, after a request for data up to the SYNCH."""
    waiting = list(recordings.stream(name + ".s2c").messages())
    while True:
        message = peer.receive()
        if message is None:
            return
        if message.header.kind != Kind.REQ:
            continue
        last = _index_of_answer(waiting, message)
        if last is None:
            peer.answer(message, body=message.body)  # a close that the recording does not have
            continue
        for header, body in waiting[: last + 1]:
            peer.send(header.encode() + body)
        del waiting[: last + 1]


def _index_of_answer(waiting: Sequence[Message], request: Message):
    wanted = request.header
    is_data = wanted.interface == 1 and wanted.subtype == 4
    for i, (header, _) in enumerate(waiting):
        if is_data and header.kind == Kind.SYNCH:
            return i
        answers = header.kind in (Kind.ACK, Kind.NACK)
        if not is_data and answers and (header.interface, header.index, header.subtype) == (
            wanted.interface, wanted.index, wanted.subtype,
        ):
            return i
    return None


def masked(message: bytes) -> bytes:
    """Without what differs from run to run: the time, and the port where a device is addressed."""
    header = Header.decode(message[:HEADER_BYTES])
    robot = header.robot if header.interface == 1 else 0
    return header._replace(timestamp=0.0, robot=robot).encode() + message[HEADER_BYTES:]


def shown(messages: Sequence[bytes]) -> List[str]:
    return [m.hex() for m in messages]


class Replay(unittest.TestCase):
    maxDiff = None

    def check(self, command: Sequence[str], name: str) -> None:
        with FakeServer(lambda peer: replay(name, peer)) as server:
            program = [*command, name, server.address]
            done = subprocess.run(program, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        assert server.peer is not None
        sent = [masked(m) for m in server.peer.received]
        recorded = [masked(h.encode() + b) for h, b in recordings.stream(name + ".c2s").messages()]
        extra = sent[len(recorded) :]
        self.assertEqual(shown(sent[: len(recorded)]), shown(recorded))
        if name in DIFFERENCES:
            self.assertTrue(all(_closes(m) for m in extra), shown(extra))
        else:
            self.assertEqual(shown(extra), [])

    def test_python_sends_what_was_recorded(self) -> None:
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "scenarios.py")
        for name in SCENARIOS:
            with self.subTest(name):
                self.check([sys.executable, script], name)

    @languages.needed
    def test_the_other_languages_send_what_was_recorded(self) -> None:
        for language, program in languages.programs("scenarios").items():
            for name in SCENARIOS:
                with self.subTest(language, name=name):
                    self.check([program], name)


def _closes(message: bytes) -> bool:
    header = Header.decode(message[:HEADER_BYTES])
    return header.interface == 1 and header.subtype == 3 and message[HEADER_BYTES + 19] == 2


if __name__ == "__main__":
    unittest.main()
