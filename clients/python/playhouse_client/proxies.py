"""Proxies of the common interfaces. SI units and radians; x forward, y left, z up, angles
counter-clockwise.

Reading a device's data never waits: it returns the data of the last Client.read(), and raises NoData before the
first data of the device. next_data() and updates() wait.
"""

import collections
import math
import struct
import zlib
from array import array
from typing import Any, Deque, Generic, Iterator, List, NamedTuple, Optional, Sequence, Tuple, TypeVar, cast

from .device import Device
from .errors import GoalRefused, InvalidValue, NoData, RequestRefused, RunEnded, WireError
from .generated import aio, bumper, camera, common, fiducial, gps, imu, laser, localize, opaque, planner, pointcloud3d, position2d
from .generated import map as grid_map
from .generated import position3d, ptz, ranger, simulation, sonar, speech, speech_recognition
from .wire import MessageType, Struct, c_string, text

Kept = TypeVar("Kept")

_ENDED = "the run has ended"  # the server's reason to refuse a step then
_TILE = 512  # cells along a side of a tile of a map, so that any map fits into messages
_MOST_CELLS = 1 << 26  # of a map
_REFUSAL_PERIOD = 1.0  # of the server's time (s), between two questions of a refusal while there is a path
_STATES_UNDER_WAY = 2  # of another goal, after an answer


class Pose(NamedTuple):
    """A pose in the plane, in this order: x (m), y (m), a (heading in rad, counter-clockwise, 0 along the frame's x, in
    (-pi, pi] as servers report it). The frame is documented where a pose is returned."""

    x: float = 0.0
    y: float = 0.0
    a: float = 0.0


class Pose3d(NamedTuple):
    """A pose in space, in this order: x, y, z (m), then roll, pitch, yaw (rad): rotations about z by yaw, then about the
    new y by pitch, then about the new x by roll. The frame is documented where a pose is returned."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    roll: float = 0.0
    pitch: float = 0.0
    yaw: float = 0.0


class Size(NamedTuple):
    """Extents in m along x, y and z."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0


class Velocity(NamedTuple):
    """x and y in m/s, a in rad/s, in the robot's frame."""

    x: float = 0.0
    y: float = 0.0
    a: float = 0.0


class Geometry(NamedTuple):
    """Pose of a device on its robot (for a base: its own centre), and its size."""

    pose: Pose3d
    size: Size


class State(NamedTuple):
    """The data of a base: pose estimate, velocity, and whether it is blocked.

    `pose` is in the frame of the estimate: with odometry that of the start pose, or as set by set_odometry();
    with localization by gps the world. `time` is the server's, in s.
    """

    pose: Pose
    velocity: Velocity
    stalled: bool
    time: float


class Scan(NamedTuple):
    """Ranges in m and their directions in rad, pairwise, in the order of measurement.

    Directions are counter-clockwise from the sensor's x axis. `time` is the server's, in s.
    """

    ranges: List[float]
    angles: List[float]
    max_range: float
    time: float

    def nearest(self, low: float = -math.pi, high: float = math.pi) -> float:
        """The minimum range between two directions; max_range if no beam is there."""
        return min((r for r, a in zip(self.ranges, self.angles) if low <= a <= high), default=self.max_range)

    def points(self) -> List[Tuple[float, float]]:
        """End points of the beams, in the sensor's frame."""
        return [(r * math.cos(a), r * math.sin(a)) for r, a in zip(self.ranges, self.angles)]


class Marker(NamedTuple):
    """A marker in view: its id, and its pose in the sensor's frame."""

    id: int
    pose: Pose3d

    @property
    def distance(self) -> float:
        return math.hypot(self.pose.x, self.pose.y)

    @property
    def bearing(self) -> float:
        return math.atan2(self.pose.y, self.pose.x)


class Face(NamedTuple):
    """The face of a bumper switch: pose of its centre on the robot (yaw: outward direction) and its length. `radius` is
    its radius of curvature, 0 if it is straight. In m."""

    pose: Pose3d
    length: float
    radius: float


class Image(NamedTuple):
    """An image: rows from the top, pixels from the left. `format` is one of camera.FORMAT_MONO8, FORMAT_MONO16 (of
    Playhouse: depth in mm, little-endian, 0 if nothing is in range), FORMAT_RGB565 and FORMAT_RGB888.
    `data` is the pixels, or a JPEG file if `is_jpeg`. `time` is the server's, in s."""

    width: int
    height: int
    format: int
    is_jpeg: bool
    data: bytes
    time: float

    def pixel(self, column: int, row: int) -> Tuple[int, ...]:
        """(red, green, blue), or (brightness,), or (depth in mm,). Raises InvalidValue for a JPEG file, for other
        formats, outside the image, and if the data are shorter than the image."""
        if self.is_jpeg or self.format not in _CHANNELS:
            raise InvalidValue("pixels can be told of raw MONO8, MONO16 and RGB888 alone")
        if not (0 <= column < self.width and 0 <= row < self.height):
            raise InvalidValue(f"pixel {column}, {row} is outside the {self.width} x {self.height} picture")
        channel, size = _CHANNELS[self.format]
        first = (row * self.width + column) * size
        if first + size > len(self.data):
            raise InvalidValue(f"the picture has fewer bytes than pixels: {len(self.data)}")
        return struct.unpack_from(channel, self.data, first)

    def model_id(self, column: int, row: int) -> Optional[int]:
        """For images of a camera with `image "segmentation"`: the id of the model at the pixel, as in client.models(),
        up to 24 bits; None without a model. Raises InvalidValue as pixel(), and for other formats."""
        channels = self.pixel(column, row)
        if len(channels) != 3:
            raise InvalidValue("which model a pixel shows is told by RGB888 alone")
        red, green, blue = channels
        number = red << 16 | green << 8 | blue
        return number - 1 if number > 0 else None


