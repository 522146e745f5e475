"""Recordings as programs for ROS 2 use them: odometry, frames and sensors, against closed forms; and, where the package
rosbags is installed (pip install rosbags), as it reads them by its own definitions of the messages."""

import csv
import math
import struct
import sys
import unittest

from house import PATIENCE, ROOT, House, HouseTest, finish

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import RunEnded, connect  # noqa: E402

try:
    from rosbags.highlevel import AnyReader
    from rosbags.typesys import Stores, get_typestore
except ImportError:
    AnyReader = None

LATITUDE, LONGITUDE, ALTITUDE = 47.0, 8.0, 400.0
WORLD = f"""
interval_sim 100
latitude {LATITUDE} longitude {LONGITUDE} altitude {ALTITUDE}
model( name "near" pose [12 2 0 0] size [0.2 3 4] )
model( name "far" pose [81 0 0 0] size [0.2 200 40] )
position( name "a" pose [1 -8 0 0] size [0.4 0.4 0.2] localization "odom" odom_error [0.1 0.1 0 0.1] velocity [0.2 0 0 5] alwayson 1
  camera( name "cam" pose [0.1 0 0.2 90] size [0.1 0.1 0.1] resolution [64 48] fov [60 45] )
  imu( name "imu" pose [0.1 0 0.2 30] ) )
position( name "b" pose [2 2 0 0] size [0.4 0.4 0.2]
  camera( name "deep" pose [0 0 0.2 0] resolution [41 3] fov [90 20] range [0.2 200] image "depth" )
  camera( name "narrow" pose [0 0 0.2 0] resolution [21 21] fov [60 60] range [0.2 20] )
  gps( name "gps" pose [0.1 0 0.2 0] noise [0 0] ) )
"""


class Transform:
    """A pose: its position, and its orientation x, y, z, w."""

    def __init__(self, row: dict, place: str, turn: str):
        self.p = [float(row[place + axis]) for axis in "xyz"]
        self.q = [float(row[turn + axis]) for axis in "xyzw"]

    def turned(self, v) -> list[float]:
        x, y, z, w = self.q
        t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
        return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]]

    def applied(self, point) -> list[float]:
        return [a + b for a, b in zip(self.turned(point), self.p)]


