#!/usr/bin/env python3
"""Measures the cost of viewers of the arena: bytes per second of one viewer of 200 driving robots, processor time of 50 viewers, the same for UDP
observers, and the latency from a command of a Player client to the first frame that shows it. On loopback, in real time; prints one JSON line each.

    tools/bench_viewers.py [--program build/playhouse] [--seconds 10]
"""

import argparse
import json
import os
import pathlib
import select
import statistics
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests/e2e"))

from house import Client, House  # noqa: E402
from viewer import Viewer  # noqa: E402

WORLD = """
include "pioneer.inc"
include "sick.inc"
interval_sim 50
model( name "fence" pose [0 0 0 0] size [46 32 1] boundary 1 noblocks 1 )
define robot pioneer2dx_bare( sicklaser_low() ctrl "wander" )
"""
STILL = 'include "pioneer.inc"\ninterval_sim 20\npioneer2dx_bare( name "r0" )\n'
TRIALS = 30


def crowd(robots: int) -> str:
    rows = [f'robot( pose [{-19 + 2 * (i % 20)} {-9 + 2 * (i // 20)} 0 {37 * i % 360}] )' for i in range(robots)]
    return WORLD + "\n".join(rows) + "\n"


def cpu_seconds(process: int) -> float:
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Watching:
    """Viewers, each on its own thread, that count received bytes and packets."""

    def __init__(self, port: int, count: int) -> None:
        self.bytes = self.packets = 0
        self._lock, self._over = threading.Lock(), False
        self._threads = [threading.Thread(target=self._watch, args=(port,), daemon=True) for _ in range(count)]
        for thread in self._threads:
            thread.start()

    def _watch(self, port: int) -> None:
        with Viewer(port) as viewer:
            take = viewer._receive

            def counted():
                code, payload = take()
                with self._lock:
                    self.bytes += len(payload)
                    self.packets += code == 2
                return code, payload

            viewer._receive = counted
            while not self._over:
                viewer.turn()

    def stop(self) -> None:
        self._over = True
        for thread in self._threads:
            thread.join()


def run(program: str, world: pathlib.Path) -> House:
    return House("run", world, "--engine", "arena", "--port", 0, "--web", 0, "--observers", 0, program=program)


def observe(house: House, program: str, count: int, seconds: float) -> dict:
    """UDP observers, by their own statistics from the reception of the world on."""
    server = house.wait_for_line(r"^observers: (\S+)").group(1)
    cpu_then, then = cpu_seconds(house.process.pid), time.monotonic()
    observers = [House("observe", server, "--name", "-", "--seconds", seconds, "--stats", program=program) for _ in range(count)]
    figures = []
    for observer in observers:
        assert observer.wait() == 0, observer.log()
        figures.append(json.loads(observer.output().splitlines()[-1]))
    return {
        "observers": count, "cpu": round((cpu_seconds(house.process.pid) - cpu_then) / (time.monotonic() - then), 3),
        "kB_per_s_each": round(statistics.mean(each["bytes_per_second"] for each in figures) / 1000, 1),
        "kB_per_s_with_heads": round(statistics.mean((each["bytes"] + 28 * each["datagrams"]) / each["seconds"] for each in figures) / 1000, 1),
        "packets_per_s_each": round(statistics.mean(each["packets"] / each["seconds"] for each in figures), 1),
    }


def web_port(house: House) -> int:
    return int(house.wait_for_line(r"web page: http://[^:]+:(\d+)/").group(1))


def measure(house: House, viewers: int, seconds: float) -> dict:
    watching = Watching(web_port(house), viewers)
    time.sleep(3)  # the whole world has come
    bytes_then, packets_then, cpu_then, then = watching.bytes, watching.packets, cpu_seconds(house.process.pid), time.monotonic()
    time.sleep(seconds)
    span = time.monotonic() - then
    found = {
        "viewers": viewers, "cpu": round((cpu_seconds(house.process.pid) - cpu_then) / span, 3),
        "kB_per_s_each": round((watching.bytes - bytes_then) / 1000 / span / max(viewers, 1), 1),
        "packets_per_s_each": round((watching.packets - packets_then) / span / max(viewers, 1), 1),
    }
    watching.stop()
    return found


def latency(program: str, folder: pathlib.Path) -> dict:
    world = folder / "still.world"
    world.write_text(STILL)
    found = []
    with run(program, world) as house, Client(house.port()) as client, Viewer(web_port(house)) as viewer:
        client.open(4, 0)
        sizes = []
        take = viewer._receive

        def noted():
            code, payload = take()
            sizes.append(len(payload) if code == 2 else 0)
            return code, payload

        viewer._receive = noted
        for trial in range(TRIALS):
            client.drive(0, 0.0)
            end = time.monotonic() + 1.5 + 0.013 * trial  # at any place in a tick
            while time.monotonic() < end:
                if viewer.buffer or select.select([viewer.socket], [], [], 0.01)[0]:
                    viewer.turn()
            still = max(sizes[-5:], default=0)
            sizes.clear()
            client.drive(0, 0.5)
            then = time.monotonic()
            while max(sizes, default=0) <= still:
                viewer.turn()
            found.append(time.monotonic() - then)
    return {"ms_median": round(1000 * statistics.median(found), 1), "ms_most": round(1000 * max(found), 1), "trials": TRIALS}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / "build/playhouse"))
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--robots", type=int, default=200)
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        world = folder / "crowd.world"
        world.write_text(crowd(chosen.robots))
        with run(chosen.program, world) as house:
            for viewers in (0, 1, 50):
                print(json.dumps({"robots": chosen.robots, **measure(house, viewers, chosen.seconds)}), flush=True)
            for observers in (1, 50):
                print(json.dumps({"robots": chosen.robots, **observe(house, chosen.program, observers, chosen.seconds)}), flush=True)
        print(json.dumps({"command_to_picture": latency(chosen.program, folder)}))


if __name__ == "__main__":
    main()
