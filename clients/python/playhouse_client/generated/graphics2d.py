"""Interface graphics2d, code 55. Draws 2D shapes for display.

Generated from interfaces/055_graphics2d.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 55


@dataclass
class CmdPoints(Struct):
    """Points. (player_graphics2d_cmd_points_t)"""

    # In m, frame p_SP.
    points: List[common.Point2d] = field(default_factory=list)
    color: common.Color = field(default_factory=common.Color)

    def write(self, writer: Writer) -> None:
        writer.length("points", len(self.points), 2097149)
        writer.length("points", len(self.points), 2097149)
        for item in self.points:
            item.write(writer)
        self.color.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "CmdPoints":
        self = cls()
        points_count = reader.number("I")
        points_length = reader.length("points", points_count, 16)
        self.points = [common.Point2d.read(reader) for _ in range(points_length)]
        self.color = common.Color.read(reader)
        return self


@dataclass
class CmdPolyline(Struct):
    """A line through points. (player_graphics2d_cmd_polyline_t)"""

    # In m, frame p_SP.
    points: List[common.Point2d] = field(default_factory=list)
    color: common.Color = field(default_factory=common.Color)

    def write(self, writer: Writer) -> None:
        writer.length("points", len(self.points), 2097149)
        writer.length("points", len(self.points), 2097149)
        for item in self.points:
            item.write(writer)
        self.color.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "CmdPolyline":
        self = cls()
        points_count = reader.number("I")
        points_length = reader.length("points", points_count, 16)
        self.points = [common.Point2d.read(reader) for _ in range(points_length)]
        self.color = common.Color.read(reader)
        return self


@dataclass
class CmdPolygon(Struct):
    """A polygon. (player_graphics2d_cmd_polygon_t)"""

    # Vertices (in m, frame p_SP).
    points: List[common.Point2d] = field(default_factory=list)
    # Outline color.
    color: common.Color = field(default_factory=common.Color)
    # Fill color.
    fill_color: common.Color = field(default_factory=common.Color)
    # 1: filled.
    filled: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("points", len(self.points), 2097149)
        writer.length("points", len(self.points), 2097149)
        for item in self.points:
            item.write(writer)
        self.color.write(writer)
        self.fill_color.write(writer)
        writer.number("B", self.filled)

    @classmethod
    def read(cls, reader: Reader) -> "CmdPolygon":
        self = cls()
        points_count = reader.number("I")
        points_length = reader.length("points", points_count, 16)
        self.points = [common.Point2d.read(reader) for _ in range(points_length)]
        self.color = common.Color.read(reader)
        self.fill_color = common.Color.read(reader)
        self.filled = reader.number("B")
        return self


@dataclass
class CmdMultiline(Struct):
    """Lines, each between two points. (player_graphics2d_cmd_multiline_t)"""

    # Start and end of each line, alternating (in m, frame p_SP).
    points: List[common.Point2d] = field(default_factory=list)
    color: common.Color = field(default_factory=common.Color)

    def write(self, writer: Writer) -> None:
        writer.length("points", len(self.points), 2097149)
        writer.length("points", len(self.points), 2097149)
        for item in self.points:
            item.write(writer)
        self.color.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "CmdMultiline":
        self = cls()
        points_count = reader.number("I")
        points_length = reader.length("points", points_count, 16)
        self.points = [common.Point2d.read(reader) for _ in range(points_length)]
        self.color = common.Color.read(reader)
        return self


# Removes all drawn shapes.
CMD_CLEAR = MessageType(55, Kind.CMD, 1, "graphics2d.cmd.clear")
# Draws points.
CMD_POINTS = MessageType(55, Kind.CMD, 2, "graphics2d.cmd.points", CmdPoints)
# Draws a line through points.
CMD_POLYLINE = MessageType(55, Kind.CMD, 3, "graphics2d.cmd.polyline", CmdPolyline)
# Draws a polygon.
CMD_POLYGON = MessageType(55, Kind.CMD, 4, "graphics2d.cmd.polygon", CmdPolygon)
# Draws a line for each pair of points.
CMD_MULTILINE = MessageType(55, Kind.CMD, 5, "graphics2d.cmd.multiline", CmdMultiline)
