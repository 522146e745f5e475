"""Interface bumper, code 14. Contact switches.

Generated from interfaces/014_bumper.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 14


@dataclass
class Data(Struct):
    """Which bumpers are pressed. (player_bumper_data_t)"""

    # One per bumper: 0 free, else pressed.
    bumpers: bytes = b""

    def write(self, writer: Writer) -> None:
        writer.length("bumpers", len(self.bumpers), 33554392)
        writer.length("bumpers", len(self.bumpers), 33554392)
        writer.opaque(self.bumpers)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        bumpers_count = reader.number("I")
        self.bumpers = reader.opaque(reader.length("bumpers", bumpers_count, 1))
        return self


@dataclass
class Define(Struct):
    """One bumper. (player_bumper_define_t)"""

    # Of the bumper's centre (in m, m, m, rad, rad, rad, frame X_RS).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # In m.
    length: float = 0.0
    # Radius of curvature; 0 if it is straight (in m).
    radius: float = 0.0

    def write(self, writer: Writer) -> None:
        self.pose.write(writer)
        writer.number("f", self.length)
        writer.number("f", self.radius)

    @classmethod
    def read(cls, reader: Reader) -> "Define":
        self = cls()
        self.pose = common.Pose3d.read(reader)
        self.length = reader.number("f")
        self.radius = reader.number("f")
        return self


@dataclass
class Geom(Struct):
    """Poses of the bumpers. (player_bumper_geom_t)"""

    bumper_def: List[Define] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("bumper_def", len(self.bumper_def), 599185)
        writer.length("bumper_def", len(self.bumper_def), 599185)
        for item in self.bumper_def:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Geom":
        self = cls()
        bumper_def_count = reader.number("I")
        bumper_def_length = reader.length("bumper_def", bumper_def_count, 56)
        self.bumper_def = [Define.read(reader) for _ in range(bumper_def_length)]
        return self


# Which bumpers are pressed.
DATA_STATE = MessageType(14, Kind.DATA, 1, "bumper.data.state", Data)
# Poses of the bumpers, sent on change.
DATA_GEOM = MessageType(14, Kind.DATA, 2, "bumper.data.geom", Geom)
# Requests the poses of the bumpers.
REQ_GET_GEOM = MessageType(14, Kind.REQ, 1, "bumper.req.get_geom", Geom)
