"""Drivers that use devices of other drivers: chains of them in a configuration file, from a scan or a map to the wheels."""

import json
import math
import struct
import sys
import unittest
import zlib

from house import ACK, CMD, DATA, NACK, POSITION2D, REQ, ROOT, SIMULATION, Client, House, HouseTest, free_ports
from house import Message as Received

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Access, GoalRefused, Mode, RequestRefused, connect  # noqa: E402
from playhouse_client.generated import blackboard, health  # noqa: E402
from playhouse_client.generated import map as grid  # noqa: E402
from playhouse_client.generated import planner  # noqa: E402
from playhouse_client.connection import Message  # noqa: E402
from playhouse_client.generated.common import BlackboardEntry  # noqa: E402
from playhouse_client.wire import Kind, c_string, text  # noqa: E402

sys.path.insert(0, str(ROOT / "clients/python/tests"))
from fake_server import FakeServer, Peer  # noqa: E402

MAP, PLANNER = 42, 44
GET_GEOM = 1

GOAL = (6.5, 0.0, 0.0)  # behind a crate and a wall with a gap, which are right ahead
PAUSE = 1               # command of simulation: a paused world goes on


def drive_to(test: HouseTest, goal, cfg, *arguments) -> tuple[dict, list[tuple[float, ...]]]:
    """One run as fast as possible, in which position2d:1 is given its goal before the first tick. The result, and what
    its STATE said: x, y, heading, their velocities, stall."""
    with House("serve", cfg, "--port", 0, "--headless", "--fast", "--paused", "--duration", 60, "--json",
               *arguments) as house, Client(house.port()) as client:
        test.assertEqual(client.open(POSITION2D, 1).type, ACK)
        client.send(POSITION2D, 1, CMD, 2, struct.pack(">ddddddI", *goal, 0, 0, 0, 1))
        client.send(SIMULATION, 0, CMD, PAUSE)
        states = []
        with test.assertRaises(ConnectionError):  # the end of the run
            while True:
                states.append(struct.unpack(">ddddddI", client.next_data(POSITION2D, 1).body))
        test.assertEqual(house.wait(), 0, house.log())
        return json.loads(house.output()), states


class Chain(HouseTest):
    """worlds/avoid.cfg: ranger -> rangertolaser -> vfh -> position2d."""

    def drive(self, *arguments) -> tuple[dict, list[tuple[float, ...]]]:
        return drive_to(self, GOAL, ROOT / "worlds/avoid.cfg", *arguments)

    def test_a_robot_drives_round_what_is_in_its_way_to_the_same_bits_each_time(self):
        result, states = self.drive()
        self.assertLess(math.dist(states[-1][:2], GOAL[:2]), 0.25)
        self.assertLess(abs(states[-1][2] - GOAL[2]), math.radians(12))
        self.assertEqual(states[-1][3:6], (0, 0, 0), "it stands at its goal")
        self.assertFalse(any(state[6] for state in states), "it touches nothing")
        self.assertGreater(max(abs(state[1]) for state in states), 0.8, "straight ahead there is a crate")
        for arguments in ((), ("--workers", 4)):
            again, _ = self.drive(*arguments)
            for word in ("ticks", "hash", "sensed_hash"):
                self.assertEqual(again[word], result[word])

    def test_the_documented_section_is_that_of_the_example(self):
        documented = (ROOT / "docs/drivers.md").read_text().split('## driver "vfh"')[1].split("```")[1]
        self.assertIn(documented.strip(), (ROOT / "worlds/avoid.cfg").read_text())


def access(answer: Received) -> int:
    return struct.unpack_from(">I", answer.body, 16)[0]


