"""The checkout as a folder that people move."""

import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from house import PATIENCE, ROOT


class Moved(unittest.TestCase):
    def test_a_checkout_that_was_moved_is_configured_anew(self):
        with tempfile.TemporaryDirectory() as folder:
            before, after = Path(folder) / "before", Path(folder) / "after"
            shutil.copytree(ROOT, before, ignore=shutil.ignore_patterns("build", "out", "node_modules", ".git", "__pycache__"))
            self.configure(before)
            self.assertNotIn("anew", self.configure(before))
            before.rename(after)
            self.assertIn("anew", self.configure(after))
            self.assertIn(f"={after.resolve()}\n", (after / "build/release/CMakeCache.txt").read_text())

    def configure(self, checkout: Path) -> str:
        done = subprocess.run([checkout / "tools/configure.sh", "release"], capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout


class Committed(unittest.TestCase):
    """The commit that the program names is asked of git in each build."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.output = self.root / "version.cc"

    def named(self, commit: str = "") -> str:
        self.run_here("cmake", f"-DSOURCE={self.root}", "-DVERSION=1.2.3", f"-DCOMMIT={commit}", f"-DOUTPUT={self.output}",
                      "-P", ROOT / "cmake/WriteVersion.cmake")
        found = re.search(r'"1\.2\.3 \((.*)\)"', self.output.read_text())
        assert found, self.output.read_text()
        return found[1]

    def run_here(self, *command) -> str:
        return subprocess.run(command, cwd=self.root, capture_output=True, text=True, check=True, timeout=PATIENCE).stdout.strip()

    def git(self, *words: str) -> str:
        return self.run_here("git", "-c", "user.name=a", "-c", "user.email=a@b", *words)

    def test_is_that_of_the_repository_and_says_what_no_commit_has(self):
        self.git("init", "--quiet")
        (self.root / "file").write_text("1")
        self.git("add", "file")
        self.git("commit", "--quiet", "--message", "one")
        self.git("tag", "--annotate", "v1.2.3", "--message", "a release")
        commit = self.git("rev-parse", "--short=7", "HEAD")
        self.assertEqual(self.named("other"), commit)
        before = self.output.stat().st_mtime_ns
        self.assertEqual(self.named(), commit)
        self.assertEqual(self.output.stat().st_mtime_ns, before, "nothing is to be compiled")
        (self.root / "file").write_text("2")
        self.assertEqual(self.named(), f"{commit}-dirty")

    def test_outside_a_repository_is_what_the_build_was_told(self):
        self.assertEqual(self.named("abc1234"), "abc1234")
        self.assertEqual(self.named(), "unknown")


if __name__ == "__main__":
    unittest.main()
