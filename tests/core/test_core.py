"""The device server alone, as it is built for one kind of machine (tools/cores.sh): the same bytes as the whole program sends,
relays of each other's devices, and the command line of Player's own server. PLAYHOUSE_PLAYER: its command, an emulator first
where this machine cannot run it; PLAYHOUSE_PROGRAM: the whole program."""

import os
import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/e2e"), str(ROOT / "clients/python")]
from house import DATA, PROGRAM, Client, HouseTest, free_ports  # noqa: E402
from playhouse_client import RequestRefused, connect  # noqa: E402
from playhouse_client.generated import INTERFACES, find_message  # noqa: E402
from playhouse_client.wire import Kind  # noqa: E402

PLAYER = shlex.split(os.environ["PLAYHOUSE_PLAYER"])
NAMES = {name: code for code, name in INTERFACES.items() if name != "player"}
MADE_UP = "driver( name \"dummy\" provides [" + " ".join(f'"{name}:0"' for name in NAMES) + "] rate 20 seed 4 )\n"


class Running:
    """A program that serves a file, and the port that it says."""

    def __init__(self, *command):
        self.program = subprocess.Popen([*map(str, command)], stdout=subprocess.PIPE, text=True)
        line = self.program.stdout.readline()
        if not line.startswith("Listening on ports: "):
            raise AssertionError(f"{command} says {line!r} and ends with {self.program.wait()}")
        self.port = int(line.split()[3])

    def end(self) -> int:
        self.program.terminate()
        code = self.program.wait()
        self.program.stdout.close()
        return code


class Core(HouseTest):
    def player(self, text: str, port: int = 0, *words: str) -> Running:
        running = Running(*PLAYER, *words, "-p", port, self.write(f"{len(os.listdir(self.folder))}.cfg", text))
        self.addCleanup(running.end)
        return running

    def whole_program(self, text: str, port: int = 0) -> Running:
        link = Path(self.enterContext(tempfile.TemporaryDirectory())) / "player"
        link.symlink_to(Path(PROGRAM).resolve())
        running = Running(link, "-p", port, self.write(f"{len(os.listdir(self.folder))}.cfg", text))
        self.addCleanup(running.end)
        return running

    def first_data(self, port: int, count: int) -> dict:
        """Of each device, opened alone: the first messages, (subtype, body)."""
        found = {}
        for name, code in NAMES.items():
            if not any(find_message(code, Kind.DATA, subtype) for subtype in range(1, 247)):
                continue
            with Client(port) as client:
                client.open(code, 0)
                messages = []
                while len(messages) < count:
                    message = client.receive()
                    if message.type == DATA:
                        messages.append((message.subtype, message.body))
                found[name] = messages
        return found

    def test_sends_the_bytes_of_the_whole_program(self):
        port = free_ports()[0]  # which what is made up depends on
        running = self.player(MADE_UP, port)
        here = self.first_data(port, 3)
        running.end()
        self.whole_program(MADE_UP, port)
        there = self.first_data(port, 3)
        self.assertGreater(len(here), 35)
        for name, messages in here.items():
            with self.subTest(name):
                self.assertEqual(messages, there[name])

    def test_relays_the_whole_program_and_is_relayed_by_it(self):
        lab = self.whole_program(MADE_UP)
        relay = ("driver( name \"passthrough\" requires [\":127.0.0.1:{}:laser:0\" \":127.0.0.1:{}:position2d:0\"] "
                 "provides [\"laser:0\" \"position2d:0\"] )\n")
        middle = self.player(relay.format(lab.port, lab.port))
        end = self.whole_program(relay.format(middle.port, middle.port))
        with connect(f":{end.port}", timeout=20) as client:
            laser = client.laser()
            laser.next_data()
            self.assertEqual(len(laser.ranges), 181)
            client.position2d().drive(0.5)
            self.assertIsNotNone(laser.geometry())

    def test_asks_for_a_key(self):
        running = self.player(MADE_UP, 0, "-k", "the-key-7", "-b", "127.0.0.1", "-m", "5")
        for token in ("", "the-key-8"):
            with self.subTest(token), self.assertRaises(RequestRefused), connect(f":{running.port}", token=token) as client:
                client.laser()
        with connect(f":{running.port}", token="the-key-7", timeout=20) as client:
            client.laser().next_data()

    def test_ends_as_players_own_server_does(self):
        self.assertEqual(self.player(MADE_UP).end(), 0)
        for words, code in [(["-x"], 255), (["-k", "short", "any.cfg"], 255), (["-m", "4", "any.cfg"], 255), (["nowhere.cfg"], 1), ([self.write("bad.cfg", "driver ( nme \"dummy\" )")], 255)]:
            with self.subTest(words):
                done = subprocess.run([*PLAYER, *map(str, words)], capture_output=True, text=True)
                self.assertEqual(done.returncode, code, done.stderr)
        self.assertIn("bad.cfg:1: error: a driver needs a name", done.stderr)


if __name__ == "__main__":
    unittest.main()
