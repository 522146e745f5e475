"""Interface actarray, code 53. A chain of prismatic or revolute joints, such as an arm.

Generated from interfaces/053_actarray.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 53

# Values of Actuator.state.
ACTSTATE_IDLE = 1
ACTSTATE_MOVING = 2
ACTSTATE_BRAKED = 4
ACTSTATE_STALLED = 8

# Values of Actuatorgeom.type.
TYPE_LINEAR = 1
TYPE_ROTARY = 2


@dataclass
class Actuator(Struct):
    """State of one joint. (player_actarray_actuator_t)"""

    # In m or rad.
    position: float = 0.0
    # In m/s or rad/s.
    speed: float = 0.0
    # In m/s^2 or rad/s^2.
    acceleration: float = 0.0
    # Of its motor; -1 if unknown (in A).
    current: float = 0.0
    # Idle, moving, braked or stalled.
    state: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.position)
        writer.number("f", self.speed)
        writer.number("f", self.acceleration)
        writer.number("f", self.current)
        writer.number("B", self.state)

    @classmethod
    def read(cls, reader: Reader) -> "Actuator":
        self = cls()
        self.position = reader.number("f")
        self.speed = reader.number("f")
        self.acceleration = reader.number("f")
        self.current = reader.number("f")
        self.state = reader.number("B")
        return self


@dataclass
class Data(Struct):
    """State of each joint. (player_actarray_data_t)"""

    actuators: List[Actuator] = field(default_factory=list)
    # 1: motors on, 0: off.
    motor_state: int = 0

    def write(self, writer: Writer) -> None:
        writer.length("actuators", len(self.actuators), 1677719)
        writer.length("actuators", len(self.actuators), 1677719)
        for item in self.actuators:
            item.write(writer)
        writer.number("B", self.motor_state)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        actuators_count = reader.number("I")
        actuators_length = reader.length("actuators", actuators_count, 20)
        self.actuators = [Actuator.read(reader) for _ in range(actuators_length)]
        self.motor_state = reader.number("B")
        return self


@dataclass
class Actuatorgeom(Struct):
    """Description of a joint. (player_actarray_actuatorgeom_t)"""

    # Prismatic or revolute.
    type: int = 0
    # To the next joint (in m).
    length: float = 0.0
    # Orientation of the joint at rest, relative to the previous joint (in rad, rad, rad, frame R_BJ).
    orientation: common.Orientation3d = field(default_factory=common.Orientation3d)
    # Unit vector of the axis of translation or rotation (frame n_J).
    axis: common.Point3d = field(default_factory=common.Point3d)
    # Lowest position (in m or rad).
    min: float = 0.0
    # Centre position (in m or rad).
    centre: float = 0.0
    # Highest position (in m or rad).
    max: float = 0.0
    # Position after CMD HOME (in m or rad).
    home: float = 0.0
    # Speed in position control (in m/s or rad/s).
    config_speed: float = 0.0
    # 1 if it has brakes.
    hasbrakes: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.type)
        writer.number("f", self.length)
        self.orientation.write(writer)
        self.axis.write(writer)
        writer.number("f", self.min)
        writer.number("f", self.centre)
        writer.number("f", self.max)
        writer.number("f", self.home)
        writer.number("f", self.config_speed)
        writer.number("B", self.hasbrakes)

    @classmethod
    def read(cls, reader: Reader) -> "Actuatorgeom":
        self = cls()
        self.type = reader.number("B")
        self.length = reader.number("f")
        self.orientation = common.Orientation3d.read(reader)
        self.axis = common.Point3d.read(reader)
        self.min = reader.number("f")
        self.centre = reader.number("f")
        self.max = reader.number("f")
        self.home = reader.number("f")
        self.config_speed = reader.number("f")
        self.hasbrakes = reader.number("B")
        return self


@dataclass
class Geom(Struct):
    """Joints and base pose of the chain. (player_actarray_geom_t)"""

    actuators: List[Actuatorgeom] = field(default_factory=list)
    # Position of the base of the chain on the robot (in m, frame p_RB).
    base_pos: common.Point3d = field(default_factory=common.Point3d)
    # Orientation of the base of the chain on the robot (in rad, frame R_RB).
    base_orientation: common.Orientation3d = field(default_factory=common.Orientation3d)

    def write(self, writer: Writer) -> None:
        writer.length("actuators", len(self.actuators), 419429)
        writer.length("actuators", len(self.actuators), 419429)
        for item in self.actuators:
            item.write(writer)
        self.base_pos.write(writer)
        self.base_orientation.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Geom":
        self = cls()
        actuators_count = reader.number("I")
        actuators_length = reader.length("actuators", actuators_count, 80)
        self.actuators = [Actuatorgeom.read(reader) for _ in range(actuators_length)]
        self.base_pos = common.Point3d.read(reader)
        self.base_orientation = common.Orientation3d.read(reader)
        return self


@dataclass
class PositionCmd(Struct):
    """Commanded position of one joint. (player_actarray_position_cmd_t)"""

    # Index of the joint, from 0.
    joint: int = 0
    # In m or rad.
    position: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.joint)
        writer.number("f", self.position)

    @classmethod
    def read(cls, reader: Reader) -> "PositionCmd":
        self = cls()
        self.joint = reader.number("i")
        self.position = reader.number("f")
        return self


@dataclass
class MultiPositionCmd(Struct):
    """Commanded positions of all joints. (player_actarray_multi_position_cmd_t)"""

    # In m or rad.
    positions: List[float] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("positions", len(self.positions), 8388598)
        writer.length("positions", len(self.positions), 8388598)
        writer.numbers("f", self.positions)

    @classmethod
    def read(cls, reader: Reader) -> "MultiPositionCmd":
        self = cls()
        positions_count = reader.number("I")
        self.positions = reader.numbers("f", reader.length("positions", positions_count, 4))
        return self


@dataclass
class SpeedCmd(Struct):
    """Commanded speed of one joint. (player_actarray_speed_cmd_t)"""

    # Index of the joint, from 0.
    joint: int = 0
    # In m/s or rad/s.
    speed: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.joint)
        writer.number("f", self.speed)

    @classmethod
    def read(cls, reader: Reader) -> "SpeedCmd":
        self = cls()
        self.joint = reader.number("i")
        self.speed = reader.number("f")
        return self


@dataclass
class MultiSpeedCmd(Struct):
    """Commanded speeds of all joints. (player_actarray_multi_speed_cmd_t)"""

    # In m/s or rad/s.
    speeds: List[float] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("speeds", len(self.speeds), 8388598)
        writer.length("speeds", len(self.speeds), 8388598)
        writer.numbers("f", self.speeds)

    @classmethod
    def read(cls, reader: Reader) -> "MultiSpeedCmd":
        self = cls()
        speeds_count = reader.number("I")
        self.speeds = reader.numbers("f", reader.length("speeds", speeds_count, 4))
        return self


@dataclass
class HomeCmd(Struct):
    """A joint to move to its home position. (player_actarray_home_cmd_t)"""

    # Index of the joint; -1: all.
    joint: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.joint)

    @classmethod
    def read(cls, reader: Reader) -> "HomeCmd":
        self = cls()
        self.joint = reader.number("i")
        return self


@dataclass
class CurrentCmd(Struct):
    """Commanded current of one joint. (player_actarray_current_cmd_t)"""

    # Index of the joint, from 0.
    joint: int = 0
    # In A.
    current: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.joint)
        writer.number("f", self.current)

    @classmethod
    def read(cls, reader: Reader) -> "CurrentCmd":
        self = cls()
        self.joint = reader.number("i")
        self.current = reader.number("f")
        return self


@dataclass
class MultiCurrentCmd(Struct):
    """Commanded currents of all joints. (player_actarray_multi_current_cmd_t)"""

    # In A.
    currents: List[float] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("currents", len(self.currents), 8388598)
        writer.length("currents", len(self.currents), 8388598)
        writer.numbers("f", self.currents)

    @classmethod
    def read(cls, reader: Reader) -> "MultiCurrentCmd":
        self = cls()
        currents_count = reader.number("I")
        self.currents = reader.numbers("f", reader.length("currents", currents_count, 4))
        return self


@dataclass
class PowerConfig(Struct):
    """The motors' switch. (player_actarray_power_config_t)"""

    # 1: on, 0: off.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "PowerConfig":
        self = cls()
        self.value = reader.number("B")
        return self


