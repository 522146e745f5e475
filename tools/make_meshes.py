#!/usr/bin/env python3
"""Generates the COLLADA files and the texture of worlds/mesh.world: a table of planks, a barrel, a ramp. Metres, z up."""

import math
import pathlib
import struct
import zlib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "worlds/meshes"

HEAD = """<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><created>2026-11-25T00:00:00Z</created><modified>2026-11-25T00:00:00Z</modified>
<unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
"""


class Solid:
    """Vertices with normals and texture coordinates, and triangles."""

    def __init__(self):
        self.corners, self.triangles = [], []

    def add(self, points, uv=None):
        """A flat convex polygon, counter-clockwise from outside."""
        a, b, c = points[:3]
        u, v = [[q[i] - a[i] for i in range(3)] for q in (b, c)]
        n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        size = math.sqrt(sum(x * x for x in n))
        first = len(self.corners)
        for k, p in enumerate(points):
            place = uv[k] if uv else (0, 0)
            self.corners.append((p, [x / size for x in n], place))
        self.triangles += [(first, first + k, first + k + 1) for k in range(1, len(points) - 1)]

    def add_box(self, middle, half, planks=1):
        (x, y, z), (a, b, c) = middle, half
        at = lambda i, j, k: (x + i * a, y + j * b, z + k * c)
        whole = [(0, 0), (planks, 0), (planks, 1), (0, 1)]
        for face in (((-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)), ((-1, 1, -1), (1, 1, -1), (1, -1, -1), (-1, -1, -1)),
                     ((-1, -1, -1), (1, -1, -1), (1, -1, 1), (-1, -1, 1)), ((1, 1, -1), (-1, 1, -1), (-1, 1, 1), (1, 1, 1)),
                     ((1, -1, -1), (1, 1, -1), (1, 1, 1), (1, -1, 1)), ((-1, 1, -1), (-1, -1, -1), (-1, -1, 1), (-1, 1, 1))):
            self.add([at(*corner) for corner in face], whole)

    def add_ring(self, low, high, count):
        """The lateral surface between two circles (radius, z) about z."""
        for k in range(count):
            a, b = (2 * math.pi * i / count for i in (k, k + 1))
            on = lambda turn, ring: (ring[0] * math.cos(turn), ring[0] * math.sin(turn), ring[1])
            self.add([on(a, low), on(b, low), on(b, high), on(a, high)])

    def add_disc(self, radius, z, count, up):
        points = [(radius * math.cos(2 * math.pi * k / count), radius * math.sin(2 * math.pi * k / count), z) for k in range(count)]
        self.add(points if up else points[::-1])


def source(name, values, names):
    numbers = " ".join(f"{x:.6g}" for value in values for x in value)
    params = "".join(f'<param name="{n}" type="float"/>' for n in names)
    return (f'<source id="{name}"><float_array id="{name}-a" count="{len(values) * len(names)}">{numbers}</float_array><technique_common>'
            f'<accessor source="#{name}-a" count="{len(values)}" stride="{len(names)}">{params}</accessor></technique_common></source>\n')


def geometry(name, solid):
    rows = " ".join(str(k) for triangle in solid.triangles for k in triangle)
    points, normals, places = zip(*solid.corners)
    return (f'<geometry id="{name}"><mesh>\n{source(name + "-p", points, "XYZ")}{source(name + "-n", normals, "XYZ")}{source(name + "-t", places, "ST")}'
            f'<vertices id="{name}-v"><input semantic="POSITION" source="#{name}-p"/></vertices>\n'
            f'<triangles material="m" count="{len(solid.triangles)}"><input semantic="VERTEX" source="#{name}-v" offset="0"/>'
            f'<input semantic="NORMAL" source="#{name}-n" offset="0"/><input semantic="TEXCOORD" source="#{name}-t" offset="0" set="0"/>'
            f'<p>{rows}</p></triangles></mesh></geometry>\n')


def effect(name, color=None, shine=None):
    texture = ('<newparam sid="s"><surface type="2D"><init_from>picture</init_from></surface></newparam>'
               '<newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>')
    diffuse = f'<color>{" ".join(map(str, color))} 1</color>' if color else '<texture texture="t" texcoord="uv"/>'
    gloss = f"<specular><color>0.4 0.4 0.4 1</color></specular><shininess><float>{shine}</float></shininess>" if shine else ""
    model = "phong" if shine else "lambert"
    return (f'<effect id="{name}-fx"><profile_COMMON>{"" if color else texture}<technique sid="c"><{model}><diffuse>{diffuse}</diffuse>{gloss}</{model}>'
            "</technique></profile_COMMON></effect>\n")


def physics(shapes, mass, friction, restitution):
    return ('<library_physics_materials><physics_material id="rub"><technique_common>'
            f"<dynamic_friction>{friction}</dynamic_friction><restitution>{restitution}</restitution></technique_common></physics_material></library_physics_materials>\n"
            '<library_physics_models><physics_model id="model"><rigid_body sid="body"><technique_common><dynamic>true</dynamic>'
            f'<mass>{mass}</mass><instance_physics_material url="#rub"/>\n{shapes}</technique_common></rigid_body></physics_model></library_physics_models>\n'
            '<library_physics_scenes><physics_scene id="forces"><instance_physics_model url="#model">'
            '<instance_rigid_body body="body" target="#top"/></instance_physics_model></physics_scene></library_physics_scenes>\n')


