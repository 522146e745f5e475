"""Interface laser, code 6. A scanning range finder. New drivers use the ranger interface.

Generated from interfaces/006_laser.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 6

# Largest number of filter parameters.
MAX_FILTER_PARAMS = 8

# Values of SetFilterConfig.filter_type.
FILTER_MEDIAN = 1
FILTER_EDGE = 2
FILTER_RANGE = 3
FILTER_MEAN = 4


@dataclass
class Data(Struct):
    """One scan at equal angles. (player_laser_data_t)"""

    # Of the first beam, counter-clockwise from x (in rad).
    min_angle: float = 0.0
    # Of the last beam (in rad).
    max_angle: float = 0.0
    # Angle between neighbouring beams (in rad).
    resolution: float = 0.0
    # Reported range of a beam without a hit (in m).
    max_range: float = 0.0
    # From right to left (in m).
    ranges: List[float] = field(default_factory=list)
    # Intensity of the echo per beam; empty if the device has none.
    intensity: bytes = b""
    # Increases from scan to scan, by one or more.
    id: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.min_angle)
        writer.number("f", self.max_angle)
        writer.number("f", self.resolution)
        writer.number("f", self.max_range)
        writer.length("ranges", len(self.ranges), 8388598)
        writer.length("ranges", len(self.ranges), 8388598)
        writer.numbers("f", self.ranges)
        writer.length("intensity", len(self.intensity), 33554392)
        writer.length("intensity", len(self.intensity), 33554392)
        writer.opaque(self.intensity)
        writer.number("I", self.id)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.min_angle = reader.number("f")
        self.max_angle = reader.number("f")
        self.resolution = reader.number("f")
        self.max_range = reader.number("f")
        ranges_count = reader.number("I")
        self.ranges = reader.numbers("f", reader.length("ranges", ranges_count, 4))
        intensity_count = reader.number("I")
        self.intensity = reader.opaque(reader.length("intensity", intensity_count, 1))
        self.id = reader.number("I")
        return self


@dataclass
class DataScanpose(Struct):
    """One scan and the pose at which it was measured. (player_laser_data_scanpose_t)"""

    scan: Data = field(default_factory=Data)
    # Of the robot at the time of the scan (in m, m, rad, frame X_OR).
    pose: common.Pose2d = field(default_factory=common.Pose2d)

    def write(self, writer: Writer) -> None:
        self.scan.write(writer)
        self.pose.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "DataScanpose":
        self = cls()
        self.scan = Data.read(reader)
        self.pose = common.Pose2d.read(reader)
        return self


@dataclass
class DataScanangle(Struct):
    """One scan with an angle per beam. (player_laser_data_scanangle_t)"""

    # Reported range of a beam without a hit (in m).
    max_range: float = 0.0
    # One per beam (in m).
    ranges: List[float] = field(default_factory=list)
    # One per beam, counter-clockwise from x (in rad).
    angles: List[float] = field(default_factory=list)
    # Intensity of the echo per beam; empty if the device has none.
    intensity: bytes = b""
    # Increases from scan to scan, by one or more.
    id: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.max_range)
        writer.length("ranges", len(self.ranges), 8388598)
        writer.length("ranges", len(self.ranges), 8388598)
        writer.numbers("f", self.ranges)
        writer.length("angles", len(self.angles), 8388598)
        writer.length("angles", len(self.angles), 8388598)
        writer.numbers("f", self.angles)
        writer.length("intensity", len(self.intensity), 33554392)
        writer.length("intensity", len(self.intensity), 33554392)
        writer.opaque(self.intensity)
        writer.number("I", self.id)

    @classmethod
    def read(cls, reader: Reader) -> "DataScanangle":
        self = cls()
        self.max_range = reader.number("f")
        ranges_count = reader.number("I")
        self.ranges = reader.numbers("f", reader.length("ranges", ranges_count, 4))
        angles_count = reader.number("I")
        self.angles = reader.numbers("f", reader.length("angles", angles_count, 4))
        intensity_count = reader.number("I")
        self.intensity = reader.opaque(reader.length("intensity", intensity_count, 1))
        self.id = reader.number("I")
        return self


@dataclass
class Geom(Struct):
    """The device's size and pose. (player_laser_geom_t)"""

    # Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # Bounding box of the device (in m, m, m).
    size: common.Bbox3d = field(default_factory=common.Bbox3d)

    def write(self, writer: Writer) -> None:
        self.pose.write(writer)
        self.size.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Geom":
        self = cls()
        self.pose = common.Pose3d.read(reader)
        self.size = common.Bbox3d.read(reader)
        return self


