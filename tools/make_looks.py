#!/usr/bin/env python3
"""Generates the looks of the shipped robots and sensors (worlds/looks/*.obj): bodies with wheels, casters and sensors for pages, pictures
and cameras, of our own making. Metres, z up, about the middle of the body, on the floor. Each fills exactly the size of its model, to which
it is scaled. The material "painted" is white: it takes the color of the model (docs/meshes.md)."""

import math
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "worlds/looks"

COLORS = {"painted": (1, 1, 1), "tyre": (0.05, 0.05, 0.055), "dark": (0.1, 0.105, 0.115), "metal": (0.55, 0.56, 0.58),
          "gold": (0.72, 0.55, 0.2), "glass": (0.03, 0.035, 0.05), "orange": (0.85, 0.35, 0.06), "green": (0.1, 0.6, 0.2)}


def circle(radius, count, middle=(0, 0), begin=0.0, end=2 * math.pi):
    """Points of a circle, or of an arc with both its ends."""
    whole = end - begin > 2 * math.pi - 1e-9
    steps = count if whole else count - 1
    return [(middle[0] + radius * math.cos(begin + (end - begin) * k / steps), middle[1] + radius * math.sin(begin + (end - begin) * k / steps))
            for k in range(count)]


def rounded(x_min, x_max, y_half, corner):
    """A rectangle about y = 0 with cut corners, counter-clockwise."""
    return [(x_max, -y_half + corner), (x_max, y_half - corner), (x_max - corner, y_half), (x_min + corner, y_half),
            (x_min, y_half - corner), (x_min, -y_half + corner), (x_min + corner, -y_half), (x_max - corner, -y_half)]


class Look:
    def __init__(self, name, size):
        self.name, self.size = name, size
        self.faces = {}   # by material: lists of (point, normal)

    def face(self, material, points, normals=None):
        """A flat convex polygon, counter-clockwise from outside."""
        if normals is None:
            a, b, c = points[:3]
            u, v = [[q[i] - a[i] for i in range(3)] for q in (b, c)]
            n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            normals = [tuple(x / math.hypot(*n) for x in n)] * len(points)
        self.faces.setdefault(material, []).append(list(zip(points, normals)))

    def prism(self, material, outline, low, high, top=None):
        """A convex outline, counter-clockwise, between two heights; `top`: the material of its upper face."""
        self.face(top or material, [(x, y, high) for x, y in outline])
        self.face(material, [(x, y, low) for x, y in outline[::-1]])
        for (ax, ay), (bx, by) in zip(outline, outline[1:] + outline[:1]):
            self.face(material, [(ax, ay, low), (bx, by, low), (bx, by, high), (ax, ay, high)])

    def box(self, material, middle, size):
        (x, y, z), (a, b, c) = middle, [s / 2 for s in size]
        self.prism(material, [(x - a, y - b), (x + a, y - b), (x + a, y + b), (x - a, y + b)], z - c, z + c)

    def drum(self, material, axis, middle, radius, length, count=20, end=None):
        """A cylinder along a unit vector, smooth around; `end`: the material of its two ends."""
        side = (0, 0, 1) if abs(axis[2]) < 0.9 else (1, 0, 0)
        u = (axis[1] * side[2] - axis[2] * side[1], axis[2] * side[0] - axis[0] * side[2], axis[0] * side[1] - axis[1] * side[0])
        u = tuple(x / math.hypot(*u) for x in u)
        v = (axis[1] * u[2] - axis[2] * u[1], axis[2] * u[0] - axis[0] * u[2], axis[0] * u[1] - axis[1] * u[0])

        def ring(k):
            c, s = math.cos(2 * math.pi * k / count), math.sin(2 * math.pi * k / count)
            return tuple(c * a + s * b for a, b in zip(u, v))

        def at(way, along):
            return tuple(m + radius * w + along * a for m, w, a in zip(middle, way, axis))
        half = length / 2
        for k in range(count):
            a, b = ring(k), ring(k + 1)
            self.face(material, [at(a, -half), at(b, -half), at(b, half), at(a, half)], [a, b, b, a])
        self.face(end or material, [at(ring(k), half) for k in range(count)])
        self.face(end or material, [at(ring(-k), -half) for k in range(count)])

    def wheel(self, x, y, radius, width):
        """On the floor, its axle along y."""
        out = math.copysign(1, y)
        self.drum("tyre", (0, 1, 0), (x, y - out * 0.04 * width, radius), radius, 0.92 * width)
        self.drum("metal", (0, 1, 0), (x, y + out * 0.3 * width, radius), 0.6 * radius, 0.4 * width, 14)

    def caster(self, x, radius, width, top):
        """A small wheel in a fork that hangs from `top`."""
        self.drum("tyre", (0, 1, 0), (x, 0, radius), radius, width, 16)
        top = max(top, 2 * radius + 0.01)
        self.box("metal", (x + 0.3 * radius, 0, (2 * radius + top) / 2), (0.9 * radius, 1.4 * width, top - 2 * radius))

    def transducers(self, places, z, radius=0.017):
        """Sonars: (x, y, heading in degrees)."""
        for x, y, heading in places:
            a = math.radians(heading)
            self.drum("gold", (math.cos(a), math.sin(a), 0), (x, y, z), radius, 0.012, 12)

    def write(self):
        points = [p for faces in self.faces.values() for face in faces for p, _ in face]
        for k, (low, high) in enumerate(((-self.size[0] / 2, self.size[0] / 2), (-self.size[1] / 2, self.size[1] / 2), (0, self.size[2]))):
            extent = min(p[k] for p in points), max(p[k] for p in points)
            assert abs(extent[0] - low) < 5e-4 and abs(extent[1] - high) < 5e-4, (self.name, "xyz"[k], extent, (low, high))
        vertices, normals, lines = {}, {}, []

        def row(rows, value, digits):
            x, y, z = value
            value = x, z, -y   # OBJ is y up
            return rows.setdefault(" ".join(f"{round(x, digits) + 0:g}" for x in value), len(rows) + 1)
        for material, faces in sorted(self.faces.items()):
            lines.append(f"usemtl {material}")
            lines += ["f " + " ".join(f"{row(vertices, p, 5)}//{row(normals, n, 3)}" for p, n in face) for face in faces]
        text = ["# Generated by tools/make_looks.py: edit that.", "mtllib looks.mtl", *(f"v {v}" for v in vertices), *(f"vn {n}" for n in normals), *lines]
        (FOLDER / f"{self.name}.obj").write_text("\n".join(text) + "\n")


