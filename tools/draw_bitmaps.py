#!/usr/bin/env python3
"""Draws the bitmaps of worlds/: black is solid rock, white is free floor.

usage: tools/draw_bitmaps.py [FOLDER]      (default: worlds/bitmaps)

The cave is a union of chambers and corridors, given below in metres, as one signed distance field whose
surface is roughened by smooth noise. All numbers are fixed, so the output is reproducible.
Standard library only; half a minute.
"""

import math
import pathlib
import struct
import sys
import zlib

# The cave: a square of SIDE metres about the origin, PIXELS a side, image row 0 at +y.
SIDE, PIXELS = 16.0, 640
RIM = 0.35  # m of rock that always closes the cave

# Chambers: centre, half axes [m] and turn [rad].
CHAMBERS = [
    (-5.1, -5.2, 1.75, 1.45, 0.3),  # south-west hall, where things are found
    (5.1, 5.1, 1.80, 1.50, 0.5),    # north-east hall, where they are brought
    (-0.3, 0.1, 2.30, 1.60, -0.5),  # the great chamber
    (-5.5, 4.7, 1.15, 1.50, 0.2),
    (-1.5, 5.3, 1.35, 0.95, 0.1),
    (5.6, 0.3, 1.05, 1.35, 0.2),
    (4.7, -5.0, 1.75, 1.35, -0.5),
    (0.1, -5.6, 1.35, 0.85, 0.2),
    (-5.6, -0.3, 0.95, 1.40, 0.3),
]

# Corridors: radius [m], then the points their middle passes.
CORRIDORS = [
    (0.55, (-5.1, -5.2), (-3.9, -3.4), (-1.9, -2.7), (-0.3, 0.1)),
    (0.58, (-0.3, 0.1), (1.9, 1.3), (2.4, 3.2), (5.1, 5.1)),
    (0.52, (-5.5, 4.7), (-3.7, 6.2), (-1.5, 5.3)),
    (0.54, (-1.5, 5.3), (0.7, 6.3), (2.6, 5.6), (5.1, 5.1)),
    (0.55, (-5.5, 4.7), (-4.0, 2.6), (-2.1, 2.3), (-0.3, 0.1)),
    (0.54, (-1.5, 5.3), (-0.9, 3.9), (-0.4, 2.2), (-0.3, 0.1)),
    (0.56, (5.1, 5.1), (6.1, 2.9), (5.6, 0.3)),
    (0.54, (5.6, 0.3), (4.9, -1.8), (6.2, -3.2), (4.7, -5.0)),
    (0.55, (-0.3, 0.1), (2.1, -1.0), (2.2, -3.0), (4.7, -5.0)),
    (0.55, (4.7, -5.0), (2.6, -6.5), (0.1, -5.6)),
    (0.54, (0.1, -5.6), (-2.0, -6.4), (-5.1, -5.2)),
    (0.54, (-5.1, -5.2), (-6.3, -3.1), (-5.6, -0.3)),
    (0.53, (-5.6, -0.3), (-6.3, 2.2), (-5.5, 4.7)),
    (0.52, (-5.6, -0.3), (-4.1, -1.1), (-2.0, 0.2)),
    (0.54, (2.0, 1.2), (3.7, 1.0), (5.6, 0.3)),
]

# Pillars left standing: centre and radius [m].
PILLARS = [(-4.8, -5.1, 0.30), (5.2, 5.3, 0.32), (-1.2, 0.6, 0.36), (0.7, -0.5, 0.30), (4.5, -5.1, 0.33)]


def noise_corner(x, y, salt):
    """A fixed pseudo-random number in [-1, 1) for a lattice point."""
    h = (x * 0x27D4EB2D + y * 0x165667B1 + salt * 0x9E3779B1) & 0xFFFFFFFF
    h = ((h ^ (h >> 15)) * 0x85EBCA6B) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 0xC2B2AE35) & 0xFFFFFFFF
    return (h ^ (h >> 16)) / 2147483648.0 - 1.0


def noise(x, y, salt):
    """Smooth noise in [-1, 1) with features about one unit wide."""
    x0, y0 = math.floor(x), math.floor(y)
    u, v = x - x0, y - y0
    u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
    south = noise_corner(x0, y0, salt) * (1 - u) + noise_corner(x0 + 1, y0, salt) * u
    north = noise_corner(x0, y0 + 1, salt) * (1 - u) + noise_corner(x0 + 1, y0 + 1, salt) * u
    return south * (1 - v) + north * v