@dataclass
class Config(Struct):
    """Angles, resolution and rate. (player_laser_config_t)"""

    # Of the first beam (in rad).
    min_angle: float = 0.0
    # Of the last beam (in rad).
    max_angle: float = 0.0
    # Angle between neighbouring beams (in rad).
    resolution: float = 0.0
    # Maximum range (in m).
    max_range: float = 0.0
    # Range resolution (in m).
    range_res: float = 0.0
    # 1: send intensities, too.
    intensity: int = 0
    # Scans per second (in Hz).
    scanning_frequency: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.min_angle)
        writer.number("f", self.max_angle)
        writer.number("f", self.resolution)
        writer.number("f", self.max_range)
        writer.number("f", self.range_res)
        writer.number("B", self.intensity)
        writer.number("f", self.scanning_frequency)

    @classmethod
    def read(cls, reader: Reader) -> "Config":
        self = cls()
        self.min_angle = reader.number("f")
        self.max_angle = reader.number("f")
        self.resolution = reader.number("f")
        self.max_range = reader.number("f")
        self.range_res = reader.number("f")
        self.intensity = reader.number("B")
        self.scanning_frequency = reader.number("f")
        return self


@dataclass
class PowerConfig(Struct):
    """The device's switch. (player_laser_power_config_t)"""

    # 1: on, 0: off.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "PowerConfig":
        self = cls()
        self.state = reader.number("B")
        return self


@dataclass
class GetIdConfig(Struct):
    """A serial number. (player_laser_get_id_config_t)"""

    # 0 in the request.
    serial_number: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.serial_number)

    @classmethod
    def read(cls, reader: Reader) -> "GetIdConfig":
        self = cls()
        self.serial_number = reader.number("I")
        return self


@dataclass
class SetFilterConfig(Struct):
    """A filter. (player_laser_set_filter_config_t)"""

    # Type of filter.
    filter_type: int = 0
    # Filter-specific.
    parameters: List[float] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.number("B", self.filter_type)
        writer.length("parameters", len(self.parameters), 8)
        writer.length("parameters", len(self.parameters), 8)
        writer.numbers("f", self.parameters)

    @classmethod
    def read(cls, reader: Reader) -> "SetFilterConfig":
        self = cls()
        self.filter_type = reader.number("B")
        reader.number("I")
        self.parameters = reader.numbers("f", reader.length("parameters", 8, 4))
        return self


# One scan at equal angles.
DATA_SCAN = MessageType(6, Kind.DATA, 1, "laser.data.scan", Data)
# One scan and the pose at which it was measured.
DATA_SCANPOSE = MessageType(6, Kind.DATA, 2, "laser.data.scanpose", DataScanpose)
# One scan with an angle per beam.
DATA_SCANANGLE = MessageType(6, Kind.DATA, 3, "laser.data.scanangle", DataScanangle)
# Requests the device's size and pose.
REQ_GET_GEOM = MessageType(6, Kind.REQ, 1, "laser.req.get_geom", Geom)
# Sets angles, resolution and rate; the answer has the values in effect.
REQ_SET_CONFIG = MessageType(6, Kind.REQ, 2, "laser.req.set_config", Config)
# Requests angles, resolution and rate.
REQ_GET_CONFIG = MessageType(6, Kind.REQ, 3, "laser.req.get_config", Config)
# Switches the device on or off.
REQ_POWER = MessageType(6, Kind.REQ, 4, "laser.req.power", PowerConfig)
# Requests the serial number.
REQ_GET_ID = MessageType(6, Kind.REQ, 5, "laser.req.get_id", GetIdConfig)
# Selects a filter for the ranges.
REQ_SET_FILTER = MessageType(6, Kind.REQ, 6, "laser.req.set_filter", SetFilterConfig)
