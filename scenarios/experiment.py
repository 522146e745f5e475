"""Common part of the experiments: start of the program, clock, participants and results file.

The simulation runs in lock-step with this program (docs/lock-step.md), in real time or, with --fast, as fast as possible.
With stand-ins only, runs with the same seed are bit-identical; the actions of people in browsers are in the recording.
"""

import argparse
import json
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import threading
from typing import Any, Dict, List

HOUSE = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(HOUSE / "clients/python"))  # runs in place, without an installation

from playhouse_client import Client, Mode, PlayerError, RequestRefused, RunEnded, connect  # noqa: E402

from ground import Point  # noqa: E402

REFEREE = "referee"    # a person in each world that announces the score, and the prototype of the stand-ins
STEP = 2               # ticks per decision


def options(about: str, names: List[str], seconds: float) -> argparse.Namespace:
    """Parses the command line; `names` are those of stand-ins."""
    parser = argparse.ArgumentParser(description=about, epilog="Options after -- are passed to playhouse run, such as --bind.")
    parser.add_argument("--stand-ins", type=int, default=0, metavar="N", help=f"number of scripted people, up to {len(names)}")
    parser.add_argument("--seconds", type=float, default=seconds, help="simulated time from the first person on (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="seed of the world and of the stand-ins (%(default)s)")
    parser.add_argument("--fast", action="store_true", help="as fast as possible, without a page")
    parser.add_argument("--results", default="results.json", metavar="FILE", help="results file (%(default)s)")
    parser.add_argument("--record", metavar="FILE.mcap", help="record the run, with all participants")
    parser.add_argument("--program", default=os.environ.get("PLAYHOUSE_PROGRAM", str(HOUSE / "build/playhouse")))
    parser.add_argument("more", nargs="*", help=argparse.SUPPRESS)
    chosen = parser.parse_args()
    if not 0 <= chosen.stand_ins <= len(names):
        parser.error(f"--stand-ins {chosen.stand_ins}: from 0 to {len(names)}")
    if not 0 < chosen.seconds < float("inf"):
        parser.error(f"--seconds {chosen.seconds}: more than 0")
    if chosen.fast and not chosen.stand_ins:
        parser.error("--fast: people cannot follow, so that it needs --stand-ins")
    if not 0 <= chosen.seed < 1 << 63:
        parser.error(f"--seed {chosen.seed}: from 0 to 2^63 - 1")
    return chosen


class Program:
    """`playhouse run` in the arena, in lock-step with this program; a context manager that terminates it."""

    def __init__(self, world: pathlib.Path, chosen: argparse.Namespace) -> None:
        words = [chosen.program, "run", str(world), "--engine", "arena", "--lock-step", REFEREE, "--port", "0"]
        words += ["--seed", str(chosen.seed), "--headless" if chosen.fast else "--speed"] + ([] if chosen.fast else ["1"])
        words += ["--record", chosen.record] if chosen.record else []
        try:
            # In its own process session: Ctrl-C reaches this program only, which terminates the other after saving results.
            self._process = subprocess.Popen(words + chosen.more, stderr=subprocess.PIPE, text=True, start_new_session=True)
        except OSError as error:
            sys.exit(f"{chosen.program}: {error.strerror}; make build makes it, --program says where it is")

    def port(self) -> int:
        """Port for Player clients. Forwards the program's output to standard error."""
        assert self._process.stderr
        for line in self._process.stderr:
            sys.stderr.write(line)
            found = re.match(r"Player clients: [\d.]+:(\d+)$", line)
            if found:
                threading.Thread(target=self._pass_on, daemon=True).start()
                return int(found[1])
        sys.exit(self._process.wait() or 1)

    def _pass_on(self) -> None:
        for line in self._process.stderr or ():
            sys.stderr.write(line)

    def __enter__(self) -> "Program":
        return self

    def __exit__(self, *_: object) -> None:
        self._process.terminate()  # SIGTERM: the recording is closed
        self._process.wait()


class Experiment:
    """One run. A scenario is a subclass that opens its robots in `prepare` and makes decisions in `tick`."""

    name = ""
    robot_names: List[str] = []

    def __init__(self, client: Client, world: pathlib.Path, chosen: argparse.Namespace, stand_ins: List[str]) -> None:
        self.client, self.chosen = client, chosen
        self.world = client.simulation(0)
        self.random = random.Random(chosen.seed)
        self.stand_in_names = stand_ins
        self.time = 0.0            # s since the first person joined
        self.events: List[Dict[str, Any]] = []
        self.people: Dict[str, Point] = {}   # positions, stand-ins included
        self.is_interrupted = False
        self._path = world

    # Implemented by scenarios.
    def prepare(self) -> None: ...
    def arrived(self, person: str) -> None: ...
    def tick(self) -> bool:
        """Makes decisions; returns whether the experiment continues."""
        raise NotImplementedError
    def score(self) -> Dict[str, Any]:
        raise NotImplementedError

    def run(self) -> Dict[str, Any]:
        self.prepare()
        self.world.join(REFEREE)
        interval = self._interval()
        steps = 0
        try:
            while True:
                self.world.step(STEP)
                if steps % 5 == 0:
                    self._look_who_is_there()
                steps += 1
                self._look_where_people_are()
                if not self.people:
                    continue
                self.time = round(self.time + STEP * interval, 6)
                if not self.tick() or self.time >= self.chosen.seconds:
                    break
        except RunEnded:
            pass  # ended by options of the program; results so far are valid
        except KeyboardInterrupt:
            self.is_interrupted = True
        return self.results()

    def tell(self, event: str, who: str, **more: Any) -> None:
        """Records an event in the results, and prints it."""
        self.events.append({"time": round(self.time, 3), "event": event, "who": who, **more})
        words = [value if key == "what" else f"{key} {value}" for key, value in more.items()]
        print(f"{self.time:7.1f} s  " + " ".join([who, event, *words]), flush=True)

    def results(self) -> Dict[str, Any]:
        return {
            "scenario": self.name, "seed": self.chosen.seed, "seconds": self.time, "stand_ins": self.stand_in_names,
            "score": self.score(), "events": self.events,
        }

    def _interval(self) -> float:
        found = re.search(r"^interval_sim (\S+)$", self._path.read_text(), re.MULTILINE)
        return float(found[1]) / 1000 if found else 0.1

    def _look_who_is_there(self) -> None:
        others = {REFEREE, *self.robot_names}
        bases = [m.name for m in self.client.models() if m.type == "position" and not m.parent]
        names = [name for name in bases if name not in others]
        for gone in [name for name in self.people if name not in names]:
            del self.people[gone]
            self.tell("left", gone)
        for name in names:
            if name not in self.people:
                self.people[name] = (0.0, 0.0)
                self.arrived(name)
                if name not in self.stand_in_names:
                    self.tell("joined", name)

    def _look_where_people_are(self) -> None:
        for name in list(self.people):
            try:
                pose = self.world.pose(name)
            except RequestRefused:  # removed since the last query
                del self.people[name]
                self.tell("left", name)
                continue
            self.people[name] = (pose.x, pose.y)


def main(kind: Any, world: pathlib.Path, about: str, names: List[str], seconds: float) -> None:
    """Runs an Experiment by the command line, and writes its results."""
    chosen = options(about, names, seconds)
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as Ctrl-C: results so far are written
    try:
        with open(chosen.results, "a", encoding="utf-8"):
            pass  # fail before the run, not after it
        with Program(world, chosen) as program:
            with connect(f"127.0.0.1:{program.port()}", mode=Mode.PUSH) as client:
                if not chosen.stand_ins:
                    print('open the page and press "Join": the clock starts with the first person', flush=True)
                experiment = kind(client, world, chosen, names[: chosen.stand_ins])
                results = experiment.run()
        with open(chosen.results, "w", encoding="utf-8") as file:
            json.dump(results, file, indent=1)
            file.write("\n")
    except OSError as error:
        sys.exit(f"{chosen.results}: {error.strerror}")
    except PlayerError as error:
        sys.exit(str(error))
    except KeyboardInterrupt:
        sys.exit(130)
    counts = {key: value for key, value in results["score"].items() if not isinstance(value, dict)}
    print(", ".join(f"{key} {value}" for key, value in counts.items()) + f"; all of it is in {chosen.results}")
    sys.exit(130 if experiment.is_interrupted else 0)
