"""Interface graphics3d, code 58. Draws 3D shapes for display.

Generated from interfaces/058_graphics3d.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 58

# Values of CmdDraw.draw_mode: primitives made from the points.
DRAW_POINTS = 0
DRAW_LINES = 1
DRAW_LINE_STRIP = 2
DRAW_LINE_LOOP = 3
DRAW_TRIANGLES = 4
DRAW_TRIANGLE_STRIP = 5
DRAW_TRIANGLE_FAN = 6
DRAW_QUADS = 7
DRAW_QUAD_STRIP = 8
DRAW_POLYGON = 9


@dataclass
class CmdDraw(Struct):
    """Points, lines or faces. (player_graphics3d_cmd_draw_t)"""

    draw_mode: int = 0
    # In m, frame p_SP.
    points: List[common.Point3d] = field(default_factory=list)
    color: common.Color = field(default_factory=common.Color)

    def write(self, writer: Writer) -> None:
        writer.number("I", self.draw_mode)
        writer.length("points", len(self.points), 1398099)
        writer.length("points", len(self.points), 1398099)
        for item in self.points:
            item.write(writer)
        self.color.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "CmdDraw":
        self = cls()
        self.draw_mode = reader.number("I")
        points_count = reader.number("I")
        points_length = reader.length("points", points_count, 24)
        self.points = [common.Point3d.read(reader) for _ in range(points_length)]
        self.color = common.Color.read(reader)
        return self


@dataclass
class CmdTranslate(Struct):
    """A translation of the coordinate frame. (player_graphics3d_cmd_translate_t)"""

    # In m.
    x: float = 0.0
    # In m.
    y: float = 0.0
    # In m.
    z: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.x)
        writer.number("d", self.y)
        writer.number("d", self.z)

    @classmethod
    def read(cls, reader: Reader) -> "CmdTranslate":
        self = cls()
        self.x = reader.number("d")
        self.y = reader.number("d")
        self.z = reader.number("d")
        return self


@dataclass
class CmdRotate(Struct):
    """A rotation of the coordinate frame. (player_graphics3d_cmd_rotate_t)"""

    # Angle about the vector (x, y, z) (in rad).
    a: float = 0.0
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.a)
        writer.number("d", self.x)
        writer.number("d", self.y)
        writer.number("d", self.z)

    @classmethod
    def read(cls, reader: Reader) -> "CmdRotate":
        self = cls()
        self.a = reader.number("d")
        self.x = reader.number("d")
        self.y = reader.number("d")
        self.z = reader.number("d")
        return self


# Removes all drawn shapes.
CMD_CLEAR = MessageType(58, Kind.CMD, 1, "graphics3d.cmd.clear")
# Draws points, lines or faces.
CMD_DRAW = MessageType(58, Kind.CMD, 2, "graphics3d.cmd.draw", CmdDraw)
# Translates the coordinate frame of subsequent drawing.
CMD_TRANSLATE = MessageType(58, Kind.CMD, 3, "graphics3d.cmd.translate", CmdTranslate)
# Rotates the coordinate frame of subsequent drawing.
CMD_ROTATE = MessageType(58, Kind.CMD, 4, "graphics3d.cmd.rotate", CmdRotate)
# Pushes the current coordinate frame.
CMD_PUSH = MessageType(58, Kind.CMD, 5, "graphics3d.cmd.push")
# Pops the pushed coordinate frame.
CMD_POP = MessageType(58, Kind.CMD, 6, "graphics3d.cmd.pop")
