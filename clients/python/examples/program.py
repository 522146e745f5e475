"""The command line that the examples share: PROGRAM [HOST:PORT [INDEX [SECONDS ...]]]."""

import pathlib
import sys
import time
from typing import Callable, List

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))  # runs in place, without an installation

from playhouse_client import Client, PlayerError, connect  # noqa: E402


class Clock:
    """How long the program may still run; 0 seconds means until Ctrl-C."""

    def __init__(self, seconds: float) -> None:
        self._end = time.monotonic() + seconds if seconds > 0 else float("inf")

    def up(self) -> bool:
        return time.monotonic() >= self._end


def run(behave: Callable[[Client, int, Clock, List[int]], None], usage: str) -> None:
    """Connects, behaves, and ends with 0 when done, 1 on an error, 2 on wrong arguments, 130 on Ctrl-C."""
    arguments = sys.argv[1:] + ["127.0.0.1:6665", "0", "0"][len(sys.argv) - 1 :]
    try:
        index, seconds, more = int(arguments[1]), float(arguments[2]), [int(word) for word in arguments[3:]]
    except ValueError:
        print(f"usage: {usage}", file=sys.stderr)
        sys.exit(2)
    try:
        with connect(arguments[0]) as client:
            behave(client, index, Clock(seconds), more)
    except PlayerError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(130)
