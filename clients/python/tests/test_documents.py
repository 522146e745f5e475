"""The Python that the documents show does what they say."""

import doctest
import math
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from typing import List

from package import ROOT
from server_program import HANG, World, needed
from playhouse_client import Access, connect

ADDRESS = "127.0.0.1:6665"


def blocks(document: str) -> List[str]:
    """The Python of a document, block by block."""
    return re.findall(r"^```python\n(.*?)^```", (ROOT / "docs" / document).read_text(), re.M | re.S)


class NumbersApart(doctest.OutputChecker):
    """Takes an output for the one shown if it differs in digits only: when a person looks is not known."""

    def check_output(self, want: str, got: str, optionflags: int) -> bool:
        return self._without_digits(want) == self._without_digits(got)

    @staticmethod
    def _without_digits(shown: str) -> str:
        return re.sub(r"-?\d+(\.\d*(e-\d+)?(\.\.\.)?)?", "N", shown)


@needed
class Documents(unittest.TestCase):
    def test_the_lines_of_the_tutorial_print_what_it_shows(self) -> None:
        lines = "".join(block for block in blocks("tutorial.md") if block.startswith(">>>"))
        with World("simple.world") as world:
            session = doctest.DocTestParser().get_doctest(
                lines.replace(ADDRESS, world.address), {}, "tutorial.md", "tutorial.md", 0
            )
            said: List[str] = []
            runner = doctest.DocTestRunner(NumbersApart(), verbose=False)  # it would take a -v of unittest as its own
            result = runner.run(session, out=said.append, clear_globs=False)
            session.globs["client"].close()
        self.assertEqual((result.failed, "".join(said)), (0, ""))
        self.assertGreater(result.attempted, 10)

    def test_the_tutorials_program_drives_and_ends_on_ctrl_c_without_a_traceback(self) -> None:
        (program,) = [block for block in blocks("tutorial.md") if not block.startswith(">>>")]
        self.check_program(program, told="", code=130)

    def test_the_ten_lines_drive(self) -> None:
        (program,) = [block for block in blocks("clients.md") if "laser.updates()" in block]
        self.check_program(program, told=None, code=-signal.SIGINT)

    def test_the_planners_program_ends_at_its_goal(self) -> None:
        (program,) = blocks("drivers.md")
        with World("navigate.cfg", speed="20") as world, connect(world.address) as client:
            done = self.run_program(program.replace(ADDRESS, world.address))
            pose = client.simulation(0).pose("r0")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^there: x [56]\.\d\d m, y [34]\.\d\d m\n$")
        self.assertLess(math.dist(pose[:2], (6.0, 4.0)), 0.6)

    def run_program(self, program: str) -> "subprocess.CompletedProcess[str]":
        environment = {**os.environ, "PYTHONPATH": str(ROOT / "clients" / "python")}
        command = [sys.executable, "-c", program]
        return subprocess.run(command, capture_output=True, text=True, env=environment, timeout=HANG)

    def check_program(self, program: str, told, code: int) -> None:
        """Runs it until its robot moves, sends Ctrl-C, and insists on what it says then, and that the robot stands."""
        with World("simple.world") as world, tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "avoid.py"
            path.write_text(program.replace(ADDRESS, world.address))
            environment = {**os.environ, "PYTHONPATH": str(ROOT / "clients" / "python")}
            with connect(world.address) as client, client.position2d(0, Access.READ) as base:
                command = [sys.executable, str(path)]
                process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env=environment)
                base.next_data()
                while process.poll() is None and base.velocity.x == 0.0:
                    base.next_data()
                process.send_signal(signal.SIGINT)
                said = process.communicate(timeout=HANG)[1]
                self.assertEqual(process.returncode, code, said)
                if told is not None:
                    self.assertEqual(said, told)
                base.next_data()
                base.next_data()
                self.assertEqual(base.velocity, (0.0, 0.0, 0.0))


if __name__ == "__main__":
    unittest.main()
