"""The checkout as a folder that people move."""

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


if __name__ == "__main__":
    unittest.main()
