"""Interface imu, code 60. Accelerations, turn rates, magnetic field and orientation.

Generated from interfaces/060_imu.toml by codegen; do not edit.
"""

from dataclasses import dataclass, field

from . import common
from ..wire import Kind, MessageType, Reader, Struct, Writer

CODE = 60


@dataclass
class DataState(Struct):
    """Pose by integration. (player_imu_data_state_t)"""

    # In m, m, m, rad, rad, rad, frame X_WS.
    pose: common.Pose3d = field(default_factory=common.Pose3d)

    def write(self, writer: Writer) -> None:
        self.pose.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "DataState":
        self = cls()
        self.pose = common.Pose3d.read(reader)
        return self


@dataclass
class DataCalib(Struct):
    """Calibrated readings. (player_imu_data_calib_t)"""

    # In m/s^2, frame a_WS_S.
    accel_x: float = 0.0
    # In m/s^2, frame a_WS_S.
    accel_y: float = 0.0
    # In m/s^2, frame a_WS_S.
    accel_z: float = 0.0
    # In rad/s, frame v_WS_S.
    gyro_x: float = 0.0
    # In rad/s, frame v_WS_S.
    gyro_y: float = 0.0
    # In rad/s, frame v_WS_S.
    gyro_z: float = 0.0
    # Magnetic field, in a driver-specific unit (frame n_S).
    magn_x: float = 0.0
    # Frame n_S.
    magn_y: float = 0.0
    # Frame n_S.
    magn_z: float = 0.0

    def write(self, writer: Writer) -> None:
        writer.number("f", self.accel_x)
        writer.number("f", self.accel_y)
        writer.number("f", self.accel_z)
        writer.number("f", self.gyro_x)
        writer.number("f", self.gyro_y)
        writer.number("f", self.gyro_z)
        writer.number("f", self.magn_x)
        writer.number("f", self.magn_y)
        writer.number("f", self.magn_z)

    @classmethod
    def read(cls, reader: Reader) -> "DataCalib":
        self = cls()
        self.accel_x = reader.number("f")
        self.accel_y = reader.number("f")
        self.accel_z = reader.number("f")
        self.gyro_x = reader.number("f")
        self.gyro_y = reader.number("f")
        self.gyro_z = reader.number("f")
        self.magn_x = reader.number("f")
        self.magn_y = reader.number("f")
        self.magn_z = reader.number("f")
        return self


@dataclass
class DataQuat(Struct):
    """Calibrated readings and orientation as a quaternion. (player_imu_data_quat_t)"""

    calib_data: DataCalib = field(default_factory=DataCalib)
    # Real part (frame R_WS).
    q0: float = 0.0
    # Frame R_WS.
    q1: float = 0.0
    # Frame R_WS.
    q2: float = 0.0
    # Frame R_WS.
    q3: float = 0.0

    def write(self, writer: Writer) -> None:
        self.calib_data.write(writer)
        writer.number("f", self.q0)
        writer.number("f", self.q1)
        writer.number("f", self.q2)
        writer.number("f", self.q3)

    @classmethod
    def read(cls, reader: Reader) -> "DataQuat":
        self = cls()
        self.calib_data = DataCalib.read(reader)
        self.q0 = reader.number("f")
        self.q1 = reader.number("f")
        self.q2 = reader.number("f")
        self.q3 = reader.number("f")
        return self


@dataclass
class DataEuler(Struct):
    """Calibrated readings and orientation as angles. (player_imu_data_euler_t)"""

    calib_data: DataCalib = field(default_factory=DataCalib)
    # In rad, frame R_WS.
    orientation: common.Orientation3d = field(default_factory=common.Orientation3d)

    def write(self, writer: Writer) -> None:
        self.calib_data.write(writer)
        self.orientation.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "DataEuler":
        self = cls()
        self.calib_data = DataCalib.read(reader)
        self.orientation = common.Orientation3d.read(reader)
        return self


@dataclass
class DataFullstate(Struct):
    """Pose, velocity and acceleration. (player_imu_data_fullstate_t)"""

    # In m, m, m, rad, rad, rad, frame X_WS.
    pose: common.Pose3d = field(default_factory=common.Pose3d)
    # In m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_WS_S.
    vel: common.Pose3d = field(default_factory=common.Pose3d)
    # In m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2, frame a_WS_S.
    acc: common.Pose3d = field(default_factory=common.Pose3d)

    def write(self, writer: Writer) -> None:
        self.pose.write(writer)
        self.vel.write(writer)
        self.acc.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "DataFullstate":
        self = cls()
        self.pose = common.Pose3d.read(reader)
        self.vel = common.Pose3d.read(reader)
        self.acc = common.Pose3d.read(reader)
        return self


@dataclass
class DatatypeConfig(Struct):
    """Selected data message. (player_imu_datatype_config_t)"""

    # Its subtype.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("B", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "DatatypeConfig":
        self = cls()
        self.value = reader.number("B")
        return self


@dataclass
class ResetOrientationConfig(Struct):
    """Quantity that becomes the reference. (player_imu_reset_orientation_config_t)"""

    # 0: heading, 1: orientation, 2: driver-specific.
    value: int = 0

    def write(self, writer: Writer) -> None:
        writer.number("I", self.value)

    @classmethod
    def read(cls, reader: Reader) -> "ResetOrientationConfig":
        self = cls()
        self.value = reader.number("I")
        return self


@dataclass
class ResetEulerConfig(Struct):
    """A new orientation. (player_imu_reset_euler_config_t)"""

    # Only the angles apply (in m, m, m, rad, rad, rad, frame X_WS).
    orientation: common.Pose3d = field(default_factory=common.Pose3d)

    def write(self, writer: Writer) -> None:
        self.orientation.write(writer)

    @classmethod
    def read(cls, reader: Reader) -> "ResetEulerConfig":
        self = cls()
        self.orientation = common.Pose3d.read(reader)
        return self


# Pose by integration.
DATA_STATE = MessageType(60, Kind.DATA, 1, "imu.data.state", DataState)
# Calibrated readings.
DATA_CALIB = MessageType(60, Kind.DATA, 2, "imu.data.calib", DataCalib)
# Calibrated readings and orientation as a quaternion.
DATA_QUAT = MessageType(60, Kind.DATA, 3, "imu.data.quat", DataQuat)
# Calibrated readings and orientation as angles.
DATA_EULER = MessageType(60, Kind.DATA, 4, "imu.data.euler", DataEuler)
# Pose, velocity and acceleration.
DATA_FULLSTATE = MessageType(60, Kind.DATA, 5, "imu.data.fullstate", DataFullstate)
# Selects which data message is sent.
REQ_SET_DATATYPE = MessageType(60, Kind.REQ, 1, "imu.req.set_datatype", DatatypeConfig)
# Makes the current orientation the reference.
REQ_RESET_ORIENTATION = MessageType(60, Kind.REQ, 2, "imu.req.reset_orientation", ResetOrientationConfig)
# Sets the current orientation.
REQ_RESET_EULER = MessageType(60, Kind.REQ, 3, "imu.req.reset_euler", ResetEulerConfig)
