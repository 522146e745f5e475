"""Interface fiducial, code 10. Sees marked things and tells which and where they are.

Generated from interfaces/010_fiducial.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 10


@dataclass
class Item(Struct):
    """One marker in view. (player_fiducial_item_t)"""

    # Number of the marker; if it cannot be told -1, from simulated finders 0.
    id: int = 0
    # Where the marker is (in m, m, m, rad, rad, rad, frame X_ST).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # Standard deviation of each part of the pose; 0 if unknown (in m, m, m, rad, rad, rad, frame X_ST).
    upose: common.Pose3d = field(default_factory=common.Pose3d)

    def write(self, writer: Writer) -> None:
        writer.number("i", self.id)
        self.pose.write(writer)
        self.upose.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Item":
        self = cls()
        self.id = reader.number("i")
        self.pose = common.Pose3d.read(reader)
        self.upose = common.Pose3d.read(reader)
        return self


@dataclass
class Data(Struct):
    """The markers in view. (player_fiducial_data_t)"""

    fiducials: List[Item] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("fiducials", len(self.fiducials), 335543)
        writer.length("fiducials", len(self.fiducials), 335543)
        for item in self.fiducials:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        fiducials_count = reader.number("I")
        fiducials_length = reader.length("fiducials", fiducials_count, 100)
        self.fiducials = [Item.read(reader) for _ in range(fiducials_length)]
        return self


@dataclass
class Geom(Struct):
    """Size and place. (player_fiducial_geom_t)"""

    # Where the device is on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # Of a box around the device (in m, m, m).
    size: common.Bbox3d = field(default_factory=common.Bbox3d)
    # Of the markers; 0 if unknown (in m, m).
    fiducial_size: common.Bbox2d = field(default_factory=common.Bbox2d)

    def write(self, writer: Writer) -> None:
        self.pose.write(writer)
        self.size.write(writer)
        self.fiducial_size.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Geom":
        self = cls()
        self.pose = common.Pose3d.read(reader)
        self.size = common.Bbox3d.read(reader)
        self.fiducial_size = common.Bbox2d.read(reader)
        return self


@dataclass
class Fov(Struct):
    """How far and how wide the device sees. (player_fiducial_fov_t)"""

    # In m.
    min_range: float = 0.0
    # In m.
    max_range: float = 0.0
    # From the first to the last direction (in rad).
    view_angle: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.min_range)
        writer.number("f", self.max_range)
        writer.number("f", self.view_angle)

    @classmethod
    def read(cls, reader: Reader) -> "Fov":
        self = cls()
        self.min_range = reader.number("f")
        self.max_range = reader.number("f")
        self.view_angle = reader.number("f")
        return self


@dataclass
class Id(Struct):
    """A marker's number. (player_fiducial_id_t)"""

    id: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.id)

    @classmethod
    def read(cls, reader: Reader) -> "Id":
        self = cls()
        self.id = reader.number("I")
        return self


# The markers in view.
DATA_SCAN = MessageType(10, Kind.DATA, 1, "fiducial.data.scan", Data)
# Asks for the device's size and place and the markers' size.
REQ_GET_GEOM = MessageType(10, Kind.REQ, 1, "fiducial.req.get_geom", Geom)
# Asks how far and how wide the device sees.
REQ_GET_FOV = MessageType(10, Kind.REQ, 2, "fiducial.req.get_fov", Fov)
# Sets how far and how wide the device sees; the answer tells what was taken.
REQ_SET_FOV = MessageType(10, Kind.REQ, 3, "fiducial.req.set_fov", Fov)
# Asks for the number that the robot itself shows to others.
REQ_GET_ID = MessageType(10, Kind.REQ, 7, "fiducial.req.get_id", Id)
# Sets the number that the robot itself shows to others.
REQ_SET_ID = MessageType(10, Kind.REQ, 8, "fiducial.req.set_id", Id)
