"""Interface fiducial, code 10. Detects markers and reports their ids and poses.

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

    # Id of the marker; -1 if it cannot be identified, from simulated finders 0.
    id: int = 0
    # Pose of the marker (in m, m, m, rad, rad, rad, frame X_ST).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # Standard deviation of each component of the pose; 0 if unknown (in m, m, m, rad, rad, rad, frame X_ST).
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
    """Size and pose. (player_fiducial_geom_t)"""

    # Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # Bounding box of the device (in m, m, m).
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
    """Range and field of view. (player_fiducial_fov_t)"""

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
    """A marker id. (player_fiducial_id_t)"""

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
# Requests the device's size and pose and the markers' size.
REQ_GET_GEOM = MessageType(10, Kind.REQ, 1, "fiducial.req.get_geom", Geom)
# Requests the range and the field of view.
REQ_GET_FOV = MessageType(10, Kind.REQ, 2, "fiducial.req.get_fov", Fov)
# Sets the range and the field of view; the answer has the values in effect.
REQ_SET_FOV = MessageType(10, Kind.REQ, 3, "fiducial.req.set_fov", Fov)
# Requests the robot's own marker id.
REQ_GET_ID = MessageType(10, Kind.REQ, 7, "fiducial.req.get_id", Id)
# Sets the robot's own marker id.
REQ_SET_ID = MessageType(10, Kind.REQ, 8, "fiducial.req.set_id", Id)