_CHANNELS = {camera.FORMAT_MONO8: ("<B", 1), camera.FORMAT_MONO16: ("<H", 2), camera.FORMAT_RGB888: ("<3B", 3)}


class View(NamedTuple):
    """State of a camera mount: pan to the left, tilt upwards and horizontal field of view, in rad; speeds in rad/s."""

    pan: float
    tilt: float
    zoom: float
    pan_speed: float = 0.0
    tilt_speed: float = 0.0


class State3d(NamedTuple):
    """The data of a base that moves in space: pose estimate, velocity (m/s and rad/s along and about its own axes), and
    whether it is blocked. `time` is the server's, in s."""

    pose: Pose3d
    velocity: Pose3d
    stalled: bool
    time: float


class Inertia(NamedTuple):
    """Measurements of an inertial unit along and about its own axes: specific force in m/s^2, (0, 0, 9.81) when level
    and at rest; turn rates in rad/s; magnetic field, in a unit of the server."""

    acceleration: Tuple[float, float, float]
    turn_rate: Tuple[float, float, float]
    field: Tuple[float, float, float]


class Fix(NamedTuple):
    """A fix of a satellite receiver: latitude and longitude in degrees, altitude in m above the ellipsoid (WGS84), UTM
    easting and northing in m; speed in m/s, course in rad, clockwise from north; expected errors in m. `quality` is 0
    without a fix, and then the rest is invalid. `time` is the server's, in s."""

    latitude: float
    longitude: float
    altitude: float
    easting: float
    northing: float
    speed: float
    course: float
    quality: int
    satellites: int
    horizontal_error: float
    vertical_error: float
    time: float


class Point(NamedTuple):
    """A point of a cloud, in m in the sensor's frame, and its color: red, green, blue, alpha from 0 to 255."""

    x: float
    y: float
    z: float
    color: Tuple[int, int, int, int]


class Covariance(NamedTuple):
    """Covariance of a pose in the plane: of x, y (m) and a (rad). In this order xx, yy, aa (variances), xy, ya, xa."""

    xx: float = 0.0
    yy: float = 0.0
    aa: float = 0.0
    xy: float = 0.0
    ya: float = 0.0
    xa: float = 0.0

    @staticmethod
    def of_deviations(x: float, y: float, a: float) -> "Covariance":
        """That of independent errors with these standard deviations, in m, m and rad."""
        return Covariance(x * x, y * y, a * a)


class Hypothesis(NamedTuple):
    """A hypothesis about where the robot is: the mean pose on the map, its covariance, and its weight; the weights of
    all sum to 1."""

    pose: Pose
    covariance: Covariance
    weight: float


class Particle(NamedTuple):
    """A particle of the localization's filter: a possible pose of the robot on the map, and its weight."""

    pose: Pose
    weight: float


class PlannerState(NamedTuple):
    """The data of a planner, poses on the map: whether there is a path to the goal (`valid`), whether the goal is reached
    (`done`), the robot's pose, the goal, the waypoint that the robot drives to, its index in the path (-1 if there is
    none) and the number of waypoints of the path. `time` is the server's, in s."""

    valid: bool
    done: bool
    pose: Pose
    goal: Pose
    waypoint: Pose
    index: int
    count: int
    time: float


class Path(NamedTuple):
    """A planned path: its waypoints on the map, from the robot to the goal, and its length in m."""

    waypoints: List[Pose]
    length: float


class Cell(NamedTuple):
    """A cell of a map: its column from the left and its row from the bottom, from 0."""

    column: int
    row: int


class Grid(NamedTuple):
    """The grid of a map: length of a cell's side in m, width and height in cells, and the pose of the lower left corner of
    cell (0, 0) in the world."""

    cell_size: float
    width: int
    height: int
    origin: Pose

    def cell_of(self, x: float, y: float) -> Optional[Cell]:
        """The cell with this point of the world (m); None beyond the map."""
        dx, dy = x - self.origin.x, y - self.origin.y
        c, s = math.cos(self.origin.a), math.sin(self.origin.a)
        column, row = (c * dx + s * dy) / self.cell_size, (c * dy - s * dx) / self.cell_size
        if not (0.0 <= column < self.width and 0.0 <= row < self.height):
            return None
        return Cell(int(column), int(row))


