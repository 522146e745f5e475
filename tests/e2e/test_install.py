"""What `cmake --install` leaves is enough: docs/install.md installs the release program to an empty folder, and the tutorials
are followed with that alone. Each command runs where an empty folder is in place of the checkout, sources and builds."""

import contextlib
import doctest
import os
import re
import signal
import subprocess
import sys
import tempfile
import unittest
import urllib.request
from pathlib import Path

from house import PATIENCE, POSITION2D, RELEASE, ROOT, SIMULATION, Client, House

sys.path.append(str(ROOT / "clients" / "python" / "tests"))
from test_documents import ADDRESS, NumbersApart, blocks  # noqa: E402

# Commands that get a mount namespace of their own; as root, and as a user if the system permits it.
HIDES = ["unshare", "--map-root-user", "--mount", "sh", "-c", 'mount -t tmpfs none "$0" && exec "$@"', str(ROOT)]
ENTER = ["sh", "-c", 'cd "$0" && exec "$@"']  # anew, since an open folder stays what it was


def shell_blocks(document: str) -> list[str]:
    return re.findall(r"^```sh\n(.*?)^```", (ROOT / "docs" / document).read_text(), re.M | re.S)


def can_hide() -> bool:
    done = subprocess.run([*HIDES, "test", "!", "-e", str(ROOT / "docs")], capture_output=True, text=True)
    if done.returncode:
        print(f"no mount namespaces here ({done.stderr.strip()}): instead of hiding the checkout, this test looks for "
              "open files of it", file=sys.stderr)
    return done.returncode == 0


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Installs as docs/install.md says, in a home of its own."""
        if not os.path.exists(RELEASE):
            raise unittest.SkipTest("there is no release program; `make build` makes it")
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.home = Path(folder.name).resolve()
        cls.prefix = cls.home / "playhouse"
        cls.data = cls.prefix / "share" / "playhouse"
        cls.own = cls.home / "own"  # files of the user
        cls.own.mkdir()
        install, variables = shell_blocks("install.md")
        user = {"HOME": str(cls.home), "PATH": os.environ["PATH"], "LANG": "C.UTF-8"}
        install = install.removeprefix("make build\n").replace("build/release", str(Path(RELEASE).parent / "release"))
        subprocess.run(["sh", "-ec", install], env=user, stdout=subprocess.DEVNULL, check=True)
        told = subprocess.run(["sh", "-ec", variables + "env"], env=user, capture_output=True, text=True, check=True).stdout
        cls.user = dict(line.split("=", 1) for line in told.splitlines())
        cls.hides = HIDES if can_hide() else []

    def command(self, folder: Path, *words) -> list[str]:
        return [*self.hides, *ENTER, str(folder), *map(str, words)]

    def start(self, folder: Path, *words) -> House:
        program, *arguments = self.command(folder, *words)
        return House(*arguments, program=program, env=self.user)

    def finish(self, folder: Path, *words, **more) -> subprocess.CompletedProcess:
        return subprocess.run(self.command(folder, *words), capture_output=True, text=True, timeout=PATIENCE, env=self.user,
                              **more)

    def succeed(self, folder: Path, *words, **more) -> str:
        done = self.finish(folder, *words, **more)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def check_opens_nothing_of_the_checkout(self, house: House):
        process = Path("/proc") / str(house.process.pid)
        opened = []
        for file in (process / "fd").iterdir():
            with contextlib.suppress(FileNotFoundError):  # closed meanwhile
                opened.append(os.readlink(file))
        self.assertNotIn(str(ROOT), (process / "maps").read_text() + "\n".join(opened))

    def test_the_tutorial_is_followed(self):
        run, devices, python = (block.replace("build/playhouse", "playhouse").split() for block in shell_blocks("tutorial.md"))
        self.assertEqual(python[-1], "python3")
        with self.start(self.data, *run, "--port", 0, "--web", 0) as house:
            address = f"127.0.0.1:{house.port()}"
            page = house.wait_for_line(r"http://127\.0\.0\.1:\d+/").group()
            if not self.hides:
                self.check_opens_nothing_of_the_checkout(house)
            with urllib.request.urlopen(page, timeout=PATIENCE) as answer:
                self.assertIn(b"<script", answer.read())
            listed = self.succeed(self.own, *devices, address)
            for device in ("position2d:0", "laser:0", "sonar:0", "speech:0", "simulation:0", "ranger:0", "ranger:1"):
                self.assertIn(device, listed)
            *sessions, program = sorted(blocks("tutorial.md"), key=lambda block: not block.startswith(">>>"))
            self.check_session("".join(sessions).replace(ADDRESS, address))
            self.check_program(program.replace(ADDRESS, address), house.port())

    def check_session(self, session: str):
        """Types lines into Python, and compares what it prints with what the document shows."""
        examples = doctest.DocTestParser().get_examples(session)
        done = self.finish(self.own, "python3", "-i", input="".join(example.source for example in examples))
        wanted = "".join(example.want for example in examples)
        self.assertTrue(NumbersApart().check_output(wanted, done.stdout, 0), done.stdout + done.stderr)

    def check_program(self, program: str, port: int):
        """Runs it until its robot moves; Ctrl-C ends it."""
        (self.own / "avoid.py").write_text(program)
        with Client(port) as client:
            client.open(SIMULATION, 0)
            start = client.pose("r0")
            process = subprocess.Popen(self.command(self.own, "python3", "avoid.py"), env=self.user,
                                       stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            client.open(POSITION2D, 0)
            while process.poll() is None and client.pose("r0") == start:
                client.next_data(POSITION2D, 0)
            process.send_signal(signal.SIGINT)
            self.assertEqual((process.communicate(timeout=PATIENCE)[0], process.returncode), ("", 130))

    def test_the_world_of_the_tutorial_of_people_is_made_in_any_folder(self):
        text = (ROOT / "docs" / "tutorial-people.md").read_text()
        world = self.own / "my.world"
        world.write_text("".join(re.findall(r"^```\n(.*?)^```", text.partition("## 4.")[0], re.M | re.S)))
        self.assertIn('include "pioneer.inc"', world.read_text())
        self.succeed(self.own, "playhouse", "check", "my.world")
        for engine in ("stage", "arena"):
            self.succeed(self.own, "playhouse", "run", "my.world", "--engine", engine, "--port", 0, "--headless", "--fast",
                         "--duration", 1)

    def test_bitmaps_and_meshes_of_the_program_are_found_from_any_folder(self):
        (self.own / "shapes.world").write_text('model( size [16 16 1] bitmap "bitmaps/cave.png" )\nmodel( mesh "meshes/table.dae" )\n')
        told = self.succeed(self.own, "playhouse", "check", "shapes.world")
        for file in ("bitmaps/cave.png", "meshes/table.dae"):
            self.assertIn(f'so "{self.data}/worlds/{file}" is read', told)

    def test_all_worlds_and_configurations_load(self):
        files = sorted(file for file in (self.data / "worlds").iterdir() if file.suffix in (".world", ".inc", ".cfg"))
        self.assertEqual([file.name for file in files],
                         sorted(file.name for file in (ROOT / "worlds").iterdir() if file.suffix in (".world", ".inc", ".cfg")))
        self.succeed(self.own, "playhouse", "check", *files)

    def test_a_world_of_the_program_is_suggested_to_whom_names_it_elsewhere(self):
        for command, name in (("run", "worlds/simple.world"), ("serve", "avoid.cfg")):
            done = self.finish(self.own, "playhouse", command, name)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f'{name}: cannot be opened: no such file (did you mean "{self.data}/worlds/{Path(name).name}"?)',
                          done.stderr.replace("error: ", ""))

    def test_scripts_find_the_program_as_players_server(self):
        self.assertEqual(os.readlink(self.prefix / "bin" / "player"), "playhouse")

    def test_installs_no_tests_and_no_path_of_the_checkout(self):
        files = [path for path in self.prefix.rglob("*") if not path.is_symlink()]
        names = [path.relative_to(self.prefix).as_posix() for path in files]
        self.assertEqual([name for name in names if re.search(r"(^|/)(testing|tests|__pycache__)|_(test|fuzz|bench)\.", name)], [])
        where = os.fsencode(ROOT)
        self.assertEqual([str(path) for path in files if path.is_file() and where in path.read_bytes()], [])
        for needed in ("LICENSE", "README.md", "docs/install.md"):
            self.assertTrue((self.prefix / "share" / "doc" / "playhouse" / needed).is_file(), needed)


if __name__ == "__main__":
    unittest.main()
