"""How tests in Python wait: for what they need, never for a time. The one place of theirs that sleeps and reads a clock
(tools/waits.py)."""

import select
import time
from typing import Callable, Sequence, TypeVar

# Seconds after which a wait is a failure; generous, for slow machines with sanitizers.
PATIENCE = 60.0

T = TypeVar("T")


def wait_until(condition: Callable[[], T], what: str) -> T:
    """Looks until `condition` holds, for what neither a message nor a file descriptor tells."""
    deadline = time.monotonic() + PATIENCE
    while not (found := condition()):
        if time.monotonic() > deadline:
            raise AssertionError(f"never {what}")
        time.sleep(0.01)
    return found


def wait_for_any(files: Sequence, what: str) -> Sequence:
    """Those of the files that can be read. That of os.pidfd_open() can be once its process has ended."""
    ready = select.select(files, [], [], PATIENCE)[0]
    if not ready:
        raise AssertionError(f"never {what}")
    return ready