class OnAMap(HouseTest):
    """Drivers that use the map of a world."""

    CAVE = f"""
include "pioneer.inc"
include "sick.inc"
include "map.inc"
interval_sim 100
floorplan( name "cave" bitmap "{ROOT}/worlds/bitmaps/cave.png" size [16 16 0.6] )
define explorer pioneer2dx ( sicklaser_low() localization "odom" odom_error [0.05 0.05 0.05 0.1] ctrl "wander" )
explorer( name "r0" pose [-5.8 -4.3 0 20] )
explorer( name "r1" pose [-4 -5.7 0 120] )
"""
    STAGE = """
driver( name "stage" provides ["simulation:0"] worldfile "cave.world" )
driver( name "stage" provides ["map:0"] model "cave" )
driver( name "stage" provides ["position2d:0" "laser:0" "sonar:0"] model "r0" )
"""

    def localized(self, sensor: str, options: str, seconds: float) -> tuple[float, float]:
        """How far the pose of `amcl`, and that of the odometry, is from the true one after so many simulated seconds."""
        self.write("cave.world", self.CAVE)
        cfg = self.write("cave.cfg", self.STAGE + f"""
driver( name "amcl" provides ["localize:0" "position2d:2"]
  requires ["odometry:::position2d:0" "{sensor}:0" "{sensor}:::map:0"] {options} )
""")
        with House("serve", cfg, "--port", 0, "--headless", "--fast", "--paused") as house, \
                Client(house.port()) as client:
            for index in (0, 2):
                self.assertEqual(client.open(POSITION2D, index).type, ACK)
            start = client.pose("r0")
            client.send(SIMULATION, 0, CMD, PAUSE)
            poses = {}
            while (message := client.receive()).time < seconds:
                poses[message.index] = struct.unpack_from(">ddd", message.body)
            client.send(SIMULATION, 0, CMD, PAUSE)
            true = client.pose("r0")
            poses |= {message.index: struct.unpack_from(">ddd", message.body) for message in client.data}
            c, s = math.cos(start[2]), math.sin(start[2])
            x, y, _ = poses[0]
            return math.dist(poses[2][:2], true[:2]), \
                math.dist((start[0] + c * x - s * y, start[1] + s * x + c * y), true[:2])

    def test_a_robot_is_localized_from_a_rough_pose(self):
        error, drift = self.localized("laser", "init_pose [-5 -5 0]", 300)
        self.assertGreater(drift, 3)
        self.assertLess(error, 0.15)

    def test_a_robot_is_localized_from_anywhere(self):
        error, _ = self.localized("laser", "init_pose_var [10 10 360]", 100)
        self.assertLess(error, 0.15)

    def test_a_robot_is_localized_by_its_sonars(self):
        error, drift = self.localized("sonar", "init_pose [-5.8 -4.3 20] init_pose_var [0.3 0.3 20]", 300)
        self.assertGreater(drift, 3)
        self.assertLess(error, 0.5)


class OfAnotherServer(HouseTest):
    """Drivers of one program that use devices of another, by its port alone."""

    def test_a_robot_of_one_program_is_driven_and_localized_by_drivers_of_another(self):
        self.write("cave.world", OnAMap.CAVE.replace('ctrl "wander"', ""))
        robot = self.write("robot.cfg", OnAMap.STAGE)
        with House("serve", robot, "--port", 0, "--headless", "--speed", 10) as lab:
            port = lab.port()
            brain = self.write("brain.cfg", f"""
driver( name "passthrough" provides ["map:0"] requires ["{port}:map:0"] )
driver( name "amcl" provides ["localize:0" "position2d:2"] requires ["{port}:position2d:0" "{port}:laser:0" "map:0"]
  init_pose [-5.8 -4.3 20] init_pose_var [0.1 0.1 5] )
driver( name "vfh" provides ["position2d:1"] requires ["{port}:position2d:0" "{port}:laser:0"] max_speed 0.4 )
""")
            with House("serve", brain, "--port", 0, "--headless") as house, Client(house.port()) as client, \
                    Client(port) as truth:
                self.assertRegex(house.log(), f'"{port}:laser:0" is taken from the server at localhost:{port}')
                for index in (1, 2):
                    self.assertEqual(access(client.open(POSITION2D, index)), 1)
                start = truth.pose("r0")
                client.send(POSITION2D, 1, CMD, 2, struct.pack(">ddddddI", 2, 0, 0, 0, 0, 0, 1))
                way = [start[:2]]  # what is believed was so a while ago: how long depends on the machine
                for _ in range(1000):
                    if math.dist(way[-1], start[:2]) > 1.4:
                        break
                    believed = struct.unpack_from(">ddd", client.next_data(POSITION2D, 2).body)
                    way.append(truth.pose("r0")[:2])
                    self.assertLess(min(math.dist(believed[:2], place) for place in way), 0.3)
                else:
                    self.fail("it does not get there")


class OffBoard(HouseTest):
    """A robot is localized by another program, which was there before the robot and outlives it."""

    def test_a_robot_is_waited_for_and_found_again(self):
        world = self.write("cave.world", OnAMap.CAVE.replace('ctrl "wander"', ""))
        (port,) = free_ports()
        brain = self.write("brain.cfg", f"""
driver( name "passthrough" provides ["position2d:0" "laser:0"] requires ["127.0.0.1:{port}:position2d:0" "127.0.0.1:{port}:laser:0"] )
driver( name "mapfile" provides ["map:0"] filename "{ROOT}/worlds/bitmaps/cave.png" resolution 0.025 )
driver( name "amcl" provides ["localize:0" "position2d:2"] requires ["position2d:0" "laser:0" "map:0"] alwayson 1
  init_pose [-5.8 -4.3 20] init_pose_var [0.1 0.1 5] )
""")
        with House("serve", brain, "--port", 0, "--headless") as house:
            house.wait_for_line(rf'brain.cfg:4: driver "amcl" waits: 127.0.0.1:{port} cannot connect')
            with Client(house.port()) as early:
                self.assertEqual(access(early.open(POSITION2D, 2)), 3)
            with House("run", world, "--port", port, "--headless"):
                house.wait_for_line('brain.cfg:4: driver "amcl" has started')
                with Client(house.port()) as client, Client(port) as robot:
                    self.assertEqual(access(client.open(POSITION2D, 2)), 1)
                    self.check(client, robot, 0.3)
            house.wait_for_line(f"passthrough: 127.0.0.1:{port} .*: trying again")
            with House("run", world, "--port", port, "--headless"):
                house.wait_for_line(f"passthrough: 127.0.0.1:{port} is connected")
                with Client(house.port()) as client, Client(port) as robot:
                    self.assertEqual(access(client.open(POSITION2D, 2)), 1)
                    self.check(client, robot, 0.6)  # it goes on from where it believed the robot to be
            lines = [line for line in house.lines if " waits: " in line]
            self.assertEqual(len(lines), 1, lines)

    def check(self, client: Client, robot: Client, most: float) -> None:
        """The robot drives, and is where it is believed to be, to so many metres."""
        robot.drive(0, 0.3)
        start = robot.pose("r0")
        way = [start[:2]]
        while math.dist(way[-1], start[:2]) < 0.3:
            believed = struct.unpack_from(">ddd", client.next_data(POSITION2D, 2).body)
            way.append(robot.pose("r0")[:2])
            self.assertLess(min(math.dist(believed[:2], place) for place in way), most)


