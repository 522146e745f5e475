"""Pictures and films of worlds, drawn without a screen: read back byte by byte, so that nothing that draws is trusted."""

import math
import os
import shutil
import signal
import struct
import subprocess
import unittest
import zlib
from pathlib import Path

from house import PATIENCE, PROGRAM, ROOT, HouseTest, finish, wait_until

# A square of red, 2 m wide, half of it under blue that is higher, and a driving robot, in 8 m by 8 m.
WORLD = """
interval_sim 100
model( name "edge" size [8 8 0.1] color "white" obstacle_return 0 ranger_return -1 )
model( name "low" pose [2 0 0 0] size [2 2 0.5] color "red" )
model( name "high" pose [2.5 0 0 0] size [1 2 1] color "blue" )
position( name "r" pose [-3 0 0 0] size [1 1 0.3] color "green" ctrl "expand_swarm"
  ranger( size [0 0 0] sensor( range [0 5] ) ) )
"""


def chunks_of(data: bytes):
    """Type and content of each chunk; every check sum is right."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, chunks = 8, []
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        content = data[at + 8:at + 8 + length]
        assert struct.unpack_from(">I", data, at + 8 + length)[0] == zlib.crc32(kind + content), kind
        chunks.append((kind.decode(), content))
        at += 12 + length
    return chunks


def pixels_of(packed: bytes, width: int, height: int):
    """Rows of red, green and blue, filters undone."""
    data, stride, rows = zlib.decompress(packed), 3 * width, []
    before = bytes(stride)
    for y in range(height):
        kind, row = data[y * (stride + 1)], bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            left, up, corner = (row[x - 3] if x >= 3 else 0), before[x], (before[x - 3] if x >= 3 else 0)
            near = left + up - corner
            paeth = min((left, up, corner), key=lambda value: abs(near - value))
            row[x] = (row[x] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        rows.append([tuple(row[x:x + 3]) for x in range(0, stride, 3)])
        before = row
    return rows


def chunks_of_frames(chunks):
    """The packed pixels of each picture of a film."""
    return [content if kind == "IDAT" else content[4:] for kind, content in chunks if kind in ("IDAT", "fdAT")]


# Two cubes to the right and left of a robot that drives between them, along y.
CUBES = """
interval_sim 100
model( name "floor" size [12 12 0.01] color "white" obstacle_return 0 ranger_return -1 )
model( name "red" pose [2 0 0 0] size [1 1 1] color "red" )
model( name "blue" pose [-2 0 0 0] size [1 1 1] color "blue" )
position( name "r" pose [0 -2 0 90] size [0.4 0.4 0.4] color "green" ctrl "expand_swarm"
  ranger( size [0 0 0] sensor( range [0 5] ) ) )
