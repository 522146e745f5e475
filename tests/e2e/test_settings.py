"""What clients set of simulated devices: the next one reads it back, and data show it."""

import json
import math
import sys
import unittest

from house import ROOT, House, HouseTest, finish

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Mode, RequestRefused, connect  # noqa: E402
from playhouse_client.generated import actarray, blobfinder, camera, laser, position2d, ranger, wifi  # noqa: E402
from playhouse_client.generated import map as maps  # noqa: E402

WORLD = """
interval_sim 100
model( name "wall" pose [3 0 0 0] size [0.2 10 1] color "red" map_resolution 0.5 fiducial_return 9 )
wifi( name "post" pose [5 5 0 0] mac "08:00:20:00:00:01" )
position( name "r0" size [0.4 0.4 0.2] localization "odom" odom_error [0 0 0 0]
  ranger( pose [0 0 0 0] size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 181 ) )
  fiducial( range_max 8 fov 180 )
  blobfinder( range 8 )
  camera( resolution [4 2] )
  wifi( power 30 ) )
actuator( name "lift" pose [0 -5 0 0] max_position 3 max_speed 1 )
"""
DEGREE = math.pi / 180


class Settings(HouseTest):
    def setUp(self):
        super().setUp()
        house = self.run_house("--speed", 20, world=self.world(WORLD))
        self.addCleanup(house.__exit__)
        self.port = house.port()

    def client(self):
        return self.enterContext(connect(f":{self.port}", mode=Mode.PUSH, timeout=20))

    def data_until(self, device, message, fits):
        """The first data of that message that fit."""
        while True:
            value = device.latest(message)
            if value is not None and fits(value):
                return value
            device.next_data()

    def test_a_laser_scans_as_it_is_set_and_other_clients_see_it(self):
        one = self.client().device("laser")
        wanted = laser.Config(-45 * DEGREE, 45 * DEGREE, 5 * DEGREE, 4, 0, 0, 5)
        now = one.request(laser.REQ_SET_CONFIG, wanted)
        self.assertEqual(one.request(laser.REQ_GET_CONFIG), now)
        self.assertAlmostEqual(now.resolution, 5 * DEGREE, places=5)
        self.assertEqual(now.max_range, 4)
        other = self.client().device("laser")
        scan = self.data_until(other, laser.DATA_SCAN, lambda scan: len(scan.ranges) == 19)
        self.assertEqual(scan.max_range, 4)
        self.assertAlmostEqual(scan.ranges[9], 2.9, places=5)
        self.assertEqual(max(scan.ranges), 4)
        self.assertEqual(scan.intensity, b"")
        for refused in (laser.Config(-2, 1, 0, 0, 0, 1, 0), laser.Config(-1, 1, 0.001, 0, 0, 1, 0), laser.Config(math.nan, 1, 0, 0, 0, 1, 0)):
            with self.assertRaises(RequestRefused):
                one.request(laser.REQ_SET_CONFIG, refused)
        self.assertEqual(other.request(laser.REQ_GET_CONFIG), now)
        self.assertEqual(other.get_property("max_range", float), 4)
        other.set_property("max_range", 8.0)
        self.data_until(one, laser.DATA_SCAN, lambda scan: max(scan.ranges) > 4)

    def test_the_configuration_that_libplayercs_test_sends_is_taken(self):
        device = self.client().device("laser")
        now = device.request(laser.REQ_SET_CONFIG, laser.Config(-math.pi / 2, math.pi / 2, 100, 0, 1, 1, 10))
        self.assertEqual(round(now.resolution / DEGREE * 100), 100)
        self.assertEqual(now.range_res, 1)

    def test_a_ranger_says_with_the_scan_how_it_was_made(self):
        one, other = self.client().device("ranger"), self.client().device("ranger")
        wanted = one.config
        wanted.min_angle, wanted.frequency = 0, 5
        one.set_config(wanted)
        self.assertEqual(one.config.frequency, 5)
        stamped = self.data_until(other, ranger.DATA_RANGESTAMPED, lambda _: True)
        self.assertEqual(stamped.config, one.config)
        self.assertEqual(len(stamped.data.ranges), 91)
        self.data_until(one, ranger.DATA_RANGE, lambda scan: len(scan.ranges) == 91)
        self.assertEqual(len(one.scan().ranges), 91)

    def test_what_finders_report_is_narrowed(self):
        client = self.client()
        finder = client.device("fiducial")
        for markers in finder.updates():
            if markers:
                break
        finder.set_field_of_view(0, 2, 1)
        self.assertEqual(finder.field_of_view().max_range, 2)
        for markers in finder.updates():
            if not markers:
                break
        blobs = client.device("blobfinder")
        self.data_until(blobs, blobfinder.DATA_BLOBS, lambda data: [blob.id for blob in data.blobs] == [0])
        blobs.request(blobfinder.REQ_SET_COLOR, blobfinder.ColorConfig(1, 200, 255, 0, 9, 0, 9))
        blobs.request(blobfinder.REQ_SET_COLOR, blobfinder.ColorConfig(0, 0, 9, 0, 9, 0, 9))
        self.assertEqual(blobs.request(blobfinder.REQ_GET_COLOR, blobfinder.ColorConfig(1)).rmin, 200)
        self.data_until(blobs, blobfinder.DATA_BLOBS, lambda data: [blob.id for blob in data.blobs] == [1])

    def test_radios_cameras_and_joints_keep_what_is_set(self):
        client = self.client()
        radio = client.device("wifi")
        self.data_until(radio, wifi.DATA_STATE, lambda state: len(state.links) == 1)
        radio.request(wifi.REQ_IWSPY_PING, wifi.IwspyAddrReq(b"08:00:20:00:00:01".ljust(32, b"\0")))
        radio.request(wifi.REQ_IWSPY_ADD, wifi.IwspyAddrReq(b"08:00:20:00:00:02".ljust(32, b"\0")))
        self.data_until(radio, wifi.DATA_STATE, lambda state: not state.links)
        eye = client.device("camera")
        eye.request(camera.REQ_SET_SOURCE, camera.Source(b"PAL\0", 0))
        self.assertEqual(eye.get_property("norm", str), "PAL")
        self.assertEqual(eye.get_property("source", int), 0)
        lift = client.device("actarray")
        lift.request(actarray.REQ_ACCEL, actarray.AccelConfig(0, 0.5))
        lift.command(actarray.CMD_POS, actarray.PositionCmd(0, 3))
        speeds = set()
        self.data_until(lift, actarray.DATA_STATE, lambda state: speeds.add(round(state.actuators[0].speed, 3)) or state.actuators[0].speed > 0.9)
        self.assertTrue(speeds - {0, 1.0}, "it is as fast as it can at once")

    def test_words_of_the_model_are_properties_that_nobody_sets(self):
        base = self.client().device("position2d")
        self.assertEqual(base.get_property("drive", str), "diff")
        self.assertEqual(base.get_property("name", str), "r0")
        base.set_property("speed_pid.kp", 0.5)
        self.assertEqual(base.get_property("speed_pid.kp", float), 0.5)
        for key in ("drive", "no such name"):
            with self.assertRaises(RequestRefused):
                base.set_property(key, "omni")
        with self.assertRaises(RequestRefused):
            base.get_property("drive", float)

    def test_what_was_set_ends_with_the_last_client(self):
        with connect(f":{self.port}", mode=Mode.PUSH, timeout=20) as client:
            client.device("laser").set_property("max_range", 2.0)
        device = self.client().device("laser")
        self.assertEqual(device.get_property("max_range", float), 8)