class Position2d(Device):
    """A mobile base. Closing it while it moves stops it first."""

    _moving = False

    @property
    def state(self) -> State:
        data, time = self._stamped(position2d.DATA_STATE)
        return State(_pose(data.pos), Velocity(*_pose(data.vel)), bool(data.stall), time)

    def updates(self, timeout: Optional[float] = None) -> Iterator[State]:
        """Reads for ever: one State per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.state

    @property
    def pose(self) -> Pose:
        """The robot's pose estimate: State.pose."""
        return self.state.pose

    @property
    def velocity(self) -> Velocity:
        return self.state.velocity

    @property
    def stalled(self) -> bool:
        return self.state.stalled

    def drive(self, vx: float, va: float = 0.0, vy: float = 0.0) -> None:
        """Forward and to the left in m/s, turning in rad/s, until the next command."""
        self._insist_on_finite(vx=vx, va=va, vy=vy)
        self._moving = (vx, vy, va) != (0.0, 0.0, 0.0)
        self.command(position2d.CMD_VEL, position2d.CmdVel(common.Pose2d(vx, vy, va), 1))

    def stop(self) -> None:
        self.drive(0.0)

    def drive_car(self, speed: float, steering: float) -> None:
        """For a base with car steering: speed in m/s, and steering angle in rad, positive to the left."""
        self._insist_on_finite(speed=speed, steering=steering)
        self._moving = speed != 0.0
        self.command(position2d.CMD_CAR, position2d.CmdCar(speed, steering))

    def go_to(self, x: float, y: float, a: float, speed: float = 0.0) -> None:
        """Drives to a pose in the frame of State.pose, by the driver's position control; speed 0: the driver's choice."""
        self._insist_on_finite(x=x, y=y, a=a, speed=speed)
        self._moving = True
        goal, velocity = common.Pose2d(x, y, a), common.Pose2d(speed, 0.0, 0.0)
        self.command(position2d.CMD_POS, position2d.CmdPos(goal, velocity, 1))

    def why_refused(self) -> str:
        """Requests why the driver (nd, vfh) does not drive to the goal of the last go_to(), as its log says; empty if it does,
        has arrived, or is a driver that gives no reasons."""
        return self._why_refused()

    def set_motor_power(self, on: bool) -> None:
        self.request(position2d.REQ_MOTOR_POWER, position2d.PowerConfig(int(on)))

    def set_odometry(self, x: float, y: float, a: float) -> None:
        """Sets the pose estimate; the robot does not move."""
        self._insist_on_finite(x=x, y=y, a=a)
        self.request(position2d.REQ_SET_ODOM, position2d.SetOdomReq(common.Pose2d(x, y, a)))

    def reset_odometry(self) -> None:
        self.request(position2d.REQ_RESET_ODOM)

    def geometry(self) -> Geometry:
        return _geometry(_answer(self.request(position2d.REQ_GET_GEOM)))

    def close(self) -> None:
        if self._open and self._moving and not self.gone and self._session.connection.alive:
            self.stop()
        super().close()


class Ranger(Device):
    """A range finder: a laser scanner, or a ring of sonars. Opening requests its configuration."""

    config = ranger.Config()
    geom = ranger.Geom()

    def prepare(self) -> None:
        self.config = cast(ranger.Config, _answer(self.request(ranger.REQ_GET_CONFIG)))
        self.geom = cast(ranger.Geom, _answer(self.request(ranger.REQ_GET_GEOM)))

    @property
    def ranges(self) -> List[float]:
        """In m, in the order of measurement."""
        data, _ = self._stamped(ranger.DATA_RANGE)
        return cast(List[float], data.ranges)

    @property
    def intensities(self) -> List[float]:
        """One per range, in the device's unit. Raises NoData also for a device without intensities."""
        data, _ = self._stamped(ranger.DATA_INTNS)
        return cast(List[float], data.intensities)

    def scan(self) -> Scan:
        """Ranges with directions: those of the elements if there is one per range, else spread over the field of view."""
        data, time = self._stamped(ranger.DATA_RANGE)
        ranges, poses = data.ranges, self.geom.element_poses
        if len(poses) == len(ranges) and len(ranges) > 1:
            angles = [pose.pyaw for pose in poses]
        else:
            angles = _spread(self.config.min_angle, self.config.max_angle, len(ranges))
        return Scan(ranges, angles, self.config.max_range, time)

    def updates(self, timeout: Optional[float] = None) -> Iterator[Scan]:
        """Reads for ever: one Scan per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.scan()

    def geometry(self) -> Geometry:
        return _geometry(self.geom)

    def set_power(self, on: bool) -> None:
        self.request(ranger.REQ_POWER, ranger.PowerConfig(int(on)))

    def set_intensities(self, on: bool) -> None:
        """Enables or disables intensities."""
        self.request(ranger.REQ_INTNS, ranger.IntnsConfig(int(on)))

    def set_config(self, config: ranger.Config) -> None:
        """Requests another configuration; `config` then has the values in effect."""
        self.request(ranger.REQ_SET_CONFIG, config)
        self.config = cast(ranger.Config, _answer(self.request(ranger.REQ_GET_CONFIG)))


class Laser(Device):
    """A laser scanner; its data include the directions of the beams."""

    def scan(self) -> Scan:
        data, time = self._stamped(laser.DATA_SCAN)
        angles = _spread(data.min_angle, data.max_angle, len(data.ranges))
        return Scan(data.ranges, angles, data.max_range, time)

    def updates(self, timeout: Optional[float] = None) -> Iterator[Scan]:
        """Reads for ever: one Scan per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.scan()

    @property
    def ranges(self) -> List[float]:
        """In m, from min_angle to max_angle."""
        return self.scan().ranges

    @property
    def intensities(self) -> bytes:
        """One per range, in the device's unit; empty if it measures none."""
        data, _ = self._stamped(laser.DATA_SCAN)
        return cast(bytes, data.intensity)

    def config(self) -> laser.Config:
        return cast(laser.Config, _answer(self.request(laser.REQ_GET_CONFIG)))

    def set_config(self, config: laser.Config) -> None:
        self.request(laser.REQ_SET_CONFIG, config)

    def geometry(self) -> Geometry:
        return _geometry(_answer(self.request(laser.REQ_GET_GEOM)))