class InACircle(HouseTest):
    """Programs whose devices stand for each other."""

    def check_ring(self, size: int) -> None:
        ports = free_ports(size)
        houses = []
        for nth, port in enumerate(ports):
            cfg = self.write(f"{nth}.cfg", 'driver( name "passthrough" provides ["position2d:0"] '
                             f'requires ["127.0.0.1:{ports[(nth + 1) % size]}:position2d:0"] )')
            houses.append(House("serve", cfg, "--port", port, "--headless"))
            self.addCleanup(houses[-1].__exit__)
            houses[-1].port()
        for nth in reversed(range(size)):
            with Client(ports[nth]) as client:
                for _ in range(2):
                    self.assertEqual(access(client.open(POSITION2D, 0)), 3)
                self.assertEqual(client.request(POSITION2D, 0, GET_GEOM).type, NACK)
                self.assertEqual(client.devices(), [(POSITION2D, 0)])
        for nth, house in enumerate(houses):
            house.wait_for_line(f"passthrough: position2d:0 leads in a circle by way of 127.0.0.1:{ports[(nth + 1) % size]}")
            self.assertEqual(sum(line.startswith("error: ") for line in house.lines), 1, house.log())

    def test_two_say_so_and_open_nothing(self):
        self.check_ring(2)

    def test_three_say_so_and_open_nothing(self):
        self.check_ring(3)


