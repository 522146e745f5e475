"""The small drivers that configuration files put between a robot and a client: what a client reads and drives through them."""

import json
import math
import struct
import sys
import unittest
import zlib

from house import ACK, CMD, LASER, NACK, POSITION2D, RANGER, ROOT, SIMULATION, SONAR, Client, House, HouseTest

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client.generated import map as grid  # noqa: E402

LOCALIZE, MAP = 25, 42
GET_CONFIG_OF_LASER, GET_CONFIG_OF_RANGER, GET_GEOM = 3, 5, 1
PAUSE = 1

# A wall right ahead of the robot, 3 m from it; another robot behind.
WORLD = """
interval_sim 100
define scanner ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 181 ) )
define ears ranger( size [0.1 0.1 0.1]
  sensor( pose [0 0 0 0] range [0 5] fov 10 ) sensor( pose [0 0 0 90] range [0 5] fov 10 ) )
model( name "wall" pose [3.1 0 0 0] size [0.2 10 1] color "gray" )
position( name "r0" pose [0 0 0 0] size [0.4 0.4 0.2] scanner( pose [0 0 0 0] ) ears( pose [0 0 0 0] ) )
position( name "r1" pose [-5 2 0 90] size [0.4 0.4 0.2] )
"""
STAGE = """
driver( name "stage" provides ["simulation:0"] worldfile "filters.world" )
driver( name "stage" provides ["position2d:0" "laser:0" "sonar:0"] model "r0" )
driver( name "stage" provides ["position2d:1"] model "r1" )
"""


def floats(body: bytes, at: int, code: str) -> tuple[list[float], int]:
    """A list of numbers, which stand behind their count and its copy; and where it ends."""
    count = struct.unpack_from(">I", body, at)[0]
    size = struct.calcsize(">" + code)
    return list(struct.unpack_from(f">{count}{code}", body, at + 8)), at + 8 + count * size


def scan_of(body: bytes) -> dict:
    """A scan of a laser."""
    first, last, step, most = struct.unpack_from(">ffff", body)
    return {"first": first, "last": last, "step": step, "max_range": most, "ranges": floats(body, 16, "f")[0]}


class Filters(HouseTest):
    def serve(self, sections: str, *arguments) -> House:
        self.write("filters.world", WORLD)
        cfg = self.write("filters.cfg", STAGE + sections)
        return House("serve", cfg, "--port", 0, "--headless", "--fast", "--paused", *arguments)

    def go_on(self, client: Client):
        client.send(SIMULATION, 0, CMD, PAUSE)


class Scans(Filters):
    SECTIONS = """
driver( name "lasertoranger" provides ["ranger:0"] requires ["laser:0"] )
driver( name "sonartoranger" provides ["ranger:1"] requires ["sonar:0"] )
driver( name "lasercutter" provides ["laser:1"] requires ["laser:0"] min_angle -30 max_angle 30 )
driver( name "lasercspace" provides ["laser:2"] requires ["laser:1"] radius 0.5 )
driver( name "laserposeinterpolator" provides ["laser:3"] requires ["laser:0" "position2d:0"] )
"""

    def test_a_client_reads_a_laser_as_a_ranger_with_the_same_ranges(self):
        with self.serve(self.SECTIONS) as house, Client(house.port()) as client:
            for interf, index in ((LASER, 0), (RANGER, 0), (SONAR, 0), (RANGER, 1)):
                self.assertEqual(client.open(interf, index).type, ACK)
            self.go_on(client)
            scan = scan_of(client.next_data(LASER, 0).body)
            ranges, _ = floats(client.next_data(RANGER, 0).body, 0, "d")
            self.assertEqual(len(ranges), 181)
            self.assertEqual(ranges, scan["ranges"])
            self.assertAlmostEqual(ranges[90], 3, delta=0.01)
            config = struct.unpack(">ddddddd", client.request(RANGER, 0, GET_CONFIG_OF_RANGER).body)
            self.assertAlmostEqual(config[0], -math.pi / 2, places=5)
            self.assertAlmostEqual(config[1], math.pi / 2, places=5)
            self.assertAlmostEqual(config[2], math.pi / 180, places=6)
            self.assertEqual(config[4], 8)
            heard, _ = floats(client.next_data(SONAR, 0).body, 0, "f")
            self.assertEqual(floats(client.next_data(RANGER, 1).body, 0, "d")[0], heard)

    def test_filters_of_filters_cut_a_scan_and_shorten_it(self):
        with self.serve(self.SECTIONS) as house, Client(house.port()) as client:
            for index in (0, 1, 2, 3):
                self.assertEqual(client.open(LASER, index).type, ACK)
            self.go_on(client)
            whole = scan_of(client.next_data(LASER, 0).body)
            cut = scan_of(client.next_data(LASER, 1).body)
            self.assertEqual(cut["ranges"], whole["ranges"][60:121])
            self.assertAlmostEqual(cut["first"], math.radians(-30), places=5)
            free = scan_of(client.next_data(LASER, 2).body)["ranges"]
            # A disc of half a metre touches the wall when its middle is half a metre from it; the ends of beams are up to 5 cm apart.
            for i, range_ in enumerate(free):
                self.assertAlmostEqual(range_, 2.5 / math.cos(math.radians(i - 30)), delta=0.02)
            config = struct.unpack_from(">ff", client.request(LASER, 2, GET_CONFIG_OF_LASER).body)
            self.assertAlmostEqual(config[1], math.radians(30), places=5)
            posed = client.next_data(LASER, 3, subtype=2).body
            self.assertEqual(scan_of(posed)["ranges"], whole["ranges"])
            self.assertEqual(struct.unpack(">ddd", posed[-24:]), (0, 0, 0))