def ellipse(x, y, chamber):
    """Approximate distance to an ellipse's edge, negative inside. [m]"""
    cx, cy, a, b, turn = chamber
    c, s = math.cos(turn), math.sin(turn)
    u, v = (x - cx) * c + (y - cy) * s, (y - cy) * c - (x - cx) * s
    return (math.hypot(u / a, v / b) - 1.0) * min(a, b)


def capsule(x, y, radius, p, q):
    """Distance to a corridor's wall, negative inside. [m]"""
    dx, dy = q[0] - p[0], q[1] - p[1]
    t = ((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy)
    t = max(0.0, min(1.0, t))
    return math.hypot(x - p[0] - t * dx, y - p[1] - t * dy) - radius


def blend(a, b, width):
    """Smooth minimum of two distances, rounded over `width` metres."""
    h = max(width - abs(a - b), 0.0) / width
    return min(a, b) - h * h * width * 0.25


def curve(points):
    """A corridor's centre line: a Catmull-Rom spline through its points, six steps per span."""
    bent = []
    padded = [points[0], *points, points[-1]]
    for p0, p1, p2, p3 in zip(padded, padded[1:], padded[2:], padded[3:]):
        for step in range(6):
            t = step / 6
            bent.append(tuple(
                p1[i] + 0.5 * t * (p2[i] - p0[i] + t * (2 * p0[i] - 5 * p1[i] + 4 * p2[i] - p3[i]
                                                        + t * (3 * (p1[i] - p2[i]) + p3[i] - p0[i])))
                for i in (0, 1)))
    return bent + [points[-1]]


def cave():
    """Rows of the cave's pixels, True where there is rock."""
    spans = []
    for radius, *points in CORRIDORS:
        bent = curve(points)
        spans += [(radius, p, q) for p, q in zip(bent, bent[1:])]
    rows = []
    for row in range(PIXELS):
        y = SIDE / 2 - (row + 0.5) * SIDE / PIXELS
        # A corridor further than its radius and the blend from this row can't change it.
        near = [s for s in spans if min(s[1][1], s[2][1]) - 1.8 < y < max(s[1][1], s[2][1]) + 1.8]
        line = []
        for column in range(PIXELS):
            x = (column + 0.5) * SIDE / PIXELS - SIDE / 2
            distance = 9.0
            for chamber in CHAMBERS:
                distance = blend(distance, ellipse(x, y, chamber), 0.3)
            for radius, p, q in near:
                distance = blend(distance, capsule(x, y, radius, p, q), 0.25)
            for px, py, radius in PILLARS:
                distance = max(distance, radius - math.hypot(x - px, y - py))
            rough = (0.20 * noise(x * 0.9, y * 0.9, 1) + 0.13 * noise(x * 2.1, y * 2.1, 2)
                     + 0.05 * noise(x * 5.2, y * 5.2, 3))
            rim = SIDE / 2 - max(abs(x), abs(y))
            line.append(distance + rough > 0.0 or rim < RIM + 0.5 * rough)
        rows.append(line)
    return keep_largest(rows)


def regions(rows, solid):
    """Connected pixels (by edges) that are `solid`, largest region first."""
    seen = [[False] * len(rows[0]) for _ in rows]
    found = []
    for r, line in enumerate(rows):
        for c, value in enumerate(line):
            if value != solid or seen[r][c]:
                continue
            seen[r][c], region, at = True, [(r, c)], 0
            while at < len(region):
                y, x = region[at]
                at += 1
                for v, u in ((y + 1, x), (y - 1, x), (y, x + 1), (y, x - 1)):
                    if 0 <= v < len(rows) and 0 <= u < len(line) and rows[v][u] == solid and not seen[v][u]:
                        seen[v][u] = True
                        region.append((v, u))
            found.append(region)
    return sorted(found, key=len, reverse=True)


def keep_largest(rows):
    """Keeps one connected floor and removes pieces of rock too small to be detected by a robot."""
    for region in regions(rows, False)[1:]:
        for r, c in region:
            rows[r][c] = True
    for region in regions(rows, True):
        if len(region) < 60:
            for r, c in region:
                rows[r][c] = False
    return rows


def png(rows):
    """An 8-bit grey PNG of the rows, True drawn black."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    pixels = b"".join(b"\0" + bytes(0 if solid else 255 for solid in line) for line in rows)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(pixels, 9))
            + chunk(b"IEND", b""))


def main():
    default = pathlib.Path(__file__).resolve().parent.parent / "worlds" / "bitmaps"
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "cave.png").write_bytes(png(cave()))
    print(folder / "cave.png")


if __name__ == "__main__":
    main()