def pioneer_dx(name, size, axle, sonars):
    """A hull between two wheels, a caster behind, rings of sonars, a lid in the colour of the robot."""
    length, width, height = size
    look = Look(name, size)
    radius, tyre = 0.0825, 0.037
    inner = width / 2 - tyre - 0.012
    look.prism("painted", rounded(-length / 2 + 0.03, length / 2 - 0.07, inner, 0.03), 0.045, height - 0.015)
    for sign in (1, -1):
        look.wheel(axle, sign * (width - tyre) / 2, radius, tyre)
    look.caster(-length / 2 + 0.07, 0.0375, 0.028, 0.05)
    ring = height - 0.065, height - 0.015
    front, back = [s for s in sonars if s[0] > 0], [s for s in sonars if s[0] < 0]
    for arc in (front, back):
        outline = [(x, y) for x, y, _ in arc]
        look.prism("dark", outline if cross_sum(outline) > 0 else outline[::-1], *ring)
    look.transducers(sonars, (ring[0] + ring[1]) / 2)
    # The lid, which leaves the wheels to be seen from above.
    notch = (width - 2 * tyre) / 2 - 0.004
    look.prism("dark", rounded(-length / 2, length / 2, notch, 0.05), height - 0.015, height - 0.008)
    look.prism("painted", rounded(-length / 2 + 0.008, length / 2 - 0.008, notch - 0.008, 0.046), height - 0.008, height)
    look.write()


def cross_sum(outline):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, outline[1:] + outline[:1]))


