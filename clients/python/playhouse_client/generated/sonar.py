"""Interface sonar, code 5. An array of sonars. New drivers use the ranger interface.

Generated from interfaces/005_sonar.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 5


@dataclass
class Data(Struct):
    """One range per sonar. (player_sonar_data_t)"""

    # Range of the nearest echo, in the order of the geometry (in m).
    ranges: List[float] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("ranges", len(self.ranges), 8388598)
        writer.length("ranges", len(self.ranges), 8388598)
        writer.numbers("f", self.ranges)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        ranges_count = reader.number("I")
        self.ranges = reader.numbers("f", reader.length("ranges", ranges_count, 4))
        return self


@dataclass
class Geom(Struct):
    """Poses of the sonars. (player_sonar_geom_t)"""

    # One per sonar; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS).
    poses: List[common.Pose3d] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("poses", len(self.poses), 699049)
        writer.length("poses", len(self.poses), 699049)
        for item in self.poses:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Geom":
        self = cls()
        poses_count = reader.number("I")
        poses_length = reader.length("poses", poses_count, 48)
        self.poses = [common.Pose3d.read(reader) for _ in range(poses_length)]
        return self


@dataclass
class PowerConfig(Struct):
    """The sonars' switch. (player_sonar_power_config_t)"""

    # 1: on, 0: off.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "PowerConfig":
        self = cls()
        self.state = reader.number("B")
        return self


# Requests the poses of the sonars.
REQ_GET_GEOM = MessageType(5, Kind.REQ, 1, "sonar.req.get_geom", Geom)
# Switches the sonars on or off.
REQ_POWER = MessageType(5, Kind.REQ, 2, "sonar.req.power", PowerConfig)
# One range per sonar.
DATA_RANGES = MessageType(5, Kind.DATA, 1, "sonar.data.ranges", Data)
# Poses of the sonars, sent on change.
DATA_GEOM = MessageType(5, Kind.DATA, 2, "sonar.data.geom", Geom)