class Sonar(Device):
    """A ring of sonars."""

    @property
    def ranges(self) -> List[float]:
        """In m, one per sonar, in the order of poses()."""
        data, _ = self._stamped(sonar.DATA_RANGES)
        return cast(List[float], data.ranges)

    def poses(self) -> List[Pose3d]:
        """Poses of the sonars on the robot."""
        return [_pose3d(pose) for pose in cast(sonar.Geom, _answer(self.request(sonar.REQ_GET_GEOM))).poses]

    def set_power(self, on: bool) -> None:
        self.request(sonar.REQ_POWER, sonar.PowerConfig(int(on)))


class Fiducial(Device):
    """A fiducial finder."""

    @property
    def markers(self) -> List[Marker]:
        """Markers in view."""
        data, _ = self._stamped(fiducial.DATA_SCAN)
        return [Marker(item.id, _pose3d(item.pose)) for item in data.fiducials]

    def updates(self, timeout: Optional[float] = None) -> Iterator[List[Marker]]:
        """Reads for ever: one list per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.markers

    def field_of_view(self) -> fiducial.Fov:
        return cast(fiducial.Fov, _answer(self.request(fiducial.REQ_GET_FOV)))

    def set_field_of_view(self, min_range: float, max_range: float, view_angle: float) -> None:
        """Ranges in m, the full field of view in rad."""
        self._insist_on_finite(min_range=min_range, max_range=max_range, view_angle=view_angle)
        self.request(fiducial.REQ_SET_FOV, fiducial.Fov(min_range, max_range, view_angle))

    def geometry(self) -> Geometry:
        return _geometry(_answer(self.request(fiducial.REQ_GET_GEOM)))


class Camera(Device):
    """A camera."""

    @property
    def image(self) -> Image:
        """The newest image."""
        data, time = self._stamped(camera.DATA_STATE)
        return Image(data.width, data.height, data.format, data.compression == camera.COMPRESS_JPEG, bytes(data.image), time)

    def updates(self, timeout: Optional[float] = None) -> Iterator[Image]:
        """Reads for ever: one image per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.image


class Ptz(Device):
    """A pan-tilt-zoom mount of a camera."""

    @property
    def view(self) -> View:
        """The current direction and field of view."""
        data, _ = self._stamped(ptz.DATA_STATE)
        return View(data.pan, data.tilt, data.zoom, data.panspeed, data.tiltspeed)

    def updates(self, timeout: Optional[float] = None) -> Iterator[View]:
        """Reads for ever: one view per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.view

    def look(self, pan: float, tilt: float = 0.0, zoom: float = 0.0) -> None:
        """Turns to these angles, in position control; a zoom of 0 keeps the field of view."""
        self._insist_on_finite(pan=pan, tilt=tilt, zoom=zoom)
        self.command(ptz.CMD_STATE, ptz.Cmd(pan, tilt, zoom, 0.0, 0.0))

    def turn(self, pan_speed: float, tilt_speed: float = 0.0) -> None:
        """Turns at these speeds; requires set_velocity_control(True)."""
        self._insist_on_finite(pan_speed=pan_speed, tilt_speed=tilt_speed)
        self.command(ptz.CMD_STATE, ptz.Cmd(0.0, 0.0, 0.0, pan_speed, tilt_speed))

    def set_velocity_control(self, on: bool) -> None:
        """Selects velocity control, or position control."""
        mode = ptz.VELOCITY_CONTROL if on else ptz.POSITION_CONTROL
        self.request(ptz.REQ_CONTROL_MODE, ptz.ReqControlMode(mode))

    def geometry(self) -> Geometry:
        geom = cast(ptz.Geom, _answer(self.request(ptz.REQ_GEOM)))
        return Geometry(_pose3d(geom.pos), Size(geom.size.sl, geom.size.sw, geom.size.sh))


class Bumper(Device):
    """Contact switches."""

    @property
    def pressed(self) -> List[bool]:
        """One per switch, in the order of faces()."""
        data, _ = self._stamped(bumper.DATA_STATE)
        return [state != 0 for state in data.bumpers]

    def updates(self, timeout: Optional[float] = None) -> Iterator[List[bool]]:
        """Reads for ever: one list per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.pressed

    def faces(self) -> List[Face]:
        """Faces of the switches on the robot."""
        geom = cast(bumper.Geom, _answer(self.request(bumper.REQ_GET_GEOM)))
        return [Face(_pose3d(one.pose), one.length, one.radius) for one in geom.bumper_def]