class Motion(Filters):
    def states(self, client: Client, index: int, until: float):
        """Time and forward speed of each STATE until a simulated time."""
        seen = []
        while not seen or seen[-1][0] < until:
            message = client.next_data(POSITION2D, index)
            seen.append((message.time, struct.unpack_from(">dddddd", message.body)[3]))
        return seen

    def test_a_robot_whose_client_falls_silent_stops(self):
        with self.serve("""
driver( name "deadstop" provides ["position2d:5"] requires ["position2d:0"] timeout 0.5 )
""") as house, Client(house.port()) as client:
            self.assertEqual(client.open(POSITION2D, 5).type, ACK)
            client.drive(5, 0.5)
            client.request(POSITION2D, 5, GET_GEOM)  # it has the command
            self.go_on(client)
            speeds = self.states(client, 5, 2)
            begun = next(time for time, speed in speeds if speed > 0)
            stopped = next(time for time, speed in speeds if time > begun and speed == 0)
            self.assertGreaterEqual(stopped - begun, 0.5 - 1e-6)
            self.assertLess(stopped - begun, 1)
            self.assertFalse(any(speed for time, speed in speeds if time > stopped))

    def test_a_robot_stops_before_what_its_laser_sees(self):
        with self.serve("""
driver( name "lasersafe" provides ["position2d:5"] requires ["position2d:0" "laser:0"] safedistance 0.6 )
""") as house, Client(house.port()) as client:
            self.assertEqual(client.open(POSITION2D, 5).type, ACK)
            self.go_on(client)
            self.states(client, 5, 0.5)
            client.drive(5, 0.4)
            poses = []
            while len(poses) < 3 or poses[-1] != poses[-3] or poses[-1] == 0:
                poses.append(struct.unpack_from(">d", client.next_data(POSITION2D, 5).body)[0])
            self.assertGreater(poses[-1], 2.2)
            self.assertLess(poses[-1], 2.5)

    def test_a_robot_gets_to_a_goal_and_another_does_as_it_does(self):
        with self.serve("""
driver( name "cmdsplitter" provides ["position2d:5"] requires ["0:::position2d:0" "1:::position2d:1"] devices 2 )
driver( name "goto" provides ["position2d:6"] requires ["position2d:5"] )
""") as house, Client(house.port()) as client:
            self.assertEqual(client.open(POSITION2D, 6).type, ACK)
            client.send(POSITION2D, 6, CMD, 2, struct.pack(">ddddddI", 1, 1, 0, 0, 0, 0, 1))
            client.request(POSITION2D, 6, GET_GEOM)
            self.go_on(client)
            self.states(client, 6, 20)
            self.go_on(client)
            self.assertLess(math.dist(client.pose("r0")[:2], (1, 1)), 0.1)
            self.assertLess(math.dist(client.pose("r1")[:2], (-6, 3)), 0.1)


