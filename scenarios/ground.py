"""Path planning among the fixed obstacles of a world, modelled as rectangles.

Paths are shortest paths in a visibility graph: straight segments between corners of the rectangles, each inflated by the
clearance of the moving body. Source: Lozano-Perez, Wesley, "An algorithm for planning collision-free paths among polyhedral
obstacles", 1979.
"""

import heapq
import math
import pathlib
import re
from typing import Dict, List, NamedTuple, Tuple

Point = Tuple[float, float]

# A line of a world file with one upright, axis-aligned obstacle, in the format of the scenarios.
_THING = re.compile(r'^(\w+)\( name "(\w+)" pose \[(\S+) (\S+) 0 0\] size \[(\S+) (\S+) \S+\]')


class Rect(NamedTuple):
    """An axis-aligned rectangle, in m."""

    x0: float
    y0: float
    x1: float
    y1: float

    def grown(self, by: float) -> "Rect":
        return Rect(self.x0 - by, self.y0 - by, self.x1 + by, self.y1 + by)

    def holds(self, p: Point) -> bool:
        return self.x0 < p[0] < self.x1 and self.y0 < p[1] < self.y1

    def meets(self, a: Point, b: Point) -> bool:
        """Whether the segment from a to b intersects the interior (Liang, Barsky, 1984)."""
        first, last = 0.0, 1.0
        for start, end, low, high in ((a[0], b[0], self.x0, self.x1), (a[1], b[1], self.y0, self.y1)):
            way = end - start
            if way == 0:
                if not low < start < high:
                    return False
                continue
            enters, leaves = sorted(((low - start) / way, (high - start) / way))
            first, last = max(first, enters), min(last, leaves)
        return first < last


def read_things(world: pathlib.Path, *words: str) -> Dict[str, Rect]:
    """The obstacles of a world file with one of these words, by name: lines such as
    wall( name "north" pose [0 4 0 0] size [10 0.2 1.2] )."""
    things = {}
    for line in world.read_text().splitlines():
        found = _THING.match(line)
        if found and found[1] in words:
            x, y, width, depth = map(float, found.groups()[2:])
            things[found[2]] = Rect(x - width / 2, y - depth / 2, x + width / 2, y + depth / 2)
    if not things:
        raise ValueError(f"{world}: no line has one of the words {', '.join(words)}")
    return things


def distance(a: Point, b: Point) -> float:
    return math.hypot(b[0] - a[0], b[1] - a[1])


class Ground:
    """Obstacles, and path planning with a `clearance` from them (m)."""

    def __init__(self, things: List[Rect], clearance: float) -> None:
        self.things = things
        self._grown = [thing.grown(0.95 * clearance) for thing in things]
        corners = [(x, y) for r in things for g in [r.grown(clearance)] for x in (g.x0, g.x1) for y in (g.y0, g.y1)]
        self._corners = [p for p in corners if not any(r.holds(p) for r in self._grown)]
        self._near = [self._seen_from(p) for p in self._corners]

    def is_free(self, a: Point, b: Point) -> bool:
        """Whether the segment keeps the clearance. Obstacles closer than the clearance to an end are tested without it,
        and obstacles that contain an end are ignored."""
        return not any(self._is_in_the_way(r, grown, a, b) for r, grown in zip(self.things, self._grown))

    @staticmethod
    def _is_in_the_way(thing: Rect, grown: Rect, a: Point, b: Point) -> bool:
        if not (grown.holds(a) or grown.holds(b)):
            return grown.meets(a, b)
        return not (thing.holds(a) or thing.holds(b)) and thing.meets(a, b)

    def sees(self, a: Point, b: Point) -> bool:
        """Whether the line of sight is free."""
        return not any(thing.meets(a, b) for thing in self.things)

    def way(self, a: Point, b: Point) -> List[Point]:
        """Waypoints of the shortest path, without a and with b; empty if there is none."""
        if self.is_free(a, b):
            return [b]
        ends = dict(self._seen_from(b))
        best: Dict[int, float] = {}
        queue = [(length, corner, [corner]) for corner, length in self._seen_from(a)]
        heapq.heapify(queue)
        goal = len(self._corners)
        while queue:
            length, corner, way = heapq.heappop(queue)
            if corner == goal:
                return [self._corners[i] for i in way[:-1]] + [b]
            if best.get(corner, math.inf) <= length:
                continue
            best[corner] = length
            if corner in ends:
                heapq.heappush(queue, (length + ends[corner], goal, way + [goal]))
            for other, step in self._near[corner]:
                if best.get(other, math.inf) > length + step:
                    heapq.heappush(queue, (length + step, other, way + [other]))
        return []

    def _seen_from(self, p: Point) -> List[Tuple[int, float]]:
        return [(i, distance(p, c)) for i, c in enumerate(self._corners) if c != p and self.is_free(p, c)]
