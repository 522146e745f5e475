"""Sensors in space from outside: rings, light, inertia, places on the earth and attitudes, by the Python client."""

import json
import math
import sys
import tomllib
import unittest

from house import ROOT, HouseTest, finish

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Mode, RequestRefused, connect  # noqa: E402
from playhouse_client.generated import imu  # noqa: E402

ROOM = """
interval_sim 20
latitude 50.7747
longitude 6.0839
altitude 220
model( name "white" pose [5 0 0 0] size [0.2 6 3] material "paper" )
model( name "black" pose [-5 0 0 0] size [0.2 6 3] material "rubber" )
position( name "r0" pose [0 0 0 0] size [0.4 0.4 0.3] update_interval 20
  ranger( size [0.1 0.1 0.1] update_interval 20
    sensor( samples 5 fov 360 range [0.1 20] rings 5 ring_fov [-20 20] error "lidar" range_dark 6 ) )
  imu( update_interval 20 ) gps( update_interval 100 noise [0.5 0.5] ) )
"""


WORDS = {"ranger": "sensor()"}  # without which a kind measures nothing


def sensors_of_kinds() -> dict[str, tuple[str, int]]:
    """The device of each kind of sensor on a robot that carries one of each: (interface, index), of the interface that stands first."""
    found: dict[str, tuple[str, int]] = {}
    for path in sorted((ROOT / "kinds").glob("*.toml")):
        kind = tomllib.loads(path.read_text(encoding="utf-8"))
        if kind["name"] != "custom" and any(each["name"] == "measured_tick" for each in kind.get("column", [])):
            interface = kind["interface"][0]["name"]
            found[kind["name"]] = interface, sum(name == interface for name, _ in found.values())
    return found


class Sensors(HouseTest):
    def test_every_kind_of_sensor_is_read_in_both_engines(self) -> None:
        kinds = sensors_of_kinds()
        self.assertGreaterEqual(len(kinds), 10)
        world = self.world("interval_sim 20\nposition( " + " ".join(f"{kind}( {WORDS.get(kind, '')} )" for kind in kinds) + " )")
        for engine in ("stage", "arena"):
            with self.run_house("--speed", 5, "--engine", engine, world=world) as house:
                for kind, (interface, index) in kinds.items():
                    done = finish("watch", f":{house.port()}", f"{interface}:{index}", "--count", 1)
                    self.assertEqual(done.returncode, 0, f"{engine}, {kind}: {done.stderr}")
                    self.assertTrue(json.loads(done.stdout.splitlines()[0]), f"{engine}, {kind}")

    def test_a_lidar_of_several_rings_sees_white_and_no_black(self) -> None:
        with self.run_house("--speed", 5, "--engine", "arena", world=self.world(ROOM)) as house, \
                connect(f":{house.port()}") as client:
            points = next(client.pointcloud3d(0).updates(10))
            ahead = [point for point in points if point.x > 4 and abs(point.y) < 0.01]
            self.assertGreaterEqual(len(ahead), 3, points)
            for point in ahead:
                self.assertAlmostEqual(point.x, 4.9, delta=0.01)
                self.assertGreater(point.color[0], 80)
            self.assertFalse([point for point in points if point.x < -3])
            scan = next(client.laser(0).updates(10))
            self.assertAlmostEqual(scan.ranges[2], 4.9, delta=0.01)
            self.assertEqual([round(each) for each in (scan.ranges[0], scan.ranges[4])], [20, 20], "behind it is black")

    def test_with_the_stage_engine_a_line_says_that_there_is_one_level_ring(self) -> None:
        with self.run_house("--speed", 5, world=self.world(ROOM)) as house, connect(f":{house.port()}") as client:
            points = next(client.pointcloud3d(0).updates(10))
            self.assertEqual(len(points), 3)
            self.assertEqual(len({round(point.z, 6) for point in points}), 1)
        self.assertRegex(house.log(), r"error, material, rings have their full effect with --engine arena only")

    def test_an_imu_and_a_gps_follow_a_robot_in_both_engines(self) -> None:
        for engine in ("stage", "arena"):
            with self.subTest(engine), self.run_house("--speed", 2, "--engine", engine, world=self.world(ROOM)) as house, \
                    connect(f":{house.port()}") as client:
                base, unit, receiver = client.position3d(0), client.imu(0), client.gps(0)
                unit.send(imu.DATA_EULER)
                base.drive(0.4, 1.0)
                while base.state.pose.yaw < 1 if base.has_data else True:
                    base.next_data(10)
                turning = self.newest(client, unit)
                self.assertAlmostEqual(turning.turn_rate[2], 1.0, delta=0.1)
                self.assertAlmostEqual(turning.acceleration[1], 0.4, delta=0.1)
                self.assertAlmostEqual(turning.acceleration[2], 9.81, delta=0.1)
                receiver.next_data(10)
                fix = receiver.fix
                self.assertEqual(fix.quality, 1)
                self.assertAlmostEqual(fix.latitude, 50.7747, delta=1e-4)
                self.assertAlmostEqual(fix.longitude, 6.0839, delta=1e-4)
                self.assertAlmostEqual(fix.altitude, 220, delta=5)
                unit.reset_orientation()
                base.stop()
                self.assertLess(abs(unit.attitude[0]) + abs(unit.attitude[1]), 0.05)
                with self.assertRaises(RequestRefused):
                    unit.request(imu.REQ_SET_DATATYPE, imu.DatatypeConfig(9))

    @staticmethod
    def newest(client, unit):
        for _ in range(20):
            unit.next_data(10)
        return unit.inertia

    def test_playhouse_watch_tells_a_fix(self) -> None:
        with self.run_house("--speed", 5, world=self.world(ROOM)) as house:
            done = finish("watch", f":{house.port()}", "gps:0", "--count", 1)
            self.assertIn('"latitude":5077', done.stdout)

    def test_words_that_make_no_sense_have_a_line_each(self) -> None:
        for words, wanted in (("latitude 91", '"latitude" needs -90 to 90 degrees'),
                              ("model( ranger( sensor( rings 16 ring_fov [10 -10] ) ) )", '"ring_fov" needs the lowest ring'),
                              ("model( ranger( sensor( samples 65536 rings 2 ) ) )", '"rings" needs at most 65536 beams'),
                              ("model( imu( gyro_noise [-1 0] ) )", '"gyro_noise"'),
                              ('model( ranger( sensor( error "lidr" ) ) )', "lidar")):
            done = finish("check", self.world(words))
            self.assertNotEqual(done.returncode, 0, words)
            self.assertIn(wanted, done.stdout + done.stderr, words)

    def test_the_world_that_comes_with_it_shows_what_it_says(self) -> None:
        with self.run_house("--lock-step", "reader", "--engine", "arena",
                            world=ROOT / "worlds" / "outdoor.world") as house, \
                connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
            world, robot = client.simulation(0), client.robot("r0")
            cloud, receiver, unit = robot.pointcloud3d, robot.gps, robot.imu
            world.join("reader")
            world.step(300)  # 3 s
            points = cloud.points
            self.assertGreater(len(points), 2000)
            self.assertGreater(max(math.dist(point[:3], (0, 0, 0)) for point in points), 6)
            self.assertAlmostEqual(receiver.fix.latitude, 50.7747, delta=1e-3)
            believed, true = unit.pose, world.pose("r0")
            self.assertGreater(math.dist((true.x, true.y), (-2, 0)), 0.3)
            self.assertLess(math.dist((believed.x, believed.y), (true.x, true.y)), 0.4)


if __name__ == "__main__":
    unittest.main()
