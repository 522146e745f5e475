"""C programs as they were written for Player, built with the installed pkg-config package and nothing else, against the real
server: clients/c/playerc/tests."""

import csv
import json
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from house import ROOT, House, HouseTest, finish
from installed import tool

PROGRAMS = ROOT / "clients" / "c" / "playerc" / "tests"
OLD = ("-std=gnu89", "-Wall", "-Wextra", "-Werror")

# What printing.cc prints of each proxy: the word after the first number, or the first word.
PRINTED = re.compile(r"(?:[\d.]+ )?([\w%]+)")
WORDS = ("joints|voltages|audio|blackboard|blobs|bumpers|x|message|inputs|fiducials|latitude|graphics2d|graphics3d|state|%|pose|ranges|ranges|at|axes|"
         "hypotheses|reads|x|bytes|at|points|at|at|at|V|pan|ranges|tags|simulation|ranges|speech|words|x|layers|links|node")


class OldPrograms(HouseTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.place = Path(folder.name)
        tool("cmake", "-G", "Ninja", "-S", ROOT / "clients" / "c", "-B", cls.place / "build", "-DCMAKE_BUILD_TYPE=Debug")
        tool("cmake", "--build", cls.place / "build")
        tool("cmake", "--install", cls.place / "build", "--prefix", cls.place / "prefix")

    def flags(self, *what, package="playerc") -> list[str]:
        path = self.place / "prefix" / "lib" / "pkgconfig"
        return tool("pkg-config", *what, package, env={"PATH": "/usr/bin:/bin", "PKG_CONFIG_PATH": str(path)}).split()

    def build(self, name: str, *more, libraries=()) -> Path:
        program = self.folder / name
        tool("cc", *OLD, *self.flags("--cflags"), *more, PROGRAMS / f"{name}.c", *(libraries or self.flags("--libs")), "-o", program)
        return program

    def test_a_robot_wanders_by_its_laser(self):
        with self.run_house("--speed", 10) as house:
            said = tool(self.build("wander"), house.port()).splitlines()
        self.assertEqual(said[0], "size 0.40 0.40")
        self.assertEqual(said[1], "beams 181 start -1.5708 step 0.0175 max 8.0 bad 0")
        x, y, heading = map(float, said[2].split()[1:4])
        self.assertTrue(1.5 < x < 2.5 and abs(y) < 0.1 and 0.78 < heading < 1.6, said)
        self.assertEqual(said[2].split()[4:], ["time", "1"])

    def test_devices_are_listed_and_refusals_told(self):
        with self.run_house() as house:
            said = tool(self.build("devices"), house.port()).splitlines()
        self.assertRegex(said[0], r"^udp -1: udp:127\.0\.0\.1:\d+: .*Connection refused$")
        self.assertIn("position2d:1 (stage)", said)
        self.assertIn("ranger:3 (stage)", said)
        self.assertEqual(said[-5:], ["laser:7 -1 there is no laser:7", "driver stage", "nobody -2", "property -2", "r1 1.50 -2.00 0.50"])

    def test_a_robot_is_driven_by_udp(self):
        with House("run", self.world(), "--port", 0, "--web", "off", "--udp", "--speed", 10) as house:
            port = house.wait_for_line(r"^Player clients: 127\.0\.0\.1:(\d+) \(also UDP\)$").group(1)
            self.assertEqual(tool(self.build("udp"), port), "came 0.3, scans of 181 beams\n")

    def test_messages_are_read_one_by_one_until_the_run_ends(self):
        with self.run_house("--speed", 10) as house:
            program = subprocess.Popen([self.build("push"), str(house.port())], stdout=subprocess.PIPE, text=True)
            self.addCleanup(program.stdout.close)
            self.addCleanup(program.kill)
            self.assertEqual(program.stdout.readline(), "others 0 calls as many\n")
            house.end()
            self.assertRegex(program.communicate(timeout=60)[0], "the run ended")
            self.assertEqual(program.returncode, 0)

    def test_a_map_is_fetched(self):
        self.write("room.pgm", "P2 4 3 255 0 0 0 0 0 255 255 0 0 0 255 0")
        cfg = self.write("map.cfg", 'driver ( name "mapfile" provides ["map:0"] filename "room.pgm" resolution 0.5 )')
        with House("serve", cfg, "--port", 0) as house:
            said = tool(self.build("map"), house.port())
        self.assertEqual(said, "4 x 3 of 0.50 m from -1.0 -0.8\n####\n#..#\n##.#\n")

    def test_a_program_draws_in_the_frame_of_a_robot(self):
        self.world('position( name "r" )')
        cfg = self.write("draw.cfg", 'driver ( name "stage" provides ["simulation:0"] worldfile "test.world" )\n'
                                     'driver ( name "stage" provides ["graphics2d:0" "graphics3d:0"] model "r" )')
        with House("serve", cfg, "--port", 0, "--headless", "--record", self.folder / "run.mcap") as house:
            tool(self.build("drawing"), house.port())
            house.end()
        changes = [line for line in finish("export", self.folder / "run.mcap", "--changes").stdout.splitlines() if ",draw," in line]
        drawn = [json.loads(row[-1]) for row in csv.reader(changes)]
        outline = [[1, -0.5], [1, 0.5], [1, 0.5], [2, 0], [2, 0], [1, -0.5]]
        self.assertEqual([(each["layer"], each["corners"], round(each["color"][3], 2)) for each in drawn], [(0, 3, 0.2), (0, 2, 1), (1, 2, 1)])
        self.assertEqual({tuple(p[:2]) for p in drawn[0]["points"]} - {(2, 0), (1, -0.5), (1, 0.5), (1, 0)}, set())
        self.assertEqual([p[:2] for p in drawn[1]["points"]], outline)
        self.assertEqual(drawn[2]["points"], [[0, 0, 0.5], [0, 0, 1.5]])

    def test_values_of_a_blackboard_are_set_by_their_type(self):
        with House("serve", ROOT / "worlds" / "board.cfg", "--port", 0, "--headless") as house:
            self.assertEqual(tool(self.build("texts"), house.port()), "111\n")

    def test_a_robot_is_told_where_it_is_with_three_variances_or_six(self):
        with House("serve", ROOT / "worlds" / "navigate.cfg", "--port", 0, "--headless") as house:
            said = tool(self.build("place"), house.port())
        self.assertEqual(said, "x -5.0 y -4.5 variance 0.01, map 0\nsix 0\n")

    def test_several_servers_are_read_together(self):
        with self.run_house("--speed", 10) as one, self.run_house("--speed", 10) as other:
            said = tool(self.build("several"), one.port(), other.port()).splitlines()
        self.assertEqual(said[-1], "time 1")
        for line in said[:2]:
            self.assertRegex(line, r"^181 ranges, 181 points, the middle one at 2\.\d\d (-0|0)\.00$")

    def test_a_program_may_be_linked_without_shared_libraries(self):
        folder = self.place / "prefix" / "lib"
        libraries = [folder / "libplayerc.a", folder / "libplayhouse_c.a", "-lturbojpeg", "-lz", "-lm"]
        with self.run_house() as house:
            self.assertIn("driver stage", tool(self.build("devices", libraries=libraries), house.port()))

    def test_a_program_without_packages_of_others_is_built(self):
        alone = {"PATH": "/usr/bin:/bin", "PKG_CONFIG_LIBDIR": str(self.place / "only")}
        (self.place / "only").mkdir()
        for name in ("playerc", "playhouse_c"):
            shutil.copy(self.place / "prefix" / "lib" / "pkgconfig" / f"{name}.pc", self.place / "only")
        (self.place / "only" / "zlib.pc").write_text("Name: zlib\nDescription: as anywhere\nVersion: 1\nLibs: -lz\n")
        self.assertIn("player-3.1", tool("pkg-config", "--cflags", "playerc", env=alone))
        self.assertNotIn("-lturbojpeg", tool("pkg-config", "--libs", "playerc", env=alone))
        self.assertIn("-lturbojpeg", tool("pkg-config", "--libs", "--static", "playerc", env=alone))

    def build_cpp(self, name: str) -> Path:
        program = self.folder / name
        tool("c++", "-std=c++11", "-Wall", "-Wextra", "-Werror", *self.flags("--cflags", package="playerc++"), PROGRAMS / f"{name}.cc",
             *self.flags("--libs", package="playerc++"), "-o", program)
        return program

    def test_equipment_in_cpp_is_read_and_told(self):
        with House("serve", ROOT / "worlds" / "dummy.cfg", "--port", 0, "--headless") as house:
            said = tool(self.build_cpp("equipment"), house.port()).splitlines()
        self.assertEqual(said, ["lift 0", "tags 1", "node 1", "radio dummy 1 1", "health 1", "board 1", "audio dummy- 1", "map 1 1",
                                "eyes 64x48 9216 1", "cloud 1", "camera 0", "laser -1.5 1.5 0.5 0.01 1 25", "mote 1 1",
                                "WiFiProxy::GetLink()(-1): there is no such link"])

    def test_every_proxy_in_cpp_is_printed_and_a_program_may_have_its_own(self):
        with House("serve", ROOT / "worlds" / "dummy.cfg", "--port", 0, "--headless") as house:
            program = subprocess.run([self.build_cpp("printing"), str(house.port())], capture_output=True, text=True, timeout=60)
        said = program.stdout.splitlines()
        self.assertEqual(said[:3], ["1 2, 1 2 3, 1 2 3, 1 2 3 4 5 6", "1 2, 1 2 3, 1 2 to 3 4, 1 2 to 3 4", "power:0 (dummy)"])
        self.assertEqual([PRINTED.match(line).group(1) for line in said[3:-5]], WORDS.split("|"))
        self.assertEqual(said[-5:], ["before data 0 0", "after it 0 0", "RangerProxy(-1): there is no element 999 of 181 of ranger",
                                     "late 0 1 1 1", "own 3 1 120"])
        self.assertRegex(program.stderr, r"\AClientProxy: there is no element 99 of \d of ir: zeros\n\Z")

    def test_functions_that_are_connected_are_called_after_data_until_they_are_not(self):
        with House("serve", ROOT / "worlds" / "dummy.cfg", "--port", 0, "--headless") as house:
            program = subprocess.Popen([self.build_cpp("signals"), str(house.port())], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE, text=True)
            self.addCleanup(program.kill)
            said = ["5 5 1 0\n", "5 6\n", "destroyed 0 0\n", "in a thread\n", "again after each\n"]
            self.assertEqual([program.stdout.readline() for _ in said], said)
            self.assertEqual(program.stderr.readline(), "PlayerClient::StartThread(): no idea\n")
            house.end()
            self.assertIn("the run ended", program.stderr.readline())
            self.assertEqual((program.communicate("\n", timeout=60)[0], program.returncode), ("over\n", 0))

    def test_a_robot_in_cpp_drives_along_and_exceptions_tell_what_fails(self):
        program = self.build_cpp("drive")
        with self.run_house("--speed", 10) as house:
            said = tool(program, house.port()).splitlines()
        self.assertEqual(said[0], f"localhost:{house.port()}")
        self.assertRegex(said[1], r"^at 1\.\d+ 0 0, speed 0\.\d+ 0 0$")
        self.assertEqual(said[2:5], ["181 181 2 ranges", "where it is: as its odometry says", "-1 0.3 1.5708"])
        self.assertRegex(said[5], r"^RangerProxy\(-1\): there is no element 181 of 181 of ranger$")
        self.assertRegex(said[6], r"^ClientProxy\(-1\): .*there is no sonar:9$")

    def test_a_new_program_links_the_shared_library_by_pkg_config(self):
        examples = ROOT / "clients" / "c" / "examples"
        flags = self.flags("--cflags", "--libs", package="playhouse_c")
        tool("cc", "-std=c11", examples / "square.c", examples / "program.c", *flags, "-o", self.folder / "square")
        said = subprocess.run([self.folder / "square", "127.0.0.1:65536"], capture_output=True, text=True)
        self.assertIn("127.0.0.1:65536", said.stderr, "it is loaded and refuses the port")
        needed = tool("readelf", "-d", self.folder / "square")
        self.assertRegex(needed, r"libplayhouse_c\.so\.\d+\.\d+\]")

    def test_the_parts_of_the_header_in_cpp_are_included_alone(self):
        for part in ("playererror", "playerclient", "clientproxy", "utility", "playerc++config"):
            source = self.write("part.cc", f"#include <libplayerc++/{part}.h>\nint main() {{ return 0; }}\n")
            tool("c++", "-std=c++11", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", *self.flags("--cflags", package="playerc++"), source)

    def test_the_headers_are_of_cpp_as_well_and_clash_with_none_of_ours(self):
        source = self.write("both.cc", "#include <libplayerc/playerc.h>\n#include <playhouse/c.h>\n"
                                       "int main() { return PLAYER_LASER_CODE == PH_LASER_CODE ? 0 : 1; }\n")
        include = self.place / "prefix" / "include"
        tool("c++", "-Wall", "-Wextra", "-Werror", *self.flags("--cflags"), f"-I{include}", source, "-o", self.folder / "both", *self.flags("--libs"))
        tool(self.folder / "both")


if __name__ == "__main__":
    unittest.main()