class Planned(HouseTest):
    """worlds/plan.cfg: mapfile -> wavefront -> vfh -> position2d."""

    GOAL = (6.0, 4.0, 1.5)  # at the other side of the cave

    def drive(self, *arguments) -> tuple[dict, list[planner.Data], list[tuple[float, ...]]]:
        """One run as fast as possible, in which the planner is given its goal before the first tick. The result, and what
        the planner's and the robot's STATE said."""
        with House("serve", ROOT / "worlds/plan.cfg", "--port", 0, "--headless", "--fast", "--paused", "--duration", 65,
                   "--json", *arguments) as house, Client(house.port()) as client, Client(house.port()) as robot:
            self.assertEqual(client.open(PLANNER, 0).type, ACK)
            self.assertEqual(robot.open(POSITION2D, 0).type, ACK)
            client.send(PLANNER, 0, CMD, 1, struct.pack(">ddd", *self.GOAL))
            path = planner.WaypointsReq.decode(client.request(PLANNER, 0, 1).body)
            self.assertEqual((path.waypoints_distance, path.waypoints), (0, []), "it plans in ticks")
            client.send(SIMULATION, 0, CMD, PAUSE)
            plans, robots = [], []
            with self.assertRaises(ConnectionError):  # the end of the run
                while True:
                    plans.append(planner.Data.decode(client.next_data(PLANNER, 0).body))
            with self.assertRaises(ConnectionError):
                while True:
                    robots.append(struct.unpack(">ddddddI", robot.next_data(POSITION2D, 0).body))
            self.assertEqual(house.wait(), 0, house.log())
            return json.loads(house.output()), plans, robots

    def test_a_robot_finds_its_way_to_another_room_to_the_same_bits_each_time(self):
        result, plans, robots = self.drive()
        self.assertEqual((len(plans), len(robots)), (650, 650), "every tick")
        self.assertEqual([plan.valid for plan in plans[:3]], [0, 0, 1])
        self.assertEqual((plans[-1].done, plans[-1].waypoint_idx), (1, -1))
        self.assertLess(math.dist(robots[-1][:2], self.GOAL[:2]), 0.25)
        self.assertLess(abs(robots[-1][2] - self.GOAL[2]), math.radians(6))
        self.assertEqual(robots[-1][3:6], (0, 0, 0), "it stands at its goal")
        self.assertFalse(any(robot[6] for robot in robots), "it touches nothing")
        driven = sum(math.dist(one[:2], next_one[:2]) for one, next_one in zip(robots, robots[1:]))
        self.assertGreater(driven, 1.08 * math.dist(robots[0][:2], self.GOAL[:2]), "round the rocks")
        for arguments in ((), ("--workers", 4)):
            again = self.drive(*arguments)
            for word in ("ticks", "hash", "sensed_hash"):
                self.assertEqual(again[0][word], result[word])
            self.assertEqual(again[1:], (plans, robots))

    def test_a_refused_goal_is_an_error_of_the_client_with_the_reason_of_the_log(self):
        reasons = {(-7.9, -7.9): "the goal is within safety_dist of an obstacle",  # rock, all around the cave
                   (99, 0): "the goal is off the map"}
        with House("serve", ROOT / "worlds/plan.cfg", "--port", 0, "--headless", "--fast") as house, \
                connect(f"127.0.0.1:{house.port()}") as client, client.planner(0) as guide:
            self.assertEqual(guide.why_refused(), "")
            for (x, y), reason in reasons.items():
                with self.assertRaises(GoalRefused) as refused:
                    guide.drive_to(x, y, 0)
                why = house.wait_for_line(rf"driver wavefront: (no path to \({x}, {y}\): .*)").group(1)
                self.assertEqual(why, f"no path to ({x}, {y}): {reason}")
                self.assertTrue(str(refused.exception).endswith(f"planner:0: {why}"), str(refused.exception))
                self.assertEqual(guide.why_refused(), why)
            here = guide.drive_to(*self.GOAL)
            self.assertTrue(here.done)
            self.assertEqual(guide.why_refused(), "")

    def test_a_client_learns_why_there_is_no_map_and_why_a_robot_drives_to_no_goals(self):
        def nothing(peer: Peer, message: Message) -> None:
            peer.answer(message, Kind.NACK)

        world = self.world('interval_sim 100\nposition( name "r0" size [0.4 0.4 0.2] )')
        with FakeServer(lambda peer: peer.serve(nothing)) as maps, FakeServer(lambda peer: peer.serve(nothing)) as lasers:
            cfg = self.write("mute.cfg", f"""
                driver( name "stage" provides ["simulation:0"] worldfile "{world}" )
                driver( name "stage" provides ["position2d:0"] model "r0" )
                driver( name "nd" provides ["position2d:1"]
                        requires ["output:::position2d:0" "input:::position2d:0" "{lasers.port}:laser:0"] )
                driver( name "wavefront" provides ["planner:0"]
                        requires ["output:::position2d:0" "input:::position2d:0" "{maps.port}:map:0"] )
                """)
            with House("serve", cfg, "--port", 0, "--headless") as house, connect(f"127.0.0.1:{house.port()}") as client:
                guide, base = client.planner(0), client.position2d(1)
                with self.assertRaises(GoalRefused) as refused:
                    guide.drive_to(1, 0, 0)
                why = house.wait_for_line("driver wavefront: (no path to .*)").group(1)
                self.assertEqual(why, "no path to (1, 0): there is no map: it does not tell its size")
                self.assertTrue(str(refused.exception).endswith(f"planner:0: {why}"), str(refused.exception))
                why = house.wait_for_line("driver nd: (.*)").group(1)
                self.assertEqual(why, "its laser does not tell its place, so it drives to no goals")
                self.assertEqual(base.why_refused(), "", "it has no goal")
                base.go_to(1, 0, 0)
                self.assertEqual(base.why_refused(), why)
                base.stop()
                self.assertEqual(base.why_refused(), "")
                self.assertEqual(client.position2d(0).why_refused(), "", "simulated robots give no reasons")

    def test_the_documented_section_is_that_of_the_example(self):
        documented = (ROOT / "docs/drivers.md").read_text().split('## driver "wavefront"')[1].split("```")[1]
        self.assertIn(documented.strip(), (ROOT / "worlds/plan.cfg").read_text())


class Navigated(HouseTest):
    """worlds/navigate.cfg: amcl and the map of the world -> wavefront -> nd -> position2d."""

    GOALS = ((6.0, 4.0, 1.5), (-5.8, 5.0, 3.0))

    def drive(self) -> tuple[list[tuple[float, ...]], list[planner.Data], bool]:
        """One run as fast as possible to the goals, one after the other. The robot's true pose and the planner's STATE at
        each of them, and whether the robot ever touched anything."""
        with House("serve", ROOT / "worlds/navigate.cfg", "--port", 0, "--headless", "--fast", "--paused") as house, \
                Client(house.port()) as client:
            for interf in (PLANNER, POSITION2D):
                self.assertEqual(client.open(interf, 0).type, ACK)
            client.send(SIMULATION, 0, CMD, PAUSE)
            poses, plans, touched = [], [], False
            for goal in self.GOALS:
                client.send(PLANNER, 0, CMD, 1, struct.pack(">ddd", *goal))
                while True:
                    message = client.receive()
                    self.assertLess(message.time, 300, f"it does not reach {goal}")
                    if message.interf == POSITION2D:
                        touched = touched or struct.unpack_from(">I", message.body, 48)[0] != 0
                        continue
                    plan = planner.Data.decode(message.body)
                    if plan.done and (plan.goal.px, plan.goal.py) == goal[:2]:
                        break
                plans.append(plan)
                poses.append(client.pose("r0"))
                client.data.clear()
            return poses, plans, touched

    def test_a_robot_whose_odometry_drifts_reaches_goals_on_the_map(self):
        poses, plans, touched = self.drive()
        for pose, plan, goal in zip(poses, plans, self.GOALS):
            self.assertLess(math.dist(pose[:2], goal[:2]), 0.6, "distance_epsilon, and the error of the belief")
            self.assertLess(math.dist(pose[:2], (plan.pos.px, plan.pos.py)), 0.25, "it knows where it is")
        self.assertFalse(touched)

    def test_the_documented_section_is_that_of_the_example(self):
        documented = (ROOT / "docs/drivers.md").read_text().split('## driver "amcl"')[1].split("```")[1]
        self.assertIn(documented.strip(), (ROOT / "worlds/navigate.cfg").read_text())


