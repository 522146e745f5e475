#!/usr/bin/env python3
"""Measures what a server costs that shows the robots of other servers: processor time of one with `passthrough` for all robots of several
`playhouse run`, position2d and laser each, while one client reads everything ten times a second. On loopback, in real time; prints one JSON line.

    tools/bench_relay.py [--program build/playhouse] [--servers 10] [--robots 10] [--seconds 20]
"""

import argparse
import contextlib
import json
import pathlib
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests/e2e"), str(ROOT / "clients/python")]

from bench_viewers import cpu_seconds, crowd  # noqa: E402
from house import House  # noqa: E402
from playhouse_client import Mode, connect  # noqa: E402

INTERFACES = ("position2d", "laser")
PERIOD = 0.1  # s


def section(server: int, port: int, robots: int) -> str:
    def devices(first: int, prefix: str) -> str:
        return " ".join(f'"{prefix}{interface}:{first + robot}"' for interface in INTERFACES for robot in range(robots))

    return f'driver( name "passthrough" provides [{devices(server * robots, "")}] requires [{devices(0, f"{port}:")}] )\n'


def read(port: int, devices: int, seconds: float, process: int) -> dict:
    """Of the relay's process, while everything is read."""
    with connect(f":{port}", mode=Mode.PULL) as client:
        for interface in INTERFACES:
            for index in range(devices):
                client.device(interface, index)
        client.read()
        messages, begun, before = 0, time.monotonic(), cpu_seconds(process)
        rounds = round(seconds / PERIOD)
        for turn in range(1, rounds + 1):
            messages += client.read()
            time.sleep(max(0, begun + turn * PERIOD - time.monotonic()))
        took = time.monotonic() - begun
        return {"seconds": round(took, 2), "messages_per_s": round(messages / took), "lost": client.lost_count(),
                "cpu_percent": round(100 * (cpu_seconds(process) - before) / took, 2)}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/playhouse"))
    parser.add_argument("--servers", type=int, default=10)
    parser.add_argument("--robots", type=int, default=10, help="of each server")
    parser.add_argument("--seconds", type=float, default=20)
    options = parser.parse_args()
    with contextlib.ExitStack() as stack:
        folder = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory()))
        world = folder / "crowd.world"
        world.write_text(crowd(options.robots).replace("interval_sim 50", "interval_sim 100"))
        servers = [stack.enter_context(House("run", world, "--port", 0, "--headless", program=options.program))
                   for _ in range(options.servers)]
        cfg = folder / "relay.cfg"
        cfg.write_text("".join(section(nth, server.port(), options.robots) for nth, server in enumerate(servers)))
        relay = stack.enter_context(House("serve", cfg, "--port", 0, "--headless", program=options.program))
        robots = options.servers * options.robots
        print(json.dumps({"servers": options.servers, "robots": robots, "devices": len(INTERFACES) * robots}
                         | read(relay.port(), robots, options.seconds, relay.process.pid)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
