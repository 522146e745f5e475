"""The world as it stands, saved as a world file that runs."""

import subprocess
import unittest

from house import ACK, CMD, PATIENCE, POSITION2D, PROGRAM, ROOT, SIMULATION, WORLD, Client, House, HouseTest, finish
from viewer import Viewer

PAUSE, SAVE = 1, 3
ROBOT = 1   # of the list of what can be added: the wall is the first

CFG = 'driver ( name "stage" provides ["simulation:0"] worldfile "test.world" )\n'


class SaveWorld(HouseTest):
    def setUp(self):
        super().setUp()
        self.saved = self.folder / "saved.world"

    def start(self, *arguments) -> House:
        house = House(*arguments)
        self.addCleanup(house.__exit__)
        return house

    def client(self, house: House) -> Client:
        client = Client(house.port())
        self.addCleanup(client.close)
        self.assertEqual(client.open(SIMULATION, 0).type, ACK)
        return client

    def run_world(self, world, *arguments) -> House:
        return self.start("run", world, "--port", 0, "--headless", *arguments)

    def poses(self, client: Client, names) -> list[tuple[float, float, float]]:
        return [client.pose(name) for name in names]

    def assert_same_poses(self, was, now):
        for pose, other in zip(was, now, strict=True):
            for a, b in zip(pose, other, strict=True):
                self.assertAlmostEqual(a, b, delta=1e-9)

    def checked(self, file):
        done = finish("check", file)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_what_a_client_saves_runs_and_everybody_stands_where_they_stood(self):
        world = self.world()
        house = self.start("run", world, "--port", 0, "--web", 0, "--save-world", self.saved)
        client = self.client(house)
        viewer = Viewer(int(house.wait_for_line(r"^web page: http://127\.0\.0\.1:(\d+)/").group(1)))
        self.addCleanup(viewer.close)
        viewer.send(do="add", robot=ROBOT, x=-2, y=4, a=0.3)
        viewer.turn_until(lambda: viewer.came)
        viewer.send(do="remove", model=next(id for id, model in viewer.models.items() if model["name"] == "r1"))
        viewer.turn_until(lambda: all(model["name"] != "r1" for model in viewer.models.values()))
        self.assertEqual(client.open(POSITION2D, 0).type, ACK)
        client.drive(0, 0.4, 0.5)
        while client.pose("r0")[2] < 0.8:
            client.next_data(POSITION2D, 0)
        client.send(SIMULATION, 0, CMD, PAUSE)
        names = ["wall", "r0", "r0.ranger:0", "r0.ranger:1", "r0~2"]
        was = self.poses(client, names)
        client.send(SIMULATION, 0, CMD, SAVE)
        house.wait_for_line(r"saved the world at \S+ s to .*saved\.world$")
        self.assertEqual(house.end(), 128 + 15)

        self.checked(self.saved)
        self.assertEqual(world.read_text(), WORLD, "the world that ran is as it was")
        self.assertEqual(sorted(file.name for file in self.folder.iterdir()), ["saved.world", "test.world"])
        again = self.client(self.run_world(self.saved))
        self.assert_same_poses(was, self.poses(again, names))
        self.assertEqual(len([device for device in again.devices() if device[0] == POSITION2D]), 2, "r1 has gone")

    def test_robots_with_controllers_go_on_from_where_they_stood(self):
        names = ["amber", "azure", "guest", "crate_a", "amber.ranger:1"]
        run = self.run_world(ROOT / "worlds/cave.world", "--fast", "--save-world", self.saved)
        client = self.client(run)
        client.send(SIMULATION, 0, CMD, SAVE)
        run.wait_for_line("saved the world at")
        self.checked(self.saved)
        later = self.folder / "later.world"
        done = finish("run", self.saved, "--port", 0, "--headless", "--fast", "--duration", 5, "--save-at", 5, later)
        self.assertEqual(done.returncode, 0, done.stderr)
        start, end = [self.poses(self.client(self.run_world(file, "--speed", "1e-9")), names) for file in (self.saved, later)]
        self.assertGreater(abs(start[0][0] - end[0][0]) + abs(start[0][1] - end[0][1]), 0.1)
        self.assertEqual(start[2:], end[2:], "who has no controller stays")

    def test_a_server_with_a_configuration_saves_too(self):
        self.world()
        house = self.start("serve", self.write("test.cfg", CFG), "--port", 0, "--headless", "--save-world", self.saved)
        self.client(house).send(SIMULATION, 0, CMD, SAVE)
        house.wait_for_line("saved the world at")
        self.checked(self.saved)

    def test_no_client_writes_a_file_unless_whoever_runs_the_program_said_so(self):
        house = self.run_world(self.world())
        client = self.client(house)
        client.send(SIMULATION, 0, CMD, SAVE)
        house.wait_for_line("a client asked to save the world, which --save-world FILE allows")
        client.pose("r0")
        self.assertEqual([file.name for file in self.folder.iterdir()], ["test.world"])

    def test_a_world_is_saved_at_a_time_and_out_of_a_saved_run(self):
        state, other = self.folder / "s.run", self.folder / "other.world"
        world = ROOT / "worlds/cave.world"
        done = finish("run", world, "--port", 0, "--headless", "--fast", "--duration", 4, "--save-at", 3, self.saved,
                      "--save-at", 3, state)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = finish("run", "--from", state, "--port", 0, "--headless", "--fast", "--duration", 4, "--save-at", 0, other)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.saved.read_text(), other.read_text())
        self.assertIn("# As it stood at 3 s", other.read_text())

    def test_what_is_saved_of_a_saved_world_is_the_same(self):
        for world in sorted((ROOT / "worlds").glob("*.world")):
            files = [self.folder / name for name in ("one.world", "two.world")]
            for said, file in zip([world, files[0]], files):
                done = finish("run", said, "--port", 0, "--headless", "--fast", "--duration", 0, "--save-at", 0, file)
                self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(files[0].read_text(), files[1].read_text())

    def test_no_file_that_is_read_is_written_over(self):
        self.write("plan.pbm", "P1 2 2 1001")
        self.write("walls.inc", 'model( bitmap "plan.pbm" size [4 4 1] )')
        world = self.world('include "walls.inc"\nposition( name "r0" pose [1 1 0 0] )')
        cfg = self.write("test.cfg", CFG)
        state = self.folder / "a.run"
        always = ["--port", "0", "--headless", "--fast", "--duration", "1"]
        finish("run", world, *always, "--save-at", 0, state)
        (self.folder / "linked").symlink_to("test.world")
        before = {file: file.read_bytes() for file in self.folder.iterdir()}
        for command, said, output in (
                ("run", world, ("--record", world)), ("run", world, ("--save-at", 0, world)),
                ("run", world, ("--save-world", self.folder / "." / "walls.inc")),
                ("run", world, ("--save-at", 0.5, self.folder / "plan.pbm")),
                ("run", world, ("--save-at", 0.5, self.folder / "linked")),
                ("serve", cfg, ("--record", cfg)), ("serve", cfg, ("--record", world)),
                ("run", "--from", (state, "--record", state)), ("run", "--from", (state, "--save-at", 0, state)),
                ("run", "--from", (state, "--save-at", 0, world))):
            done = finish(command, said, *output, *always)
            self.assertEqual(done.returncode, 2, (output, done.stderr))
            self.assertEqual(done.stderr, f"{output[-1]}: error: is what is read: give another name\n")
            for file, content in before.items():
                self.assertEqual(file.read_bytes(), content, file)

    def test_no_picture_is_written_over_a_bitmap_of_the_world(self):
        plan = self.write("plan.pbm", "P1 2 2 1001")
        (self.folder / "linked.png").symlink_to("plan.pbm")
        world = self.world('model( bitmap "plan.pbm" size [4 4 1] )')
        for command in ("picture", "film"):
            done = finish(command, world, "--renderer", "playhouse", "-o", self.folder / "linked.png")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("is what is read", done.stderr)
        self.assertEqual(plan.read_text(), "P1 2 2 1001")

    def test_a_file_that_cannot_be_written_is_one_line_and_leaves_the_old_one(self):
        nowhere = self.folder / "none" / "x.world"
        arguments = ["--port", "0", "--headless", "--fast", "--duration", "1"]
        for options in (["--save-world", nowhere], ["--save-at", 0, nowhere]):
            done = finish("run", self.world(), *arguments, *options)
            self.assertEqual(done.returncode, 1, done.stderr)
            errors = [line for line in done.stderr.splitlines() if "error" in line]
            self.assertEqual(len(errors), 1, done.stderr)
            self.assertIn(f"{nowhere}: error: cannot be written: No such file or directory", errors[0])
        self.saved.write_text("good")
        limited = 'trap "" XFSZ; ulimit -f 1; exec "$@"'   # no file of more than a block
        done = subprocess.run(["bash", "-c", limited, "bash", PROGRAM, "run", str(ROOT / "worlds/cave.world"), *arguments,
                               "--save-at", "0", str(self.saved)], capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(f"{self.saved}: error: cannot be written: File too large", done.stderr)
        self.assertEqual(self.saved.read_text(), "good")
        self.assertEqual([file.name for file in self.folder.glob("*.part")], [])


if __name__ == "__main__":
    unittest.main()
