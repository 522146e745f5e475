"""The installed package, for tests that build with it and nothing else."""

import os
import re
import subprocess
import tempfile
from pathlib import Path

from house import ROOT, HouseTest

# Of the program: it has the install script.
BUILD = os.environ.get("PLAYHOUSE_BUILD", str(ROOT / "build" / "release"))


def tool(*command, **more) -> str:
    """What it prints. Fails with all that it says."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, **more)
    if done.returncode:
        raise AssertionError(f"{command}: {done.stdout}{done.stderr}")
    return done.stdout


class InstalledTest(HouseTest):
    @classmethod
    def setUpClass(cls):
        """The package, in a folder of its own."""
        super().setUpClass()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.place = Path(folder.name)
        tool("cmake", "--install", BUILD, "--prefix", cls.place / "prefix")

    @classmethod
    def build(cls, source, build):
        """With the installed package alone, and without the optimiser, which costs time and tells nothing. By the
        compiler of the program, whose sanitizers the client library may have."""
        compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", (Path(BUILD) / "CMakeCache.txt").read_text(), re.M).group(1)
        tool("cmake", "-G", "Ninja", "-S", source, "-B", build, "-DCMAKE_BUILD_TYPE=Debug",
             f"-DCMAKE_PREFIX_PATH={cls.place}/prefix", f"-DCMAKE_CXX_COMPILER={compiler}")
        tool("cmake", "--build", build)

    def build_walk(self, page: str, files: set[str]) -> str:
        """The files of a tutorial in docs/, built in self.folder. Its text."""
        walk = (ROOT / "docs" / page).read_text()
        found = dict(re.findall(r"`(\w+\.[\w.]+)`:\n\n```\w*\n(.*?)```", walk, re.DOTALL))
        self.assertEqual(set(found), files)
        for name, content in found.items():
            self.write(name, content)
        self.build(self.folder, self.folder / "build")
        return walk
