"""What a Player client draws by graphics2d and graphics3d: in pictures of the recorded run, byte by byte."""

import struct
import unittest

from house import ACK, CMD, POSITION2D, SIMULATION, Client, House, HouseTest, finish
from test_picture import RENDERERS, chunks_of, hue, pixels_of

GRAPHICS2D, GRAPHICS3D = 55, 58
CLEAR, POINTS, POLYGON = 1, 2, 4
CLEAR_3D, DRAW, TRANSLATE, ROTATE, PUSH, POP = range(1, 7)
QUADS = 7
PAUSE = 1   # command of simulation: a paused world goes on

RED, BLUE, GREEN = (255, 255, 0, 0), (255, 0, 0, 255), (0, 0, 255, 0)   # opacity first; 0: not set

# A robot on a floor of 8 m by 8 m, which looks along y, 2 m to the left of the middle.
WORLD = """
interval_sim 100
model( name "edge" size [8 8 0.01] color "white" obstacle_return 0 ranger_return -1 )
position( name "r" pose [-2 -1 0 90] size [0.4 0.4 0.2] color "gray" )
model( name "post" pose [2 0 0 0] size [0.2 0.2 0.2] color "gray" )
"""
CFG = """
driver ( name "stage" provides ["simulation:0"] worldfile "test.world" )
driver ( name "stage" provides ["position2d:0" "graphics2d:0" "graphics3d:0"] model "r" )
driver ( name "stage" provides ["graphics2d:1"] model "post" )
"""


def points(*all_points) -> bytes:
    """As player_point_2d_t or _3d_t: counted twice."""
    return struct.pack(">II", len(all_points), len(all_points)) + b"".join(struct.pack(f">{len(p)}d", *p) for p in all_points)


def color(parts) -> bytes:
    return struct.pack(">IIII", *parts)


