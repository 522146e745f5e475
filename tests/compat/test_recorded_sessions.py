"""Sessions recorded between original Player clients and the original server, played against this one: every request
must get an answer of the recorded type, subtype and size. What we do better on purpose is listed in IMPROVED."""

import os
import random
import struct
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "e2e"))

from house import ACK, LASER, NACK, PLAYER, POSITION2D, REFERENCE, REQ, ROOT, SYNCH, Client, House, Message

CAPTURES = REFERENCE / "player" / "captures"
# Stage's own worlds are not in this tree; stage_source() of playhouse/base/testing/reference.h looks in the same places.
NAMED, BESIDE = os.environ.get("PLAYHOUSE_STAGE", ""), ROOT.parent / "shared" / "stage"
SIMPLE = Path(NAMED or BESIDE / "worlds-data") / "worlds" / "simple.cfg"
with_stage = unittest.skipUnless(NAMED or BESIDE.is_dir(), "needs Stage's own worlds: git clone https://github.com/rtv/Stage "
                                 "(281ed731 is 4.3.0), and PLAYHOUSE_STAGE=the folder")

# (interface, subtype of the request) -> (type, size) recorded, (type, size) here, why
IMPROVED = {
    (LASER, 2): ((NACK, 0), (ACK, 28), "a laser takes a configuration"),
    (POSITION2D, 7): ((NACK, 0), (ACK, 0), "gains are kept (docs/drivers.md)"),
    (POSITION2D, 255): ((NACK, 0), (ACK, 0), "capabilities are told truly; the original says no to everything"),
}


def messages(data: bytes):
    at = 0
    while at + 40 <= len(data):
        size = struct.unpack(">I", data[at + 36:at + 40])[0]
        yield Message(data[at:at + 40], data[at + 40:at + 40 + size]), data[at:at + 40 + size]
        at += 40 + size


def answers(stream) -> list[tuple]:
    return [(m.interf, m.index, m.subtype, m.type, m.size) for m in stream if m.type in (ACK, NACK)]


class RecordedSessions(unittest.TestCase):
    configuration = Path(__file__).with_name("recorded.cfg")

    @classmethod
    def setUpClass(cls):
        cls.house = House("serve", cls.configuration, "--port", 0, "--headless", "--speed", 10)
        cls.addClassCleanup(cls.house.__exit__)
        cls.port = cls.house.port()

    def say(self, client: Client, raw: bytes):
        client.socket.sendall(raw)

    def play(self, name: str):
        """Sends the client's half message by message; gives back what was recorded and what came."""
        ours: list[Message] = []
        with Client(self.port) as client:
            recorded = (CAPTURES / f"{name}.s2c").read_bytes()
            self.assertEqual(len(client.banner), 32)
            for message, raw in messages((CAPTURES / f"{name}.c2s").read_bytes()):
                self.say(client, raw)
                if message.type != REQ:
                    continue
                self.read_answer(client, message, ours)
        return answers(m for m, _ in messages(recorded[32:])), answers(ours)

    def read_answer(self, client: Client, request: Message, heard: list[Message]):
        """Up to the answer, and where a round of data was asked for, up to its end."""
        wants_round = (request.interf, request.subtype) == (PLAYER, 4)
        while True:
            message = client.receive()
            heard.append(message)
            if message.type == SYNCH and wants_round:
                return
            answered = message.type in (ACK, NACK) and (message.interf, message.subtype) == (request.interf,
                                                                                             request.subtype)
            if answered and not wants_round:
                return

    def check(self, name: str):
        recorded, ours = self.play(name)
        # A session that was cut off has answers that nobody recorded.
        self.assertGreaterEqual(len(ours), len(recorded))
        for number, (theirs, mine) in enumerate(zip(recorded, ours)):
            improved = IMPROVED.get((theirs[0], theirs[2]))
            if improved and theirs[3:] == improved[0] and mine[3:] in improved[:2]:
                theirs = mine
            self.assertEqual(theirs, mine, f"answer {number} of {name}")


class RecordedSessionsInCrumbs(RecordedSessions):
    """The same over a line that delivers a few bytes at a time, and at odd times."""

    def setUp(self):
        self.draw = random.Random(self.id())
        self.witness = self.enterContext(Client(self.port))

    def say(self, client: Client, raw: bytes):
        at = 0
        while at < len(raw):
            size = self.draw.choice([1, 1, 1, 2, 3, 7, 40, 41])
            client.socket.sendall(raw[at:at + size])
            at += size
            if self.draw.random() < 0.1:
                self.witness.request(PLAYER, 0, 1)  # the server has read what was sent


@with_stage
class RecordedSessionsInTheRecordedWorld(RecordedSessions):
    configuration = SIMPLE


def add_test(name: str):
    def test(self):
        self.check(name)
    setattr(RecordedSessions, f"test_{name}", test)


for capture in ("02_raw_push_position2d", "03_raw_pull_mode", "05_playerprint_position2d", "06_playerprint_defaults",
                "10_cxxtest_position2d", "12_cxxtest_ranger", "14_raw_simulation"):
    add_test(capture)


@with_stage
class SimpleConfiguration(unittest.TestCase):
    def test_stages_own_sample_runs_unmodified(self):
        with House("serve", SIMPLE, "--port", 0, "--headless") as house, Client(house.port()) as client:
            self.assertEqual(client.devices(), [(31, 0), (POSITION2D, 0), (62, 0), (62, 1), (6, 0)])
            client.open(6, 0)
            scan = client.next_data(6, 0)
            self.assertEqual(struct.unpack(">I", scan.body[16:20])[0], 180)
            self.assertEqual(house.end(), 143)


if __name__ == "__main__":
    unittest.main()