def pioneer_at(name, size, sonars):
    """A hull on four large wheels."""
    length, width, height = size
    look = Look(name, size)
    radius, tyre = 0.111, 0.075
    inner = width / 2 - tyre - 0.012
    look.prism("painted", rounded(-length / 2 + 0.06, length / 2 - 0.06, inner, 0.03), 0.065, height - 0.015)
    for x in (-length / 2 + radius + 0.01, length / 2 - radius - 0.01):
        for sign in (1, -1):
            look.wheel(x, sign * (width - tyre) / 2, radius, tyre)
    ring = height - 0.065, height - 0.015
    for arc in ([s for s in sonars if s[0] > 0], [s for s in sonars if s[0] < 0]):
        outline = [(x, y) for x, y, _ in arc]
        look.prism("dark", outline if cross_sum(outline) > 0 else outline[::-1], *ring)
    look.transducers(sonars, (ring[0] + ring[1]) / 2)
    look.prism("dark", rounded(-length / 2, length / 2, inner - 0.002, 0.06), height - 0.015, height - 0.008)
    look.prism("painted", rounded(-length / 2 + 0.01, length / 2 - 0.01, inner - 0.012, 0.055), height - 0.008, height)
    look.write()


def amigobot():
    size = length, width, height = 0.33, 0.28, 0.25
    look = Look("amigobot", size)
    radius, tyre = 0.05, 0.03
    for sign in (1, -1):
        look.wheel(0.0, sign * (width - tyre) / 2, radius, tyre)
    look.caster(-0.12, 0.025, 0.02, 0.05)
    look.prism("painted", rounded(-length / 2, length / 2, width / 2 - tyre - 0.004, 0.05), 0.04, 0.13)
    look.prism("dark", rounded(-length / 2 + 0.01, length / 2 - 0.01, width / 2 - tyre - 0.014, 0.05), 0.13, 0.2)
    sonars = [(0.073, 0.105, 90), (0.13, 0.078, 41), (0.154, 0.03, 15), (0.154, -0.03, -15), (0.13, -0.078, -41), (0.073, -0.105, -90),
              (-0.146, -0.06, -145), (-0.146, 0.06, 145)]
    look.transducers([(min(max(x, -0.15), 0.15), min(max(y, -0.094), 0.094), a) for x, y, a in sonars], 0.165)
    look.prism("painted", rounded(-length / 2 + 0.02, length / 2 - 0.02, width / 2 - tyre - 0.02, 0.05), 0.2, height)
    look.write()


def roomba():
    """A disc with a bumper around its front half."""
    radius, height = 0.165, 0.1
    look = Look("roomba", (2 * radius, 2 * radius, height))
    for sign in (1, -1):
        look.wheel(0, sign * 0.115, 0.033, 0.024)
    look.caster(0.12, 0.014, 0.014, 0.03)
    look.drum("painted", (0, 0, 1), (0, 0, 0.045), radius - 0.008, 0.06, 40)
    look.drum("painted", (0, 0, 1), (0, 0, 0.08), radius, 0.01, 40)
    for k in range(12):   # the bumper in straight pieces
        a, b = (math.pi * (k / 12 - 0.5), math.pi * ((k + 1) / 12 - 0.5))
        at = [(r * math.cos(t), r * math.sin(t)) for r, t in ((radius - 0.01, a), (radius, a), (radius, b), (radius - 0.01, b))]
        look.prism("dark", at, 0.018, 0.075)
    look.drum("metal", (0, 0, 1), (0, 0, 0.0875), radius - 0.03, 0.005, 40)
    look.drum("painted", (0, 0, 1), (0, 0, 0.0925), radius - 0.04, 0.005, 40)
    look.drum("dark", (0, 0, 1), (0.135, 0, 0.0925), 0.012, 0.015, 16)   # the window that sees the base
    look.drum("green", (0, 0, 1), (0.04, 0, 0.0965), 0.014, 0.007, 16)
    look.write()


def footbot():
    """Treads beneath, a ring of lights, a beacon on top."""
    radius, height = 0.085, 0.146
    look = Look("footbot", (2 * radius, 2 * radius, height))
    for sign in (1, -1):
        look.box("tyre", (0, sign * 0.055, 0.02), (0.11, 0.02, 0.04))
        for x in (-0.04, 0.04):
            look.drum("metal", (0, 1, 0), (x, sign * 0.055, 0.02), 0.014, 0.026, 12)
    look.drum("painted", (0, 0, 1), (0, 0, 0.055), radius, 0.05, 32)
    look.drum("dark", (0, 0, 1), (0, 0, 0.085), 0.8 * radius, 0.01, 32)
    look.drum("painted", (0, 0, 1), (0, 0, 0.1), 0.9 * radius, 0.02, 32)
    for k in range(12):
        a = math.pi * k / 6
        look.box("green", (0.9 * radius * math.cos(a) * 0.97, 0.9 * radius * math.sin(a) * 0.97, 0.113), (0.01, 0.01, 0.006))
    look.drum("glass", (0, 0, 1), (0, 0, 0.126), 0.025, 0.032, 20)
    look.drum("orange", (0, 0, 1), (0, 0, 0.144), 0.02, 0.004, 20)
    look.write()


