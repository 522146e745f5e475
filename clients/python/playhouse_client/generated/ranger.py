"""Interface ranger, code 62. Range finders of any type: lasers, sonars, infrared, single or in arrays.

Generated from interfaces/062_ranger.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 62


@dataclass
class Config(Struct):
    """Angles, ranges and rate. (player_ranger_config_t)"""

    # Of the first beam, counter-clockwise from x (in rad).
    min_angle: float = 0.0
    # Of the last beam (in rad).
    max_angle: float = 0.0
    # Angle between neighbouring beams (in rad).
    angular_res: float = 0.0
    # Minimum range (in m).
    min_range: float = 0.0
    # Maximum range, and reported range of a beam without a hit (in m).
    max_range: float = 0.0
    # Range resolution (in m).
    range_res: float = 0.0
    # Scans per second (in Hz).
    frequency: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.min_angle)
        writer.number("d", self.max_angle)
        writer.number("d", self.angular_res)
        writer.number("d", self.min_range)
        writer.number("d", self.max_range)
        writer.number("d", self.range_res)
        writer.number("d", self.frequency)

    @classmethod
    def read(cls, reader: Reader) -> "Config":
        self = cls()
        self.min_angle = reader.number("d")
        self.max_angle = reader.number("d")
        self.angular_res = reader.number("d")
        self.min_range = reader.number("d")
        self.max_range = reader.number("d")
        self.range_res = reader.number("d")
        self.frequency = reader.number("d")
        return self


@dataclass
class Geom(Struct):
    """Size and pose of the device and its elements. (player_ranger_geom_t)"""

    # Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # Bounding box of the device (in m, m, m).
    size: common.Bbox3d = field(default_factory=common.Bbox3d)
    # One per element; x points along its beam, or along the middle of its scan (in m, m, m, rad, rad, rad,
    # frame X_SE).
    element_poses: List[common.Pose3d] = field(default_factory=list)
    # One per element (in m, m, m).
    element_sizes: List[common.Bbox3d] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        self.pose.write(writer)
        self.size.write(writer)
        writer.length("element_poses", len(self.element_poses), 699049)
        writer.length("element_poses", len(self.element_poses), 699049)
        for item in self.element_poses:
            item.write(writer)
        writer.length("element_sizes", len(self.element_sizes), 1398099)
        writer.length("element_sizes", len(self.element_sizes), 1398099)
        for item in self.element_sizes:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Geom":
        self = cls()
        self.pose = common.Pose3d.read(reader)
        self.size = common.Bbox3d.read(reader)
        element_poses_count = reader.number("I")
        element_poses_length = reader.length("element_poses", element_poses_count, 48)
        self.element_poses = [common.Pose3d.read(reader) for _ in range(element_poses_length)]
        element_sizes_count = reader.number("I")
        element_sizes_length = reader.length("element_sizes", element_sizes_count, 24)
        self.element_sizes = [common.Bbox3d.read(reader) for _ in range(element_sizes_length)]
        return self


@dataclass
class DataRange(Struct):
    """Ranges. (player_ranger_data_range_t)"""

    # Beam by beam from right to left, element by element (in m).
    ranges: List[float] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("ranges", len(self.ranges), 4194299)
        writer.length("ranges", len(self.ranges), 4194299)
        writer.numbers("d", self.ranges)

    @classmethod
    def read(cls, reader: Reader) -> "DataRange":
        self = cls()
        ranges_count = reader.number("I")
        self.ranges = reader.numbers("d", reader.length("ranges", ranges_count, 8))
        return self


@dataclass
class DataRangestamped(Struct):
    """Ranges with geometry and configuration. (player_ranger_data_rangestamped_t)"""

    data: DataRange = field(default_factory=DataRange)
    # 1 if `geom` is valid.
    have_geom: int = 0
    geom: Geom = field(default_factory=Geom)
    # 1 if `config` is valid.
    have_config: int = 0
    config: Config = field(default_factory=Config)

    def write(self, writer: Writer) -> None:
        self.data.write(writer)
        writer.number("B", self.have_geom)
        self.geom.write(writer)
        writer.number("B", self.have_config)
        self.config.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "DataRangestamped":
        self = cls()
        self.data = DataRange.read(reader)
        self.have_geom = reader.number("B")
        self.geom = Geom.read(reader)
        self.have_config = reader.number("B")
        self.config = Config.read(reader)
        return self


@dataclass
class DataIntns(Struct):
    """Intensities. (player_ranger_data_intns_t)"""

    # In the order of the ranges; driver-specific scale.
    intensities: List[float] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("intensities", len(self.intensities), 4194299)
        writer.length("intensities", len(self.intensities), 4194299)
        writer.numbers("d", self.intensities)

    @classmethod
    def read(cls, reader: Reader) -> "DataIntns":
        self = cls()
        intensities_count = reader.number("I")
        self.intensities = reader.numbers("d", reader.length("intensities", intensities_count, 8))
        return self


@dataclass
class DataIntnsstamped(Struct):
    """Intensities with geometry and configuration. (player_ranger_data_intnsstamped_t)"""

    data: DataIntns = field(default_factory=DataIntns)
    # 1 if `geom` is valid.
    have_geom: int = 0
    geom: Geom = field(default_factory=Geom)
    # 1 if `config` is valid.
    have_config: int = 0
    config: Config = field(default_factory=Config)

    def write(self, writer: Writer) -> None:
        self.data.write(writer)
        writer.number("B", self.have_geom)
        self.geom.write(writer)
        writer.number("B", self.have_config)
        self.config.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "DataIntnsstamped":
        self = cls()
        self.data = DataIntns.read(reader)
        self.have_geom = reader.number("B")
        self.geom = Geom.read(reader)
        self.have_config = reader.number("B")
        self.config = Config.read(reader)
        return self


@dataclass
class PowerConfig(Struct):
    """The device's switch. (player_ranger_power_config_t)"""

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
class IntnsConfig(Struct):
    """The switch of intensities. (player_ranger_intns_config_t)"""

    # 1: on, 0: off.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "IntnsConfig":
        self = cls()
        self.state = reader.number("B")
        return self


# Ranges.
DATA_RANGE = MessageType(62, Kind.DATA, 1, "ranger.data.range", DataRange)
# Ranges with the geometry and configuration of the measurement.
DATA_RANGESTAMPED = MessageType(62, Kind.DATA, 2, "ranger.data.rangestamped", DataRangestamped)
# Intensities.
DATA_INTNS = MessageType(62, Kind.DATA, 3, "ranger.data.intns", DataIntns)
# Intensities with the geometry and configuration of the measurement.
DATA_INTNSSTAMPED = MessageType(62, Kind.DATA, 4, "ranger.data.intnsstamped", DataIntnsstamped)
# Size and pose, sent on change.
DATA_GEOM = MessageType(62, Kind.DATA, 5, "ranger.data.geom", Geom)
# Requests size and pose.
REQ_GET_GEOM = MessageType(62, Kind.REQ, 1, "ranger.req.get_geom", Geom)
# Switches the device on or off.
REQ_POWER = MessageType(62, Kind.REQ, 2, "ranger.req.power", PowerConfig)
# Switches intensities on or off.
REQ_INTNS = MessageType(62, Kind.REQ, 3, "ranger.req.intns", IntnsConfig)
# Sets angles, ranges and rate; the answer has the values in effect.
REQ_SET_CONFIG = MessageType(62, Kind.REQ, 4, "ranger.req.set_config", Config)
# Requests angles, ranges and rate.
REQ_GET_CONFIG = MessageType(62, Kind.REQ, 5, "ranger.req.get_config", Config)
