"""The program of this checkout, serving a world on a free port."""

import os
import re
import subprocess
import unittest

from package import ROOT

PROGRAM = os.environ.get("PLAYHOUSE_PROGRAM", str(ROOT / "build" / "playhouse"))
SPEED = "6"  # times real time, so that a minute of driving is ten seconds of test
HANG = 120.0  # seconds after which something is taken for hung

needed = unittest.skipUnless(os.access(PROGRAM, os.X_OK), f"there is no server program at {PROGRAM}")


class World:
    """The server, running a world or a configuration file on a free port, as a `with` block."""

    def __init__(self, world: str, *options: str, speed: str = SPEED) -> None:
        command = [PROGRAM, "serve" if world.endswith(".cfg") else "run", str(ROOT / "worlds" / world)]
        command += ["--port", "0", "--headless", "--speed", speed, *options]
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.address = self._read_address()

    def _read_address(self) -> str:
        assert self._process.stdout is not None
        said = ""
        for line in self._process.stdout:
            said += line
            found = re.search(r"Player clients: (\S+)", line)
            if found:
                return found.group(1)
        self._process.wait()
        raise AssertionError(f"the server ended with {self._process.returncode}:\n{said}")

    def wait(self) -> None:
        """Waits for the end of a run that ends by itself."""
        self._process.wait(HANG)

    def __enter__(self) -> "World":
        return self

    def __exit__(self, *_: object) -> None:
        self._process.terminate()
        self._process.communicate(timeout=HANG)