class Position3d(Device):
    """A mobile base in space. Closing it while it moves stops it first."""

    _moving = False

    @property
    def state(self) -> State3d:
        data, time = self._stamped(position3d.DATA_STATE)
        return State3d(_pose3d(data.pos), _pose3d(data.vel), bool(data.stall), time)

    def updates(self, timeout: Optional[float] = None) -> Iterator[State3d]:
        """Reads for ever: one State3d per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.state

    def drive(self, vx: float, va: float = 0.0, vy: float = 0.0, vz: float = 0.0) -> None:
        """Forward, to the left and upwards in m/s, turning in rad/s, until the next command."""
        self._insist_on_finite(vx=vx, va=va, vy=vy, vz=vz)
        self._moving = (vx, vy, vz, va) != (0.0, 0.0, 0.0, 0.0)
        self.command(position3d.CMD_SET_VEL, position3d.CmdVel(common.Pose3d(vx, vy, vz, 0.0, 0.0, va), 1))

    def stop(self) -> None:
        self.drive(0.0)

    def go_to(self, pose: Pose3d) -> None:
        """Moves to a pose in the frame of State3d.pose, by the driver's position control."""
        self._insist_on_finite(**pose._asdict())
        self._moving = True
        self.command(position3d.CMD_SET_POS, position3d.CmdPos(common.Pose3d(*pose), common.Pose3d(), 1))

    def set_motor_power(self, on: bool) -> None:
        self.request(position3d.REQ_MOTOR_POWER, position3d.PowerConfig(int(on)))

    def set_odometry(self, pose: Pose3d) -> None:
        """Sets the pose estimate, State3d.pose."""
        self._insist_on_finite(**pose._asdict())
        self.request(position3d.REQ_SET_ODOM, position3d.SetOdomReq(common.Pose3d(*pose)))

    def reset_odometry(self) -> None:
        self.request(position3d.REQ_RESET_ODOM)

    def geometry(self) -> Geometry:
        return _geometry(_answer(self.request(position3d.REQ_GET_GEOM)))

    def close(self) -> None:
        if self._open and self._moving and not self.gone and self._session.connection.alive:
            self.stop()
        super().close()


class Imu(Device):
    """An inertial unit. send() selects the data message; initially it is that of `pose`."""

    def send(self, datatype: MessageType) -> None:
        """One of imu.DATA_STATE (`pose`), DATA_CALIB (`inertia`), DATA_QUAT (`inertia` and `quaternion`), DATA_EULER
        (`inertia` and `attitude`) and DATA_FULLSTATE (`pose` and `velocity`), for all subscribers of the device."""
        self.request(imu.REQ_SET_DATATYPE, imu.DatatypeConfig(datatype.subtype))

    @property
    def pose(self) -> Pose3d:
        """Estimated pose."""
        data = self._newest_of(imu.DATA_STATE, imu.DATA_FULLSTATE)
        return _pose3d(data.pose)

    @property
    def velocity(self) -> Pose3d:
        """Estimated velocity, along and about its own axes."""
        return _pose3d(self._stamped(imu.DATA_FULLSTATE)[0].vel)

    @property
    def inertia(self) -> Inertia:
        data = self._newest_of(imu.DATA_CALIB, imu.DATA_QUAT, imu.DATA_EULER)
        one = data if isinstance(data, imu.DataCalib) else data.calib_data
        return Inertia((one.accel_x, one.accel_y, one.accel_z), (one.gyro_x, one.gyro_y, one.gyro_z),
                       (one.magn_x, one.magn_y, one.magn_z))

    @property
    def attitude(self) -> Tuple[float, float, float]:
        """Roll, pitch and yaw, in rad."""
        turns = self._stamped(imu.DATA_EULER)[0].orientation
        return turns.proll, turns.ppitch, turns.pyaw

    @property
    def quaternion(self) -> Tuple[float, float, float, float]:
        """Orientation, the real part first."""
        data = self._stamped(imu.DATA_QUAT)[0]
        return data.q0, data.q1, data.q2, data.q3

    def reset_orientation(self, all_axes: bool = False) -> None:
        """Makes the current heading, or the whole current orientation, the reference."""
        self.request(imu.REQ_RESET_ORIENTATION, imu.ResetOrientationConfig(int(all_axes)))

    def reset_attitude(self, roll: float, pitch: float, yaw: float) -> None:
        """Sets the current orientation, in rad."""
        self._insist_on_finite(roll=roll, pitch=pitch, yaw=yaw)
        self.request(imu.REQ_RESET_EULER, imu.ResetEulerConfig(common.Pose3d(0.0, 0.0, 0.0, roll, pitch, yaw)))

    def _lack_of(self, message: MessageType) -> str:
        why = super()._lack_of(message)
        constant = message.name.replace("imu.", "", 1).replace(".", "_").upper()
        return f"{why}; send(imu.{constant}) selects it" if self.has_data else why

    def _newest_of(self, *kinds: MessageType) -> Any:
        known = [self._stamped(kind) for kind in kinds if self.latest(kind) is not None]
        return max(known, key=lambda each: each[1])[0] if known else self._stamped(kinds[0])[0]


class Gps(Device):
    """A satellite receiver."""

    @property
    def fix(self) -> Fix:
        data, time = self._stamped(gps.DATA_STATE)
        return Fix(data.latitude * 1e-7, data.longitude * 1e-7, data.altitude * 1e-3, data.utm_e, data.utm_n, data.speed,
                   data.course, data.quality, data.num_sats, data.err_horz, data.err_vert, time)

    def updates(self, timeout: Optional[float] = None) -> Iterator[Fix]:
        """Reads for ever: one Fix per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.fix


class PointCloud3d(Device):
    """A 3D point cloud, such as that of a lidar with several rings."""

    @property
    def points(self) -> List[Point]:
        data, _ = self._stamped(pointcloud3d.DATA_STATE)
        return [Point(one.point.px, one.point.py, one.point.pz,
                      (one.color.red, one.color.green, one.color.blue, one.color.alpha)) for one in data.points]

    def updates(self, timeout: Optional[float] = None) -> Iterator[List[Point]]:
        """Reads for ever: one list per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.points


