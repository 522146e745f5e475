"""Interface ptz, code 8. A camera mount that pans, tilts and zooms.

Generated from interfaces/008_ptz.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field
from typing import List

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 8

# Values of ReqControlMode.mode.
VELOCITY_CONTROL = 0
POSITION_CONTROL = 1


@dataclass
class Data(Struct):
    """Direction of the mount. (player_ptz_data_t)"""

    # Positive to the left (in rad).
    pan: float = 0.0
    # Positive upwards (in rad).
    tilt: float = 0.0
    # Field of view (in rad).
    zoom: float = 0.0
    # Positive to the left (in rad/s).
    panspeed: float = 0.0
    # Positive upwards (in rad/s).
    tiltspeed: float = 0.0
    # Driver-specific.
    status: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.pan)
        writer.number("f", self.tilt)
        writer.number("f", self.zoom)
        writer.number("f", self.panspeed)
        writer.number("f", self.tiltspeed)
        writer.number("I", self.status)

    @classmethod
    def read(cls, reader: Reader) -> "Data":
        self = cls()
        self.pan = reader.number("f")
        self.tilt = reader.number("f")
        self.zoom = reader.number("f")
        self.panspeed = reader.number("f")
        self.tiltspeed = reader.number("f")
        self.status = reader.number("I")
        return self


@dataclass
class Cmd(Struct):
    """Commanded direction or velocity of the mount. (player_ptz_cmd_t)"""

    # Positive to the left (in rad).
    pan: float = 0.0
    # Positive upwards (in rad).
    tilt: float = 0.0
    # Field of view (in rad).
    zoom: float = 0.0
    # Used by velocity control (in rad/s).
    panspeed: float = 0.0
    # Used by velocity control (in rad/s).
    tiltspeed: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.pan)
        writer.number("f", self.tilt)
        writer.number("f", self.zoom)
        writer.number("f", self.panspeed)
        writer.number("f", self.tiltspeed)

    @classmethod
    def read(cls, reader: Reader) -> "Cmd":
        self = cls()
        self.pan = reader.number("f")
        self.tilt = reader.number("f")
        self.zoom = reader.number("f")
        self.panspeed = reader.number("f")
        self.tiltspeed = reader.number("f")
        return self


@dataclass
class ReqStatus(Struct):
    """The mount's status. (player_ptz_req_status_t)"""

    # Driver-specific.
    status: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.status)

    @classmethod
    def read(cls, reader: Reader) -> "ReqStatus":
        self = cls()
        self.status = reader.number("I")
        return self


@dataclass
class Geom(Struct):
    """The mount's size and pose. (player_ptz_geom_t)"""

    # Pose of the mount on the robot (in m, m, m, rad, rad, rad, frame X_RS).
    pos: common.Pose3d = field(default_factory=common.Pose3d)
    # Bounding box of the mount (in m, m, m).
    size: common.Bbox3d = field(default_factory=common.Bbox3d)

    def write(self, writer: Writer) -> None:
        self.pos.write(writer)
        self.size.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "Geom":
        self = cls()
        self.pos = common.Pose3d.read(reader)
        self.size = common.Bbox3d.read(reader)
        return self


@dataclass
class ReqGeneric(Struct):
    """Driver-specific words. (player_ptz_req_generic_t)"""

    # Driver-specific.
    config: List[int] = field(default_factory=list)

    def write(self, writer: Writer) -> None:
        writer.length("config", len(self.config), 8388598)
        writer.length("config", len(self.config), 8388598)
        writer.numbers("I", self.config)

    @classmethod
    def read(cls, reader: Reader) -> "ReqGeneric":
        self = cls()
        config_count = reader.number("I")
        self.config = reader.numbers("I", reader.length("config", config_count, 4))
        return self


@dataclass
class ReqControlMode(Struct):
    """A control mode. (player_ptz_req_control_mode_t)"""

    # Velocity or position.
    mode: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.mode)

    @classmethod
    def read(cls, reader: Reader) -> "ReqControlMode":
        self = cls()
        self.mode = reader.number("I")
        return self


# Exchanges driver-specific words with the mount.
REQ_GENERIC = MessageType(8, Kind.REQ, 1, "ptz.req.generic", ReqGeneric)
# Selects between velocity and position control.
REQ_CONTROL_MODE = MessageType(8, Kind.REQ, 2, "ptz.req.control_mode", ReqControlMode)
# Requests size and pose.
REQ_GEOM = MessageType(8, Kind.REQ, 4, "ptz.req.geom", Geom)
# Requests the mount's status.
REQ_STATUS = MessageType(8, Kind.REQ, 5, "ptz.req.status", ReqStatus)
# Direction of the mount.
DATA_STATE = MessageType(8, Kind.DATA, 1, "ptz.data.state", Data)
# Size and pose, sent on change.
DATA_GEOM = MessageType(8, Kind.DATA, 2, "ptz.data.geom", Geom)
# Commanded direction of the mount.
CMD_STATE = MessageType(8, Kind.CMD, 1, "ptz.cmd.state", Cmd)
