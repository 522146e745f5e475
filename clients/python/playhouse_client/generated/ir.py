"""Interface ir, code 22. An array of infrared range finders. New drivers use the ranger interface.

Generated from interfaces/022_ir.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 22


@dataclass
class Data(Struct):
    """Measurements of the sensors. (player_ir_data_t)"""

    # One per sensor, as measured (in V).
    voltages: List[float] = field(default_factory=list)
    # One per sensor, computed from the voltage (in m).
    ranges: List[float] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("voltages", len(self.voltages), 8388598)
        writer.length("voltages", len(self.voltages), 8388598)
        writer.numbers("f", self.voltages)
        writer.length("ranges", len(self.ranges), 8388598)
        writer.length("ranges", len(self.ranges), 8388598)
        writer.numbers("f", self.ranges)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        voltages_count = reader.number("I")
        self.voltages = reader.numbers("f", reader.length("voltages", voltages_count, 4))
        ranges_count = reader.number("I")
        self.ranges = reader.numbers("f", reader.length("ranges", ranges_count, 4))
        return self


@dataclass
class Pose(Struct):
    """Poses of the sensors. (player_ir_pose_t)"""

    # One per sensor; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS).
    poses: List[common.Pose3d] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("poses", len(self.poses), 699049)
        writer.length("poses", len(self.poses), 699049)
        for item in self.poses:
            item.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Pose":
        self = cls()
        poses_count = reader.number("I")
        poses_length = reader.length("poses", poses_count, 48)
        self.poses = [common.Pose3d.read(reader) for _ in range(poses_length)]
        return self


@dataclass
class PowerReq(Struct):
    """The sensors' switch. (player_ir_power_req_t)"""

    # 1: on, 0: off.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "PowerReq":
        self = cls()
        self.state = reader.number("B")
        return self


# Requests the poses of the sensors.
REQ_POSE = MessageType(22, Kind.REQ, 1, "ir.req.pose", Pose)
# Switches the sensors on or off.
REQ_POWER = MessageType(22, Kind.REQ, 2, "ir.req.power", PowerReq)
# Voltages and ranges.
DATA_RANGES = MessageType(22, Kind.DATA, 1, "ir.data.ranges", Data)