class Runs(Filters):
    def result(self, *arguments) -> dict:
        """Of a run in which a goal is given before the first tick, through a chain of drivers."""
        with self.serve("""
driver( name "deadstop" provides ["position2d:5"] requires ["position2d:0"] timeout 0.5 )
driver( name "lasersafe" provides ["position2d:6"] requires ["position2d:5" "laser:0"] safedistance 0.6 )
driver( name "goto" provides ["position2d:7"] requires ["position2d:6"] )
driver( name "gridmap" provides ["map:0"] requires ["position2d:0" "laser:0"] sonartreshold 8 alwayson 1 )
driver( name "fakelocalize" provides ["localize:0"] requires ["simulation:0"] model "r0" alwayson 1 )
""", "--duration", 20, "--json", *arguments) as house, Client(house.port()) as client:
            self.assertEqual(client.open(POSITION2D, 7).type, ACK)
            client.send(POSITION2D, 7, CMD, 2, struct.pack(">ddddddI", 5, 1, 0, 0, 0, 0, 1))
            client.request(POSITION2D, 7, GET_GEOM)
            self.go_on(client)
            poses = []
            with self.assertRaises(ConnectionError):  # the end of the run
                while True:
                    poses.append(struct.unpack_from(">d", client.next_data(POSITION2D, 7).body)[0])
            self.assertEqual(house.wait(), 0, house.log())
            self.assertGreater(poses[-1], 1.5, "it drives")
            self.assertLess(poses[-1], 2.6, "and stops before the wall")
            return json.loads(house.output())

    def test_a_run_with_them_is_the_same_to_the_bit_each_time(self):
        first, again = self.result(), self.result("--workers", 4)
        for word in ("ticks", "hash", "sensed_hash"):
            self.assertEqual(again[word], first[word])


class Maps(Filters):
    # 7 by 5 cells of 0.5 m; what is black is occupied.
    IMAGE = "P2 7 5 255\n" + "\n".join(("255 255 255 255 255 255 255",) * 2 + ("255 255 255 0 255 255 255",) +
                                      ("255 255 255 255 255 255 255",) * 2) + "\n"

    def cells(self, client: Client, index: int, width: int, height: int) -> list[int]:
        answer = client.request(MAP, index, 2, grid.Data(0, 0, width, height, 0, b"").encode())
        return list(struct.unpack(f"{width * height}b", zlib.decompress(grid.Data.decode(answer.body).data)))

    def test_a_client_reads_a_map_with_larger_obstacles_and_one_with_larger_cells(self):
        self.write("plan.pgm", self.IMAGE)
        with self.serve("""
driver( name "mapfile" provides ["map:0"] filename "plan.pgm" resolution 0.5 )
driver( name "mapcspace" provides ["map:1"] requires ["map:0"] robot_radius 0.6 )
driver( name "mapscale" provides ["map:2"] requires ["map:1"] resolution 1 )
""") as house, Client(house.port()) as client:
            for index in (1, 2):
                self.assertEqual(client.open(MAP, index).type, ACK)
            grown = self.cells(client, 1, 7, 5)
            expected = [1 if abs(i % 7 - 3) + abs(i // 7 - 2) <= 1 else -1 for i in range(35)]
            self.assertEqual(grown, expected)
            info = grid.Info.decode(client.request(MAP, 2, 1).body)
            self.assertEqual((info.scale, info.width, info.height), (1, 4, 3))
            # A larger cell is as the worst part of it, and unknown where it reaches over the edge.
            self.assertEqual(self.cells(client, 2, 4, 3), [-1, 1, -1, 0, -1, 1, 1, 0, 0, 0, 0, 0])


class Localization(Filters):
    def test_a_client_reads_the_true_pose_of_a_robot_that_drives(self):
        with self.serve("""
driver( name "fakelocalize" provides ["localize:0" "position2d:7"] requires ["simulation:0"] model "r0" )
""") as house, Client(house.port()) as client:
            for interf, index in ((LOCALIZE, 0), (POSITION2D, 7), (POSITION2D, 0)):
                self.assertEqual(client.open(interf, index).type, ACK)
            client.drive(0, 0.4, 0.2)
            client.request(POSITION2D, 0, GET_GEOM)
            self.go_on(client)
            while client.next_data(LOCALIZE, 0).time < 3:
                pass
            self.go_on(client)
            true = client.pose("r0")
            answer = client.request(LOCALIZE, 0, 2)
            self.assertEqual(answer.type, ACK)
            told = struct.unpack_from(">ddd", answer.body)
            self.assertLess(math.dist(told[:2], true[:2]), 0.05)
            self.assertGreater(math.dist(told[:2], (0, 0)), 0.5)
            self.assertEqual(client.request(POSITION2D, 7, GET_GEOM).type, NACK)


if __name__ == "__main__":
    unittest.main()
