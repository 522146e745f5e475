"""Interface limb, code 54. An arm controlled by the pose of its end effector.

Generated from interfaces/054_limb.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 54

# Values of Data.state.
STATE_IDLE = 1
STATE_BRAKED = 2
STATE_MOVING = 3
STATE_OOR = 4
STATE_COLL = 5


@dataclass
class Data(Struct):
    """Pose of the end effector. (player_limb_data_t)"""

    # In m, frame p_BE.
    position: common.Point3d = field(default_factory=common.Point3d)
    # Approach direction, a unit vector (frame n_B).
    approach: common.Point3d = field(default_factory=common.Point3d)
    # Unit vector across the end effector (frame n_B).
    orientation: common.Point3d = field(default_factory=common.Point3d)
    # Idle, braked, moving, out of reach or in contact.
    state: int = 0

    def write(self, writer: Writer) -> None:
        self.position.write(writer)
        self.approach.write(writer)
        self.orientation.write(writer)
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.position = common.Point3d.read(reader)
        self.approach = common.Point3d.read(reader)
        self.orientation = common.Point3d.read(reader)
        self.state = reader.number("B")
        return self


@dataclass
class SetposeCmd(Struct):
    """Commanded pose of the end effector. (player_limb_setpose_cmd_t)"""

    # In m, frame p_BE.
    position: common.Point3d = field(default_factory=common.Point3d)
    # Commanded approach direction, a unit vector (frame n_B).
    approach: common.Point3d = field(default_factory=common.Point3d)
    # Unit vector across the end effector (frame n_B).
    orientation: common.Point3d = field(default_factory=common.Point3d)

    def write(self, writer: Writer) -> None:
        self.position.write(writer)
        self.approach.write(writer)
        self.orientation.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "SetposeCmd":
        self = cls()
        self.position = common.Point3d.read(reader)
        self.approach = common.Point3d.read(reader)
        self.orientation = common.Point3d.read(reader)
        return self


@dataclass
class SetpositionCmd(Struct):
    """Commanded position of the end effector. (player_limb_setposition_cmd_t)"""

    # In m, frame p_BE.
    position: common.Point3d = field(default_factory=common.Point3d)

    def write(self, writer: Writer) -> None:
        self.position.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "SetpositionCmd":
        self = cls()
        self.position = common.Point3d.read(reader)
        return self


@dataclass
class VecmoveCmd(Struct):
    """A straight motion of the end effector. (player_limb_vecmove_cmd_t)"""

    # Unit vector of the motion (frame n_B).
    direction: common.Point3d = field(default_factory=common.Point3d)
    # Distance (in m).
    length: float = 0.0

    def write(self, writer: Writer) -> None:
        self.direction.write(writer)
        writer.number("f", self.length)

    @classmethod
    def read(cls, reader: Reader) -> "VecmoveCmd":
        self = cls()
        self.direction = common.Point3d.read(reader)
        self.length = reader.number("f")
        return self


@dataclass
class PowerReq(Struct):
    """The motors' switch. (player_limb_power_req_t)"""

    # 1: on, 0: off.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "PowerReq":
        self = cls()
        self.value = reader.number("B")
        return self


@dataclass
class BrakesReq(Struct):
    """The brakes' switch. (player_limb_brakes_req_t)"""

    # 1: braked, 0: released.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "BrakesReq":
        self = cls()
        self.value = reader.number("B")
        return self


@dataclass
class GeomReq(Struct):
    """Pose of the arm's base. (player_limb_geom_req_t)"""

    # Of the arm's base on the robot (in m, frame p_RB).
    basePos: common.Point3d = field(default_factory=common.Point3d)

    def write(self, writer: Writer) -> None:
        self.basePos.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "GeomReq":
        self = cls()
        self.basePos = common.Point3d.read(reader)
        return self


@dataclass
class SpeedReq(Struct):
    """Speed of the end effector. (player_limb_speed_req_t)"""

    # Maximum speed of the end effector (in m/s).
    speed: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.speed)

    @classmethod
    def read(cls, reader: Reader) -> "SpeedReq":
        self = cls()
        self.speed = reader.number("f")
        return self


# Pose of the end effector.
DATA_STATE = MessageType(54, Kind.DATA, 1, "limb.data.state", Data)
# Moves the arm to its home position.
CMD_HOME = MessageType(54, Kind.CMD, 1, "limb.cmd.home")
# Stops the arm at its current position.
CMD_STOP = MessageType(54, Kind.CMD, 2, "limb.cmd.stop")
# Moves the end effector to a pose.
CMD_SETPOSE = MessageType(54, Kind.CMD, 3, "limb.cmd.setpose", SetposeCmd)
# Moves the end effector to a position, in any orientation.
CMD_SETPOSITION = MessageType(54, Kind.CMD, 4, "limb.cmd.setposition", SetpositionCmd)
# Moves the end effector along a line from its current position.
CMD_VECMOVE = MessageType(54, Kind.CMD, 5, "limb.cmd.vecmove", VecmoveCmd)
# Switches the motors on or off.
REQ_POWER = MessageType(54, Kind.REQ, 1, "limb.req.power", PowerReq)
# Sets or releases the brakes.
REQ_BRAKES = MessageType(54, Kind.REQ, 2, "limb.req.brakes", BrakesReq)
# Requests the pose of the arm's base on the robot.
REQ_GEOM = MessageType(54, Kind.REQ, 3, "limb.req.geom", GeomReq)
# Sets the speed of the end effector.
REQ_SPEED = MessageType(54, Kind.REQ, 4, "limb.req.speed", SpeedReq)