@dataclass
class BrakesConfig(Struct):
    """The brakes' switch. (player_actarray_brakes_config_t)"""

    # 1: braked, 0: released.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "BrakesConfig":
        self = cls()
        self.value = reader.number("B")
        return self


@dataclass
class SpeedConfig(Struct):
    """Speed of one joint. (player_actarray_speed_config_t)"""

    # Index of the joint; -1: all.
    joint: int = 0
    # In m/s or rad/s.
    speed: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.joint)
        writer.number("f", self.speed)

    @classmethod
    def read(cls, reader: Reader) -> "SpeedConfig":
        self = cls()
        self.joint = reader.number("i")
        self.speed = reader.number("f")
        return self


@dataclass
class AccelConfig(Struct):
    """Acceleration of one joint. (player_actarray_accel_config_t)"""

    # Index of the joint; -1: all.
    joint: int = 0
    # In m/s^2 or rad/s^2.
    accel: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("i", self.joint)
        writer.number("f", self.accel)

    @classmethod
    def read(cls, reader: Reader) -> "AccelConfig":
        self = cls()
        self.joint = reader.number("i")
        self.accel = reader.number("f")
        return self


# Switches the motors on or off.
REQ_POWER = MessageType(53, Kind.REQ, 1, "actarray.req.power", PowerConfig)
# Sets or releases the brakes.
REQ_BRAKES = MessageType(53, Kind.REQ, 2, "actarray.req.brakes", BrakesConfig)
# Requests the joints and the base pose of the chain.
REQ_GET_GEOM = MessageType(53, Kind.REQ, 3, "actarray.req.get_geom", Geom)
# Sets a joint's speed in position control.
REQ_SPEED = MessageType(53, Kind.REQ, 4, "actarray.req.speed", SpeedConfig)
# Sets a joint's acceleration in position control.
REQ_ACCEL = MessageType(53, Kind.REQ, 5, "actarray.req.accel", AccelConfig)
# Commanded position of one joint.
CMD_POS = MessageType(53, Kind.CMD, 1, "actarray.cmd.pos", PositionCmd)
# Commanded positions of all joints.
CMD_MULTI_POS = MessageType(53, Kind.CMD, 2, "actarray.cmd.multi_pos", MultiPositionCmd)
# Commanded speed of one joint.
CMD_SPEED = MessageType(53, Kind.CMD, 3, "actarray.cmd.speed", SpeedCmd)
# Commanded speeds of all joints.
CMD_MULTI_SPEED = MessageType(53, Kind.CMD, 4, "actarray.cmd.multi_speed", MultiSpeedCmd)
# Moves one joint, or all, to the home position.
CMD_HOME = MessageType(53, Kind.CMD, 5, "actarray.cmd.home", HomeCmd)
# Commanded current of one joint.
CMD_CURRENT = MessageType(53, Kind.CMD, 6, "actarray.cmd.current", CurrentCmd)
# Commanded currents of all joints.
CMD_MULTI_CURRENT = MessageType(53, Kind.CMD, 7, "actarray.cmd.multi_current", MultiCurrentCmd)
# State of each joint.
DATA_STATE = MessageType(53, Kind.DATA, 1, "actarray.data.state", Data)
