"""Worlds for older versions of Stage: they run, and `convert` writes them in today's words, which run the same."""

import contextlib
import json
import math
import os
import struct
import unittest
from pathlib import Path

from house import ROOT, HouseTest, finish

OLD = """
size [16 16]
interval_real 100
window( scale 0.028 rangerdata 1 )
define sonars ranger( scount 3 spose[0] [0.1 0.1 50] spose[1] [0.1 0 0] spose[2] [0.1 -0.1 -50] sview [0 5 15] ssize [0.01 0.05] )
define sick laser( range_max 8 samples 361 size [0.14 0.14] )
define robot position( size [0.44 0.33] polygons 1 polygon[0].points 3
  polygon[0].point[0] [0.2 0] polygon[0].point[1] [-0.2 0.1] polygon[0].point[2] [-0.2 -0.1] sonars() ctrl "wander" )
player( port 6665 )
map( bitmap "plan.pbm" size [16 16] name "plan" )
robot( name "r0" pose [-3 -2 45] sick( pose [0.04 0 0] samples 180 ) )
robot( name "r1" pose [1 2 90] velocity [0.3 0 0 20] laser() truth() )
puck( pose [1 1 0] laser_return 0 )
"""


class Convert(HouseTest):
    def hash_of(self, world) -> str:
        done = finish("run", world, "--headless", "--fast", "--port", "0", "--duration", "1", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["hash"]

    def test_a_converted_world_runs_as_the_old_one_and_has_no_old_words(self):
        self.write("plan.pbm", "P1 4 4 1111 1001 1001 1111\n")
        old, new = self.write("old.world", OLD), self.folder / "new.world"
        done = finish("convert", old, "-o", new)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        self.assertIn('old.world:6: warning: "laser" is a type of older versions: write ranger(', done.stderr)
        self.assertEqual(finish("check", new).stdout.strip().splitlines()[:-1], [])
        self.assertEqual(self.hash_of(new), self.hash_of(old))

    def test_without_a_name_the_world_is_printed(self):
        done = finish("convert", self.write("old.world", "laser( samples 5 )"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("samples 5", done.stdout)
        self.assertNotIn("laser", done.stdout.replace("model", ""))

    def test_a_world_is_not_written_over(self):
        old = self.write("old.world", OLD)
        done = finish("convert", old, "-o", old)
        self.assertEqual(done.returncode, 2)
        self.assertIn("is what is read", done.stderr)
        self.assertEqual(old.read_text(), OLD)

    def test_what_a_world_is_made_of_is_not_written_over(self):
        files = {"plan.pgm": "P2 2 2 255 0 255 0 0", "walls.inc": 'define walls model( bitmap "plan.pgm" size [2 2 1] )',
                 "plan.world": 'include "walls.inc"\nwalls( )\n'}
        for name, content in files.items():
            self.write(name, content)
        (self.folder / "linked.world").symlink_to("walls.inc")
        for output in ("plan.yaml", "walls.inc", "./linked.world", "plan.pgm"):
            done = finish("convert", self.folder / "plan.world", "-o", self.folder / output)
            self.assertEqual(done.returncode, 2, output)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertRegex(done.stderr, "error: is (what is read|an image)")
            for name, content in files.items():
                self.assertEqual((self.folder / name).read_text(), content)
        self.assertFalse((self.folder / "plan.yaml").exists())

    def test_a_world_is_not_written_as_an_image(self):
        made = self.folder / "w.png"
        done = finish("convert", self.write("w.world", "model( )"), "-o", made)
        self.assertEqual((done.returncode, done.stderr),
                         (2, f"{made}: error: is an image: a world is written as .world, a map as .yaml, bodies as .glb\n"))
        self.assertFalse(made.exists())

    def test_an_image_that_is_not_read_is_told_with_those_that_are(self):
        (self.folder / "plan.gif").write_bytes(b"GIF89a\x01\0\x01\0\0\0\0;")
        done = finish("convert", self.folder / "plan.gif", "--scale", "0.05", "-o", self.folder / "new.world")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"plan\.gif: error: is an image of a kind that is not read: PNG, JPEG, .* and BMP are\n$")
        (self.folder / "plan.jpg").write_bytes(b"GIF89a\x01\0\x01\0\0\0\0;")
        done = finish("convert", self.folder / "plan.jpg", "--scale", "0.05")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"plan\.jpg: error: is not a PNG, JPEG, .* or BMP image\n$")

    def test_what_is_no_world_is_told_with_what_reads_it(self):
        """Whatever wants a world says in one line what it got."""
        image = (ROOT / "worlds" / "bitmaps" / "cave.png").read_bytes()
        files = {"plan.png": (image, "is an image, not a world: playhouse convert"), "plan.jpg": (b"\xff\xd8\xff\xe0 and so on", "is an image"),
                 "plan": (image, "is an image"), "room.pbm": (b"P1 2 2 0 1 1 0", "is an image"), "map.yaml": (b"image: m.pgm\n", "is a map of ROS"),
                 "table.stl": (b"solid table\n", "is a mesh"), "run.world": (b"\x89MCAP0\r\n", "is a recording"),
                 "cave.run": (b"playhouse saved run 1", "is a saved run")}
        for name, (content, told) in files.items():
            file = self.folder / name
            file.write_bytes(content)
            for command in ("check", "run"):
                with self.subTest((name, command)):
                    done = finish(command, file, *(["--headless", "--duration", 1, "--port", 0] if command == "run" else []))
                    self.assertEqual(done.returncode, 2)
                    lines = (done.stdout + done.stderr).splitlines()
                    self.assertEqual(len(lines), 1, lines)
                    self.assertIn(f"{file}: error: {told}", lines[0])

    def test_an_empty_world_is_told(self):
        world = self.write("empty.world", 'name "nothing"\n')
        told = f"{world}:1: warning: there is no model in it: the world is empty"
        done = finish("check", world)
        self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (0, told), done.stdout)
        self.assertEqual(finish("check", "--strict", world).returncode, 2)
        done = finish("run", world, "--fast", "--headless", "--duration", 1, "--port", 0)
        self.assertEqual((done.returncode, done.stderr.count(told)), (0, 1), done.stderr)
        done = finish("check", self.write("some.world", "model( )"))
        self.assertNotIn("empty", done.stdout)

    def test_a_world_with_faults_is_told(self):
        done = finish("convert", self.write("old.world", "laser( pose [1] )"), "-o", self.folder / "new.world")
        self.assertEqual(done.returncode, 2)
        self.assertIn("old.world:1: error:", done.stderr)
        self.assertFalse((self.folder / "new.world").exists())

    def glb(self, world: str, *files):
        """The parts of the .glb that is made of a world: what its JSON says, and its bytes."""
        for name, text in files:
            self.write(name, text)
        made = self.folder / "made.glb"
        done = finish("convert", self.write("w.world", world), "-o", made)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        data = made.read_bytes()
        magic, version, length, json_length, json_type = struct.unpack_from("<4sIII4s", data)
        self.assertEqual((magic, version, length, json_type, json_length % 4), (b"glTF", 2, len(data), b"JSON", 0))
        about = json.loads(data[20:20 + json_length])
        if "buffers" not in about:
            self.assertEqual(len(data), 20 + json_length)
            return about, b""
        binary_length, binary_type = struct.unpack_from("<I4s", data, 20 + json_length)
        self.assertEqual((binary_type, binary_length % 4, 28 + json_length + binary_length), (b"BIN\0", 0, len(data)))
        self.assertLess(binary_length - about["buffers"][0]["byteLength"], 4)
        return about, data[28 + json_length:]

    def elements(self, about, binary: bytes, accessor: int):
        """What an accessor holds, after its bounds."""
        found = about["accessors"][accessor]
        view = about["bufferViews"][found["bufferView"]]
        width, letter = {("VEC3", 5126): (3, "f"), ("SCALAR", 5125): (1, "I")}[found["type"], found["componentType"]]
        self.assertEqual(view["byteLength"], found["count"] * width * 4)
        self.assertLessEqual(view["byteOffset"] + view["byteLength"], about["buffers"][0]["byteLength"])
        values = struct.unpack_from(f"<{found['count'] * width}{letter}", binary, view["byteOffset"])
        return [values[k:k + width] for k in range(0, len(values), width)]

    def test_a_world_becomes_glTF_whose_meshes_are_closed_and_as_large_as_the_bodies(self):
        about, binary = self.glb("""
            name "w"
            define post model( size [0.2 0.4 1] color "red" )
            post( name "a" pose [1 2 0 90] ) post( name "b" pose [3 2 0.5 0] ) post( name "c" color "blue" )
            model( name "walls" size [4 4 1] bitmap "plan.pbm" )
            position( name "r" pose [0 0 0 45] size [0.4 0.4 0.2] origin [0.1 0 0 0] ranger( name "eye" size [0 0 0] pose [0.1 0 0 0] ) )""",
                                 ("plan.pbm", "P1 4 4 1111 1001 1001 1111\n"))
        nodes = {node["name"]: node for node in about["nodes"]}
        self.assertEqual(set(nodes), {"a", "b", "c", "walls", "r", "r.eye", "w"})
        self.assertEqual([about["nodes"][k]["name"] for k in about["scenes"][0]["nodes"]], ["w"])
        self.assertEqual(sorted(about["nodes"][k]["name"] for k in nodes["w"]["children"]), ["a", "b", "c", "r", "walls"])
        self.assertEqual([about["nodes"][k]["name"] for k in nodes["r"]["children"]], ["r.eye"])
        self.assertEqual(nodes["b"]["translation"], [3, 2, 0.5])
        self.assertEqual(nodes["a"]["mesh"], nodes["b"]["mesh"])
        self.assertNotEqual(nodes["a"]["mesh"], nodes["c"]["mesh"], "another color")
        self.assertNotIn("mesh", nodes["r.eye"])
        volumes = {}
        for name, node in nodes.items():
            if "mesh" not in node:
                continue
            primitive = about["meshes"][node["mesh"]]["primitives"][0]
            points = self.elements(about, binary, primitive["attributes"]["POSITION"])
            normals = self.elements(about, binary, primitive["attributes"]["NORMAL"])
            corners = [k for (k,) in self.elements(about, binary, primitive["indices"])]
            self.assertEqual(len(points), len(normals))
            self.assertEqual((len(corners) % 3, max(corners) < len(points)), (0, True))
            accessor = about["accessors"][primitive["attributes"]["POSITION"]]
            for axis in range(3):
                self.assertAlmostEqual(accessor["min"][axis], min(p[axis] for p in points), 5)
                self.assertAlmostEqual(accessor["max"][axis], max(p[axis] for p in points), 5)
            # A closed surface, counter-clockwise seen from outside, holds what the divergence theorem says.
            volumes[name] = 0
            for k in range(0, len(corners), 3):
                (a, b, c), normal = (points[j] for j in corners[k:k + 3]), normals[corners[k]]
                cross = [(b[i - 2] - a[i - 2]) * (c[i - 1] - a[i - 1]) - (b[i - 1] - a[i - 1]) * (c[i - 2] - a[i - 2]) for i in range(3)]
                self.assertGreater(sum(cross[i] * normal[i] for i in range(3)), 0)
                volumes[name] += sum(a[i] * cross[i] for i in range(3)) / 6
        self.assertAlmostEqual(volumes["a"], 0.2 * 0.4 * 1, 6)
        self.assertAlmostEqual(volumes["walls"], 12, 4)
        self.assertAlmostEqual(volumes["r"], 0.4 * 0.4 * 0.2, 6)

    def test_what_is_tilted_is_so_in_glTF(self):
        about, _ = self.glb('model( name "plank" pose [1 2 3 90] tilt [0 -30] size [2 0.4 0.1] )')
        node = next(node for node in about["nodes"] if node["name"] == "plank")
        (zs, zc), (ys, yc) = ((math.sin(math.radians(a / 2)), math.cos(math.radians(a / 2))) for a in (90, -30))
        for is_, should in zip(node["rotation"], (-zs * ys, zc * ys, zs * yc, zc * yc)):  # qz qy
            self.assertAlmostEqual(is_, should, 6)

    def test_an_empty_world_is_glTF_without_buffers_and_a_plan_is_none(self):
        about, _ = self.glb('name "nothing"')
        self.assertEqual([node["name"] for node in about["nodes"]], ["nothing"])
        plan = self.write("plan.pbm", "P1 2 2 1111\n")
        for source, target, told in ((plan, "a.glb", "convert the plan to a .world first"), ("w.world", "a.gltf", "name it .glb")):
            done = finish("convert", self.folder / source, "--scale", 1, "-o", self.folder / target)
            self.assertEqual(done.returncode, 2)
            self.assertIn(told, done.stderr)
            self.assertFalse((self.folder / target).exists())

    def test_a_floor_plan_becomes_a_world_that_runs_and_a_map_and_a_world_again(self):
        room = "P1 40 30\n" + "\n".join("".join("1" if x in (0, 39) or y in (0, 29) else "0" for x in range(40)) for y in range(30)) + "\n"
        plan = self.write("plan.pbm", room)
        for command in (("convert", plan, "--scale", "0.1", "-o", self.folder / "plan.world"),
                        ("convert", self.folder / "plan.world", "-o", self.folder / "map.yaml", "--scale", "0.1"),
                        ("convert", self.folder / "map.yaml", "-o", self.folder / "again.world")):
            done = finish(*command)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertIn("origin: [-2.1, -1.6, 0]", (self.folder / "map.yaml").read_text())
        self.assertEqual(self.hash_of(self.folder / "plan.world"), self.hash_of(self.folder / "plan.world"))
        walls = [line for name in ("plan", "again") for line in (self.folder / f"{name}.world").read_text().splitlines() if "bitmap" in line]
        self.assertIn("size [4 3 0.6] pose [0 0 0 0]", walls[0])
        self.assertIn("size [4 3 0.6] pose [0 0 0 0]", walls[1])

    def test_a_plan_that_no_world_can_hold_is_refused_and_one_without_room_for_the_robot_is_told(self):
        plan = self.write("plan.pbm", "P1 3 1 1 0 1")
        for scale in ("1e9", "1e30"):
            done = finish("convert", plan, "--scale", scale, "-o", self.folder / "far.world")
            self.assertEqual((done.returncode, done.stderr),
                             (2, f"{plan}: error: has a place or a size beyond 1e9 m, the largest number of a world file\n"))
            self.assertFalse((self.folder / "far.world").exists())
        done = finish("convert", plan, "--scale", "1e8", "-o", self.folder / "wide.world")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(finish("check", self.folder / "wide.world").returncode, 0)
        black = self.write("black.pbm", "P1 2 1 1 1")
        done = finish("convert", black, "--scale", "1", "-o", self.folder / "black.world")
        self.assertEqual((done.returncode, done.stderr), (0, f"warning: {black}: has no free pixel, so the world has no robot\n"))

    def test_an_image_wants_its_scale_and_a_map_its_keys(self):
        done = finish("convert", self.write("plan.pbm", "P1 1 1 1"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("--scale", done.stderr)
        os.mkfifo(self.folder / "pipe.pgm")
        for endless in ("/dev/zero", "pipe.pgm"):
            done = finish("convert", self.write("map.yaml", self.MAP.format(endless)))
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, r"error: cannot be opened: not a regular file\n$")
        done = finish("convert", self.write("map.yaml", "image: plan.pbm\nresoluton: 1\n"))
        self.assertEqual(done.returncode, 2)
        self.assertIn('map.yaml:2: error: there is no key "resoluton" (did you mean "resolution"?)', done.stderr)

    ROOM = "P2 4 4 255 " + "0 0 0 0 0 254 254 0 0 254 254 0 0 0 0 0\n"
    MAP = "image: {}\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"

    def test_a_world_names_its_image_from_any_folder_and_through_links(self):
        (self.folder / "maps").mkdir()
        (self.folder / "data" / "worlds").mkdir(parents=True)
        (self.folder / "link").symlink_to("data/worlds")
        self.write("maps/m.pgm", self.ROOM)
        self.write("maps/map.yaml", self.MAP.format("m.pgm"))
        with contextlib.chdir(self.folder / "maps"):
            for output in ("../x.world", "../link/x.world", "../data/worlds/y.world", "./z.world", str(self.folder / "maps/../a.world")):
                for source in (("map.yaml",), ("m.pgm", "--scale", "0.5")):
                    with self.subTest(output, source=source):
                        done = finish("convert", *source, "-o", output)
                        self.assertEqual(done.returncode, 0, done.stderr)
                        self.assertIn('bitmap "', Path(output).read_text())
                        self.assertNotIn(str(self.folder), Path(output).read_text(), "the path is relative")
                        done = finish("check", output)
                        self.assertEqual(done.returncode, 0, done.stderr)
                        written = self.folder / "data" / "worlds" / "again.world"
                        done = finish("convert", output, "-o", "../link/again.world")
                        self.assertEqual(done.returncode, 0, done.stderr)
                        self.assertEqual(finish("check", written).returncode, 0)

    def test_a_map_of_another_machine_is_read(self):
        self.write("m.pgm", self.ROOM)
        file = self.write("map.yaml", self.MAP.format("/home/robot/maps/m.pgm") + "floor: 2\n")
        done = finish("convert", file, "-o", self.folder / "lab.world")
        self.assertEqual((done.returncode, done.stderr.splitlines()), (0, [
            f'{file}:7: warning: there is no key "floor"; it has no effect',
            f'warning: {file}: there is no "/home/robot/maps/m.pgm"; "{self.folder}/m.pgm" is read instead']))
        self.assertEqual(finish("check", self.folder / "lab.world").returncode, 0)


if __name__ == "__main__":
    unittest.main()