class Wired(HouseTest):
    """docs/wiring.md: worlds/robot.cfg, and worlds/station.cfg in another program."""

    def test_a_station_that_starts_first_drives_the_robot_to_a_goal(self):
        (port,) = free_ports()
        station = self.write("station.cfg", (ROOT / "worlds/station.cfg").read_text().replace("6665", str(port)))
        with House("serve", station, "--port", 0, "--headless") as house:
            house.wait_for_line(rf'driver "amcl" waits: localhost:{port} cannot connect: Connection refused')
            with House("serve", ROOT / "worlds/robot.cfg", "--port", port, "--headless", "--speed", 10):
                house.wait_for_line('driver "amcl" has started')
                with Client(house.port()) as client:
                    self.assertEqual(client.open(PLANNER, 0).type, ACK)
                    client.send(PLANNER, 0, CMD, 1, struct.pack(">ddd", -4.0, -1.0, 0.0))
                    while True:
                        message = client.receive()
                        plan = planner.Data.decode(message.body)
                        if plan.done and (plan.goal.px, plan.goal.py) == (-4.0, -1.0):
                            break
                    self.assertLess(math.dist((plan.pos.px, plan.pos.py), (-4.0, -1.0)), 0.6)
                with Client(port) as robot:
                    self.assertLess(math.dist(robot.pose("r0")[:2], (-4.0, -1.0)), 1.0, "where it really is")

    def test_the_page_has_the_sections_of_the_files(self):
        written = "".join((ROOT / "worlds" / name).read_text() for name in ("robot.cfg", "station.cfg"))
        blocks = [block for block in (ROOT / "docs/wiring.md").read_text().split("```")[1::2] if "driver" in block]
        self.assertEqual([block.strip() in written for block in blocks], [True, False, True, True, True],
                         "all but the one of a real robot")


ROOM = """
interval_sim 100
define echo sensor( range [0 5] fov 15 samples 1 )
define sonars ranger( size [0.01 0.01 0.01]
  echo( pose [0.15 0.05 0 10] ) echo( pose [0.15 -0.05 0 -10] ) echo( pose [0.12 0.10 0 30] ) echo( pose [0.12 -0.10 0 -30] )
  echo( pose [0.10 0.12 0 50] ) echo( pose [0.10 -0.12 0 -50] ) echo( pose [0.05 0.15 0 90] ) echo( pose [0.05 -0.15 0 -90] )
  echo( pose [-0.20 0.10 0 135] ) echo( pose [-0.20 -0.10 0 -135] ) )
define scanner ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 181 ) )
define wall model( color "gray" )
wall( name "north" pose [3 4.1 0 0] size [10.4 0.2 0.6] )
wall( name "south" pose [3 -4.1 0 0] size [10.4 0.2 0.6] )
wall( name "east" pose [8.1 0 0 0] size [0.2 8 0.6] )
wall( name "west" pose [-2.1 0 0 0] size [0.2 8 0.6] )
wall( name "left of the gap" pose [4.5 2.5 0 0] size [0.2 3 0.6] )
wall( name "right of the gap" pose [4.5 -2.2 0 0] size [0.2 3.6 0.6] )
wall( name "crate" pose [1.8 0.1 0 20] size [0.7 0.7 0.6] )
wall( name "post" pose [6.2 -0.6 0 0] size [0.3 0.3 0.6] )
position( name "r0" size [0.44 0.38 0.22] origin [-0.04 0 0 0] localization "odom" odom_error [0 0 0 0]
  sonars( pose [0 0 0 0] ) scanner( pose [0 0 0 0] ) )
"""

BEHIND_THE_POST = (7.2, -0.6, 0.0)
BEHIND_THE_CRATE = (3.4, 0.1, 0.0)

ND = """
driver( name "stage" provides ["simulation:0"] worldfile "test.world" )
driver( name "stage" provides ["position2d:0" "laser:0" "sonar:0" "ranger:0" "ranger:1"] model "r0" )
driver( name "nd" provides ["position2d:1"] requires ["output:::position2d:0" "input:::position2d:0" "{scans}"] goal_tol [0.2 10] )
"""