def write(name, parts, forces="", has_picture=False):
    """`parts`: (name, solid, effect)."""
    nodes = "".join(
        f'<instance_geometry url="#{part}"><bind_material><technique_common><instance_material symbol="m" target="#{part}-m">'
        '<bind_vertex_input semantic="uv" input_semantic="TEXCOORD" input_set="0"/></instance_material></technique_common></bind_material></instance_geometry>\n'
        for part, _, _ in parts)
    picture = '<library_images><image id="picture"><init_from>planks.png</init_from></image></library_images>\n' if has_picture else ""
    materials = "".join(f'<material id="{part}-m" name="{part}"><instance_effect url="#{part}-fx"/></material>' for part, _, _ in parts)
    text = (HEAD + picture + "<library_effects>\n" + "".join(look for _, _, look in parts) + "</library_effects>\n<library_materials>" + materials
            + "</library_materials>\n<library_geometries>\n" + "".join(geometry(part, solid) for part, solid, _ in parts) + "</library_geometries>\n" + forces
            + f'<library_visual_scenes><visual_scene id="scene"><node id="top" name="top">\n{nodes}</node></visual_scene></library_visual_scenes>\n'
            '<scene>' + ('<instance_physics_scene url="#forces"/>' if forces else "") + '<instance_visual_scene url="#scene"/></scene>\n</COLLADA>\n')
    (FOLDER / f"{name}.dae").write_text(text)


def box_shape(middle, half):
    return (f'<shape><translate>{" ".join(f"{x:g}" for x in middle)}</translate><box><half_extents>{" ".join(f"{x:g}" for x in half)}'
            "</half_extents></box></shape>\n")


def table():
    top, legs = Solid(), Solid()
    boxes = [((0, 0, 0.72), (0.6, 0.4, 0.02))] + [((x, y, 0.35), (0.03, 0.03, 0.35)) for x in (-0.54, 0.54) for y in (-0.34, 0.34)]
    top.add_box(*boxes[0], planks=2)
    for box in boxes[1:]:
        legs.add_box(*box)
    forces = physics("".join(box_shape(*box) for box in boxes), 14, 0.6, 0.1)
    write("table", [("board", top, effect("board")), ("legs", legs, effect("legs", (0.25, 0.2, 0.16)))], forces, True)


def barrel():
    wood, hoops = Solid(), Solid()
    wood.add_ring((0.24, 0), (0.29, 0.4), 24)
    wood.add_ring((0.29, 0.4), (0.24, 0.8), 24)
    wood.add_disc(0.24, 0.8, 24, True)
    wood.add_disc(0.24, 0, 24, False)
    for z in (0.12, 0.6):
        hoops.add_ring((0.285, z), (0.285, z + 0.06), 24)
    shape = "<shape><translate>0 0 0.4</translate><rotate>1 0 0 90</rotate><cylinder><height>0.8</height><radius>0.27 0.27</radius></cylinder></shape>\n"
    write("barrel", [("staves", wood, effect("staves", (0.72, 0.34, 0.12))), ("hoops", hoops, effect("hoops", (0.3, 0.32, 0.35), 40))],
          physics(shape, 9, 0.5, 0.2))


def ramp():
    solid = Solid()
    low, high, half, top = -1.2, 1.2, 0.6, 0.25
    begin, end = low + 1, high - 1
    solid.add([(low, half, 0), (low, -half, 0), (begin, -half, top), (begin, half, top)])
    solid.add([(begin, -half, top), (end, -half, top), (end, half, top), (begin, half, top)])
    solid.add([(end, -half, top), (high, -half, 0), (high, half, 0), (end, half, top)])
    solid.add([(low, -half, 0), (high, -half, 0), (end, -half, top), (begin, -half, top)])
    solid.add([(high, half, 0), (low, half, 0), (begin, half, top), (end, half, top)])
    solid.add([(low, half, 0), (high, half, 0), (high, -half, 0), (low, -half, 0)])
    write("ramp", [("ramp", solid, effect("ramp", (0.55, 0.57, 0.6)))])


def planks(width=64, height=64):
    """Four planks side by side, with grain."""
    rows = b""
    for y in range(height):
        rows += b"\0"
        for x in range(width):
            plank, edge = y // 16, y % 16 == 0
            grain = 0.5 + 0.5 * math.sin(0.9 * y + 0.35 * math.sin(0.2 * x + 3 * plank) * 4)
            light = 0.35 if edge else 0.75 + 0.18 * grain - 0.05 * (plank % 2)
            rows += bytes(round(light * c) for c in (196, 142, 84)) + b"\xff"

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    (FOLDER / "planks.png").write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
                                        + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for make in (table, barrel, ramp, planks):
        make()
