"""Sensors in space from outside: rings, light, inertia, places on the earth and attitudes, by the Python client."""

import json
import math
import sys
import tomllib
import unittest

from house import ROOT, House, HouseTest, finish

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Mode, RequestRefused, connect  # noqa: E402
from playhouse_client.generated import imu, ir, rfid, sonar  # noqa: E402

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


# A robot that drives through a hall with tagged boxes, and has two infrared sensors.
HALL = """
interval_sim 20
define box model( size [0.2 0.2 0.2] obstacle_return 0 ranger_return -1 )
box( name "left" pose [1 2 0 0] rfid_tag "E200 3412 0123" rfid_type 6 )
box( name "right" pose [5 -2 0 0] rfid_tag "0a" )
model( name "wall" pose [0.65 -1.5 0 0] size [0.1 1 1] )
position( name "r0" size [0.4 0.4 0.2] localization "gps" update_interval 20
  rfid( name "reader" pose [0 0 -0.2 0] size [0.1 0.1 0.2] range_max 2.5 update_interval 20 )
  ranger( name "ring" pose [0 0 -0.1 0] size [0.1 0.1 0.1] update_interval 20
    sensor( pose [0 -0.1 0 -90] range [0.1 5] fov 5 ) sensor( pose [0.2 0 0 0] range [0.1 0.8] fov 5 ) ) )
"""
HALL_CFG = """
driver ( name "stage" provides ["simulation:0"] worldfile "test.world" )
driver ( name "stage" provides ["position2d:0" "rfid:0" "ir:0" "sonar:0"] model "r0" )
"""


class TagsAndInfrared(HouseTest):
    def test_a_client_reads_tags_where_they_are_and_voltages_of_ranges_in_both_engines(self) -> None:
        self.world(HALL)
        for engine in ("stage", "arena"):
            with self.subTest(engine), \
                    House("serve", self.write("test.cfg", HALL_CFG), "--port", 0, "--headless", "--engine", engine,
                          "--lock-step", "reader") as house, \
                    connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
                world, base = client.simulation(0), client.position2d(0)
                reader, infrared = client.device("rfid"), client.device("ir")
                world.join("reader")
                base.drive(1.0, 0.0)
                passed: set[tuple[str, ...]] = set()
                for _ in range(300):  # 6 s: 6 m
                    world.step(1)
                    x = world.pose("r0").x
                    self.check_tags(reader.latest(rfid.DATA_TAGS).tags, x, passed)
                self.assertEqual(passed, {("left",), (), ("right",)})
                self.check_infrared(world, infrared, client.device("sonar"))
                self.check_requests(world, reader, infrared)

    def check_tags(self, tags, x: float, passed: set) -> None:
        """Within 2.5 m in space; the middles are at one height, and both boxes 2 m aside."""
        for name, at, tag in (("left", 1, rfid.Tag(6, b"\xe2\x00\x34\x12\x01\x23")), ("right", 5, rfid.Tag(0, b"\x0a"))):
            distance = math.hypot(at - x, 2)
            if abs(distance - 2.5) > 0.01:
                self.assertEqual(tag in tags, distance < 2.5, (name, x))
        passed.add(tuple(name for name, kind in (("left", 6), ("right", 0)) if any(tag.type == kind for tag in tags)))

    def check_infrared(self, world, infrared, ring) -> None:
        world.set_pose("r0", 0.65, 0, 0)
        world.step(2)
        data = infrared.latest(ir.DATA_RANGES)
        for measured, true in zip(data.ranges, (0.9, 0.8)):  # the wall's near face is at y -1; ahead is nothing
            self.assertAlmostEqual(measured, true, places=3)
        for volts, metres in zip(data.voltages, data.ranges):
            self.assertAlmostEqual(volts, 5 / 1024 * (6787 / (100 * metres + 4) + 3), places=5)
        self.assertEqual(infrared.request(ir.REQ_POSE).poses, ring.request(sonar.REQ_GET_GEOM).poses)

    def check_requests(self, world, reader, infrared) -> None:
        world.set_pose("r0", 1, 0, 0)
        world.step(2)
        reader.request(rfid.REQ_READTAG)
        for message in (rfid.REQ_WRITETAG, rfid.REQ_LOCKTAG):
            with self.assertRaises(RequestRefused):
                reader.request(message)
        reader.request(rfid.REQ_POWER)
        self.assertIs(reader.get_property("power", bool), False)
        with self.assertRaises(RequestRefused):
            reader.request(rfid.REQ_READTAG)
        reader.set_property("power", True)
        infrared.request(ir.REQ_POWER, ir.PowerReq(0))
        self.assertIs(infrared.get_property("power", bool), False)


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
