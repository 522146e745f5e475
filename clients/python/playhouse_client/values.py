"""Values of the proxies that are written by hand. SI units and radians; x forward, y left, z up, angles
counter-clockwise."""

import enum
import math
import struct
from typing import List, NamedTuple, Optional, Tuple

from .errors import InvalidValue
from .generated import camera

Rgb = Tuple[int, int, int]  # red, green, blue, from 0 to 255


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


class Charging(enum.IntEnum):
    """Whether a battery is being charged."""

    IMPOSSIBLE = -1
    NO = 0
    YES = 1


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