class RecordingTest(HouseTest):
    def setUp(self):
        super().setUp()
        self.file = self.folder / "run.mcap"

    def record(self, world: str, *arguments):
        done = finish("run", self.write("test.world", world), "--port", 0, "--headless", "--fast", "--record", self.file, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.export()

    def export(self):
        exported = finish("export", self.file, "--csv")
        self.assertEqual(exported.returncode, 0, exported.stderr)

    def table(self, name: str) -> list[dict]:
        with open(self.folder / "run" / f"{name}.csv", newline="") as file:
            return list(csv.DictReader(file))

    def transforms(self) -> dict[str, tuple[str, dict[float, Transform]]]:
        """By child: its parent, and where it was when."""
        found = {}
        for row in self.table("tf"):
            parent, moves = found.setdefault(row["transforms.child_frame_id"], (row["transforms.header.frame_id"], {}))
            self.assertEqual(parent, row["transforms.header.frame_id"], "one parent")
            moves[float(row["time"])] = Transform(row, "transforms.transform.translation.", "transforms.transform.rotation.")
        return found

    def at(self, moves: dict, time: float) -> Transform:
        return moves[max(t for t in moves if t <= time)]

    def assert_near(self, seen, wanted, places=9):
        for a, b in zip(seen, wanted, strict=True):
            self.assertAlmostEqual(a, b, places=places, msg=f"{seen} {wanted}")


class RosRecording(RecordingTest):
    def test_frames_are_a_tree_with_the_truth_and_what_a_robot_believes(self):
        self.record(WORLD, "--duration", 10)
        frames = self.transforms()
        for frame in frames:
            for _ in range(len(frames)):
                frame = frames[frame][0] if frame in frames else frame
            self.assertEqual(frame, "world")
        for robot in "ab":
            rows = self.table(f"{robot}.odom")
            self.assertEqual(len(rows), 100)
            for row in rows:
                self.assertEqual((row["header.frame_id"], row["child_frame_id"]), (f"{robot}/odom", robot))
                believed = Transform(row, "pose.pose.position.", "pose.pose.orientation.")
                time = float(row["time"])
                origin, truth = self.at(frames[f"{robot}/odom"][1], time), self.at(frames[robot][1], time)
                for point in ((0, 0, 0), (1, 0, 0), (0, 1, 0)):
                    self.assert_near(origin.applied(believed.applied(point)), truth.applied(point))
        last = self.table("a.odom")[-1]
        self.assert_near([float(last["twist.twist.linear.x"]), float(last["twist.twist.angular.z"])], [0.2, math.radians(5)])
        heading = float(last["pose.pose.orientation.heading"])
        self.assertAlmostEqual(abs(heading - math.radians(50)), math.radians(5), places=6, msg="a tenth of its turn")

    def test_sensors_have_frames_of_their_own(self):
        self.record(WORLD, "--duration", 2)
        frames = self.transforms()
        parent, moves = frames["a/cam_optical"]
        lens = next(iter(moves.values()))
        self.assertEqual(parent, "a")
        self.assert_near(lens.p, (0.1, 0, frames["a/imu"][1][0.0].p[2] + 0.05))
        # The camera looks to the robot's left.
        self.assert_near(lens.turned((0, 0, 1)), (0, 1, 0))
        self.assert_near(lens.turned((1, 0, 0)), (1, 0, 0))
        self.assert_near(lens.turned((0, 1, 0)), (0, 0, -1))
        for topic, frame in (("a.cam.camera_info", "a/cam_optical"), ("a.imu.data", "a/imu"), ("b.gps.fix", "b/gps")):
            self.assertEqual({row["header.frame_id"] for row in self.table(topic)}, {frame})
            self.assertIn(frame, frames)
        self.assertAlmostEqual(math.atan2(*frames["a/imu"][1][0.0].q[2:]) * 2, math.radians(30))

    def test_cameras_have_their_intrinsics(self):
        self.record(WORLD, "--duration", 1)
        info = self.table("a.cam.camera_info")[-1]
        fx, fy = 32 / math.tan(math.radians(30)), 24 / math.tan(math.radians(22.5))
        self.assertEqual((info["width"], info["height"], info["distortion_model"]), ("64", "48", "plumb_bob"))
        self.assert_near([float(info[f"k.{i}"]) for i in range(9)], [fx, 0, 31.5, 0, fy, 23.5, 0, 0, 1])
        self.assert_near([float(info[f"p.{i}"]) for i in range(12)], [fx, 0, 31.5, 0, 0, fy, 23.5, 0, 0, 0, 1, 0])
        self.assertEqual({float(info[f"d.{i}"]) for i in range(5)}, {0})

    def test_imu_and_gps_measure_what_a_robot_for_ros_expects(self):
        self.record(WORLD, "--duration", 5)
        data = self.table("a.imu.data")
        self.assertEqual(len(data), 50)
        value = lambda name: float(data[-1][name])
        self.assertAlmostEqual(value("linear_acceleration.z"), 9.80665, places=2)
        self.assertAlmostEqual(value("angular_velocity.z"), math.radians(5), places=6)
        self.assertAlmostEqual(value("orientation.heading"), math.radians(30 + 5 * 5), delta=math.radians(1))
        fix = self.table("b.gps.fix")[-1]
        self.assertEqual((fix["status.status"], fix["position_covariance_type"]), ("0", "2"))
        s, squared = math.sin(math.radians(LATITUDE)), 0.0066943799901413165   # of the eccentricity of WGS84
        across = 6378137 / math.sqrt(1 - squared * s * s)
        along = across * (1 - squared) / (1 - squared * s * s)
        north, east = math.degrees(2 / (along + ALTITUDE)), math.degrees(2.1 / ((across + ALTITUDE) * math.cos(math.radians(LATITUDE))))
        self.assertAlmostEqual(float(fix["latitude"]), LATITUDE + north, places=9)
        self.assertAlmostEqual(float(fix["longitude"]), LONGITUDE + east, places=9)
        self.assertAlmostEqual(float(fix["altitude"]), ALTITUDE, delta=1)

    def test_what_models_say_is_a_table(self):
        world = self.write("test.world", 'interval_sim 100 position( name "r" say "good morning" )')
        with House("run", world, "--port", 0, "--headless", "--lock-step", "--duration", 3, "--record", self.file) as house, \
                connect(f":{house.port()}", timeout=PATIENCE) as client:
            simulator, voice = client.simulation(0), client.speech(0)
            simulator.step(5)
            voice.say("on my way, \"now\"")
            simulator.step(5)
            voice.say("")
            with self.assertRaises(RunEnded):
                while True:
                    simulator.step()
            self.assertEqual(house.wait(), 0, house.log())
        self.export()
        said = [(row["model"], row["text"]) for row in self.table("playhouse.speech")]
        self.assertEqual(said, [("r", "good morning"), ("r", 'on my way, "now"'), ("r", "")])
        times = [float(row["time"]) for row in self.table("playhouse.speech")]
        self.assertEqual(times[0], 0)
        self.assertTrue(0.5 <= times[1] <= 0.7 and times[1] + 0.4 <= times[2] <= 1.2, times)

    def test_speech_and_odometry_can_be_chosen_and_left_out(self):
        topics = lambda: {path.name for path in (self.folder / "run").iterdir()}
        self.record(WORLD + 'model( name "voice" say "hello" )', "--duration", 1, "--record-only", "speech,position@a")
        self.assertTrue({"playhouse.speech.csv", "a.odom.csv", "a.position.csv"} <= topics())
        self.assertFalse({"b.odom.csv", "a.imu.data.csv", "a.cam.camera_info.csv"} & topics())
        self.assertNotIn("b/odom", self.transforms())


@unittest.skipIf(AnyReader is None, "the package rosbags is not installed")
class ByRosbags(RecordingTest):
    """What a reader makes of a recording that knows nothing of Playhouse."""

    def messages(self, *topics) -> dict[str, list]:
        store = get_typestore(Stores.ROS2_HUMBLE)
        found = {topic: [] for topic in topics}
        with AnyReader([self.file]) as reader:
            for connection, _, raw in reader.messages():
                if connection.topic in found:
                    found[connection.topic].append(store.deserialize_cdr(raw, connection.msgtype))
        return found

    def test_every_message_of_ros_is_one_by_its_own_definition(self):
        self.record(WORLD, "--duration", 2)
        store = get_typestore(Stores.ROS2_HUMBLE)
        types = set()
        with AnyReader([self.file]) as reader:
            for connection, _, raw in reader.messages():
                if connection.msgtype.startswith("playhouse/"):
                    continue
                message = store.deserialize_cdr(raw, connection.msgtype)
                self.assertEqual(bytes(store.serialize_cdr(message, connection.msgtype)), bytes(raw), connection.topic)
                types.add(connection.msgtype.split("/")[-1])
        self.assertEqual(types, {"TFMessage", "Image", "CameraInfo", "Imu", "NavSatFix", "Odometry"})

    def test_depths_beyond_16_bits_are_none(self):
        self.record(WORLD, "--duration", 1)
        image = self.messages("/b/deep/image")["/b/deep/image"][-1]
        self.assertEqual((image.encoding, image.width, image.height), ("16UC1", 41, 3))
        row = struct.unpack("<41H", bytes(image.data[82:164]))
        self.assertEqual(row[20], 9900)
        self.assertEqual(row[0], 0)
        self.assertEqual(set(row) - {0}, {9900})

    def test_an_edge_is_in_the_pixel_that_its_intrinsics_say(self):
        self.record(WORLD, "--duration", 1)
        found = self.messages("/b/narrow/image", "/b/narrow/camera_info")
        image, info = found["/b/narrow/image"][-1], found["/b/narrow/camera_info"][-1]
        row = bytes(image.data[10 * 63:11 * 63])
        seen = [row[3 * k:3 * k + 3] != row[:3] for k in range(21)]
        # The wall 9.9 m ahead reaches 1.5 m to either side.
        inside = lambda k: bool(abs((k - info.k[2]) / info.k[0]) * 9.9 < 1.5)
        self.assertEqual(seen, [inside(k) for k in range(21)])


if __name__ == "__main__":
    unittest.main()
