#!/usr/bin/env python3
"""Holds a server for hours under sessions that come, stay and go, and fails if one is lost, if nobody answers, or if what the
server keeps grows: of N sessions nine in ten are silent, a hundred of the others read each second, some end and are made anew,
fifty agents drive one robot, and each second a stranger sends rubbish. On loopback, in real time; prints a line a minute and one JSON line at the end.

    tools/soak.py [--program build/playhouse] [--sessions 10000] [--hours 24]
"""

import argparse
import contextlib
import json
import os
import pathlib
import random
import resource
import socket
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests/e2e"), str(ROOT / "clients/python")]

from bench_viewers import cpu_seconds, crowd  # noqa: E402
from house import House  # noqa: E402
from playhouse_client import Mode, connect  # noqa: E402

ROBOTS, AGENTS, READ, RENEWED = 50, 50, 100, 5  # of the last two a second
WARM = 600  # s until what the server keeps counts as full


def kept(process: int) -> dict:
    status = pathlib.Path(f"/proc/{process}/status").read_text()
    return {"kb": int(status.split("VmRSS:")[1].split()[0]), "descriptors": len(os.listdir(f"/proc/{process}/fd")),
            "threads": int(status.split("Threads:")[1].split()[0])}


class Soak:
    def __init__(self, house: House, sessions: int):
        self.house, self.process = house, house.process.pid
        self.dice = random.Random(1)
        self.rounds, self.renewed, self.trips = 0, 0, []
        self.clients = [self.new_client(number) for number in range(sessions)]
        self.agents = [connect(f":{house.port()}", mode=Mode.PULL) for _ in range(AGENTS)]
        self.wheels = [agent.position2d(0) for agent in self.agents]

    def new_client(self, number: int):
        client = connect(f":{self.house.port()}", mode=Mode.PULL)
        if number % 10 == 0:
            client.device("laser" if number % 20 else "position2d", number // 10 % ROBOTS)
        return client

    def second(self) -> None:
        for client in self.dice.sample(self.clients[::10], min(READ, len(self.clients[::10]))):
            begun = time.monotonic()
            client.read()  # raises if the session is lost, or nobody answers for 5 s
            self.trips.append(time.monotonic() - begun)
            self.rounds += 1
        for number in self.dice.sample(range(len(self.clients)), RENEWED):
            self.clients[number].close()
            self.clients[number] = self.new_client(number)
            self.renewed += 1
        for wheels in self.wheels:
            wheels.drive(self.dice.uniform(-0.2, 0.2), self.dice.uniform(-1, 1))
        with socket.create_connection(("127.0.0.1", self.house.port())) as stranger:
            stranger.sendall(self.dice.randbytes(self.dice.randrange(1, 4096)))

    def minute(self) -> dict:
        trips, self.trips = sorted(self.trips), []
        return kept(self.process) | {"cpu_s": round(cpu_seconds(self.process), 1), "rounds": self.rounds, "renewed": self.renewed,
                                     "round_p50_ms": round(1e3 * trips[len(trips) // 2], 2),
                                     "round_p99_ms": round(1e3 * trips[len(trips) * 99 // 100], 2)}

    def close(self) -> None:
        for client in [*self.clients, *self.agents]:
            client.close()


def hold(soak: Soak, seconds: float) -> list:
    begun, minutes = time.monotonic(), []
    for second in range(1, round(seconds) + 1):
        soak.second()
        if second % 60 == 0:
            minutes.append({"s": round(time.monotonic() - begun)} | soak.minute())
            print(json.dumps(minutes[-1]), flush=True)
        time.sleep(max(0, begun + second - time.monotonic()))
    return minutes


def grown(minutes: list) -> list:
    """What the server keeps more of at the end than once it was warm: of memory a twentieth is allowed, as a reader's queue keeps
    the room that its longest wait took, and of descriptors what renewed sessions may have open."""
    warm = [minute for minute in minutes if minute["s"] >= WARM] or minutes
    first, last = warm[0], warm[-1]
    room = {"kb": first["kb"] // 20, "descriptors": 2 * RENEWED, "threads": 0}
    return [name for name, allowed in room.items() if last[name] > first[name] + allowed]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/playhouse"))
    parser.add_argument("--sessions", type=int, default=10000)
    parser.add_argument("--hours", type=float, default=24, help="a minute at least")
    options = parser.parse_args()
    most = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))
    with contextlib.ExitStack() as stack:
        world = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory())) / "crowd.world"
        world.write_text(crowd(ROBOTS).replace("interval_sim 50", "interval_sim 100"))
        house = stack.enter_context(House("run", world, "--port", 0, "--headless", program=options.program))
        soak = Soak(house, options.sessions)
        stack.callback(soak.close)
        minutes = hold(soak, max(60, 3600 * options.hours))
        more = grown(minutes)
        print(json.dumps({"sessions": options.sessions, "hours": options.hours, "grown": more, "last": minutes[-1]}))
    return 1 if more else 0


if __name__ == "__main__":
    sys.exit(main())
