"""Interface map, code 42. Grid and vector maps.

Generated from interfaces/042_map.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 42


@dataclass
class Info(Struct):
    """Size, scale and origin of the map. (player_map_info_t)"""

    # Cell size (in m/pixel).
    scale: float = 0.0
    # In px.
    width: int = 0
    # In px.
    height: int = 0
    # Of the lower left corner of cell (0, 0) (in m, m, rad, frame X_WM).
    origin: common.Pose2d = field(default_factory=common.Pose2d)

    def write(self, writer: Writer) -> None:
        writer.number("f", self.scale)
        writer.number("I", self.width)
        writer.number("I", self.height)
        self.origin.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Info":
        self = cls()
        self.scale = reader.number("f")
        self.width = reader.number("I")
        self.height = reader.number("I")
        self.origin = common.Pose2d.read(reader)
        return self


@dataclass
class Data(Struct):
    """A rectangle of cells. (player_map_data_t)"""

    # First column, from the left (in px).
    col: int = 0
    # First row, from the bottom (in px).
    row: int = 0
    # In px.
    width: int = 0
    # In px.
    height: int = 0
    # Value of a cell that is certainly occupied; its negative: certainly free, 0: unknown.
    data_range: int = 0
    # Rows, concatenated; compressed with zlib in an answer, empty in a request.
    data: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.number("I", self.col)
        writer.number("I", self.row)
        writer.number("I", self.width)
        writer.number("I", self.height)
        writer.length("data", len(self.data), 33554392)
        writer.number("b", self.data_range)
        writer.length("data", len(self.data), 33554392)
        writer.opaque(self.data)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.col = reader.number("I")
        self.row = reader.number("I")
        self.width = reader.number("I")
        self.height = reader.number("I")
        data_count = reader.number("I")
        self.data_range = reader.number("b")
        self.data = reader.opaque(reader.length("data", data_count, 1))
        return self


@dataclass
class DataVector(Struct):
    """The map as line segments, and its extent. (player_map_data_vector_t)"""

    # In m.
    minx: float = 0.0
    # In m.
    maxx: float = 0.0
    # In m.
    miny: float = 0.0
    # In m.
    maxy: float = 0.0
    # One per line (in m, frame p_MP).
    segments: List[common.Segment] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.number("f", self.minx)
        writer.number("f", self.maxx)
        writer.number("f", self.miny)
        writer.number("f", self.maxy)
        writer.length("segments", len(self.segments), 1048574)
        writer.length("segments", len(self.segments), 1048574)
        for item in self.segments:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "DataVector":
        self = cls()
        self.minx = reader.number("f")
        self.maxx = reader.number("f")
        self.miny = reader.number("f")
        self.maxy = reader.number("f")
        segments_count = reader.number("I")
        segments_length = reader.length("segments", segments_count, 32)
        self.segments = [common.Segment.read(reader) for _ in range(segments_length)]
        return self


# Size and scale of the map, sent on change.
DATA_INFO = MessageType(42, Kind.DATA, 1, "map.data.info", Info)
# Requests the size and scale of the map.
REQ_GET_INFO = MessageType(42, Kind.REQ, 1, "map.req.get_info", Info)
# Requests a rectangle of cells; the answer's cells are compressed with zlib.
REQ_GET_DATA = MessageType(42, Kind.REQ, 2, "map.req.get_data", Data)
# Requests the map as lines.
REQ_GET_VECTOR = MessageType(42, Kind.REQ, 3, "map.req.get_vector", DataVector)
