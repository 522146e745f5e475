"""Runs in lock-step: outside clients say when each tick is done, and every run of them is the same run."""

import contextlib
import json
import random
import struct
import sys
import threading
import unittest

from house import (ACK, CMD, DATA, LASER, NACK, PLAYER, POSITION2D, ROOT, SIMULATION, Client, House, HouseTest, text)
from viewer import Viewer

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Mode, PlayerError, RequestRefused, RequestTimeout, RunEnded, connect  # noqa: E402

SET_PROPERTY = 6
TICKS = 200
ARENA = """
interval_sim 100
define scanner ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 31 noise [0.01 0.01 0] ) )
define robot position( size [0.4 0.4 0.2] localization "odom" scanner( pose [0 0 0 0] ) )
model( name "walls" size [12 12 1] boundary 1 noblocks 1 )
robot( name "r0" pose [-3 0 0 0] )
robot( name "r1" pose [3 0 0 180] )
"""


def ask_world(client: Client, prop: str, value: bytes = b"", name: str = "world"):
    value = struct.pack(">II", len(value), len(value)) + value + b"\0" * (-len(value) % 4)
    return client.request(SIMULATION, 0, SET_PROPERTY, text(name) + text(prop) + struct.pack(">I", 0) + value)


def drive(port: int, name: str, index: int, seed: int, faults: list):
    """One client: goes where its laser sees room, moves a robot that the other moves as well, and adds robots as the
    other does; all of it after questions whose number differs from run to run, and with it who is first."""
    waits = random.Random(seed)
    try:
        with connect(f":{port}", mode=Mode.PUSH, timeout=60) as client:
            world, base, laser = client.simulation(0), client.position2d(index), client.laser(index)
            other = client.position2d(0)
            world.join(name)

            def wait(answers: int):
                for _ in range(answers):
                    world.pose("r0")

            for tick in range(TICKS):
                wait(waits.choice((0, 0, 5, 20)))
                if tick > 0:
                    room = min(laser.ranges)
                    base.drive(0.5 if room > 0.8 else 0.0, 0.1 if room > 0.8 else 0.7)
                if tick % 20 == 5:
                    other.drive(0.1 * len(name), 0.2)
                if tick % 50 == 10:
                    wait(waits.choice((0, 10)))
                    world.set_pose("r0", -2.0 + index, 1.0, 0.5)
                    world.spawn("r1", -4.0 + 2 * index, -4.0 + tick / 50, 0.0)
                world.step()
            try:
                world.step()
                faults.append("a step after the end was done")
            except RunEnded:
                pass
    except BaseException as error:
        faults.append(repr(error))


