"""What is written, and when: every build runs codegen, several at once in one tree."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
A_PAGE, A_HEADER = "docs/kinds/gps.md", "playhouse/wire/generated/gps.h"


class Output(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in ("codegen", "interfaces", "kinds", "viewer"):
            shutil.copytree(ROOT / name, self.root / name, ignore=shutil.ignore_patterns("__pycache__"))

    def start(self, *arguments, seed="0"):
        return subprocess.Popen([sys.executable, "-m", "codegen", *arguments], cwd=self.root, text=True, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, env=os.environ | {"PYTHONHASHSEED": seed})

    def run_codegen(self, *arguments, seed="0", status=0):
        process = self.start(*arguments, seed=seed)
        out, error = process.communicate()
        self.assertEqual(process.returncode, status, error)
        return out or error

    def test_is_the_same_whatever_the_order_of_sets(self):
        self.run_codegen(seed="1")
        self.assertEqual(self.run_codegen("--check", seed="2"), "")

    def test_of_several_at_once_is_whole(self):
        for process in [self.start() for _ in range(4)]:
            self.assertEqual((process.communicate()[1], process.returncode), ("", 0))
        self.assertEqual(self.run_codegen("--check"), "")
        self.assertEqual([path for path in self.root.rglob(".*")], [])

    def test_that_did_not_change_keeps_its_time(self):
        self.run_codegen()
        for name in (A_PAGE, A_HEADER):
            os.utime(self.root / name, (1, 1))
        definition = self.root / "kinds/gps.toml"
        definition.write_text(definition.read_text().replace('doc = "', 'doc = "As they say: ', 1))
        self.assertIn(f"{A_PAGE}: is not what the definitions say", self.run_codegen("--check", status=1))
        self.run_codegen()
        self.assertEqual((self.root / A_HEADER).stat().st_mtime, 1)
        self.assertIn("As they say", (self.root / A_PAGE).read_text())

    def test_of_earlier_definitions_is_removed(self):
        self.run_codegen()
        left = [self.root / name for name in ("playhouse/attic/generated/old.cc", "clients/tcl/generated/old.tcl")]
        for path in left:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.touch()
        self.assertIn("playhouse/attic/generated/old.cc: is left over", self.run_codegen("--check", status=1))
        self.assertIn("2 changed", self.run_codegen())
        self.assertEqual([path for path in left if path.exists()], [])

    def test_is_listed(self):
        listed = self.run_codegen("--list").split()
        self.run_codegen()
        self.assertIn(A_PAGE, listed)
        self.assertEqual([name for name in listed if not (self.root / name).is_file()], [])


if __name__ == "__main__":
    unittest.main()