"""


def seen_at(point, eye, target, width, fov=math.pi / 3):
    """The pixel of a point, as a pinhole camera without roll sees it that looks from eye to target: 16 to 9, upright."""
    def unit(v):
        return [c / math.hypot(*v) for c in v]

    def dot(u, v):
        return sum(a * b for a, b in zip(u, v))
    ahead = unit([b - a for a, b in zip(eye, target)])
    right = unit([ahead[1], -ahead[0], 0])
    up = [right[1] * ahead[2] - right[2] * ahead[1], right[2] * ahead[0] - right[0] * ahead[2], right[0] * ahead[1] - right[1] * ahead[0]]
    way = [b - a for a, b in zip(eye, point)]
    height = round(width * 9 / 16)
    scale = height / 2 / math.tan(fov / 2) / dot(way, ahead)
    return round(width / 2 + scale * dot(way, right)), round(height / 2 - scale * dot(way, up))


def hue(pixel):
    """Of red, green and blue, what is much brighter than the others, else nothing."""
    order = sorted(range(3), key=lambda k: pixel[k])
    return "rgb"[order[2]] if pixel[order[2]] > 1.5 * pixel[order[1]] + 20 else "-"


RENDERERS = ("playhouse", "chromium") if shutil.which("chromium") else ("playhouse",)


class Views(HouseTest):
    """Cameras in the world, by both renderers; the truth is the projection of a pinhole."""

    def drawn(self, *words, renderer, source=None, width=320):
        file = self.folder / "made.png"
        done = finish(words[0], source or self.write("w.world", CUBES), "-o", file, "--renderer", renderer, "--width", width, *words[1:])
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        chunks = chunks_of(file.read_bytes())
        self.assertEqual(struct.unpack_from(">II", dict(chunks)["IHDR"]), (width, width * 9 // 16))
        return chunks

    def rows(self, *words, renderer, **more):
        chunks = self.drawn("picture", *words, renderer=renderer, **more)
        return pixels_of(b"".join(content for kind, content in chunks if kind == "IDAT"), 320, 180)

    def test_a_camera_sees_what_a_pinhole_sees(self):
        eye = (1, -5, 2.5)
        for renderer in RENDERERS:
            rows = self.rows("--from", "1,-5,2.5", "--look-at", "0.5,0,0.5", renderer=renderer)
            for point, wanted in (((2, -0.5, 0.5), "r"), ((1.6, -0.5, 0.1), "r"), ((2.4, -0.5, 0.9), "r"), ((-2, -0.5, 0.5), "b"),
                                  ((-1.6, -0.5, 0.9), "b"), ((0, -2.2, 0.2), "g"), ((2.7, -0.5, 0.5), "-"), ((1.3, -0.5, 0.5), "-"),
                                  ((2, -0.5, 1.9), "-"), ((0, 0, 0), "-")):
                column, row = seen_at(point, eye, (0.5, 0, 0.5), 320)
                self.assertEqual(hue(rows[row][column]), wanted, (point, rows[row][column]))

    def test_a_robot_has_wheels_and_a_lid_in_its_color(self):
        world = self.write("robot.world", 'include "pioneer.inc"\npioneer2dx_bare( name "r" pose [0 0 0 90] color "blue" )\n')
        for renderer in RENDERERS:
            rows = self.rows("--from", "0,0,1.5", "--look-at", "0,0,0", renderer=renderer, source=world)
            def at(x, y, z):
                column, row = seen_at((x, y + 1e-6, z), (0, -1e-6, 1.5), (0, 0, 0), 320)
                return rows[row][column]
            self.assertEqual(hue(at(0, -0.04, 0.22)), "b")
            for side in (1, -1):   # beside the lid, on the axle
                self.assertLess(max(at(0.1715 * side, 0, 0.165)), 100, "a tyre")
                self.assertGreater(min(at(0.5 * side, -0.04, 0)), 120, "the floor")

    def test_straight_down_is_up_in_y(self):
        for renderer in RENDERERS:
            rows = self.rows("--from", "0,0,9", "--look-at", "0,0,0", renderer=renderer)
            scale = 90 / math.tan(math.pi / 6)
            self.assertEqual(hue(rows[90][round(160 + scale * 2 / 8)]), "r")
            self.assertEqual(hue(rows[90][round(160 - scale * 2 / 8)]), "b")
            self.assertEqual(hue(rows[round(90 + scale * 2 / 8.6)][160]), "g")

    def test_a_robot_sees_what_is_ahead_of_it_and_not_itself(self):
        for renderer in RENDERERS:
            world = self.write("ahead.world", CUBES.replace("pose [0 -2 0 90]", "pose [0 0 0 0]"))
            rows = self.rows("--first-person", "r", renderer=renderer, source=world)
            for point, wanted in (((1.5, 0, 0.45), "r"), ((1.5, 0.45, 0.1), "r"), ((1.5, -0.45, 0.9), "r"), ((1.5, 0.6, 0.45), "-")):
                column, row = seen_at(point, (0, 0, 0.45), (1, 0, 0.45), 320)
                self.assertEqual(hue(rows[row][column]), wanted, point)
            self.assertNotIn("g", {hue(pixel) for row in rows for pixel in row})

    def test_what_is_followed_stays_in_the_middle(self):
        for renderer in RENDERERS:
            for words in (("--follow", "r"), ("--follow", "r", "--from", "4,-4,2")):
                chunks = self.drawn("film", "--duration", 2, "--rate", 1, *words, renderer=renderer)
                frames, packed = [], b""
                for kind, content in [*chunks, ("fcTL", b"")]:
                    if kind == "fcTL" and packed:
                        frames.append(pixels_of(packed, 320, 180))
                        packed = b""
                    packed += content if kind == "IDAT" else content[4:] if kind == "fdAT" else b""
                self.assertEqual([hue(frame[90][160]) for frame in frames], ["g"] * 3, words)
                self.assertFalse(frames[0] == frames[2], "it drives")

    def test_words_that_do_not_fit_are_told_in_a_line(self):
        world = self.write("w.world", CUBES)
        for words, told in ((("--look-at", "0,0,0"), "--from"), (("--from", "0,0"), "X,Y,Z in metres is valid"),
                            (("--follow", "q"), 'there is no model "q"'), (("--first-person", "bleu"), 'did you mean "blue"?'),
                            (("--first-person", "r", "--follow", "r"), "excludes"), (("--from", "nan,0,0"), "X,Y,Z")):
            with self.subTest(words):
                done = finish("picture", world, "-o", self.folder / "a.png", "--renderer", "playhouse", *words)
                self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)
                self.assertIn(told, done.stderr)


class Recordings(HouseTest):
    """The truth is the same run, drawn while it ran."""

    def setUp(self):
        super().setUp()
        self.world, self.file = self.write("w.world", WORLD), self.folder / "run.mcap"
        done = finish("run", self.world, "--fast", "--headless", "--duration", 2, "--record", self.file)
        self.assertEqual(done.returncode, 0, done.stderr)

    def drawn(self, command, source, *words):
        file = self.folder / "made.png"
        done = finish(command, source, "-o", file, "--renderer", "playhouse", "--width", 100, *words)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        return file.read_bytes()

    def test_a_moment_of_a_recording_is_that_of_the_run(self):
        first = self.drawn("picture", self.file)
        self.assertEqual(first, self.drawn("picture", self.world))
        later = self.drawn("picture", self.file, "--at", 1.5)
        self.assertEqual(later, self.drawn("picture", self.world, "--at", 1.5))
        self.assertFalse(first == later)

    def test_a_film_of_a_recording_is_that_of_the_run(self):
        whole = self.drawn("film", self.file, "--rate", 5)
        self.assertEqual(whole, self.drawn("film", self.world, "--rate", 5, "--duration", 2))
        self.assertEqual(self.drawn("film", self.file, "--rate", 5, "--duration", 1), self.drawn("film", self.world, "--rate", 5, "--duration", 1))
        self.assertEqual(self.drawn("film", self.file, "--rate", 5, "--duration", 9), whole, "it ends where the recording does")
        self.assertEqual(self.drawn("film", self.file, "--follow", "r", "--rate", 2), self.drawn("film", self.world, "--follow", "r", "--rate", 2, "--duration", 2))

    def test_what_is_not_in_it_is_told_in_a_line(self):
        (self.folder / "bad.mcap").write_bytes(b"no recording")
        for words, code, told in (((self.file, "--at", 9), 2, "error: --at: 9 s is not in the recording, which is from 0 to 2 s"),
                                  ((self.folder / "bad.mcap",), 2, "bad.mcap"), ((self.folder / "gone.mcap",), 2, "gone.mcap")):
            done = finish("picture", *words, "-o", self.folder / "a.png", "--renderer", "playhouse")
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (code, 1), done.stderr)
            self.assertIn(told, done.stderr)

    def test_a_recording_is_not_drawn_over(self):
        done = finish("film", self.file, "-o", self.file, "--renderer", "playhouse")
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(finish("run", "--again", self.file).returncode, 0)


class Pictures(HouseTest):
    def drawn(self, *words, world=WORLD):
        file = self.folder / "made.png"
        world = self.write("w.world", world)
        done = finish(words[0], world, "-o", file, "--renderer", "playhouse", *words[1:])
        self.assertEqual((done.returncode, done.stdout), (0, ""))
        self.assertRegex(done.stderr, rf"^{words[0]}: drawn by Playhouse in [0-9.]+ s\n$")
        return chunks_of(file.read_bytes())

    def test_a_picture_shows_what_is_higher_over_what_is_lower_where_it_is(self):
        chunks = self.drawn("picture", "--width", 212)       # 8 m and a margin of 3 % on each side: 25 pixels a metre
        width, height = struct.unpack_from(">II", dict(chunks)["IHDR"])
        self.assertEqual((width, height), (212, 212))
        at = self.places(chunks)
        self.assertEqual(at(1.5, 0), (255, 0, 0))
        self.assertEqual(at(2.5, 0), (0, 0, 255))
        self.assertEqual(at(0, 3), (255, 255, 255))
        self.assertEqual(at(-3.3, 0)[0::2], (0, 0))
        self.assertLess(at(-2.7, 0)[1], at(-3.3, 0)[1], "the nose is darker")

    def places(self, chunks):
        """The pixel at a place (m) of a picture of 8 m by 8 m that is 212 pixels wide."""
        rows = pixels_of(b"".join(content for kind, content in chunks if kind == "IDAT"), 212, 212)
        return lambda x, y: rows[round(106 - 25 * y)][round(106 + 25 * x)]

    def seen(self, what, world, seconds=0.2):
        return self.places(self.drawn("picture", "--width", 212, "--at", seconds, *(("--show", what) if what else ()), world=world))

    def test_what_sensors_see_is_drawn_where_it_is_asked_for(self):
        world = """