VFH = """
driver( name "stage" provides ["simulation:0"] worldfile "test.world" )
driver( name "stage" provides ["position2d:0" "laser:0" "sonar:0" "ranger:0" "ranger:1"] model "r0" )
driver( name "vfh" provides ["position2d:1"] requires ["position2d:0" "{scans}"] distance_epsilon 0.2 )
"""


class VectorFieldHistogram(HouseTest):
    """Stage's ranges of any interface -> vfh -> position2d, in the same room."""

    def arrives(self, scans: str):
        self.world(ROOM)
        _, states = drive_to(self, BEHIND_THE_CRATE, self.write("vfh.cfg", VFH.format(scans=scans)))
        self.assertLess(math.dist(states[-1][:2], BEHIND_THE_CRATE[:2]), 0.25)
        self.assertEqual(states[-1][3:6], (0, 0, 0), "it stands at its goal")
        self.assertFalse(any(state[6] for state in states), "it touches nothing")
        self.assertGreater(max(abs(state[1]) for state in states if state[0] < 2.5), 0.4, "past the crate")

    def test_a_robot_gets_to_its_goal_by_a_ranger_that_scans(self):
        self.arrives("ranger:1")

    def test_and_by_a_ring_of_a_ranger(self):
        self.arrives("ranger:0")

    def test_and_by_sonars(self):
        self.arrives("sonar:0")

    def test_its_planner_brings_a_robot_to_a_goal(self):
        self.world(ROOM)
        cfg = VFH.format(scans="laser:0").replace('provides ["position2d:1"]', 'provides ["position2d:1" "planner:0"]')
        with House("serve", self.write("vfh.cfg", cfg), "--port", 0, "--headless", "--fast") as house, \
                connect(f"127.0.0.1:{house.port()}") as client, client.planner(0) as guide:
            there = guide.drive_to(*BEHIND_THE_CRATE)
            self.assertTrue(there.done)
            with Client(house.port()) as other:
                self.assertLess(math.dist(other.pose("r0")[:2], BEHIND_THE_CRATE[:2]), 0.25)


class NearnessDiagram(HouseTest):
    """Stage's ranges -> nd -> position2d, in a room with a wall whose gap is 1.4 m wide, and things in the way."""

    def drive(self, scans: str) -> tuple[dict, list[tuple[float, ...]]]:
        self.world(ROOM)
        return drive_to(self, BEHIND_THE_POST, self.write("nd.cfg", ND.format(scans=scans)))

    def arrives(self, scans: str):
        result, states = self.drive(scans)
        self.assertLess(math.dist(states[-1][:2], BEHIND_THE_POST[:2]), 0.25)
        self.assertLess(abs(states[-1][2]), math.radians(12))
        self.assertEqual(states[-1][3:6], (0, 0, 0), "it stands at its goal")
        self.assertFalse(any(state[6] for state in states), "it touches nothing and gives nothing up")
        self.assertGreater(max(abs(state[1]) for state in states if state[0] < 2.5), 0.4, "past the crate")
        again, _ = self.drive(scans)
        for word in ("ticks", "hash", "sensed_hash"):
            self.assertEqual(again[word], result[word])

    def test_a_robot_with_a_laser_gets_to_its_goal_to_the_same_bits_each_time(self):
        self.arrives("laser:0")

    def test_a_robot_with_sonars_alone_gets_there_too(self):
        self.arrives("sonar:0")

    def test_and_so_does_one_with_a_ranger_that_scans(self):
        self.arrives("ranger:1")


TWO_DOORS = """
interval_sim 100
define scanner ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 181 ) )
define wall model( color "gray" )
model( name "house" size [0.1 0.1 0.1] pose [-1.5 -3.5 0 0]
  wall( pose [4.5 7.6 0 0] size [10.4 0.2 0.6] )
  wall( pose [4.5 -0.6 0 0] size [10.4 0.2 0.6] )
  wall( pose [9.6 3.5 0 0] size [0.2 8 0.6] )
  wall( pose [-0.6 3.5 0 0] size [0.2 8 0.6] )
  wall( pose [5 1.2 0 0] size [0.2 3.4 0.6] )
  wall( pose [5 5 0 0] size [0.2 1.8 0.6] ) )
model( name "crate" pose [3.4 0 0 30] size [0.9 0.9 0.6] color "brown" )
position( name "r0" size [0.44 0.38 0.22] origin [-0.04 0 0 0] localization "gps" scanner( pose [0 0 0 0] ) )
"""

PAST_THE_CRATE = """
driver( name "stage" provides ["simulation:0"] worldfile "test.world" )
driver( name "stage" provides ["map:0"] model "house" )
driver( name "stage" provides ["position2d:0" "laser:0"] model "r0" )
driver( name "nd" provides ["position2d:1"] requires ["output:::position2d:0" "input:::position2d:0" "laser:0"]
  goal_tol [0.2 10] )
driver( name "wavefront" provides ["planner:0"]
  requires ["output:::position2d:1" "input:::position2d:0" "map:0" {scans}] safety_dist 0.35 distance_epsilon 0.4 )
"""