class Aio(Device):
    """Analog inputs and outputs; in Playhouse a custom model: its readings are inputs, its commands outputs."""

    @property
    def voltages(self) -> List[float]:
        """One per input, in V."""
        data, _ = self._stamped(aio.DATA_STATE)
        return list(data.voltages)

    def updates(self, timeout: Optional[float] = None) -> Iterator[List[float]]:
        """Reads for ever: one list per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.voltages

    def set(self, output: int, voltage: float) -> None:
        """Sets one output, in V."""
        self._insist_on_finite(voltage=voltage)
        self.command(aio.CMD_STATE, aio.Cmd(output, voltage))


class _Keeping(Device, Generic[Kept]):
    """Base of devices whose data messages are queued until the program takes them."""

    WAITING = 1024  # queue limit; the oldest are dropped

    def prepare(self) -> None:
        self._kept: Deque[Kept] = collections.deque(maxlen=self.WAITING)

    def updates(self, timeout: Optional[float] = None) -> Iterator[Kept]:
        """Reads for ever: each message. Raises RequestTimeout."""
        while True:
            while self._kept:
                yield self._kept.popleft()
            self.next_data(timeout)

    def take(self, message: MessageType, value: Struct, timestamp: float) -> None:
        self._kept.append(self._meaning(value))
        super().take(message, value, timestamp)

    def forget_data(self) -> None:
        self._kept.clear()
        super().forget_data()

    def _meaning(self, value: Struct) -> Kept:
        raise NotImplementedError

    def _take_kept(self) -> List[Kept]:
        taken = list(self._kept)
        self._kept.clear()
        return taken


class Opaque(_Keeping[bytes]):
    """Byte messages: those between robots for a simulated radio, driver-specific for other drivers."""

    def send(self, message: bytes) -> None:
        """Sends to the driver; a radio broadcasts it to all radios in range."""
        self.command(opaque.CMD_DATA, opaque.Data(bytes(message)))

    def send_to(self, address: str, message: bytes) -> None:
        """For a radio: sends to the radio with this network address, "" to broadcast. Returns when the message is queued.
        Raises RequestRefused for an unknown address, a message that is too long, or a full queue."""
        self.request(opaque.REQ_DATA, opaque.Data(c_string(address) + bytes(message)))

    def take_messages(self) -> List[bytes]:
        """Messages of read() since the last call, in order."""
        return self._take_kept()

    def _meaning(self, value: Struct) -> bytes:
        return bytes(cast(opaque.Data, value).data)


class Speech(Device):
    """Speech output of a robot."""

    def say(self, text: str) -> None:
        """Sets the text that the robot says, replacing the previous one; "": none."""
        self.command(speech.CMD_SAY, speech.Cmd(c_string(text)))


class SpeechRecognition(_Keeping[str]):
    """Speech recognition: texts of other models heard by a robot."""

    def take_texts(self) -> List[str]:
        """Messages of read() since the last call, in order."""
        return self._take_kept()

    def _meaning(self, value: Struct) -> str:
        return text(cast(speech_recognition.Data, value).text)


class Localize(Device):
    """Localization of a robot on a map."""

    @property
    def hypotheses(self) -> List[Hypothesis]:
        """Where the robot may be, the most likely first."""
        data, _ = self._stamped(localize.DATA_HYPOTHS)
        return [Hypothesis(_pose(one.mean), Covariance(*one.cov), one.alpha) for one in data.hypoths]

    def updates(self, timeout: Optional[float] = None) -> Iterator[List[Hypothesis]]:
        """Reads for ever: one list per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.hypotheses

    @property
    def pose(self) -> Pose:
        """The pose on the map of the most likely hypothesis. Raises NoData also if there is none."""
        hypotheses = self.hypotheses
        if not hypotheses:
            raise NoData(f"{self._session.peer}: {self.name} has no hypothesis")
        return hypotheses[0].pose

    def set_pose(self, x: float, y: float, a: float, covariance: Covariance) -> None:
        """Sets the estimate of the pose on the map; the robot does not move. Raises RequestRefused if the driver takes none
        of this covariance."""
        self._insist_on_finite(x=x, y=y, a=a, **Covariance(*covariance)._asdict())
        self.request(localize.REQ_SET_POSE, localize.SetPose(common.Pose2d(x, y, a), list(covariance)))

    def particles(self) -> List[Particle]:
        """All particles of the filter; none before its first step."""
        answer = cast(localize.GetParticles, _answer(self.request(localize.REQ_GET_PARTICLES)))
        return [Particle(_pose(one.pose), one.alpha) for one in answer.particles]