class LockStep(HouseTest):
    def result_of_two_clients(self, seed: int, *arguments) -> dict:
        with self.run_house("--lock-step", "first,second", "--duration", TICKS / 10, "--json", *arguments,
                            world=self.world(ARENA)) as house:
            faults: list = []
            threads = [threading.Thread(target=drive, args=(house.port(), name, index, 2 * seed + index, faults))
                       for index, name in enumerate(("second", "first"))]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertEqual(house.wait(), 0, house.log())
            self.assertEqual(faults, [])
            return json.loads(house.output())

    def test_two_clients_drive_to_the_same_bits_each_time_and_with_two_workers(self):
        first = self.result_of_two_clients(1)
        self.assertEqual(first["ticks"], TICKS)
        for again in (self.result_of_two_clients(2), self.result_of_two_clients(3),
                      self.result_of_two_clients(4, "--workers", 2)):
            self.assertEqual([again[word] for word in ("ticks", "hash", "sensed_hash")],
                             [first[word] for word in ("ticks", "hash", "sensed_hash")])

    def test_nothing_moves_before_a_step_and_its_answer_comes_behind_the_data_of_its_ticks(self):
        with self.run_house("--lock-step", world=self.world(ARENA)) as house, Client(house.port()) as client:
            self.assertEqual(client.open(LASER, 0).type, ACK)
            for _ in range(300):
                client.pose("r0")  # between two ticks
            self.assertEqual([each for each in client.data if each.type == DATA], [])
            self.assertEqual(ask_world(client, "step", struct.pack("<I", 5)).type, ACK)
            times = [each.time for each in client.data if each.interf == LASER]
            self.assertEqual(times, [0.1, 0.2, 0.3, 0.4, 0.5])

    def test_in_pull_mode_each_read_behind_a_step_brings_the_data_of_its_ticks(self):
        with self.run_house("--lock-step", world=self.world(ARENA)) as house, \
                connect(f":{house.port()}", mode=Mode.PULL, timeout=60) as client:
            world, laser = client.simulation(0), client.laser(0)
            times: list = []
            laser.on_data(lambda kind, value, timestamp: times.append(timestamp))
            for step in range(1, 21):
                world.step(3)
                client.read()
                self.assertEqual(times, [round(0.1 * tick, 1) for tick in range(3 * step - 2, 3 * step + 1)])
                times.clear()

    def test_in_pull_mode_data_of_a_round_that_a_step_ends_are_there_at_once(self):
        with self.run_house("--lock-step", world=self.world(ARENA)) as house, \
                connect(f":{house.port()}", mode=Mode.PULL, timeout=60) as client:
            world, laser = client.simulation(0), client.laser(0)
            with self.assertRaises(RequestTimeout):
                client.read(0.1)
            for step in range(1, 4):
                world.step()
                client.read()
                self.assertEqual(laser.timestamp, round(0.1 * step, 1))

    def test_a_step_of_no_ticks_and_one_of_a_strange_size_are_refused_with_a_reason(self):
        with self.run_house("--lock-step", world=self.world(ARENA)) as house, Client(house.port()) as client:
            for value in (struct.pack("<I", 0), b"\1", b"12345"):
                answer = ask_world(client, "step", value)
                self.assertEqual(answer.type, NACK)
                self.assertIn(b"ticks", answer.body)

    def test_a_client_that_leaves_no_longer_counts_and_a_silent_one_is_dropped(self):
        with self.run_house("--lock-step", "a,b,c", "--lock-step-timeout", 1, world=self.world(ARENA)) as house:
            clients = [connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) for _ in range(3)]
            worlds = [client.simulation(0) for client in clients]
            for world, name in zip(worlds, "abc"):
                world.join(name)
            clients[0].close()
            worlds[1].step(timeout=60)  # when c is given up
            said = house.wait_for_line(r'client "c" \(127\.0\.0\.1:\d+\) has been silent for [\d.]+ s; the others go on')
            self.assertTrue(said)
            worlds[1].step(3)
            with self.assertRaisesRegex(RequestRefused, "join by name first"):
                worlds[2].step()
            worlds[2].join("c")

    def test_a_silent_client_is_told_of_where_no_time_is_set(self):
        with self.run_house("--lock-step", world=self.world(ARENA)) as house:
            with connect(f":{house.port()}", timeout=60) as client:
                client.simulation(0).join("sleeper")
                house.wait_for_line(r'client "sleeper" .* has been silent for 5\.\d s, and the world waits for it')

    def test_a_run_that_starts_again_is_the_run_of_a_fresh_start(self):
        def scans(world, laser, base):
            seen = []
            for _ in range(20):
                base.drive(0.4, 0.2)
                world.step()
                seen.append((laser.timestamp, tuple(laser.ranges), base.pose))
            return seen

        runs = {}
        for seed in (1, 5):
            with self.run_house("--lock-step", "--seed", seed, world=self.world(ARENA)) as house, \
                    connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
                world, laser, base = client.simulation(0), client.laser(0), client.position2d(0)
                runs[seed] = scans(world, laser, base)
                self.assertEqual(world.spawn("r1", 2.0, 2.0, 0.5), "r1~2")
                for again in (5, 1, 5):
                    world.reset(again)
                    self.assertEqual(world.pose("r0"), (-3.0, 0.0, 0.0))
                    with self.assertRaises(RequestRefused):
                        world.pose("r1~2")
                    runs.setdefault(again, None)
                    seen = scans(world, laser, base)
                    if runs[again] is None:
                        runs[again] = seen
                    self.assertEqual(seen, runs[again])
        self.assertNotEqual(runs[1], runs[5])

    def test_an_episode_with_robots_that_come_is_that_of_a_fresh_program(self):
        def episode(client):
            world = client.simulation(0)
            world.spawn("r1", 0.0, 2.0, 0.5, "extra")
            extra = client.robot("extra")
            laser, base = extra.laser, extra.position2d
            seen = []
            for _ in range(10):
                base.drive(0.4, 0.2)
                world.step()
                seen.append((laser.timestamp, tuple(laser.ranges), base.pose))
            return seen

        ends, seen = [], []
        for resets in (0, 3):
            with self.run_house("--lock-step", "--seed", 5, "--duration", 1, "--json", world=self.world(ARENA)) as house:
                with connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
                    for _ in range(resets):
                        client.simulation(0).spawn("r0", 0.0, -2.0, 0.0)
                        client.simulation(0).step()
                        client.simulation(0).reset(5)
                    seen.append(episode(client))
                ends.append(json.loads(house.process.communicate(timeout=60)[0].splitlines()[-1])["hash"])
        self.assertEqual(seen[0], seen[1])
        self.assertEqual(ends[0], ends[1])

    def test_who_comes_after_a_new_start_is_taken_for_nobody_who_was_there_before(self):
        """A person at the page, and devices of robots, had ids in the run before."""
        person = (ROOT / "worlds" / "person.inc").read_text()
        world = self.world(person + ARENA + 'person( name "visitor" pose [0 3 0 90] )\n')
        with House("run", world, "--port", 0, "--web", 0, "--lock-step") as house:
            client = Client(house.port())
            client.open(SIMULATION, 0)
            with Viewer(int(house.wait_for_line(r"http://127\.0\.0\.1:(\d+)/").group(1))) as viewer:
                def tick():
                    self.assertEqual(ask_world(client, "step").type, ACK)
                    viewer.turn()

                def robot_comes():
                    place = struct.pack("<ddd", -2.0, 0.0, 0.0)
                    self.assertEqual(ask_world(client, "spawn", place, "r0").type, ACK)
                    tick()

                tick()
                robot_comes()
                viewer.send(do="join", name="Ada", x=2.0, y=-4.0, a=0.0)
                while len(viewer.came) < 2:
                    tick()
                self.assertEqual(ask_world(client, "reset", struct.pack("<Q", 5)).type, ACK)
                tick()
                robot_comes()
                robot_comes()
                for _ in range(20):
                    tick()
                self.assertEqual(len(set(viewer.came)), 4)
                devices = client.devices()
                viewer.send(do="rewind", tick=1)
                while len(client.devices()) == len(devices):
                    tick()
            for _ in range(10):
                self.assertEqual(ask_world(client, "step").type, ACK)
            self.assertIsNone(house.process.poll())

    def test_robots_come_and_go_by_one_call(self):
        with self.run_house("--lock-step", world=self.world(ARENA)) as house, \
                connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
            world = client.simulation(0)
            self.assertEqual(world.spawn("r0", 1.0, 2.0, 0.5, "extra"), "extra")
            self.assertEqual(world.pose("extra"), (1.0, 2.0, 0.5))
            with self.assertRaisesRegex(RequestRefused, "nobody"):
                world.spawn("nobody", 0, 0, 0)
            with self.assertRaises(RequestRefused):
                world.spawn("r0", 0, 0, 0, "extra")
            world.remove("extra")
            with self.assertRaises(RequestRefused):
                world.pose("extra")

    def test_without_lock_step_a_running_world_refuses_to_step_and_a_paused_one_stays_paused(self):
        with self.run_house("--fast", world=self.world(ARENA)) as house, \
                connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
            world, laser = client.simulation(0), client.laser(0)
            with self.assertRaisesRegex(RequestRefused, "the world is running: pause it first, or start it with --lock-step"):
                world.step(4)
            for _ in range(3):
                laser.next_data()  # it goes on
            world.pause()
            world.step()
            before = laser.timestamp
            world.step(4)
            self.assertAlmostEqual(laser.timestamp, before + 0.4)
            for _ in range(300):
                world.pose("r0")  # many ticks of a world that runs
            world.step()
            self.assertAlmostEqual(laser.timestamp, before + 0.5, msg="it stood still meanwhile")

    def test_without_lock_step_joining_and_starting_again_are_refused(self):
        with self.run_house(world=self.world(ARENA)) as house, \
                connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
            world = client.simulation(0)
            with self.assertRaisesRegex(RequestRefused, "--lock-step"):
                world.join("me")
            with self.assertRaisesRegex(RequestRefused, "--lock-step"):
                world.reset(3)

    def test_a_paused_world_is_stepped_and_read_in_pull_mode(self):
        with self.run_house("--paused", world=self.world(ARENA)) as house, \
                connect(f":{house.port()}", mode=Mode.PULL, timeout=60) as client:
            world, laser = client.simulation(0), client.laser(0)
            for step in range(1, 6):
                world.step()
                client.read()
                self.assertEqual(laser.timestamp, round(0.1 * step, 1))