class PastWhatTheMapLacks(HouseTest):
    """A crate in the nearer of two doors, which is not on the map of the house; another door is three metres beside it."""

    BEHIND_THE_DOOR = (6.0, 0.0, 0.0)

    def drive(self, scans: str, seconds: int) -> tuple[bool, dict, list[tuple[float, ...]]]:
        """One run as fast as possible: whether the planner was done, the result, and what the robot's STATE said, which
        is its true pose."""
        self.world(TWO_DOORS)
        cfg = self.write("crate.cfg", PAST_THE_CRATE.format(scans=scans))
        with House("serve", cfg, "--port", 0, "--headless", "--fast", "--paused", "--duration", seconds, "--json") as house, \
                Client(house.port()) as client:
            for interf in (PLANNER, POSITION2D):
                self.assertEqual(client.open(interf, 0).type, ACK)
            client.send(PLANNER, 0, CMD, 1, struct.pack(">ddd", *self.BEHIND_THE_DOOR))
            client.send(SIMULATION, 0, CMD, PAUSE)
            done, states = False, []
            with self.assertRaises(ConnectionError):  # the end of the run
                while True:
                    message = client.receive()
                    if message.interf == POSITION2D:
                        states.append(struct.unpack(">ddddddI", message.body))
                    elif message.interf == PLANNER:
                        done = planner.Data.decode(message.body).done != 0
            self.assertEqual(house.wait(), 0, house.log())
            return done, json.loads(house.output()), states

    def test_a_robot_goes_through_the_other_door_to_the_same_bits_each_time(self):
        done, result, states = self.drive('"laser:0"', 90)
        self.assertTrue(done)
        self.assertLess(math.dist(states[-1][:2], self.BEHIND_THE_DOOR[:2]), 0.25)
        self.assertFalse(any(state[6] for state in states), "it touches nothing")
        through = [y for x, y, *_ in states if 3.3 < x < 3.7]
        self.assertGreater(min(through), 2.0, "the other door")
        driven = sum(math.dist(one[:2], next_one[:2]) for one, next_one in zip(states, states[1:]))
        self.assertLess(driven, 12, "hardly farther than to that door and back")
        _, again, same = self.drive('"laser:0"', 90)
        self.assertEqual((again["hash"], again["sensed_hash"], same), (result["hash"], result["sensed_hash"], states))

    def test_without_a_laser_it_never_gets_there(self):
        done, _, states = self.drive("", 180)
        self.assertFalse(done)
        self.assertLess(max(x for x, *_ in states), 3.5)