class Planner(Device):
    """A planner, which drives a robot to goals on a map. It goes on while any client has it open; wavefront cancels the
    goal when the last one closes it."""

    _goal: Optional[Pose] = None

    @property
    def state(self) -> PlannerState:
        data, time = self._stamped(planner.DATA_STATE)
        return PlannerState(bool(data.valid), bool(data.done), _pose(data.pos), _pose(data.goal), _pose(data.waypoint),
                            data.waypoint_idx, data.waypoints_count, time)

    def updates(self, timeout: Optional[float] = None) -> Iterator[PlannerState]:
        """Reads for ever: one PlannerState per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.state

    @property
    def arrived(self) -> bool:
        """Whether the last data say that the goal of the last go_to() is reached; data of another goal do not count."""
        data = cast(Optional[planner.Data], self.latest(planner.DATA_STATE))
        return data is not None and bool(data.done) and self._goal is not None and _same(_pose(data.goal), self._goal)

    def go_to(self, x: float, y: float, a: float) -> None:
        """Plans a path to a pose on the map and drives there; after stop(), from resume() on."""
        self._insist_on_finite(x=x, y=y, a=a)
        self._goal = Pose(x, y, a)
        self.command(planner.CMD_GOAL, planner.Cmd(common.Pose2d(x, y, a)))

    def why_refused(self) -> str:
        """Requests why the planner does not drive to the goal of the last go_to(), as its log says; empty if it does, has
        arrived, has not planned yet, or is a driver that gives no reasons."""
        return self._why_refused()

    def drive_to(self, x: float, y: float, a: float, timeout: Optional[float] = None) -> PlannerState:
        """go_to(), and reads until the goal is reached. Raises GoalRefused as soon as why_refused() has a reason or the
        planner has another goal, as another client's, and RequestTimeout after `timeout` s without data."""
        self.go_to(x, y, a)
        asked, others = -math.inf, 0
        for state in self.updates(timeout):
            if self.arrived:
                break
            is_mine = self._goal is not None and _same(state.goal, self._goal)
            # Once a request was answered, which came after the goal, data of before it may still be on their way.
            others = 0 if is_mine or asked == -math.inf else others + 1
            if others > _STATES_UNDER_WAY:
                raise GoalRefused(f"{self._session.peer}: {self.name}: it has another goal, or no longer one")
            if state.valid and is_mine and asked <= state.time < asked + _REFUSAL_PERIOD:
                continue
            asked = state.time
            why = self.why_refused()
            if why:
                raise GoalRefused(f"{self._session.peer}: {self.name}: {why}")
        return state

    def stop(self) -> None:
        """Stops the robot until resume(); the planner keeps its goal."""
        self.request(planner.REQ_ENABLE, planner.EnableReq(0))

    def resume(self) -> None:
        """Ends stop()."""
        self.request(planner.REQ_ENABLE, planner.EnableReq(1))

    def path(self) -> Path:
        """The path as it was planned last; without waypoints if there is none."""
        answer = cast(planner.WaypointsReq, _answer(self.request(planner.REQ_GET_WAYPOINTS)))
        return Path([_pose(one) for one in answer.waypoints], answer.waypoints_distance)


class Map(Device):
    """A grid map."""

    def grid(self) -> Grid:
        """Size and place of the map, without its cells. Raises WireError if the numbers are those of no map."""
        info = cast(grid_map.Info, _answer(self.request(grid_map.REQ_GET_INFO)))
        made = Grid(info.scale, info.width, info.height, _pose(info.origin))
        if not (made.cell_size > 0.0 and all(map(math.isfinite, (made.cell_size, *made.origin)))):
            raise WireError(f"{self.name}: invalid map: cells of {made.cell_size} m from {tuple(made.origin)} on")
        return made

    def cells(self) -> List[Sequence[int]]:
        """The whole map, row by row from the bottom: cells()[row][column] is 1 if the cell is occupied, -1 if it is free, 0 if
        that is unknown. Raises WireError for a map of more than 2^26 cells, and for faulty answers."""
        grid = self.grid()
        if grid.width * grid.height > _MOST_CELLS:
            raise WireError(f"{self.name}: {grid.width} x {grid.height} cells are over the limit of {_MOST_CELLS}")
        rows: List[Sequence[int]] = []
        for row in range(0, grid.height if grid.width > 0 else 0, _TILE):
            rows += self._band(row, grid.width, min(_TILE, grid.height - row))
        return rows

    def _band(self, row: int, width: int, height: int) -> "List[array[int]]":
        """All cells of the rows from `row` on, as high as a tile."""
        rows = [array("b") for _ in range(height)]
        for column in range(0, width, _TILE):
            part = min(_TILE, width - column)
            cells = self._tile(column, row, part, height)
            for i in range(height):
                rows[i].extend(cells[i * part : (i + 1) * part])
        return rows

    def _tile(self, column: int, row: int, width: int, height: int) -> "array[int]":
        asked = grid_map.Data(column, row, width, height)
        tile = cast(grid_map.Data, _answer(self.request(grid_map.REQ_GET_DATA, asked)))
        values = _uncompressed(tile.data, width * height)
        if len(values) != width * height:
            raise WireError(f"{self.name}: a tile of {width} x {height} cells is damaged")
        return array("b", values.translate(_occupancies(tile.data_range)))


