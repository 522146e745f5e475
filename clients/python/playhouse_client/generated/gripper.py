"""Interface gripper, code 3. A two-finger gripper, with break beams between the fingers and optionally a
store for objects.

Generated from interfaces/003_gripper.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 3

# Values of Data.state.
STATE_OPEN = 1
STATE_CLOSED = 2
STATE_MOVING = 3
STATE_ERROR = 4


@dataclass
class Data(Struct):
    """State of the fingers and of the break beams. (player_gripper_data_t)"""

    # Open, closed, moving or faulty.
    state: int = 0
    # One bit per break beam, set if it is interrupted.
    beams: int = 0
    # Number of stored objects.
    stored: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.state)
        writer.number("I", self.beams)
        writer.number("B", self.stored)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.state = reader.number("B")
        self.beams = reader.number("I")
        self.stored = reader.number("B")
        return self


@dataclass
class Geom(Struct):
    """The gripper's size and pose. (player_gripper_geom_t)"""

    # Pose of the gripper on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # Around the fingers (in m, m, m).
    outer_size: common.Bbox3d = field(default_factory=common.Bbox3d)
    # Of the gap between the open fingers (in m, m, m).
    inner_size: common.Bbox3d = field(default_factory=common.Bbox3d)
    # Number of break beams.
    num_beams: int = 0
    # Capacity of the store, in objects.
    capacity: int = 0

    def write(self, writer: Writer) -> None:
        self.pose.write(writer)
        self.outer_size.write(writer)
        self.inner_size.write(writer)
        writer.number("B", self.num_beams)
        writer.number("B", self.capacity)

    @classmethod
    def read(cls, reader: Reader) -> "Geom":
        self = cls()
        self.pose = common.Pose3d.read(reader)
        self.outer_size = common.Bbox3d.read(reader)
        self.inner_size = common.Bbox3d.read(reader)
        self.num_beams = reader.number("B")
        self.capacity = reader.number("B")
        return self


# State of the fingers and of the break beams.
DATA_STATE = MessageType(3, Kind.DATA, 1, "gripper.data.state", Data)
# Requests the gripper's size and pose.
REQ_GET_GEOM = MessageType(3, Kind.REQ, 1, "gripper.req.get_geom", Geom)
# Opens the fingers.
CMD_OPEN = MessageType(3, Kind.CMD, 1, "gripper.cmd.open")
# Closes the fingers.
CMD_CLOSE = MessageType(3, Kind.CMD, 2, "gripper.cmd.close")
# Stops the fingers at their current position.
CMD_STOP = MessageType(3, Kind.CMD, 3, "gripper.cmd.stop")
# Moves the held object into the store.
CMD_STORE = MessageType(3, Kind.CMD, 4, "gripper.cmd.store")
# Moves the object stored last between the fingers.
CMD_RETRIEVE = MessageType(3, Kind.CMD, 5, "gripper.cmd.retrieve")