class WithoutAWorld(HouseTest):
    """Drivers of a configuration that has no world."""

    def test_a_map_is_that_of_its_image(self):
        self.write("plan.pgm", "P2 3 2 255 0 128 255 255 0 255")
        cfg = self.write("map.cfg", 'driver( name "mapfile" provides ["map:0"] filename "plan.pgm" resolution 0.5 )\n')
        with self.serve(cfg) as house, Client(house.port()) as client:
            self.assertEqual(client.open(MAP, 0).type, ACK)
            info = grid.Info.decode(client.request(MAP, 0, 1).body)
            self.assertEqual((info.scale, info.width, info.height), (0.5, 3, 2))
            self.assertEqual((info.origin.px, info.origin.py, info.origin.pa), (-0.75, -0.5, 0))
            answer = client.request(MAP, 0, 2, grid.Data(1, 0, 3, 2, 0, b"").encode())
            self.assertEqual(answer.type, ACK)
            tile = grid.Data.decode(answer.body)
            self.assertEqual((tile.col, tile.row, tile.width, tile.height, tile.data_range), (1, 0, 3, 2, 1))
            cells = struct.unpack("6b", zlib.decompress(tile.data))
            self.assertEqual(cells, (1, -1, 0, 0, -1, 0))
            self.assertEqual(client.request(MAP, 0, 3).type, NACK)

    def test_a_relay_passes_bytes_on_to_all_in_order(self):
        cfg = self.write("relay.cfg", 'driver( name "relay" provides ["opaque:0"] )\n')
        with self.serve(cfg) as house, connect(f":{house.port()}", mode=Mode.PULL) as one, \
                connect(f":{house.port()}", mode=Mode.PULL) as other:
            radios = [client.opaque(0) for client in (one, other)]
            sent = [bytes([k]) * k for k in range(1, 50)]
            for message in sent:
                radios[0].send(message)
            for client, radio in zip((one, other), radios):
                heard = []
                while len(heard) < len(sent):
                    client.read(30)
                    heard += radio.take_messages()
                self.assertEqual(heard, sent)

    def test_a_blackboard_tells_each_client_of_its_own_keys_alone(self):
        with self.serve(ROOT / "worlds/board.cfg") as house:
            clients = [connect(f":{house.port()}", mode=Mode.PUSH) for _ in range(3)]
            boards = [client.device("blackboard", 0) for client in clients]
            heard: list[list[tuple[str, str, bytes]]] = [[], [], []]
            for board, told in zip(boards, heard):
                board.on_data(lambda _message, entry, _time, told=told:
                              told.append((text(entry.group), text(entry.key), entry.data)))

            def ask(board, request, group, key="", data=b""):
                return board.request(request, BlackboardEntry(c_string(key), c_string(group), 1, 2, data))

            one, two, _ = boards
            self.assertIsNone(ask(one, blackboard.REQ_SET_ENTRY, "team", "goal", b"left"))
            entry = ask(two, blackboard.REQ_SUBSCRIBE_TO_KEY, "team", "goal")
            self.assertEqual((text(entry.group), text(entry.key), entry.type, entry.subtype, entry.data),
                             ("team", "goal", 1, 2, b"left"))
            self.assertGreater(entry.timestamp_sec, 0, "the server's time")
            self.assertEqual(ask(one, blackboard.REQ_GET_ENTRY, "team", "none").data, b"")
            ask(one, blackboard.REQ_SET_ENTRY, "map", "a", b"1")
            ask(one, blackboard.REQ_SUBSCRIBE_TO_GROUP, "map")
            ask(two, blackboard.REQ_SET_ENTRY, "map", "b", b"2")
            ask(one, blackboard.REQ_SET_ENTRY, "team", "goal", b"right")
            ask(two, blackboard.REQ_UNSUBSCRIBE_FROM_KEY, "team", "goal")
            ask(one, blackboard.REQ_SET_ENTRY, "team", "goal", b"back")
            self.assertEqual(ask(two, blackboard.REQ_GET_ENTRY, "team", "goal").data, b"back")
            # An answer overtakes data that are not sent yet, and those go with it: before the second one they are here.
            for client, board in zip(clients, boards):
                for _ in range(2):
                    ask(board, blackboard.REQ_GET_ENTRY, "team", "goal")
                client.deliver_pushed()
            self.assertEqual(heard, [[("map", "a", b"1"), ("map", "b", b"2")], [("team", "goal", b"right")], []])
            clients[0].close()
            ask(two, blackboard.REQ_SET_ENTRY, "map", "b", b"3")  # the subscriber has gone
            self.assertEqual(ask(two, blackboard.REQ_GET_ENTRY, "map", "b").data, b"3")
            for client in clients[1:]:
                client.close()

    def test_who_opened_a_blackboard_for_reading_subscribes_and_sets_nothing(self):
        with self.serve(ROOT / "worlds/board.cfg") as house, connect(f":{house.port()}") as client:
            board = client.device("blackboard", 0, Access.READ)
            entry = BlackboardEntry(c_string("key"), c_string("group"), 1, 2, b"value")
            for request in (blackboard.REQ_SUBSCRIBE_TO_KEY, blackboard.REQ_SUBSCRIBE_TO_GROUP,
                            blackboard.REQ_UNSUBSCRIBE_FROM_KEY, blackboard.REQ_UNSUBSCRIBE_FROM_GROUP):
                board.request(request, entry)
            with self.assertRaises(RequestRefused):
                board.request(blackboard.REQ_SET_ENTRY, entry)
            self.assertEqual(board.request(blackboard.REQ_GET_ENTRY, entry).data, b"")

    def test_the_health_of_the_machine_adds_up(self):
        for name in ("health", "statgrabdriver"):
            cfg = self.write("health.cfg", f'driver( name "{name}" provides ["health:0"] interval 0.1 )\n')
            with self.serve(cfg) as house, connect(f":{house.port()}", mode=Mode.PULL) as client:
                device = client.device("health", 0)
                self.assertEqual(device.driver, name)
                for _ in range(2):
                    device.next_data(30)
                    state = device.latest(health.DATA_STATE)
                    cpu = state.cpu_usage
                    self.assertAlmostEqual(cpu.idle + cpu.system + cpu.user, 100, 3)
                    self.assertGreaterEqual(min(cpu.idle, cpu.system, cpu.user), 0)
                    for memory in (state.mem, state.swap):
                        self.assertEqual(memory.used + memory.free, memory.total)
                    self.assertGreater(state.mem.used, 1 << 20)
                    self.assertGreater(state.mem.free, 0)

    def test_a_run_without_a_file_has_a_blackboard_and_the_health_of_its_machine(self):
        with self.run_house() as house, connect(f":{house.port()}", mode=Mode.PULL) as client:
            board, machine = client.device("blackboard"), client.device("health")
            self.assertEqual((board.driver, machine.driver), ("localbb", "health"))
            names = c_string("goal"), c_string("team")
            board.request(blackboard.REQ_SET_ENTRY, BlackboardEntry(*names, 1, 2, b"left"))
            self.assertEqual(board.request(blackboard.REQ_GET_ENTRY, BlackboardEntry(*names)).data, b"left")
            machine.next_data(30)
            cpu = machine.latest(health.DATA_STATE).cpu_usage
            self.assertAlmostEqual(cpu.idle + cpu.system + cpu.user, 100, 3)

    def serve(self, cfg) -> House:
        return House("serve", cfg, "--port", 0, "--headless")


if __name__ == "__main__":
    unittest.main()