interval_sim 100
model( name "edge" size [8 8 0.1] color "white" obstacle_return 0 ranger_return -1 )
model( name "box" pose [2 0 0 0] size [2 2 0.9] color "red" fiducial_return 7 rfid_tag "07" )
position( name "r" pose [-3 0 0 0] size [1 1 0.3] color "green"
  rfid( range_max 6 )
  ranger( size [0 0 0.1] sensor( range [0 6] fov 90 samples 91 ) )
  fiducial( range_max 8 fov 180 )
  detector( fov 10 sees "name=box" color "purple" )
  wifi( pose [0 0 0 0] )
  camera( size [0.1 0.1 0.1] pose [0 0 0 90] range [0.2 3] fov [90 40] ) )
wifi( name "post" pose [-3 -3 1 0] )
"""
        nothing = self.seen("", world)
        for place in ((0, 0.5), (0, 0), (-3, 2), (-3, -1.5)):
            self.assertEqual(nothing(*place), (255, 255, 255), place)
        scan = self.seen("ranger", world)
        self.assertEqual(scan(0, 0.5), (217, 217, 255), "blue that one can see through")
        self.assertEqual(scan(2, 0), (255, 0, 0), "the scan ends at the box")
        self.assertEqual(scan(1.5, 2), (217, 217, 255), "and goes past it")
        self.assertEqual(scan(-3, 2), (255, 255, 255), "it looks 45 degrees to each side")
        self.assertEqual(scan(3.9, 3), (255, 255, 255), "and 6 m far")
        finder = self.seen("fiducial", world)
        red, green, blue = finder(0, 0)
        self.assertTrue(red > green > blue, "a line to the box")
        self.assertEqual(finder(0, 0.5), (255, 255, 255))
        red, green, blue = self.seen("detector", world)(0, 0)
        self.assertTrue(blue > red > green, "a purple line to what it finds")
        red, green, blue = self.seen("rfid", world)(0, 0)
        self.assertTrue(red > green > blue, "a line to the box with a tag")
        radio = self.seen("wifi", world)
        self.assertNotEqual(radio(-3, -1.5), (255, 255, 255))
        camera = self.seen("camera", world)
        self.assertNotEqual(camera(-3, 2), (255, 255, 255))
        self.assertEqual((camera(-3, 3.4), camera(0, 0)), ((255, 255, 255),) * 2, "3 m to the left")
        everything = self.seen("all", world)
        self.assertEqual((everything(1.5, 2), everything(-3, 2)), (scan(1.5, 2), camera(-3, 2)))
        self.assertEqual(self.seen("fiducial,camera", world)(-3, 2), camera(-3, 2))

    def test_sensors_see_nothing_before_they_have_measured_and_measuring_changes_nothing(self):
        before, after = (self.drawn("picture", "--width", 100, *show) for show in ((), ("--show", "ranger")))
        self.assertEqual(before, after)
        films = [chunks_of_frames(self.drawn("film", "--duration", 1, "--width", 106, *show)) for show in ((), ("--show", "ranger"))]
        self.assertEqual(films[0][0], films[1][0])
        self.assertNotEqual(films[0][5], films[1][5])

    def test_edges_between_pixels_are_mixed(self):
        chunks = self.drawn("picture", "--width", 100)
        rows = pixels_of(b"".join(content for kind, content in chunks if kind == "IDAT"), 100, 100)
        self.assertTrue([pixel for row in rows for pixel in row if pixel[0] == 255 and 0 < pixel[1] < 255 and pixel[1] == pixel[2]])

    def test_a_film_is_an_animated_png_in_which_things_move(self):
        chunks = self.drawn("film", "--duration", 1, "--rate", 5, "--width", 106)
        kinds = [kind for kind, _ in chunks]
        self.assertEqual((kinds[:2], kinds[-1]), (["IHDR", "acTL"], "IEND"))
        self.assertLess(kinds.index("fcTL"), kinds.index("IDAT"))
        about = dict(chunks)
        self.assertEqual(struct.unpack(">II", about["acTL"]), (6, 0))
        frames = [content for kind, content in chunks if kind == "fcTL"]
        self.assertEqual([struct.unpack(">IIIIIHHBB", frame)[1:7] for frame in frames], [(106, 106, 0, 0, 200, 1000)] * 6)
        numbers = [struct.unpack_from(">I", content)[0] for kind, content in chunks if kind in ("fcTL", "fdAT")]
        self.assertEqual(numbers, list(range(len(numbers))))
        pictures, packed = [], b""
        for kind, content in [*chunks, ("fcTL", b"")]:
            if kind == "fcTL" and packed:
                pictures.append(pixels_of(packed, 106, 106))
                packed = b""
            packed += content if kind == "IDAT" else content[4:] if kind == "fdAT" else b""
        self.assertEqual(len(pictures), 6)
        self.assertEqual(pictures[0][10], pictures[5][10])
        self.assertNotEqual(pictures[0][53], pictures[5][53], "the robot drives")

    def test_a_rate_that_no_film_reaches_gives_one_picture(self):
        self.assertEqual(struct.unpack(">II", dict(self.drawn("film", "--rate", "1e-300", "--width", 32))["acTL"]), (1, 0))

    def test_other_films_are_for_ffmpeg_which_may_not_be_there(self):
        world, film = self.write("w.world", WORLD), self.folder / "a.mp4"
        done = finish("film", world, "--renderer", "playhouse", "-o", film, env={**os.environ, "PATH": str(self.folder)})
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertIn("ffmpeg makes, which is not in PATH; -o FILE.png makes an animated PNG", done.stderr)
        tool = self.folder / "ffmpeg"
        tool.write_text(f'#!/bin/sh\n/usr/bin/wc -c > "{self.folder}/bytes"\necho "$@" > "{self.folder}/words"\n')
        tool.chmod(0o755)
        done = finish("film", world, "--renderer", "playhouse", "-o", film, "--duration", 1, "--width", 32, env={**os.environ, "PATH": str(self.folder)})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"^film: drawn by Playhouse in [0-9.]+ s\n$")
        self.assertEqual(int((self.folder / "bytes").read_text()), 11 * 32 * 32 * 3)
        self.assertIn(f"file:{film}", (self.folder / "words").read_text())
        tool.write_text("#!/bin/sh\nexit 3\n")
        done = finish("film", world, "--renderer", "playhouse", "-o", film, "--duration", 1, env={**os.environ, "PATH": str(self.folder)})
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)

    def test_what_ffmpeg_says_is_told_in_the_line_of_the_film(self):
        world, film, tool = self.write("w.world", WORLD), self.folder / "a.foo", self.folder / "ffmpeg"
        said = "[NULL @ 0x55d0] Unable to find a suitable output format\\n\\033[31mInvalid argument\\n"
        for reads in ("", "/usr/bin/wc -c > /dev/null\n"):   # ends before or after the pictures
            tool.write_text(f"#!/bin/sh\n{reads}printf '{said}' >&2\nexit 1\n")
            tool.chmod(0o755)
            done = finish("film", world, "--renderer", "playhouse", "-o", film, "--duration", 1,
                          env={**os.environ, "PATH": str(self.folder)})
            self.assertEqual((done.returncode, done.stderr),
                             (1, f"{film}: error: is not written: ffmpeg: Unable to find a suitable output format\n"))

    def test_an_output_that_cannot_be_written_is_told_before_anything_is_drawn(self):
        world = self.write("w.world", WORLD)
        (self.folder / "d.mp4").mkdir()
        (self.folder / "d.png").mkdir()
        locked = self.folder / "locked"
        locked.mkdir(mode=0o555)
        for command, output, why in (
                ("film", self.folder / "d.mp4", "Is a directory"), ("film", self.folder, "Is a directory"),
                ("film", self.folder / "d.png", "Is a directory"), ("picture", self.folder / "d.png", "Is a directory"),
                ("film", self.folder / "no" / "a.mp4", "No such file or directory"),
                ("film", world / "a.mp4", "Not a directory"),
                *([] if os.geteuid() == 0 else [("film", locked / "a.mp4", "Permission denied")])):
            with self.subTest(output):
                done = finish(command, world, "-o", output)
                self.assertEqual((done.returncode, done.stderr), (1, f"{output}: error: cannot be written: {why}\n"))

    def test_faults_are_told_in_a_line(self):
        world = self.write("w.world", WORLD)
        for words, code, told in (
                (("picture", world, "-o", "a.jpg"), 2, "a picture is a .png"),
                (("picture", world, "-o", self.folder / "no" / "a.png", "--renderer", "playhouse"), 1, "a.png"),
                (("picture", self.folder / "gone.world", "-o", self.folder / "a.png"), 2, "gone.world"),
                (("picture", world), 2, "--output is required"),
                (("picture", world, "-o", "a.png", "--width", 0), 2, "--width"),
                (("picture", world, "-o", "a.png", "--show", "rangr"), 2, 'invalid name "rangr": all,'),
                (("film", world, "-o", "a.png", "--show", "ranger,"), 2, 'invalid name ""'),
                (("picture", world, "-o", "a.png", "--renderer", "chromum"), 2, 'invalid renderer "chromum": chromium and playhouse are valid (did you mean "chromium"?)'),
                (("film", world, "-o", "a.png", "--duration", "1e300"), 2, "a billion pictures"),
                (("film", world, "-o", "a.png", "--rate", 0), 2, "--rate")):
            with self.subTest(words):
                done = finish(*words)
                self.assertEqual((done.returncode, len(done.stderr.splitlines())), (code, 1), done.stderr)
                self.assertIn(told, done.stderr)



class Chromium(HouseTest):
    """The page in a browser without a window, as it is installed, and what stands in for one that does not draw."""

    def setUp(self):
        super().setUp()
        self.tools, self.left = self.folder / "tools", self.folder / "left"
        self.tools.mkdir()
        self.left.mkdir()

    def real(self):
        """Chromium as this machine has it."""
        if not shutil.which("chromium") or not (ROOT / "web" / "dist" / "index.html").exists():
            self.skipTest("there is no chromium, or no built page")
        (self.tools / "chromium").symlink_to(shutil.which("chromium"))

    def fake(self, script: str):
        tool = self.tools / "chromium"
        tool.write_text(f"#!/bin/sh\n{script}\n")
        tool.chmod(0o755)

    def environment(self):
        """In which nothing but the tools is found, and what is left in the folder of temporary files can be seen."""
        return {**os.environ, "PATH": f"{self.tools}:/usr/bin:/bin" if (self.tools / "chromium").exists() else str(self.tools), "TMPDIR": str(self.left)}

    def draw(self, *words, world=WORLD) -> tuple[subprocess.CompletedProcess, Path]:
        file = self.folder / "made.png"
        file.unlink(missing_ok=True)
        done = subprocess.run([PROGRAM, words[0], self.write("w.world", world), "-o", file, *map(str, words[1:])], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=4 * PATIENCE, env=self.environment())
        self.assertEqual(list(self.left.iterdir()), [], "nothing is left")
        return done, file

    def drawn(self, *words, world=WORLD):
        done, file = self.draw(*words, world=world)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        self.assertRegex(done.stderr, rf"^{words[0]}: Chromium draws \({self.tools}/chromium\)\n{words[0]}: drawn by Chromium in [0-9.]+ s\n$")
        return chunks_of(file.read_bytes())

    def places(self, chunks):
        self.assertEqual(struct.unpack_from(">II", dict(chunks)["IHDR"]), (212, 212))
        rows = pixels_of(b"".join(content for kind, content in chunks if kind == "IDAT"), 212, 212)
        return lambda x, y: rows[round(106 - 25 * y)][round(106 + 25 * x)]

    def test_bodies_are_where_they_are_in_their_colors_from_above(self):
        self.real()
        at = self.places(self.drawn("picture", "--width", 212))
        red, green, blue = at(1.5, 0)
        self.assertTrue(red > 150 and max(green, blue) < 60, at(1.5, 0))
        red, green, blue = at(2.5, 0)
        self.assertTrue(blue > 150 and max(red, green) < 60, at(2.5, 0))
        red, green, blue = at(-3.3, -0.2)
        self.assertTrue(green > 80 and max(red, blue) < 60, at(-3.3, -0.2))
        self.assertGreater(min(at(0, 3)), 200, "white")
        self.assertGreater(min(at(-1, -2)), 200, "white")

    def test_what_sensors_see_is_drawn_where_the_other_renderer_draws_it(self):
        self.real()
        world = """
