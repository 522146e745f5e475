"""Types of command line arguments of the examples of playhouse_gym."""

import argparse
import math
from typing import Callable


def whole(least: int, most: float = math.inf) -> Callable[[str], int]:
    """Type of an argument: whole numbers from `least` to `most`."""

    def value(text: str) -> int:
        digits = text.removeprefix("-")
        if not (digits.isascii() and digits.isdigit() and least <= int(text) <= most):
            limit = "on" if most == math.inf else f"to {most}"
            raise argparse.ArgumentTypeError(f'a whole number from {least} {limit} is expected, not "{text}"')
        return int(text)

    return value
