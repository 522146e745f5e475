"""The command line that the examples share: PROGRAM [HOST:PORT [INDEX [SECONDS ...]]]."""

import math
import pathlib
import signal
import sys
import time
from typing import Callable, List

INTERRUPTIBLE = signal.getsignal(signal.SIGINT) is signal.default_int_handler  # not in the background of a script
if INTERRUPTIBLE:
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # until run(): no robot moves yet, and a traceback is of no use
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))  # runs in place, without an installation

from playhouse_client import Client, PlayerError, connect  # noqa: E402


class Clock:
    """How long the program may still run; 0 seconds means until Ctrl-C."""

    def __init__(self, seconds: float) -> None:
        self._end = time.monotonic() + seconds if seconds > 0 else float("inf")

    def up(self) -> bool:
        return time.monotonic() >= self._end


def whole(word: str) -> int:
    """A whole number up to 65535."""
    number = int(word)
    if not 0 <= number <= 65535:
        raise ValueError(word)
    return number


def seconds_of(word: str) -> float:
    seconds = float(word)
    if not (math.isfinite(seconds) and seconds >= 0):
        raise ValueError(word)
    return seconds


def catch_signals() -> None:
    """Ends by Ctrl-C, by SIGTERM, or because the terminal was closed (SIGHUP): through every `with` block, which
    stops the robot. Without this, Python ends at once. What nohup ignores stays ignored."""
    caught = [number for number in (signal.SIGTERM, signal.SIGHUP) if signal.getsignal(number) != signal.SIG_IGN]

    def end(number: int, _: object) -> None:
        for each in caught:  # a closed terminal may signal twice; already stopping
            signal.signal(each, signal.SIG_IGN)
        sys.exit(128 + number)

    for number in caught:
        signal.signal(number, end)
    if INTERRUPTIBLE:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def run(behave: Callable[[Client, int, Clock, List[int]], None], usage: str) -> None:
    """Connects, behaves, and ends with 0 when done, 1 on an error, 2 on wrong arguments, and 128 and its number on a
    signal (130 on Ctrl-C)."""
    arguments = sys.argv[1:] + ["127.0.0.1:6665", "0", "0"][len(sys.argv) - 1 :]
    try:
        index, seconds, more = whole(arguments[1]), seconds_of(arguments[2]), list(map(whole, arguments[3:]))
    except ValueError:
        print(f"usage: {usage}", file=sys.stderr)
        sys.exit(2)
    catch_signals()
    try:
        with connect(arguments[0]) as client:
            behave(client, index, Clock(seconds), more)
    except PlayerError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(130)