class Walls(HouseTest):
    def test_a_map_of_walls_is_lines(self):
        self.world(WORLD)
        config = self.write("map.cfg", """
driver( name "stage" provides ["simulation:0"] plugin "stageplugin" worldfile "test.world" )
driver( name "stage" provides ["map:0"] model "wall" )
""")
        house = self.enterContext(House("serve", config, "--port", 0, "--headless"))
        with connect(f":{house.port()}", timeout=20) as client:
            device = client.device("map")
            lines = device.request(maps.REQ_GET_VECTOR)
            info = device.request(maps.REQ_GET_INFO)
        self.assertEqual(len(lines.segments), 4)
        length = max(abs(line.y1 - line.y0) for line in lines.segments)
        self.assertEqual(length, 0.5 * (info.height - 2), "without the margin")


class SpeedProfile(HouseTest):
    """The one setting of a robot that the world computes with."""

    def run_one(self, *arguments, limit=None) -> dict:
        file = self.folder / "run.mcap"
        file.unlink(missing_ok=True)
        house = House("run", self.world(WORLD), "--port", 0, "--headless", "--json", "--speed", 5, "--record", file)
        self.addCleanup(house.__exit__)
        with connect(f":{house.port()}", mode=Mode.PUSH, timeout=20) as client:
            base = client.device("position2d")
            if limit is not None:
                base.request(position2d.REQ_SPEED_PROF, position2d.SpeedProfReq(limit, 0.5))
            base.go_to(2, 0, 0)
            top = 0
            for state in base.updates():
                top = max(top, state.velocity.x)
                if state.pose.x > 1.5:
                    break
        house.end()
        ended = finish("run", "--again", file, "--json")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        result, again = json.loads(house.output()), json.loads(ended.stdout)
        self.assertEqual(result["hash"], again["hash"])
        return top

    def test_a_robot_goes_to_its_goal_as_fast_as_it_is_told_and_its_run_again(self):
        self.assertAlmostEqual(self.run_one(), 0.4, places=6)
        self.assertAlmostEqual(self.run_one(limit=0.7), 0.7, places=6)


if __name__ == "__main__":
    unittest.main()