class End(HouseTest):
    def test_what_waits_goes_out_before_the_end_and_what_was_lost_is_counted(self):
        """A client that does not read for the whole run gets the newest of it, then its end, and the number of the rest."""
        ticks = 4000
        with self.run_house("--fast", "--paused", "--duration", ticks / 10, "--json", world=self.world(ARENA)) as house, \
                connect(f":{house.port()}", mode=Mode.PULL, timeout=60) as client:
            laser = client.laser(0)
            times = []
            laser.on_data(lambda kind, value, timestamp: times.append(timestamp))
            world = client.simulation(0)
            with contextlib.suppress(ConnectionError), Client(house.port()) as other:
                world.pause()
                while other.request(PLAYER, 0, 1).time < ticks / 10:
                    pass
            with self.assertRaises(RunEnded):
                while True:
                    client.read(60)
            self.assertEqual(times[-1], ticks / 10)
            self.assertEqual(len(times) + client.overflow_count, ticks)
            self.assertGreater(client.overflow_count, 0)
            self.assertEqual(house.wait(), 0, house.log())
            house.wait_for_line(rf"{client.overflow_count} data messages were lost in all")

    def test_whatever_is_asked_after_the_last_tick_ends_with_the_run(self):
        asked = (lambda world: world.pose("r0"), lambda world: world.spawn("r0", 1, 1, 0),
                 lambda world: world.remove(world.spawn("r0", 1, 1, 0)), lambda world: world.step())
        for ask in asked * 2:
            with self.run_house("--lock-step", "--duration", 0.5, world=self.world(ARENA)) as house, \
                    connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
                world = client.simulation(0)
                for _ in range(5):
                    world.step()
                with self.assertRaises(RunEnded):
                    while True:
                        ask(world)
                self.assertEqual(house.wait(), 0, house.log())

    def test_in_push_mode_a_client_asks_how_many_messages_were_lost(self):
        with self.run_house("--lock-step", world=self.world(ARENA)) as house, \
                connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
            self.assertEqual(client.lost_count(), 0)
            client.laser(0)
            client.simulation(0).step(3000)
            self.assertGreater(client.lost_count(), 0)


if __name__ == "__main__":
    unittest.main()