class Simulation(Device):
    """The simulator itself. Poses of models, by name, are relative to the parent, or to the world for a top-level model."""

    def pose(self, name: str) -> Pose:
        """Raises RequestRefused if there is no model of that name."""
        request = simulation.Pose2dReq(name=c_string(name))
        answer = cast(simulation.Pose2dReq, self._of_model(name, simulation.REQ_GET_POSE2D, request))
        return _pose(answer.pose)

    def set_pose(self, name: str, x: float, y: float, a: float) -> None:
        self._insist_on_finite(x=x, y=y, a=a)
        request = simulation.Pose2dReq(c_string(name), common.Pose2d(x, y, a))
        self._of_model(name, simulation.REQ_SET_POSE2D, request)

    def pose3d(self, name: str) -> Pose3d:
        request = simulation.Pose3dReq(name=c_string(name))
        answer = cast(simulation.Pose3dReq, self._of_model(name, simulation.REQ_GET_POSE3D, request))
        return _pose3d(answer.pose)

    def set_pose3d(self, name: str, pose: Pose3d) -> None:
        self._insist_on_finite(**Pose3d(*pose)._asdict())
        request = simulation.Pose3dReq(c_string(name), common.Pose3d(*pose))
        self._of_model(name, simulation.REQ_SET_POSE3D, request)

    def pause(self) -> None:
        """Pauses or resumes the clock."""
        self.command(simulation.CMD_PAUSE)

    def save(self) -> None:
        """Saves the current world to the file of `playhouse run --save-world`; without that option it has no
        effect."""
        self.command(simulation.CMD_SAVE)

    def reset(self, seed: Optional[int] = None) -> None:
        """Moves everything back to its pose in the world file, while time continues. With a seed the run restarts with
        that seed: at tick 0, with the initial models and their ids, and devices have no data until new ones arrive. That
        requires lock-step, else the server refuses: RequestRefused."""
        if seed is None:
            self.command(simulation.CMD_RESET)
            return
        self._insist_on_whole("seed", seed, 0, (1 << 64) - 1)
        self._of_world("reset", struct.pack("<Q", seed))
        self._client.forget_run()

    def join(self, name: str) -> None:
        """Joins a lock-step run as a member of this name until the connection is closed: ticks wait for its steps.
        Open devices first. Raises RequestRefused with the reason."""
        self._of_world("join", c_string(name))

    def step(self, ticks: int = 1, timeout: Optional[float] = None) -> None:
        """Runs this number of ticks and waits until they are done, in lock-step until all members have requested them:
        at most `timeout` seconds, None: no limit. In push mode all data of the ticks have then been delivered to the
        devices; in pull mode they are queued for read(). Without lock-step a running world refuses: pause() first."""
        self._insist_on_whole("ticks", ticks, 1, 1 << 20)
        self._of_world("step", struct.pack("<I", ticks), timeout=math.inf if timeout is None else timeout)
        self._client.deliver_pushed()

    def spawn(self, like: str, x: float, y: float, a: float, name: str = "") -> str:
        """Spawns a robot like the model `like` at a pose in the world (m, m, rad); returns its name."""
        self._insist_on_finite(x=x, y=y, a=a)
        value = struct.pack("<ddd", x, y, a) + (c_string(name) if name else b"")
        return text(self._of_world("spawn", value, like).value)

    def remove(self, name: str) -> None:
        """Removes a top-level model from the world, with its descendants."""
        self._of_world("remove", b"", name)

    def _of_world(
        self, prop: str, value: bytes, name: str = "", timeout: Optional[float] = None
    ) -> simulation.PropertyReq:
        request = simulation.PropertyReq(c_string(name), c_string(prop), 0, value)
        try:
            return cast(simulation.PropertyReq, self.request(simulation.REQ_SET_PROPERTY, request, timeout) or request)
        except RequestRefused as error:
            why = text(simulation.PropertyReq.decode(error.body).value) if error.body else "the server does not do that"
            if why == _ENDED:
                raise RunEnded(f"{self._session.peer}: {why}") from None
            raise RequestRefused(f"{self._session.peer}: {prop} was refused: {why}") from None

    def _of_model(self, name: str, message: MessageType, request: Struct) -> Optional[Struct]:
        try:
            return self.request(message, request)
        except RequestRefused:
            raise RequestRefused(f'{self._session.peer}: {message.name} of model "{name}" was refused') from None


def _answer(value):  # type: ignore[no-untyped-def]
    if value is None:
        raise WireError("an answer came without its contents")
    return value


def _pose(pose: common.Pose2d) -> Pose:
    return Pose(pose.px, pose.py, pose.pa)


def _pose3d(pose: common.Pose3d) -> Pose3d:
    return Pose3d(pose.px, pose.py, pose.pz, pose.proll, pose.ppitch, pose.pyaw)


def _geometry(geom) -> Geometry:  # type: ignore[no-untyped-def]
    return Geometry(_pose3d(geom.pose), Size(geom.size.sl, geom.size.sw, geom.size.sh))


def _same(one: Pose, other: Pose) -> bool:
    """Whether two poses are the same, whole turns aside, which drivers drop."""
    return one[:2] == other[:2] and abs(math.remainder(one.a - other.a, math.tau)) < 1e-6


def _uncompressed(data: bytes, count: int) -> bytes:
    """At most one byte more than `count`; the data themselves if they are not a zlib stream, as of a server without it."""
    try:
        return zlib.decompressobj().decompress(data, count + 1)
    except zlib.error:
        return data


def _occupancies(data_range: int) -> bytes:
    """For each byte of a map what it says as an int8: 1 and -1 beyond half of `data_range`, else 0."""
    twice = [2 * (byte - 256 if byte > 127 else byte) for byte in range(256)]
    limit = max(data_range, 1)
    return array("b", [(each > limit) - (each < -limit) for each in twice]).tobytes()


def _spread(low: float, high: float, count: int) -> List[float]:
    """`count` angles from low to high."""
    step = (high - low) / (count - 1) if count > 1 else 0.0
    return [low + i * step for i in range(count)]
