"""Interface pointcloud3d, code 61. Points in space with colors.

Generated from interfaces/061_pointcloud3d.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 61


@dataclass
class Element(Struct):
    """One point. (player_pointcloud3d_element_t)"""

    # In m, frame p_SP.
    point: common.Point3d = field(default_factory=common.Point3d)
    color: common.Color = field(default_factory=common.Color)

    def write(self, writer: Writer) -> None:
        self.point.write(writer)
        self.color.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Element":
        self = cls()
        self.point = common.Point3d.read(reader)
        self.color = common.Color.read(reader)
        return self


@dataclass
class Data(Struct):
    """One cloud. (player_pointcloud3d_data_t)"""

    points: List[Element] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("points", len(self.points), 838859)
        writer.length("points", len(self.points), 838859)
        for item in self.points:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        points_count = reader.number("I")
        points_length = reader.length("points", points_count, 40)
        self.points = [Element.read(reader) for _ in range(points_length)]
        return self


# One cloud.
DATA_STATE = MessageType(61, Kind.DATA, 1, "pointcloud3d.data.state", Data)
