"""What the end-to-end tests share: starting the real program, and a client that knows the bytes of the wire by heart
(so that a fault in the client libraries cannot hide one in the server). Standard library only; no fixed ports."""

from __future__ import annotations

import os
import random
import re
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests"))
from waiting import PATIENCE, wait_for_any, wait_until  # noqa: E402, F401

PROGRAM = os.environ.get("PLAYHOUSE_PROGRAM", str(ROOT / "build" / "playhouse"))
RELEASE = os.environ.get("PLAYHOUSE_RELEASE", "")
HEAP_REPORT = os.environ.get("PLAYHOUSE_HEAP_REPORT", "")
# Recordings of the original programs.
REFERENCE = ROOT / "tests" / "reference"

DATA, CMD, REQ, ACK, SYNCH, NACK = 1, 2, 3, 4, 5, 6
BLACKBOARD, HEALTH = 64, 59
PLAYER, POSITION2D, SONAR, LASER, FIDUCIAL, SPEECH, POSITION3D, SIMULATION, SPEECH_RECOGNITION, RANGER = 1, 4, 5, 6, 10, 12, 30, 31, 50, 62

WORLD = """
interval_sim 100
define scanner ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 181 ) )
define ears ranger( size [0.1 0.1 0.1]
  sensor( pose [0 0 0 0] range [0 5] fov 10 ) sensor( pose [0 0 0 90] range [0 5] fov 10 ) )
define robot position( size [0.4 0.4 0.2] scanner( pose [0 0 0 0] ) ears( pose [0 0 0 0] ) )
model( name "wall" pose [3 0 0 0] size [0.2 10 1] color "gray" )
robot( name "r0" pose [0 0 0 0] fiducial_return 1 )
robot( name "r1" pose [0 -3 0 90] localization "odom" odom_error [0 0 0 0] )
"""


def free_ports(count: int = 1) -> list[int]:
    """Ports for programs that start later: below those that the system gives to whoever names none, as any program's outgoing
    connection may have one of these meanwhile."""
    first_given = int(Path("/proc/sys/net/ipv4/ip_local_port_range").read_text().split()[0])
    found: list[int] = []
    for port in random.sample(range(max(1024, first_given - 12000), first_given), 2000):
        try:
            socket.create_server(("127.0.0.1", port)).close()
        except OSError:
            continue
        found.append(port)
        if len(found) == count:
            return found
    raise AssertionError(f"there are not {count} free ports below {first_given}")


class House:
    """The program, started with some arguments; a context manager that ends it."""

    def __init__(self, *arguments, program=None, stdin=subprocess.DEVNULL, env=None):
        self.process = subprocess.Popen([program or PROGRAM, *map(str, arguments)], stdin=stdin,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=env)
        self.lines: list[str] = []
        self._ended = False  # the last line is there
        self._changed = threading.Condition()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        for line in self.process.stderr:
            with self._changed:
                self.lines.append(line.rstrip("\n"))
                self._changed.notify_all()
        with self._changed:
            self.lines.append("")
            self._ended = True
            self._changed.notify_all()

    def log(self) -> str:
        return "\n".join(self.lines)

    def wait_for_line(self, pattern: str, seen=0) -> re.Match:
        """The first line of standard error that matches, but for the `seen` first ones."""
        return self.wait_for_lines(pattern, 1, seen)[0]

    def wait_for_lines(self, pattern: str, count: int, seen=0) -> list[re.Match]:
        """The same of so many lines that match."""
        found: list[re.Match] = []

        def come() -> bool:
            nonlocal seen
            found.extend(filter(None, (re.search(pattern, line) for line in self.lines[seen:])))
            seen = len(self.lines)
            return len(found) >= count

        with self._changed:
            self._changed.wait_for(lambda: come() or self._ended, PATIENCE)
        if len(found) < count:
            raise AssertionError(f"{count} lines {pattern!r} are not in:\n{self.log()}")
        return found

    def port(self) -> int:
        return int(self.wait_for_line(r"^Player clients: 127\.0\.0\.1:(\d+)$").group(1))

    def heap_in_use(self) -> int:
        """Bytes; of a program started with HEAP_REPORT in LD_PRELOAD."""
        seen = len(self.lines)
        self.process.send_signal(signal.SIGUSR2)
        self.wait_for_line("^Total", seen)
        return int(self.wait_for_line(r"^in use bytes *= *(\d+)", self.lines.index("Total (incl. mmap):", seen)).group(1))

    def wait(self) -> int:
        """The exit code, once the program has ended by itself and all that it said is in `lines`."""
        code = self.process.wait(PATIENCE)
        self._reader.join(PATIENCE)
        return code

    def end(self, by=signal.SIGTERM) -> int:
        if self.process.poll() is None:
            self.process.send_signal(by)
        return self.wait()

    def output(self) -> str:
        """Standard output, once the program has ended."""
        return self.process.stdout.read()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self._reader.join()
        self.process.stdout.close()
        self.process.stderr.close()


