"""Of paths of poses: distances in the plane."""

import math
from typing import Sequence


def distance(a: Sequence[float], b: Sequence[float]) -> float:
    return math.hypot(a[0] - b[0], a[1] - b[1])


def length(path: Sequence[Sequence[float]]) -> float:
    return sum(distance(a, b) for a, b in zip(path, path[1:]))