class Drawings(HouseTest):
    def draw(self, engine: str):
        """Records one second in which the robot drives 1 m along y; its drawing is made before."""
        self.world(WORLD)
        self.recording = self.folder / f"{engine}.mcap"
        with House("serve", self.write("test.cfg", CFG), "--port", 0, "--headless", "--fast", "--paused", "--duration", 1,
                   "--engine", engine, "--record", self.recording) as house:
            with Client(house.port()) as client:
                for interf, index in ((SIMULATION, 0), (POSITION2D, 0), (GRAPHICS2D, 0), (GRAPHICS3D, 0), (GRAPHICS2D, 1)):
                    self.assertEqual(client.open(interf, index).type, ACK)
                # Red ahead of the robot, with a bite out of its right side; what is nowhere is left out.
                client.send(GRAPHICS2D, 0, CMD, POINTS, points((9.0, 9.0)) + color(BLUE))
                client.send(GRAPHICS2D, 0, CMD, CLEAR)
                outline = points((0.5, 0.5), (0.5, -0.5), (1.0, 0.2), (1.5, -0.5), (float("nan"), 0.0), (1.5, 0.5))
                client.send(GRAPHICS2D, 0, CMD, POLYGON, outline + color(RED) + color(RED) + struct.pack(">I", 1))
                # Blue to the left of the robot, above the floor: 1 m by 1 m about (0, 1.5), turned by a right angle.
                client.send(GRAPHICS3D, 0, CMD, PUSH)
                client.send(GRAPHICS3D, 0, CMD, ROTATE, struct.pack(">dddd", 1.5707963267948966, 0, 0, 1))
                client.send(GRAPHICS3D, 0, CMD, TRANSLATE, struct.pack(">ddd", 1.5, 0, 0.1))
                square = points((-0.5, -0.5, 0.0), (0.5, -0.5, 0.0), (0.5, 0.5, 0.0), (-0.5, 0.5, 0.0))
                client.send(GRAPHICS3D, 0, CMD, DRAW, struct.pack(">I", QUADS) + square + color(BLUE))
                client.send(GRAPHICS3D, 0, CMD, POP)
                client.send(GRAPHICS2D, 1, CMD, POLYGON, points((1, 1), (2, 1), (2, 2), (1, 2)) + color(GREEN) + color(GREEN) + struct.pack(">I", 1))
                client.drive(0, 1.0)
                client.pose("r")    # answered behind all commands
                client.send(SIMULATION, 0, CMD, PAUSE)
                self.assertEqual(house.wait(), 0, house.log())

    def picture(self, renderer: str, seconds: float, *words):
        file = self.folder / "made.png"
        done = finish("picture", self.recording, "-o", file, "--renderer", renderer, "--width", 212, "--at", seconds, *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = pixels_of(b"".join(content for kind, content in chunks_of(file.read_bytes()) if kind == "IDAT"), 212, 212)
        return lambda x, y: hue(rows[round(106 - 25 * y)][round(106 + 25 * x)])     # 25 pixels a metre

    def test_what_a_client_draws_moves_with_its_robot_in_pictures(self):
        for engine in ("stage", "arena"):
            self.draw(engine)
            for renderer in RENDERERS:
                for seconds, moved in ((0.1, 0.1), (1, 1)):
                    with self.subTest(engine=engine, renderer=renderer, seconds=seconds):
                        if engine == "arena" and seconds == 1:
                            moved = 0.9     # it has a mass
                        at = self.picture(renderer, seconds)
                        y = -1 + moved      # of the robot
                        self.assertEqual([at(-2.3, y + 0.7), at(-2.3, y + 1.3)], ["r", "r"], "ahead, and a little to the left")
                        self.assertEqual(at(-1.85, y + 1.0), "-", "the bite")
                        self.assertEqual([at(-3.5, y), at(-3.2, y + 0.3)], ["b", "b"], "to its left")
                        self.assertEqual([at(-2, y + 1.9), at(-3.5, y + 0.8)], ["-", "-"])
                        self.assertEqual(at(3.5, 1.5), "g", "of the post, which stays; an opacity that is not set is full")

    def test_a_run_is_the_same_with_drawings_and_is_so_again(self):
        self.draw("stage")
        again = finish("run", "--again", self.recording)
        self.assertEqual(again.returncode, 0, again.stderr)

    def test_a_drawing_goes_when_it_is_cleared_and_stays_when_its_client_goes(self):
        self.world(WORLD)
        self.recording = self.folder / "run.mcap"
        with House("serve", self.write("test.cfg", CFG), "--port", 0, "--headless", "--fast", "--paused", "--duration", 0.2,
                   "--record", self.recording) as house:
            with Client(house.port()) as first:
                for interf, index in ((GRAPHICS2D, 0), (GRAPHICS3D, 0), (SIMULATION, 0)):
                    self.assertEqual(first.open(interf, index).type, ACK)
                square = points((0.5, -0.5), (1.5, -0.5), (1.5, 0.5), (0.5, 0.5))
                first.send(GRAPHICS2D, 0, CMD, POLYGON, square + color(RED) + color(RED) + struct.pack(">I", 1))
                square = points((0.5, 1.0, 0.1), (1.5, 1.0, 0.1), (1.5, 2.0, 0.1), (0.5, 2.0, 0.1))
                first.send(GRAPHICS3D, 0, CMD, DRAW, struct.pack(">I", QUADS) + square + color(BLUE))
                first.pose("r")
            with Client(house.port()) as second:
                for interf in (GRAPHICS3D, SIMULATION):
                    self.assertEqual(second.open(interf, 0).type, ACK)
                second.send(GRAPHICS3D, 0, CMD, CLEAR_3D)
                second.pose("r")
                second.send(SIMULATION, 0, CMD, PAUSE)
                self.assertEqual(house.wait(), 0, house.log())
        at = self.picture("playhouse", 0.2)
        self.assertEqual(at(-2, 0), "r", "of the client that went")
        self.assertEqual(at(-3.5, 0), "-", "cleared")

    def test_what_is_too_much_or_nonsense_is_told_in_a_line_and_left_out(self):
        self.world(WORLD)
        with House("serve", self.write("test.cfg", CFG), "--port", 0, "--headless") as house, Client(house.port()) as client:
            for interf, index in ((GRAPHICS2D, 0), (GRAPHICS3D, 0), (SIMULATION, 0)):
                self.assertEqual(client.open(interf, index).type, ACK)
            client.send(GRAPHICS3D, 0, CMD, DRAW, struct.pack(">I", 77) + points((0.0, 0.0, 0.0)) + color(RED))
            house.wait_for_line("not with these values")
            many = points(*[(0.001 * k, 0.0) for k in range(10000)]) + color(RED)
            for _ in range(4):
                client.send(GRAPHICS2D, 0, CMD, POINTS, many)
            house.wait_for_line('graphics2d of model "r": the drawing is full')
            client.pose("r")
            self.assertEqual(house.log().count("drawing is full"), 1)


if __name__ == "__main__":
    unittest.main()