class Message:
    def __init__(self, header: bytes, body: bytes):
        (self.host, self.robot, self.interf, self.index, self.type, self.subtype, self.time, self.seq,
         self.size) = struct.unpack(">IIIIIIdII", header)
        self.body = body

    def key(self):
        return (self.interf, self.index, self.type, self.subtype)

    def __repr__(self):
        return f"<{self.interf}:{self.index} type {self.type} subtype {self.subtype} {self.size} bytes>"


def frame(interf, index, kind, subtype, body=b"", seq=0) -> bytes:
    return struct.pack(">IIIIIIdII", 0, 0, interf, index, kind, subtype, 0.0, seq, len(body)) + body


def text(value: str) -> bytes:
    """A counted text with its NUL: count, length, bytes, padding."""
    raw = value.encode() + b"\0"
    return struct.pack(">II", len(raw), len(raw)) + raw + b"\0" * (-len(raw) % 4)


class Client:
    """One connection, byte for byte."""

    def __init__(self, port: int, source: str = "127.0.0.1"):
        self.socket = socket.create_connection(("127.0.0.1", port), PATIENCE, (source, 0))
        self.socket.settimeout(PATIENCE)
        self.buffer = b""
        self.data: list[Message] = []   # that arrived while something else was waited for
        self.banner = self.take(32)

    def take(self, size: int) -> bytes:
        while len(self.buffer) < size:
            more = self.socket.recv(65536)
            if not more:
                raise ConnectionError("the server closed the connection")
            self.buffer += more
        taken, self.buffer = self.buffer[:size], self.buffer[size:]
        return taken

    def send(self, *words, **more):
        self.socket.sendall(frame(*words, **more))

    def receive(self) -> Message:
        header = self.take(40)
        return Message(header, self.take(struct.unpack(">I", header[36:])[0]))

    def request(self, interf, index, subtype, body=b"") -> Message:
        """The answer; data that come before it are kept."""
        self.send(interf, index, REQ, subtype, body)
        while True:
            message = self.receive()
            if message.type in (ACK, NACK) and (message.interf, message.subtype) == (interf, subtype):
                return message
            self.data.append(message)

    def next_data(self, interf, index, subtype=1) -> Message:
        wanted = (interf, index, DATA, subtype)
        while True:
            message = self.data.pop(0) if self.data else self.receive()
            if message.key() == wanted:
                return message

    def open(self, interf, index, access=1) -> Message:
        return self.request(PLAYER, 0, 3, struct.pack(">IIIIIII", 0, 0, interf, index, access, 0, 0))

    def devices(self) -> list[tuple[int, int]]:
        body = self.request(PLAYER, 0, 1).body
        count = struct.unpack(">I", body[:4])[0]
        return [struct.unpack(">IIII", body[8 + 16 * i:24 + 16 * i])[2:] for i in range(count)]

    def drive(self, index, forward, turn=0.0):
        self.send(POSITION2D, index, CMD, 1, struct.pack(">dddI", forward, 0, turn, 1))

    def pose(self, name: str) -> tuple[float, float, float]:
        answer = self.request(SIMULATION, 0, 1, text(name) + struct.pack(">ddd", 0, 0, 0))
        assert answer.type == ACK, answer
        return struct.unpack(">ddd", answer.body[-24:])

    def close(self):
        self.socket.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def ranges_of(scan: Message) -> tuple[float, ...]:
    """The ranges of laser.data.scan."""
    count = struct.unpack(">I", scan.body[16:20])[0]
    return struct.unpack(f">{count}f", scan.body[24:24 + 4 * count])


class HouseTest(unittest.TestCase):
    """A test with a folder of its own for the files it writes."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name: str, content: str) -> Path:
        path = self.folder / name
        path.write_text(content)
        return path

    def world(self, content: str = WORLD) -> Path:
        return self.write("test.world", content)

    def release(self) -> str:
        """The program as users have it, without sanitizers; `make test` builds it first."""
        if not os.path.exists(RELEASE):
            self.skipTest("there is no release program; `make build` makes it")
        return RELEASE

    def run_house(self, *arguments, world=None) -> House:
        """`playhouse run` on a free port, without a page."""
        return House("run", world or self.world(), "--port", 0, "--headless", *arguments)


def finish(*arguments, program=None, env=None) -> subprocess.CompletedProcess:
    """Runs the program to its end."""
    return subprocess.run([program or PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, timeout=PATIENCE, env=env)
