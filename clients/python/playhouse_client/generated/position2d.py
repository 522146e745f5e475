"""Interface position2d, code 4. A robot that moves in the plane: odometry, velocity and position control.

Generated from interfaces/004_position2d.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 4


@dataclass
class Data(Struct):
    """Odometry. (player_position2d_data_t)"""

    # Pose from odometry (in m, m, rad, frame X_OR).
    pos: common.Pose2d = field(default_factory=common.Pose2d)
    # Velocity: forward, to the left, turning left (in m/s, m/s, rad/s, frame v_OR_R).
    vel: common.Pose2d = field(default_factory=common.Pose2d)
    # 1 if the robot is blocked by an obstacle.
    stall: int = 0

    def write(self, writer: Writer) -> None:
        self.pos.write(writer)
        self.vel.write(writer)
        writer.number("B", self.stall)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.pos = common.Pose2d.read(reader)
        self.vel = common.Pose2d.read(reader)
        self.stall = reader.number("B")
        return self


@dataclass
class CmdVel(Struct):
    """Commanded velocity. (player_position2d_cmd_vel_t)"""

    # Forward, to the left, turning left; for a simulated car the last part is its steering angle in rad (in
    # m/s, m/s, rad/s, frame v_OR_R).
    vel: common.Pose2d = field(default_factory=common.Pose2d)
    # 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER.
    state: int = 0

    def write(self, writer: Writer) -> None:
        self.vel.write(writer)
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "CmdVel":
        self = cls()
        self.vel = common.Pose2d.read(reader)
        self.state = reader.number("B")
        return self


@dataclass
class CmdPos(Struct):
    """Commanded pose, and the velocity on the way. (player_position2d_cmd_pos_t)"""

    # Goal (in m, m, rad, frame X_OG).
    pos: common.Pose2d = field(default_factory=common.Pose2d)
    # Velocity on the way; zero: chosen by the driver. Simulated robots ignore it (in m/s, m/s, rad/s, frame
    # v_OR_R).
    vel: common.Pose2d = field(default_factory=common.Pose2d)
    # 1: motors on, 0: off. Optional for drivers; simulated robots ignore it and use MOTOR_POWER.
    state: int = 0

    def write(self, writer: Writer) -> None:
        self.pos.write(writer)
        self.vel.write(writer)
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "CmdPos":
        self = cls()
        self.pos = common.Pose2d.read(reader)
        self.vel = common.Pose2d.read(reader)
        self.state = reader.number("B")
        return self


@dataclass
class CmdCar(Struct):
    """Commanded motion of a car. (player_position2d_cmd_car_t)"""

    # Forward (in m/s).
    velocity: float = 0.0
    # Steering angle of the front wheels, positive to the left; a simulated robot without them uses it as turn
    # rate in rad/s (in rad).
    angle: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.velocity)
        writer.number("d", self.angle)

    @classmethod
    def read(cls, reader: Reader) -> "CmdCar":
        self = cls()
        self.velocity = reader.number("d")
        self.angle = reader.number("d")
        return self


@dataclass
class CmdVelHead(Struct):
    """Commanded speed and heading. (player_position2d_cmd_vel_head_t)"""

    # Forward (in m/s).
    velocity: float = 0.0
    # Heading in the odometry frame (in rad).
    angle: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("d", self.velocity)
        writer.number("d", self.angle)

    @classmethod
    def read(cls, reader: Reader) -> "CmdVelHead":
        self = cls()
        self.velocity = reader.number("d")
        self.angle = reader.number("d")
        return self


@dataclass
class Geom(Struct):
    """The robot's size and centre of rotation. (player_position2d_geom_t)"""

    # Centre of the bounding box relative to the centre of rotation (in m, m, m, rad, rad, rad, frame X_RS).
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # Bounding box of the robot (in m, m, m).
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
    """The motors' switch. (player_position2d_power_config_t)"""

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
    """A velocity controller. (player_position2d_velocity_mode_config_t)"""

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
class PositionModeReq(Struct):
    """A control mode. (player_position2d_position_mode_req_t)"""

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
    """A new odometric pose. (player_position2d_set_odom_req_t)"""

    # New odometric pose (in m, m, rad, frame X_OR).
    pose: common.Pose2d = field(default_factory=common.Pose2d)

    def write(self, writer: Writer) -> None:
        self.pose.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "SetOdomReq":
        self = cls()
        self.pose = common.Pose2d.read(reader)
        return self


@dataclass
class SpeedPidReq(Struct):
    """Gains of velocity control. (player_position2d_speed_pid_req_t)"""

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
    """Gains of position control. (player_position2d_position_pid_req_t)"""

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
    """Limits of position control. (player_position2d_speed_prof_req_t)"""

    # Maximum speed (in m/s).
    speed: float = 0.0
    # Maximum acceleration (in m/s^2).
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


# Requests the robot's size and centre of rotation.
REQ_GET_GEOM = MessageType(4, Kind.REQ, 1, "position2d.req.get_geom", Geom)
# Switches the motors on or off.
REQ_MOTOR_POWER = MessageType(4, Kind.REQ, 2, "position2d.req.motor_power", PowerConfig)
# Selects the driver's velocity controller.
REQ_VELOCITY_MODE = MessageType(4, Kind.REQ, 3, "position2d.req.velocity_mode", VelocityModeConfig)
# Selects between velocity and position control.
REQ_POSITION_MODE = MessageType(4, Kind.REQ, 4, "position2d.req.position_mode", PositionModeReq)
# Sets the odometric pose.
REQ_SET_ODOM = MessageType(4, Kind.REQ, 5, "position2d.req.set_odom", SetOdomReq)
# Sets the odometric pose to zero.
REQ_RESET_ODOM = MessageType(4, Kind.REQ, 6, "position2d.req.reset_odom")
# Sets the gains of velocity control.
REQ_SPEED_PID = MessageType(4, Kind.REQ, 7, "position2d.req.speed_pid", SpeedPidReq)
# Sets the gains of position control.
REQ_POSITION_PID = MessageType(4, Kind.REQ, 8, "position2d.req.position_pid", PositionPidReq)
# Sets the speed and acceleration limits of position control.
REQ_SPEED_PROF = MessageType(4, Kind.REQ, 9, "position2d.req.speed_prof", SpeedProfReq)
# Odometry.
DATA_STATE = MessageType(4, Kind.DATA, 1, "position2d.data.state", Data)
# The robot's size, sent on change.
DATA_GEOM = MessageType(4, Kind.DATA, 2, "position2d.data.geom", Geom)
# Commanded velocity.
CMD_VEL = MessageType(4, Kind.CMD, 1, "position2d.cmd.vel", CmdVel)
# Commanded pose in the odometry frame.
CMD_POS = MessageType(4, Kind.CMD, 2, "position2d.cmd.pos", CmdPos)
# Commanded speed and steering angle of a car.
CMD_CAR = MessageType(4, Kind.CMD, 3, "position2d.cmd.car", CmdCar)
# Commanded speed and heading.
CMD_VEL_HEAD = MessageType(4, Kind.CMD, 4, "position2d.cmd.vel_head", CmdVelHead)
