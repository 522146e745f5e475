"""Runs that are recorded, and run again to the bit."""

import csv
import json
import math
import resource
import signal
import struct
import subprocess
import sys
import unittest

from house import (ACK, LASER, PATIENCE, POSITION2D, PROGRAM, ROOT, SIMULATION, WORLD, Client, House, HouseTest, finish,
                   text)
from viewer import Viewer

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Mode, RunEnded, connect  # noqa: E402

ROBOT = 1   # of the list of what can be added: the wall is the first


class Recording(HouseTest):
    def setUp(self):
        super().setUp()
        self.file = self.folder / "run.mcap"

    def start(self, *arguments) -> House:
        house = House("run", self.world(), "--port", 0, "--record", self.file, *arguments)
        self.addCleanup(house.__exit__)
        return house

    def client(self, house: House) -> Client:
        client = Client(house.port())
        self.addCleanup(client.close)
        return client

    def viewer(self, house: House) -> Viewer:
        viewer = Viewer(int(house.wait_for_line(r"^web page: http://127\.0\.0\.1:(\d+)/").group(1)))
        self.addCleanup(viewer.close)
        return viewer

    def again(self, *arguments) -> dict:
        ended = finish("run", "--again", self.file, "--json", *arguments)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return json.loads(ended.stdout)

    def assert_same(self, result: dict, other: dict):
        for key in ("sim_time", "ticks", "robots", "hash", "sensed_hash"):
            self.assertEqual(result[key], other[key], key)

    def test_a_run_that_a_client_drives_runs_again_to_the_bit(self):
        house = self.start("--headless", "--json", "--speed", 5)
        client = self.client(house)
        client.open(POSITION2D, 0)
        client.open(POSITION2D, 1)
        client.open(LASER, 0)
        client.open(SIMULATION, 0)
        for n in range(20):
            client.drive(0, 0.3, 0.1 * (n % 3))
            client.drive(1, 0.2 + 0.01 * n)
            client.next_data(LASER, 0)
        self.assertEqual(client.request(SIMULATION, 0, 2, text("r0") + struct.pack(">ddd", -1, 2, 0.5)).type, ACK)
        client.request(POSITION2D, 1, 6, b"")   # the odometry begins anew
        client.next_data(LASER, 0)
        client.close()   # the robots stop
        other = self.client(house)
        other.open(LASER, 1)
        for _ in range(10):
            other.next_data(LASER, 1)
        house.end()
        recorded = json.loads(house.output())
        self.assert_same(recorded, self.again())
        self.assert_same(recorded, self.again("--workers", 3))

    def test_a_run_that_a_page_changes_runs_again_to_the_bit(self):
        house = self.start("--web", 0, "--json", "--speed", 5)
        viewer, client = self.viewer(house), self.client(house)
        viewer.send(do="add", robot=ROBOT, x=-2, y=4, a=0)
        viewer.turn_until(lambda: viewer.came)
        client.open(POSITION2D, 2)
        client.open(LASER, 2)
        client.drive(2, 0.4, 0.2)
        for _ in range(5):
            client.next_data(LASER, 2)
        viewer.send(do="select", model=viewer.came[0])
        viewer.send(do="drag", model=viewer.came[0], x=-1.5, y=3, a=1)
        viewer.send(do="drive", model=viewer.tops()[1], forward=0.3, sideways=0, turn=0.1)
        for _ in range(10):
            client.next_data(LASER, 2)
        viewer.send(do="rewind", tick=0)
        client.open(LASER, 0)
        for _ in range(10):
            client.next_data(LASER, 0)
        viewer.send(do="add", robot=ROBOT, x=-2, y=-4, a=0)
        viewer.turn_until(lambda: len(viewer.came) > 1)
        viewer.send(do="remove", model=viewer.tops()[1])
        for _ in range(5):
            viewer.turn()
        house.end()
        self.assertEqual(viewer.notices, [])
        self.assert_same(json.loads(house.output()), self.again())

    def test_controllers_and_batteries_run_again_to_the_bit(self):
        world = self.world("""
interval_sim 100
define scanner ranger( sensor( range [0 8] fov 180 samples 31 ) )
define robot position( size [0.4 0.4 0.2] joules 5000 ctrl "wander" scanner( pose [0 0 0 0] ) )
model( name "wall" pose [3 0 0 0] size [0.2 10 1] )
robot( name "r0" pose [0 0 0 0] )
""")
        house = House("run", world, "--port", 0, "--web", 0, "--record", self.file, "--json", "--speed", 5)
        self.addCleanup(house.__exit__)
        viewer = self.viewer(house)
        for n in range(3):
            viewer.send(do="add", robot=1, x=-2, y=2 * n - 2, a=0)
            viewer.turn_until(lambda: len(viewer.came) > n)
            for _ in range(5):
                viewer.turn()
        viewer.send(do="remove", model=viewer.came[0])
        viewer.turn_until(lambda: viewer.came[0] not in viewer.models)
        house.end()
        self.assertEqual(viewer.notices, [])
        self.assert_same(json.loads(house.output()), self.again())

    def test_a_run_in_lock_step_that_begins_again_with_another_seed_runs_again_to_the_bit(self):
        noisy = WORLD.replace("samples 181", "samples 31 noise [0.01 0.01 0]")
        house = House("run", self.world(noisy), "--port", 0, "--headless", "--lock-step", "--record", self.file, "--json",
                      "--duration", 8)
        self.addCleanup(house.__exit__)
        with connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
            world, base, laser = client.simulation(0), client.position2d(0), client.laser(0)
            world.join("only")
            for seed in (5, 6):
                for tick in range(30):
                    base.drive(0.3, 0.1 * (tick % 3))
                    if tick == 10:
                        world.spawn("r1", -4.0, -4.0, 0.0)
                    world.step()
                self.assertGreater(min(laser.ranges), 0)
                world.reset(seed)
            try:
                while True:
                    world.step()
            except RunEnded:
                pass
        self.assertEqual(house.wait(), 0, house.log())
        self.assert_same(json.loads(house.output()), self.again())

    def test_changes_are_listed_by_name_as_they_were_asked_for(self):
        house = House("run", self.world(), "--port", 0, "--headless", "--lock-step", "--record", self.file, "--record-only", "poses")
        self.addCleanup(house.__exit__)
        with connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
            world, base = client.simulation(0), client.position2d(0)
            world.join("only")
            for tick in range(4):
                base.drive(0.25 * tick, 0.5)
                if tick == 2:
                    name = world.spawn("r1", -4.0, -4.0, 0.25, 'a "b", c')
                    world.set_pose(name, -3.0, -4.0, 1.0)
                world.step()
            world.reset(7)
            world.remove("r1")
            world.step()
        house.end()
        ended = finish("export", self.file, "--changes")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        rows = [(int(row["tick"]), row["change"], row["model"], json.loads(row["fields"])) for row in csv.DictReader(ended.stdout.splitlines())]
        self.assertEqual([row for row in rows if row[1] == "drive"],
                         [(tick, "drive", "r0", {"velocity": [0.25 * tick, 0, 0, 0.5]}) for tick in range(4)]
                         + [(1, "drive", "r0", {"velocity": [0, 0, 0, 0]})])   # the client lets it stand, and leaves
        done = [row for row in rows if row[1] not in ("drive", "subscribe", "unsubscribe", "watch", "unwatch", "power_wheels")]
        self.assertEqual([row[:3] for row in done], [(2, "spawn_copy", ""), (2, "place", "a_b_c"), (4, "load", ""), (0, "despawn", "")])
        self.assertEqual(done[0][3] | {"of": 0}, {"of": 0, "X_WM": [-4, -4, 0, 0.25], "name": 'a "b", c', "first_id": 0})
        self.assertEqual(done[1][3], {"X_PM": [-3, -4, 0, 1]})
        self.assertEqual(done[2][3]["seed"], 7)
        for command in (("export", self.file, "--changes", "--csv"), ("export", self.file, "--changes", "-o", self.folder / "t")):
            self.assertEqual(finish(*command).returncode, 2)

    def test_what_a_configuration_file_serves_is_recorded_too(self):
        self.world()
        cfg = self.write("test.cfg", 'driver( name "stage" provides ["simulation:0"] worldfile "test.world" )\n'
                                     'driver( name "stage" provides ["position2d:0" "laser:0"] model "r0" )\n')
        house = House("serve", cfg, "--port", 0, "--headless", "--record", self.file, "--json", "--speed", 5)
        self.addCleanup(house.__exit__)
        client = self.client(house)
        client.open(POSITION2D, 0)
        client.drive(0, 0.3, 0.2)
        for _ in range(10):
            client.next_data(POSITION2D, 0)
        house.end()
        self.assert_same(json.loads(house.output()), self.again())

    def test_a_recorded_run_is_the_run_that_it_would_be(self):
        plain = finish("run", self.world(), "--port", 0, "--headless", "--fast", "--duration", 5, "--json")
        recorded = finish("run", self.world(), "--port", 0, "--headless", "--fast", "--duration", 5, "--json",
                          "--record", self.file)
        self.assertEqual(json.loads(plain.stdout)["hash"], json.loads(recorded.stdout)["hash"])

    def test_a_program_that_is_killed_loses_at_most_the_last_second(self):
        house = self.start("--headless")
        client = self.client(house)
        client.open(LASER, 0)
        client.open(POSITION2D, 0)
        client.drive(0, 0.1)
        while client.next_data(LASER, 0).time < 3.2:   # that what the robot did by 2 s was handed over a second ago
            pass
        house.process.kill()
        house.wait()
        ended = finish("run", "--again", self.file, "--json")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertIn("was not finished", ended.stderr)
        self.assertGreaterEqual(json.loads(ended.stdout)["sim_time"], 2)

    def test_a_recording_that_ends_before_its_first_chunk_is_told_so(self):
        finish("run", self.world(), "--port", 0, "--headless", "--fast", "--duration", 5, "--record", self.file)
        whole = self.file.read_bytes()
        at = 8
        while whole[at] != 6:   # a chunk
            at += 9 + struct.unpack("<Q", whole[at + 1:at + 9])[0]
        for size in (8, at - 20, at + 9):
            self.file.write_bytes(whole[:size])
            for command in (("run", "--again"), ("replay",)):
                ended = finish(*command, self.file)
                self.assertEqual(ended.returncode, 2, ended.stderr)
                self.assertEqual(ended.stderr, f"{self.file}: error: was not finished and ends before its first whole chunk: "
                                               "there is nothing to run again\n")

    def test_a_disk_that_is_full_ends_the_recording_and_not_the_run(self):
        def little_room():
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL)   # Python ignores it, shells do not
            resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))

        ended = subprocess.run([PROGRAM, "run", str(self.world()), "--port", "0", "--headless", "--fast", "--duration", "600",
                                "--record", str(self.file), "--json"], capture_output=True, text=True, timeout=PATIENCE,
                               preexec_fn=little_room)
        self.assertEqual(ended.returncode, 1, ended.stderr)
        self.assertEqual(json.loads(ended.stdout)["sim_time"], 600)
        told = [line for line in ended.stderr.splitlines() if "run.mcap" in line]
        self.assertEqual(told, [f"{self.file}: error: cannot be written: File too large; the run goes on and is recorded no more"])
        self.again()   # what was written by then

    def test_a_recording_that_reaches_a_limit_in_its_first_megabyte_is_readable(self):
        ended = subprocess.run([PROGRAM, "run", str(ROOT / "worlds" / "cave.world"), "--port", "0", "--headless", "--fast",
                                "--duration", "60", "--record", str(self.file)], capture_output=True, text=True,
                               timeout=PATIENCE, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (300_000, 300_000)))
        self.assertEqual(ended.returncode, 1, ended.stderr)
        self.assertGreaterEqual(self.again()["sim_time"], 1)

    def test_what_cannot_be_recorded_is_told_in_one_line(self):
        for arguments, code, line in (
                (("--record", "/dev/full"), 1, "/dev/full: error: cannot be written: No space left on device"),
                (("--record", self.folder), 1, f"{self.folder}: error: cannot be written: Is a directory"),
                (("--record-only", "ranger"), 2, "--record-only requires --record"),
                (("--record", self.file, "--record-only", "rangr"), 2,
                 '--record-only: no kind that can be recorded is called "rangr" (did you mean "ranger"?)')):
            with self.subTest(arguments):
                ended = finish("run", self.world(), "--port", 0, "--headless", "--fast", "--duration", 1, *arguments)
                self.assertEqual(ended.returncode, code, ended.stderr)
                self.assertIn(line, ended.stderr)

    def test_what_is_no_recording_is_refused_in_one_line(self):
        finish("run", self.world(), "--port", 0, "--headless", "--fast", "--duration", 5, "--record", self.file)
        whole = self.file.read_bytes()
        middle = len(whole) // 3
        for content, line in ((b"playhouse saved run 2\n", "is not an MCAP file"), (b"", "is not an MCAP file"),
                              (whole[:middle] + b"\0\1\2\3" + whole[middle + 4:], "is damaged")):
            self.file.write_bytes(content)
            export = [("export", self.file, "--csv")] if "MCAP" in line else []
            for command in (("run", "--again", self.file), ("replay", self.file), *export):
                ended = finish(*command)
                self.assertEqual(ended.returncode, 2, ended.stderr)
                self.assertIn(f"{self.file}: error: {line}", ended.stderr)
                self.assertEqual(len(ended.stderr.splitlines()), 1, ended.stderr)

    def table(self, name: str) -> list[dict]:
        with open(self.folder / "run" / f"{name}.csv", newline="") as file:
            return list(csv.DictReader(file))

    def record(self, *arguments) -> dict:
        ended = finish("run", self.world(), "--port", 0, "--headless", "--fast", "--duration", 5, "--json", "--record", self.file,
                       *arguments)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return json.loads(ended.stdout)

    def export(self):
        ended = finish("export", self.file, "--csv")
        self.assertEqual(ended.returncode, 0, ended.stderr)

    def test_tables_have_what_was_recorded(self):
        recorded = self.record()
        self.export()
        checks = self.table("playhouse.checks")
        self.assertEqual([row["time"] for row in checks], ["0", "1", "2", "3", "4", "5", "5"])
        self.assertEqual(f"{int(checks[-1]['hash']):016x}", recorded["hash"])
        poses = [row for row in self.table("tf") if row["transforms.child_frame_id"] == "r1"]
        self.assertEqual({row["transforms.transform.translation.y"] for row in poses}, {"-3"})
        headings = {float(row["transforms.transform.rotation.heading"]) for row in poses}
        self.assertEqual(len(headings), 1)
        self.assertAlmostEqual(headings.pop(), math.pi / 2)
        places = self.table("r0.position")
        pose = ("x", "y", "z", "heading")
        self.assertEqual(list(places[0]), ["time", "mode", *(f"{name}.{part}" for name in ("command", "goal", "velocity", "odometry", "odometry_origin")
                                                              for part in pose), "stall", "motor_on"])
        odometry = {row["time"]: row for row in self.table("r0.odom")}
        for row in places[1:]:   # by another message of the same recording
            there = odometry[row["time"]]
            self.assertEqual([row[f"odometry.{part}"] for part in "xyz"], [there[f"pose.pose.position.{part}"] for part in "xyz"])
            self.assertAlmostEqual(float(row["odometry.heading"]), float(there["pose.pose.orientation.heading"]))
        scans = self.table("r0.ranger_0.scan")
        self.assertEqual(len(scans), 50)
        beam = float(scans[-1]["ranges.90"])   # straight ahead, where the wall is
        self.assertAlmostEqual(beam, 2.9, places=5)
        self.assertEqual(len([name for name in scans[0] if name.startswith("ranges.")]), 181)

    def test_parts_of_lists_and_of_vectors_have_names_in_words(self):
        world = self.write("parts.world", """interval_sim 100
            position( name "r" size [0.2 0.2 0.2] pose [0 0 0 0]
              fiducial( alwayson 1 range_max 8 range_max_id 8 fov 360 )
              wifi( alwayson 1 ip "10.0.0.1" ) imu( alwayson 1 ) blobfinder( alwayson 1 fov 90 ) )
            position( name "post" size [0.5 0.25 1] pose [3 4 0 90] fiducial_return 7 color "red" wifi( ip "10.0.0.2" ) )
            model( name "near" size [0.25 0.25 1] pose [2 0 0 0] fiducial_return 9 color "blue" )""")
        done = finish("run", world, "--port", 0, "--headless", "--fast", "--duration", 1, "--record", self.file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.export()
        seen = self.table("r.fiducial_0.fiducial")[-1]
        parts = ("target", "id", "range", "bearing", "heading", "size.x", "size.y", "size.z")
        self.assertEqual(list(seen), ["time", *(f"hits.{i}.{part}" for i in (0, 1) for part in parts)])
        posts = [i for i in (0, 1) if seen[f"hits.{i}.id"] == "7"]
        self.assertEqual(len(posts), 1)
        found = {part: float(seen[f"hits.{posts[0]}.{part}"]) for part in parts}
        self.assertAlmostEqual(found["range"], 5)
        self.assertAlmostEqual(found["bearing"], math.atan2(4, 3))
        self.assertAlmostEqual(found["heading"], math.pi / 2)
        self.assertEqual([found[f"size.{axis}"] for axis in "xyz"], [0.5, 0.25, 1])
        link = self.table("r.wifi_0.wifi")[-1]
        self.assertTrue(-100 < float(link["links.0.level"]) < 0)
        self.assertEqual(float(link["links.0.station"]) % 1, 0)
        self.assertIn("links.0.quality", link)
        reading = self.table("r.imu_0.imu")[-1]
        self.assertAlmostEqual(float(reading["reading.z"]), 9.81, delta=0.02)
        self.assertEqual([float(reading[f"reading.turn_{axis}"]) for axis in "xyz"], [0, 0, 0])
        blob = self.table("r.blobfinder_0.blobfinder")[-1]
        self.assertEqual([float(blob[f"blobs.0.color.{part}"]) for part in ("red", "green", "blue")], [0, 0, 1])
        for table in (self.folder / "run").glob("*.csv"):
            with open(table) as file:
                for name in file.readline().rstrip().split(","):
                    letters = name.rsplit(".", 1)[-1]
                    self.assertTrue(not letters.isdigit() or name.split(".")[-2] in
                                    ("ranges", "intensities", "covariance", "orientation_covariance", "angular_velocity_covariance",
                                     "linear_acceleration_covariance", "position_covariance", "d", "k", "r", "p"),
                                    f"{table.name}: {name}")

    def test_scans_are_as_consumers_of_ros_expect_them(self):
        world = self.write("circle.world", """interval_sim 50
            position( name "r" size [0.2 0.2 0.2] pose [0 0 0 0] update_interval 50
              ranger( size [0.1 0.1 0.1] update_interval 200 sensor( range [0.1 4] fov 360 samples 361 ) )
              ranger( size [0.1 0.1 0.1] sensor( range [0.1 4] fov 359 samples 360 ) )
              ranger( size [0.1 0.1 0.1] sensor( range [0.1 4] fov 90 samples 91 ) ) )
            model( pose [2.5 0 0 0] size [1 1 1] )""")
        done = finish("run", world, "--port", 0, "--headless", "--fast", "--duration", 1, "--record", self.file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.export()
        for ranger, count, fov, period in ((0, 360, 360, 0.2), (1, 360, 359, 0.1), (2, 91, 90, 0.1)):
            scan = self.table(f"r.ranger_{ranger}.scan")[-1]
            value = lambda name: float(scan[name])
            ranges = [float(text) for name, text in scan.items() if name.startswith("ranges.")]
            self.assertEqual(len(ranges), count)
            self.assertEqual(len([name for name in scan if name.startswith("intensities.")]), count)
            self.assertAlmostEqual(value("angle_min"), -math.radians(fov / 2), places=6)
            self.assertAlmostEqual(value("angle_increment"), math.radians(1), places=6)
            # As many as slam_toolbox counts, which takes a scan for a circle if its ends are less than a step apart.
            reach = value("angle_max") - value("angle_min")
            is_circle = abs(reach - 2 * math.pi) < value("angle_increment") - 2 * math.pi * 2 ** -23
            self.assertEqual(round(reach / value("angle_increment")) + (0 if is_circle else 1), count)
            self.assertAlmostEqual(value("scan_time"), period, places=6)
            ahead = min(range(count), key=lambda beam: abs(value("angle_min") + beam * value("angle_increment")))
            self.assertAlmostEqual(ranges[ahead], 2, places=3)
            self.assertEqual(ranges[0] if fov > 90 else ranges[-1], math.inf)

    def test_each_model_has_a_topic_and_frame_of_its_own_that_ros_accepts(self):
        names = ("a b", "a-b", "a_b", "1", "_x_", "y--z", "\u00e4")
        world = self.write("names.world", "interval_sim 100\n" + "\n".join(
            f'position( name "{name}" size [0.2 0.2 0.2] pose [{i} 0 0 0] ranger( sensor( samples 3 ) ) )' for i, name in enumerate(names)))
        done = finish("run", world, "--port", 0, "--headless", "--fast", "--duration", 2, "--record", self.file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.export()
        frames = {row["transforms.child_frame_id"] for row in self.table("tf")}
        self.assertEqual({frame for frame in frames if "/" not in frame}, {"a_b", "a_b_2", "a_b_3", "m1", "x", "y_z", "m"})
        topics = {path.name.removesuffix(".position.csv") for path in (self.folder / "run").glob("*.position.csv")}
        self.assertEqual(topics, {"a_b", "a_b_2", "a_b_3", "m1", "x", "y_z", "m"})
        self.assertTrue((self.folder / "run/a_b_2.ranger_0.scan.csv").exists())

    def test_between_two_transforms_nothing_moves_that_stood(self):
        world = self.write("still.world", 'interval_sim 100 position( name "r" size [0.2 0.2 0.2] )')
        with House("run", world, "--port", 0, "--headless", "--lock-step", "--duration", 3, "--record", self.file) as house, \
                connect(f":{house.port()}", timeout=PATIENCE) as client:
            simulator, robot = client.simulation(0), client.position2d(0)
            simulator.step(17)
            simulator.set_pose("r", 5, 0, 0)
            simulator.step(5)
            robot.drive(1, 0, 0)
            simulator.step(5)
            robot.drive(0, 0, 0)
            with self.assertRaises(RunEnded):
                while True:
                    simulator.step()
            self.assertEqual(house.wait(), 0, house.log())
        self.export()
        poses = [(float(row["time"]), float(row["transforms.transform.translation.x"])) for row in self.table("tf")
                 if row["transforms.child_frame_id"] == "r"]
        at = lambda time: next(x0 + (x1 - x0) * (time - t0) / (t1 - t0) for (t0, x0), (t1, x1) in zip(poses, poses[1:]) if t0 < time <= t1)
        self.assertEqual(poses, sorted(poses))
        for time, x in ((1.5, 0), (1.69, 0), (1.8, 5), (2.15, 5), (2.19, 5), (2.3, 5.1), (2.7, 5.5)):
            self.assertAlmostEqual(at(time), x, places=6, msg=f"{time} s of {poses}")

    def test_only_what_was_chosen_is_recorded(self):
        self.record("--record-only", "ranger@r0,position@r1")
        self.export()
        names = {path.name for path in (self.folder / "run").iterdir()}
        self.assertEqual({name for name in names if name.startswith("r")},
                         {"r0.ranger_0.scan.csv", "r0.ranger_1.ranges.csv", "r1.odom.csv", "r1.position.csv"})
        self.assertIn("tf.csv", names)
        self.again()

    def test_a_name_that_nobody_has_is_warned_of(self):
        ended = finish("run", self.world(), "--port", 0, "--headless", "--fast", "--duration", 1, "--record", self.file,
                       "--record-only", "@r7")
        self.assertEqual(ended.returncode, 0)
        self.assertIn("--record-only: no model is called r7 yet", ended.stderr)

    def test_tables_that_cannot_be_written_are_told_in_one_line(self):
        self.record()
        self.write("taken", "")
        ended = finish("export", self.file, "--csv", "-o", self.folder / "taken")
        self.assertEqual(ended.returncode, 1)
        self.assertEqual(ended.stderr, f"{self.folder}/taken: error: cannot be made: Not a directory\n")
        self.assertEqual(finish("export", self.folder / "none.mcap", "--csv").returncode, 2)
        self.assertEqual(finish("export", self.file).returncode, 2)


if __name__ == "__main__":
    unittest.main()
