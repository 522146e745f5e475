"""Cameras from outside: pictures and their directions, by the Python client."""

import math
import struct
import sys
import unittest

from house import ROOT, HouseTest

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Mode, RequestRefused, connect  # noqa: E402
from playhouse_client.generated import camera, stereo  # noqa: E402

WORLD = """
interval_sim 100
model( name "red" pose [3 0 0 0] size [0.5 0.5 2] color "red" )
model( name "blue" pose [0 3 0 0] size [0.5 0.5 2] color "blue" )
position( name "r0" size [0.3 0.3 0.2]
  camera( name "eye" resolution [21 15] fov [60 45] )
  camera( name "file" resolution [64 48] compression "jpeg" )
  camera( name "far" resolution [5 3] image "depth" ) )
"""

# 40 pixels of focal length; the wall is 2 m before the lenses, and seen 4 pixels apart.
PAIR = """
interval_sim 100
model( name "wall" pose [2.5 0 0 0] size [1 0.8 2] color "red" )
position( name "r0" size [0.2 0.2 0.2] obstacle_return 0
  camera( name "one" resolution [80 60] )
  camera( name "pair" resolution [80 60] fov [90 73.7397952917] range [0.1 4] baseline 0.2 ) )
"""


class Cameras(HouseTest):
    def test_a_camera_with_two_lenses_tells_pairs_and_how_far_everything_is(self) -> None:
        world = self.world(PAIR)
        for engine in ("stage", "arena"):
            with self.subTest(engine), self.run_house("--speed", 10, "--engine", engine, world=world) as house, \
                    connect(f":{house.port()}", mode=Mode.PULL) as client:
                self.assertEqual([each.name for each in client.devices() if each.interface == "stereo"], ["stereo:0"])
                pair = client.device("stereo")
                with self.assertRaises(RequestRefused):
                    pair.request(camera.REQ_GET_IMAGE)
                self.assertAlmostEqual(pair.get_property("baseline", float), 0.2)
                pair.next_data(30)
                seen = pair.latest(stereo.DATA_STATE)
                left, right, far = seen.left_channel, seen.right_channel, seen.disparity
                for image in (left, right, far):
                    self.assertEqual((image.width, image.height, image.compression), (80, 60, camera.COMPRESS_RAW))
                self.assertEqual((far.format, far.fdiv), (camera.FORMAT_MONO16, 16))
                row = 30 * 80
                is_red = [[image.image[3 * (row + x)] > 2 * image.image[3 * (row + x) + 1] for x in range(80)] for image in (left, right)]
                self.assertEqual(sum(is_red[0]), 16, "0.8 m of 20 pixels each")
                self.assertEqual(is_red[0][4:], is_red[1][:-4])
                disparity = struct.unpack("<4800H", bytes(far.image))
                self.assertAlmostEqual(disparity[row + 40] / far.fdiv, 40 * 0.2 / 2, delta=1 / 16)
                points = [point for point in seen.points if point.red > 2 * point.green]
                self.assertGreater(len(points), 200)
                for point in points:
                    self.assertAlmostEqual(point.px, 2, delta=0.01)
                    self.assertLess(abs(point.py), 0.41)

    def test_a_camera_shows_what_is_before_it_and_turns_to_what_is_beside(self) -> None:
        with self.run_house("--speed", 10, world=self.world(WORLD)) as house, connect(f":{house.port()}") as client:
            eye, mount = client.camera(0), client.ptz(0)
            picture = next(eye.updates(10))
            self.assertEqual((picture.width, picture.height, picture.is_jpeg), (21, 15, False))
            self.assertEqual(picture.pixel(10, 7), (255, 0, 0))
            self.assertNotEqual(picture.pixel(0, 7), (255, 0, 0))
            mount.look(math.radians(90))
            for view in mount.updates(10):
                if abs(view.pan - math.radians(90)) < 1e-6 and view.pan_speed == 0:
                    break
            for picture in eye.updates(10):
                if picture.pixel(10, 7) == (0, 0, 255):
                    break
            mount.set_velocity_control(True)
            mount.turn(-1.0)
            for view in mount.updates(10):
                if view.pan < math.radians(-99):
                    break

    def test_pictures_are_jpeg_files_or_distances_if_the_world_says_so(self) -> None:
        with self.run_house("--speed", 10, world=self.world(WORLD)) as house, connect(f":{house.port()}") as client:
            self.assertEqual(next(client.camera(1).updates(10)).data[:2], b"\xff\xd8")
            self.assertEqual(next(client.camera(2).updates(10)).pixel(2, 1), (2750,))


if __name__ == "__main__":
    unittest.main()
