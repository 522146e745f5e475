"""Cameras from outside: pictures and their directions, by the Python client."""

import math
import sys
import unittest

from house import ROOT, HouseTest

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import connect  # noqa: E402

WORLD = """
interval_sim 100
model( name "red" pose [3 0 0 0] size [0.5 0.5 2] color "red" )
model( name "blue" pose [0 3 0 0] size [0.5 0.5 2] color "blue" )
position( name "r0" size [0.3 0.3 0.2]
  camera( name "eye" resolution [21 15] fov [60 45] )
  camera( name "file" resolution [64 48] compression "jpeg" )
  camera( name "far" resolution [5 3] image "depth" ) )
"""


class Cameras(HouseTest):
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