interval_sim 100
model( name "edge" size [8 8 0.1] color "white" obstacle_return 0 ranger_return -1 )
model( name "box" pose [2 0 0 0] size [2 2 0.9] color "red" )
position( name "r" pose [-3 0 0 0] size [1 1 0.3] color "green"
  ranger( size [0 0 0.1] sensor( range [0 6] fov 90 samples 91 ) ) camera( size [0.1 0.1 0.1] pose [0 0 0 90] range [0.2 3] fov [90 40] ) )
"""
        scan = self.places(self.drawn("picture", "--width", 212, "--at", 0.2, "--show", "ranger", world=world))
        self.assertGreater(scan(0, 0.7)[2], scan(0, 0.7)[0] + 20, "blue that one can see through")
        self.assertGreater(scan(1.5, 2.2)[2], scan(1.5, 2.2)[0] + 20, "past the box")
        self.assertLess(scan(2, 0)[2], 60, "it ends at the box")
        self.assertLess(max(scan(-3.2, 2.2)) - min(scan(-3.2, 2.2)), 20, "it looks 45 degrees to each side")
        camera = self.places(self.drawn("picture", "--width", 212, "--at", 0.2, "--show", "camera", world=world))
        self.assertGreater(camera(-3.2, 2.2)[2], camera(-3.2, 2.2)[1] + 10, "purple")
        self.assertLess(max(camera(0, 0.7)) - min(camera(0, 0.7)), 20)

    def test_films_have_the_same_pictures_of_the_same_view_in_which_things_move(self):
        self.real()
        chunks = self.drawn("film", "--duration", 1, "--rate", 2, "--width", 106)
        self.assertEqual(struct.unpack(">II", dict(chunks)["acTL"]), (3, 0))
        frames = [content for kind, content in chunks if kind == "fcTL"]
        self.assertEqual([struct.unpack(">IIIIIHHBB", frame)[1:5] for frame in frames], [(106, 106, 0, 0)] * 3)
        first, last = [pixels_of(b"".join(frame), 106, 106) for frame in self.frames(chunks)][::2]
        self.assertEqual(first[100], last[100])
        self.assertNotEqual(first[53], last[53], "the robot drives")

    def frames(self, chunks):
        """The packed pixels of each picture, in the parts that it came in."""
        pictures = []
        for kind, content in chunks:
            if kind == "fcTL":
                pictures.append([])
            elif kind in ("IDAT", "fdAT"):
                pictures[-1].append(content if kind == "IDAT" else content[4:])
        return pictures

    def own(self, *words):
        done, file = self.draw(*words, "--renderer", "playhouse")
        self.assertEqual(done.returncode, 0, done.stderr)
        return file.read_bytes()

    def test_without_chromium_the_other_renderer_draws_and_that_is_told(self):
        done, file = self.draw("picture", "--width", 100)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"^picture: Playhouse draws: there is no Chromium in PATH\npicture: drawn by Playhouse in [0-9.]+ s\n$")
        self.assertEqual(file.read_bytes(), self.own("picture", "--width", 100))
        done, file = self.draw("picture", "--renderer", "chromium")
        self.assertEqual((done.returncode, len(done.stderr.splitlines()), file.exists()), (1, 1, False), done.stderr)
        self.assertIn("there is no chromium or chromium-browser or google-chrome in PATH", done.stderr)

    def test_where_chromium_does_not_draw_the_other_renderer_does_unless_it_was_asked_for(self):
        for command in (("picture", "--width", 100, "--at", 0.5), ("film", "--width", 100, "--duration", 0.5)):
            self.fake("exit 7")
            with self.subTest(command):
                done, file = self.draw(*command)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertRegex(done.stderr, rf"(?m)^warning: {command[0]}: Chromium ended with exit code 7; Playhouse draws$")
                self.assertRegex(done.stderr, rf"(?m)^{command[0]}: drawn by Playhouse in")
                self.assertEqual(file.read_bytes(), self.own(*command))
                done, file = self.draw(*command, "--renderer", "chromium")
                self.assertEqual((done.returncode, file.exists()), (1, False), done.stderr)
                self.assertEqual([line for line in done.stderr.splitlines() if line.startswith("error")],
                                 ["error: Chromium ended with exit code 7; --renderer playhouse draws without it"])

    def test_a_browser_without_webgl_does_not_draw(self):
        self.real()
        (self.tools / "chromium").rename(self.tools / "real")
        self.fake(f'exec "{self.tools}/real" "$@" --disable-3d-apis')
        done, file = self.draw("picture", "--width", 100)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("warning: picture: Chromium has no WebGL 2; Playhouse draws\n", done.stderr)
        self.assertEqual(file.read_bytes(), self.own("picture", "--width", 100))

    def test_a_picture_that_is_too_large_for_the_browser_is_refused_by_name_alone(self):
        self.real()
        done, _ = self.draw("picture", "--width", 16384, "--renderer", "chromium", world='model( size [16 2 1] color "red" )')
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("error: Chromium cannot draw it: the picture is too large for this browser; --renderer playhouse", done.stderr)

    def test_an_interrupt_ends_the_browser_and_removes_its_folder(self):
        self.real()
        film = subprocess.Popen([PROGRAM, "film", self.write("w.world", WORLD), "-o", self.folder / "a.png", "--duration", "1e6"],
                                stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=self.environment())
        with film:
            self.assertIn("Chromium draws", film.stderr.readline())
            wait_until(lambda: self.browsers() or film.poll() is not None, "drawn by a browser")
            film.send_signal(signal.SIGINT)
            self.assertEqual((film.stderr.read(), film.wait(PATIENCE)), ("", 130))
        self.assertEqual(list(self.left.iterdir()), [])
        wait_until(lambda: not self.browsers(), "left by its processes")

    def browsers(self):
        """Processes that have the folder of temporary files among their words."""
        found = []
        for about in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                if bytes(self.left) in about.read_bytes():
                    found.append(about.parent.name)
            except OSError:
                pass  # it has ended
        return found


if __name__ == "__main__":
    unittest.main()
