"""Interface position1d, code 52. A single prismatic or revolute actuator.

Generated from interfaces/052_position1d.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 52

# Bits of Data.status, by number.
STATUS_LIMIT_MIN = 0
STATUS_LIMIT_CEN = 1
STATUS_LIMIT_MAX = 2
STATUS_OC = 3
STATUS_TRAJ_COMPLETE = 4
STATUS_ENABLED = 5


@dataclass
class Data(Struct):
    """Position of the actuator. (player_position1d_data_t)"""

    # From its zero (in m or rad).
    pos: float = 0.0
    # In m/s or rad/s.
    vel: float = 0.0
    # 1 if it is blocked by an obstacle.
    stall: int = 0
    # Limits, current, motion and power, one bit each.
    status: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.pos)
        writer.number("f", self.vel)
        writer.number("B", self.stall)
        writer.number("B", self.status)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.pos = reader.number("f")
        self.vel = reader.number("f")
        self.stall = reader.number("B")
        self.status = reader.number("B")
        return self


@dataclass
class CmdVel(Struct):
    """Commanded velocity. (player_position1d_cmd_vel_t)"""

    # In m/s or rad/s.
    vel: float = 0.0
    # 1: motor on, 0: off.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.vel)
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "CmdVel":
        self = cls()
        self.vel = reader.number("f")
        self.state = reader.number("B")
        return self


@dataclass
class CmdPos(Struct):
    """Commanded position. (player_position1d_cmd_pos_t)"""

    # From its zero (in m or rad).
    pos: float = 0.0
    # Velocity on the way; zero: chosen by the driver (in m/s or rad/s).
    vel: float = 0.0
    # 1: motor on, 0: off.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.pos)
        writer.number("f", self.vel)
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "CmdPos":
        self = cls()
        self.pos = reader.number("f")
        self.vel = reader.number("f")
        self.state = reader.number("B")
        return self


@dataclass
class Geom(Struct):
    """Size and pose. (player_position1d_geom_t)"""

    # Pose of the actuator on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # Bounding box of the actuator (in m, m, m).
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
class PowerConfig(Struct):
    """The motor's switch. (player_position1d_power_config_t)"""

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
class VelocityModeConfig(Struct):
    """A velocity controller. (player_position1d_velocity_mode_config_t)"""

    # Driver-specific.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "VelocityModeConfig":
        self = cls()
        self.value = reader.number("I")
        return self


@dataclass
class ResetOdomConfig(Struct):
    """Request to set the current position to zero. (player_position1d_reset_odom_config_t)"""

    # Without meaning.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "ResetOdomConfig":
        self = cls()
        self.value = reader.number("I")
        return self


@dataclass
class PositionModeReq(Struct):
    """A control mode. (player_position1d_position_mode_req_t)"""

    # 0: velocity, 1: position.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "PositionModeReq":
        self = cls()
        self.state = reader.number("I")
        return self


@dataclass
class SetOdomReq(Struct):
    """New value of the current position. (player_position1d_set_odom_req_t)"""

    # New value of the current position (in m or rad).
    pos: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.pos)

    @classmethod
    def read(cls, reader: Reader) -> "SetOdomReq":
        self = cls()
        self.pos = reader.number("f")
        return self


@dataclass
class SpeedPidReq(Struct):
    """Gains of velocity control. (player_position1d_speed_pid_req_t)"""

    # Proportional.
    kp: float = 0.0
    # Integral.
    ki: float = 0.0
    # Derivative.
    kd: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.kp)
        writer.number("f", self.ki)
        writer.number("f", self.kd)

    @classmethod
    def read(cls, reader: Reader) -> "SpeedPidReq":
        self = cls()
        self.kp = reader.number("f")
        self.ki = reader.number("f")
        self.kd = reader.number("f")
        return self


@dataclass
class PositionPidReq(Struct):
    """Gains of position control. (player_position1d_position_pid_req_t)"""

    # Proportional.
    kp: float = 0.0
    # Integral.
    ki: float = 0.0
    # Derivative.
    kd: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.kp)
        writer.number("f", self.ki)
        writer.number("f", self.kd)

    @classmethod
    def read(cls, reader: Reader) -> "PositionPidReq":
        self = cls()
        self.kp = reader.number("f")
        self.ki = reader.number("f")
        self.kd = reader.number("f")
        return self


@dataclass
class SpeedProfReq(Struct):
    """Limits of position control. (player_position1d_speed_prof_req_t)"""

    # Maximum speed (in m/s or rad/s).
    speed: float = 0.0
    # Maximum acceleration (in m/s^2 or rad/s^2).
    acc: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.speed)
        writer.number("f", self.acc)

    @classmethod
    def read(cls, reader: Reader) -> "SpeedProfReq":
        self = cls()
        self.speed = reader.number("f")
        self.acc = reader.number("f")
        return self


# Requests size and pose.
REQ_GET_GEOM = MessageType(52, Kind.REQ, 1, "position1d.req.get_geom", Geom)
# Switches the motor on or off.
REQ_MOTOR_POWER = MessageType(52, Kind.REQ, 2, "position1d.req.motor_power", PowerConfig)
# Selects the driver's velocity controller.
REQ_VELOCITY_MODE = MessageType(52, Kind.REQ, 3, "position1d.req.velocity_mode", VelocityModeConfig)
# Selects between velocity and position control.
REQ_POSITION_MODE = MessageType(52, Kind.REQ, 4, "position1d.req.position_mode", PositionModeReq)
# Sets the reference of the position.
REQ_SET_ODOM = MessageType(52, Kind.REQ, 5, "position1d.req.set_odom", SetOdomReq)
# Sets the current position to zero.
REQ_RESET_ODOM = MessageType(52, Kind.REQ, 6, "position1d.req.reset_odom", ResetOdomConfig)
# Sets the gains of velocity control.
REQ_SPEED_PID = MessageType(52, Kind.REQ, 7, "position1d.req.speed_pid", SpeedPidReq)
# Sets the gains of position control.
REQ_POSITION_PID = MessageType(52, Kind.REQ, 8, "position1d.req.position_pid", PositionPidReq)
# Sets the speed and acceleration limits of position control.
REQ_SPEED_PROF = MessageType(52, Kind.REQ, 9, "position1d.req.speed_prof", SpeedProfReq)
# Position of the actuator.
DATA_STATE = MessageType(52, Kind.DATA, 1, "position1d.data.state", Data)
# Size and pose, sent on change.
DATA_GEOM = MessageType(52, Kind.DATA, 2, "position1d.data.geom", Geom)
# Commanded velocity.
CMD_VEL = MessageType(52, Kind.CMD, 1, "position1d.cmd.vel", CmdVel)
# Commanded position.
CMD_POS = MessageType(52, Kind.CMD, 2, "position1d.cmd.pos", CmdPos)
