"""The examples, in every language, drive robots of the real server; a second client watches."""

import math
import signal
import subprocess
import sys
import unittest
from typing import Callable, Dict, List, Sequence, Tuple

import languages
from package import ROOT
from paths import distance, length
from server_program import HANG, World, needed
from playhouse_client import Access, Client, Pose, Position2d, Simulation, connect

LONGEST = 3000.0  # s of simulated time, of an example that ends by itself


def examples(name: str) -> Dict[str, List[str]]:
    """Language -> the command that starts an example."""
    found = {"python": [sys.executable, str(ROOT / "clients" / "python" / "examples" / f"{name}.py")]}
    return {**found, **{language: [program] for language, program in languages.programs(name).items()}}


def track(
    command: Sequence[str], robot: Position2d, look: Callable[[], Tuple[float, ...]]
) -> Tuple[List[Tuple[float, ...]], str]:
    """Runs an example to its end and looks with each new state of the robot: what was seen, and what the example
    printed."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    robot.next_data()
    seen, longest = [look()], robot.timestamp + LONGEST
    while process.poll() is None:
        robot.next_data()
        seen.append(look())
        if robot.timestamp > longest:
            process.kill()
    printed = process.communicate()[0]
    if process.returncode != 0:
        raise AssertionError(f"{command} ended with {process.returncode}:\n{printed}")
    return seen, printed


@needed
class Examples(unittest.TestCase):
    def in_every_language(self, name: str, check: Callable[[List[str]], None]) -> None:
        languages.check_each(self, examples(name), check)

    def assert_stands(self, client: Client, simulator: Simulation, index: int, model: str) -> None:
        with client.position2d(index, Access.READ) as robot:
            robot.next_data()
            robot.next_data()
            before = simulator.pose(model)
            self.assertEqual(robot.velocity, (0.0, 0.0, 0.0))
            robot.next_data()
            robot.next_data()
            self.assertEqual(simulator.pose(model), before)

    def test_square_goes_round_the_corners_and_comes_back(self) -> None:
        def check(command: List[str]) -> None:
            with World("square.world") as world, connect(world.address) as client:
                simulator, robot = client.simulation(0), client.position2d(0, Access.READ)
                path, printed = track([*command, world.address, "0", "60"], robot, lambda: simulator.pose("r0"))
                self.assertEqual(printed.count("corner"), 4, printed)
                for corner in [(1.5, 0.0), (1.5, 1.5), (0.0, 1.5)]:
                    self.assertLess(min(distance(corner, pose) for pose in path), 0.25, corner)
                self.assertLess(distance(path[-1], (0.0, 0.0)), 0.25)
                self.assertAlmostEqual(math.sin(path[-1][2]), 0.0, delta=0.3)
                self.assert_stands(client, simulator, 0, "r0")

        self.in_every_language("square", check)

    def test_wander_moves_and_runs_into_nothing(self) -> None:
        def check(command: List[str]) -> None:
            with World("simple.world") as world, connect(world.address) as client:
                simulator, robot = client.simulation(0), client.position2d(0, Access.READ)
                stalls: List[bool] = []

                def look() -> Pose:
                    stalls.append(robot.stalled)
                    return simulator.pose("r0")

                path, _ = track([*command, world.address, "0", "6"], robot, look)
                self.assertGreater(length(path), 3.0)
                self.assertFalse(any(stalls))
                self.assert_stands(client, simulator, 0, "r0")

        self.in_every_language("wander", check)

    def test_signals_stop_the_robot_although_another_client_has_it_open(self) -> None:
        def check(command: List[str]) -> None:
            for by in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                with World("simple.world") as world, connect(world.address) as client:
                    simulator, robot = client.simulation(0), client.position2d(0, Access.READ)
                    start = simulator.pose("r0")
                    process = subprocess.Popen([*command, world.address])
                    while process.poll() is None and distance(start, simulator.pose("r0")) < 0.2:
                        robot.next_data()
                    process.send_signal(by)
                    self.assertEqual(process.wait(HANG), 128 + by)
                    self.assert_stands(client, simulator, 0, "r0")

        self.in_every_language("wander", check)

    def test_wrong_numbers_are_refused_alike(self) -> None:
        def check(command: List[str]) -> None:
            for words in (["-1"], ["65536"], ["1.5"], [""], ["0", "-1"], ["0", "nan"], ["0", "inf"]):
                done = subprocess.run([*command, "127.0.0.1:1", *words], stderr=subprocess.PIPE, text=True)
                self.assertEqual(done.returncode, 2, (words, done.stderr))

        self.in_every_language("wander", check)

    def test_follow_stays_with_its_leader(self) -> None:
        def check(command: List[str]) -> None:
            with World("fiducial.world") as world, connect(world.address) as client:
                simulator, robot = client.simulation(0), client.position2d(1, Access.READ)

                def look() -> Tuple[float, ...]:
                    return (*simulator.pose("r0"), *simulator.pose("leader"))

                seen, _ = track([*command, world.address, "1", "8", "7", "0"], robot, look)
                later = seen[len(seen) // 2 :]
                near = [both for both in later if distance(both[:2], both[3:5]) < 2.0]
                self.assertGreater(len(near), 0.7 * len(later))
                self.assertGreater(length([both[:2] for both in seen]), 2.0)
                self.assert_stands(client, simulator, 1, "r0")

        self.in_every_language("follow", check)

    def test_navigate_reaches_its_places_although_the_odometry_drifts(self) -> None:
        def check(command: List[str]) -> None:
            with World("navigate.cfg", speed="20") as world, connect(world.address) as client:
                simulator, robot = client.simulation(0), client.position2d(0, Access.READ)
                path, printed = track([*command, world.address, "0", "100"], robot, lambda: simulator.pose("r0"))
                self.assertEqual(printed.count("arrived"), 2, printed)
                for place in [(6.0, 4.0), (-5.8, 5.0)]:
                    self.assertLess(min(distance(place, pose) for pose in path), 0.6, place)
                self.assert_stands(client, simulator, 0, "r0")

        self.in_every_language("navigate", check)

    def test_talk_tells_each_of_two_robots_where_the_other_is(self) -> None:
        def check(talk: List[str]) -> None:
            with World("radio.world") as world:
                first, second = (
                    subprocess.Popen([*talk, world.address, str(index), "4"], stdout=subprocess.PIPE, text=True)
                    for index in (0, 1)
                )
                told = r"\d+\.\d s: robot {} is at -?\d+\.\d\d -?\d+\.\d\d\n"
                self.assertRegex(first.communicate(timeout=HANG)[0], told.format(1))
                self.assertRegex(second.communicate(timeout=HANG)[0], told.format(0))

        self.in_every_language("talk", check)


if __name__ == "__main__":
    unittest.main()
