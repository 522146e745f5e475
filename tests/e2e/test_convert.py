"""Worlds for older versions of Stage: they run, and `convert` writes them in today's words, which run the same."""

import json
import unittest

from house import HouseTest, finish

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

    def test_a_world_with_faults_is_told(self):
        done = finish("convert", self.write("old.world", "laser( pose [1] )"), "-o", self.folder / "new.world")
        self.assertEqual(done.returncode, 2)
        self.assertIn("old.world:1: error:", done.stderr)
        self.assertFalse((self.folder / "new.world").exists())

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

    def test_an_image_wants_its_scale_and_a_map_its_keys(self):
        done = finish("convert", self.write("plan.pbm", "P1 1 1 1"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("--scale", done.stderr)
        done = finish("convert", self.write("map.yaml", "image: plan.pbm\nresoluton: 1\n"))
        self.assertEqual(done.returncode, 1)
        self.assertIn('map.yaml:2: there is no key "resoluton" (did you mean "resolution"?)', done.stderr)


if __name__ == "__main__":
    unittest.main()
