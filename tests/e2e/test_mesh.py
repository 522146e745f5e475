"""Meshes as a user meets them: worlds/mesh.world in both engines, saved and converted; files of another program; files
that are missing, broken or hostile."""

import json
import re
import shutil
import struct
import subprocess
import unittest

from house import ROOT, HouseTest, finish

MESH = ROOT / "worlds" / "mesh.world"


class Mesh(HouseTest):
    def run_of(self, world, engine, *more) -> dict:
        done = finish("run", world, "--engine", engine, "--headless", "--fast", "--port", "0", "--duration", "3", "--json", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_the_world_of_meshes_loads_without_a_word_and_runs_the_same_with_more_workers(self):
        done = finish("check", MESH)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        self.run_of(MESH, "stage")
        self.assertEqual(self.run_of(MESH, "arena", "--workers", "1")["hash"], self.run_of(MESH, "arena", "--workers", "3")["hash"])

    def test_looks_change_no_run(self):
        """The truth is the same world without them."""
        shutil.copytree(ROOT / "worlds", self.folder / "bare")
        words = 0
        for file in (self.folder / "bare").glob("*.inc"):
            text, count = re.subn(r'look "[^"]*"', "", file.read_text())
            file.write_text(text)
            words += count
        self.assertGreater(words, 5)
        for name in ("cave", "lab", "simple", "plan"):
            for engine in ("stage", "arena"):
                with self.subTest((name, engine)):
                    self.assertEqual(self.run_of(ROOT / "worlds" / f"{name}.world", engine)["hash"],
                                     self.run_of(self.folder / "bare" / f"{name}.world", engine)["hash"])

    def test_every_look_is_as_large_as_its_robot_and_may_be_written_again(self):
        for name in ("pioneer2dx", "pioneer3dx", "pioneer3at", "amigobot", "roomba", "footbot"):
            include = {"roomba": "irobot", "footbot": "footbot"}.get(name, "pioneer")
            world = self.write(f"{name}.world", f'include "{include}.inc"\n{name}( name "r" color "blue" )\n')
            made, again = self.folder / "made.glb", self.folder / "again.world"
            for output in (made, again):
                done = finish("convert", world, "-o", output)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(f'looks/{name}.obj"', again.read_text())
            self.assertEqual(finish("check", again).returncode, 0)
            data = made.read_bytes()
            (length,) = struct.unpack_from("<I", data, 12)
            text = json.loads(data[20:20 + length])
            node = next(node for node in text["nodes"] if "mesh" in node)
            colors = [material["pbrMetallicRoughness"]["baseColorFactor"] for material in text["materials"]]
            self.assertIn([0, 0, 1, 1], colors, "the color of the robot")
            self.assertNotIn([1, 1, 1, 1], colors)
            boxes = [text["accessors"][part["attributes"]["POSITION"]] for part in text["meshes"][node["mesh"]]["primitives"]]
            extent = [max(box["max"][k] for box in boxes) - min(box["min"][k] for box in boxes) for k in range(3)]
            size = re.search(r"size \[([^]]*)\]", finish("convert", world).stdout).group(1).split()
            self.assertEqual([round(x, 3) for x in extent], [round(float(x), 3) for x in size])

    def test_a_world_that_is_written_again_runs_the_same(self):
        again = self.folder / "again.world"
        done = finish("convert", MESH, "-o", again)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('meshes/barrel.dae"', again.read_text())
        self.assertEqual(self.run_of(again, "arena")["hash"], self.run_of(MESH, "arena")["hash"])

    def test_a_gltf_of_the_world_has_materials_and_textures_of_its_meshes(self):
        made = self.folder / "made.glb"
        done = finish("convert", MESH, "-o", made)
        self.assertEqual(done.returncode, 0, done.stderr)
        bytes_ = made.read_bytes()
        (length,) = struct.unpack_from("<I", bytes_, 12)
        text = json.loads(bytes_[20:20 + length])
        self.assertEqual(len(text["images"]), 1)
        self.assertIn("TEXCOORD_0", json.dumps(text["meshes"]))

    def test_the_turned_scaled_and_unfitted_run_the_same_when_written_again(self):
        ramp = ROOT / "worlds/meshes/ramp.dae"
        shutil.copy(ramp, self.folder / "ramp.dae")
        world = self.write("a.world", """interval_sim 100
model( name "wall" mesh "ramp.dae" mesh_pose [0 0 0 90 0 45] pose [2 0 0 0] )
model( name "far" mesh "ramp.dae" mesh_fit 0 mesh_scale [0.5 -0.5 0.5] mesh_pose [-2 1 0.1 0 0 30] size [1 1 1] stack_children 0 )
position( pose [-1 0 0 0] velocity [0.5 0 0 0] ranger( sensor( samples 19 fov 180 range [0 8] ) ) )
""")
        again = self.folder / "again.world"
        done = finish("convert", world, "-o", again)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for word in ("mesh_pose [0 0 0 90 0 45]", "mesh_scale [0.5 -0.5 0.5]", "mesh_fit 0"):
            self.assertIn(word, again.read_text())
        for engine in ("stage", "arena"):
            self.assertEqual(self.run_of(again, engine)["hash"], self.run_of(world, engine)["hash"])

    def test_an_stl_is_the_body_that_check_tells_the_size_of(self):
        corners = [(x, y, z) for x in (0, 1000) for y in (0, 2000) for z in (0, 500)]
        sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        triangles = [tuple(side[k] for k in three) for side in sides for three in ((0, 1, 2), (0, 2, 3))]
        (self.folder / "box.stl").write_bytes(bytes(80) + struct.pack("<I", len(triangles)) + b"".join(
            bytes(12) + b"".join(struct.pack("<3f", *corners[k]) for k in triangle) + bytes(2) for triangle in triangles))
        done = finish("check", self.write("a.world", 'model( mesh "box.stl" mesh_scale 0.001 mesh_pose [0 0 0 0 0 90] )'))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("box.stl: a mesh of 2 x 1 x 0.5 m\n", done.stdout)
        self.assertNotIn("m large", done.stdout)
        done = finish("check", self.write("a.world", 'model( mesh "box.stl" )'))
        self.assertRegex(done.stdout, r'a\.world:1: warning: mesh "[^"]*box\.stl" is 1000 x 2000 x 500 m large: mesh_scale')

    @unittest.skipUnless(shutil.which("assimp"), "assimp-utils is not installed")
    def test_files_of_another_program_are_the_same_body(self):
        hashes = set()
        for ending in ("dae", "glb2", "obj", "stl", "stlb"):
            name = f"ramp.{'stl' if ending == 'stlb' else ending.rstrip('2')}"
            subprocess.run(["assimp", "export", ROOT / "worlds/meshes/ramp.dae", self.folder / name, f"-f{'collada' if ending == 'dae' else ending}"],
                           check=True, capture_output=True)
            up = "mesh_pose [0 0 0 90 0 0] " if name.endswith("stl") else ""  # written as it is inside of assimp: y up
            world = self.write("a.world", f'interval_sim 100\nmodel( mesh "{name}" {up})\nposition( pose [-2 0 0 0] velocity [0.5 0 0 0] '
                               "ranger( sensor( samples 9 fov 90 range [0 8] ) ) )\n")
            hashes.add(self.run_of(world, "arena")["hash"])
        self.assertEqual(len(hashes), 1)

    def test_what_is_wrong_with_a_file_is_one_line(self):
        self.write("empty.obj", "v 0 0 0\n")
        self.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n")
        self.write("none.dae", "<nothing/>")
        self.write("half.stl", "solid half\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n")
        self.write("endless.dae", (ROOT / "worlds/meshes/ramp.dae").read_text().replace(
            '<instance_geometry url="#ramp">', '<instance_node url="#top"/><instance_geometry url="#ramp">'))
        for name, what in (("gone.dae", "cannot be opened: no such file"), ("empty.obj", ""), ("nan.obj", ""), ("none.dae", "cannot be read: "),
                           ("half.stl", "is broken in line 5: it ends before its endsolid"),
                           ("endless.dae", "has nodes more than 128 deep, or one that is inside itself")):
            world = self.write("a.world", f'\nmodel( mesh "{name}" )\n')
            done = finish("run", world, "--headless", "--port", "0", "--duration", "1")
            self.assertEqual(done.returncode, 2, name)
            self.assertRegex(done.stderr, rf'a\.world:2: error: mesh "[^"]*{name}" {what}')
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)


if __name__ == "__main__":
    unittest.main()