def sick():
    """A box with a dark window that goes round its front."""
    size = length, width, height = 0.156, 0.155, 0.19
    look = Look("sick", size)
    back, front = -length / 2, length / 2
    look.prism("painted", [(front, -0.05), (front, 0.05), (0.05, width / 2), (back, width / 2), (back, -width / 2), (0.05, -width / 2)], 0, 0.05)
    look.prism("painted", [(-0.02, -width / 2), (-0.02, width / 2), (back, width / 2), (back, -width / 2)], 0.05, height)
    look.prism("glass", circle(0.06, 16, (0.005, 0), -math.pi / 2, math.pi / 2) + [(-0.02, 0.06), (-0.02, -0.06)], 0.05, 0.125)
    look.prism("painted", circle(0.0735, 16, (0.0, 0), -math.pi / 2, math.pi / 2) + [(-0.02, 0.0735), (-0.02, -0.0735)], 0.125, height)
    look.drum("green", (1, 0, 0), (0.073, 0, 0.16), 0.005, 0.004, 10)
    look.drum("orange", (1, 0, 0), (0.072, 0.02, 0.16), 0.005, 0.004, 10)
    look.write()


def hokuyo():
    size = length, width, height = 0.07, 0.07, 0.05
    look = Look("hokuyo", size)
    look.prism("painted", rounded(-length / 2, length / 2, width / 2, 0.008), 0, 0.022)
    look.drum("glass", (0, 0, 1), (0, 0, 0.03), 0.028, 0.016, 24)
    look.drum("painted", (0, 0, 1), (0, 0, 0.044), 0.031, 0.012, 24)
    look.write()


def vlp16():
    radius, height = 0.052, 0.072
    look = Look("vlp16", (2 * radius, 2 * radius, height))
    look.drum("painted", (0, 0, 1), (0, 0, 0.0095), radius, 0.019, 36)
    look.drum("glass", (0, 0, 1), (0, 0, 0.0375), radius - 0.001, 0.037, 36)
    look.drum("painted", (0, 0, 1), (0, 0, 0.064), radius, 0.016, 36)
    look.write()


def ring(places, shift):
    """Sonars of a file, in the frame of the middle of the body."""
    return [(x + shift, y, heading) for x, y, heading in places]


DX2 = [(0.075, 0.13, 90), (0.115, 0.115, 50), (0.15, 0.08, 30), (0.17, 0.025, 10), (0.17, -0.025, -10), (0.15, -0.08, -30), (0.115, -0.115, -50),
       (0.075, -0.13, -90), (-0.155, -0.13, -90), (-0.195, -0.115, -130), (-0.23, -0.08, -150), (-0.25, -0.025, -170), (-0.25, 0.025, 170),
       (-0.23, 0.08, 150), (-0.195, 0.115, 130), (-0.155, 0.13, 90)]
AT3 = [(0.147, 0.136, 90), (0.193, 0.119, 50), (0.227, 0.079, 30), (0.245, 0.027, 10), (0.245, -0.027, -10), (0.227, -0.079, -30), (0.193, -0.119, -50),
       (0.147, -0.136, -90), (-0.144, -0.136, -90), (-0.189, -0.119, -130), (-0.223, -0.079, -150), (-0.241, -0.027, -170), (-0.241, 0.027, 170),
       (-0.223, 0.079, 150), (-0.189, 0.119, 130), (-0.144, 0.136, 90)]


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / "looks.mtl").write_text("# Generated by tools/make_looks.py: edit that.\n" + "".join(
        f"newmtl {name}\nKd {r:g} {g:g} {b:g}\n" for name, (r, g, b) in COLORS.items()))
    pioneer_dx("pioneer2dx", (0.44, 0.38, 0.22), 0.04, ring(DX2, 0.04))
    pioneer_dx("pioneer3dx", (0.511, 0.4, 0.22), 0.045, ring(DX2, 0.045))
    pioneer_at("pioneer3at", (0.626, 0.505, 0.277), ring(AT3, 0.02))
    amigobot(), roomba(), footbot(), sick(), hokuyo(), vlp16()
