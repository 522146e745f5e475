"""Interface limb, code 54. An arm that is told where its hand shall be.

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
    """Where the hand is. (player_limb_data_t)"""

    # In m, frame p_BE.
    position: common.Point3d = field(default_factory=common.Point3d)
    # Unit vector along which the hand reaches (frame n_B).
    approach: common.Point3d = field(default_factory=common.Point3d)
    # Unit vector across the hand (frame n_B).
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
    """Wanted place and attitude of the hand. (player_limb_setpose_cmd_t)"""

    # In m, frame p_BE.
    position: common.Point3d = field(default_factory=common.Point3d)
    # Unit vector along which the hand shall reach (frame n_B).
    approach: common.Point3d = field(default_factory=common.Point3d)
    # Unit vector across the hand (frame n_B).
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
    """Wanted place of the hand. (player_limb_setposition_cmd_t)"""

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
    """A straight move of the hand. (player_limb_vecmove_cmd_t)"""

    # Unit vector of the move (frame n_B).
    direction: common.Point3d = field(default_factory=common.Point3d)
    # How far (in m).
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

    # 1 on, 0 off.
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

    # 1 braked, 0 released.
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
    """Where the arm starts. (player_limb_geom_req_t)"""

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
    """Speed of the hand. (player_limb_speed_req_t)"""

    # Largest speed of the hand (in m/s).
    speed: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.speed)

    @classmethod
    def read(cls, reader: Reader) -> "SpeedReq":
        self = cls()
        self.speed = reader.number("f")
        return self


# Where the hand is.
DATA_STATE = MessageType(54, Kind.DATA, 1, "limb.data.state", Data)
# Sends the arm home.
CMD_HOME = MessageType(54, Kind.CMD, 1, "limb.cmd.home")
# Stops the arm where it is.
CMD_STOP = MessageType(54, Kind.CMD, 2, "limb.cmd.stop")
# Moves the hand to a place and an attitude.
CMD_SETPOSE = MessageType(54, Kind.CMD, 3, "limb.cmd.setpose", SetposeCmd)
# Moves the hand to a place in any attitude.
CMD_SETPOSITION = MessageType(54, Kind.CMD, 4, "limb.cmd.setposition", SetpositionCmd)
# Moves the hand along a line from where it is.
CMD_VECMOVE = MessageType(54, Kind.CMD, 5, "limb.cmd.vecmove", VecmoveCmd)
# Switches the motors on or off.
REQ_POWER = MessageType(54, Kind.REQ, 1, "limb.req.power", PowerReq)
# Sets or releases the brakes.
REQ_BRAKES = MessageType(54, Kind.REQ, 2, "limb.req.brakes", BrakesReq)
# Asks where the arm starts on the robot.
REQ_GEOM = MessageType(54, Kind.REQ, 3, "limb.req.geom", GeomReq)
# Sets the speed of the hand.
REQ_SPEED = MessageType(54, Kind.REQ, 4, "limb.req.speed", SpeedReq)
