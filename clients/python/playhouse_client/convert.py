"""Values of the wire to those of the proxies, and back."""

from typing import List, Sequence, Tuple

from .generated import common, wifi
from .values import Charging, Pose, Pose3d, Rgb, Size, Velocity


def pose_of(pose: common.Pose2d) -> Pose:
    return Pose(pose.px, pose.py, pose.pa)


def velocity_of(velocity: common.Pose2d) -> Velocity:
    return Velocity(velocity.px, velocity.py, velocity.pa)


def pose3d_of(pose: common.Pose3d) -> Pose3d:
    return Pose3d(pose.px, pose.py, pose.pz, pose.proll, pose.ppitch, pose.pyaw)


def size_of(box: common.Bbox3d) -> Size:
    return Size(box.sl, box.sw, box.sh)


def vector_of(point: common.Point3d) -> Tuple[float, float, float]:
    return point.px, point.py, point.pz


def attitude_of(orientation: common.Orientation3d) -> Tuple[float, float, float]:
    return orientation.proll, orientation.ppitch, orientation.pyaw


def rgb_of(color: common.Color) -> Rgb:
    return color.red, color.green, color.blue


def rgba_of(color: common.Color) -> Tuple[int, int, int, int]:
    return color.red, color.green, color.blue, color.alpha


def color_of(rgb: Rgb) -> common.Color:
    red, green, blue = rgb
    return common.Color(255, red, green, blue)


def packed_rgb(color: int) -> Rgb:
    """Of 0xRRGGBB."""
    return color >> 16 & 255, color >> 8 & 255, color & 255


def charging(state: int) -> Charging:
    return Charging(max(-1, min(state, 1)))


def level(value: int, unit: int) -> int:
    """Levels in dBm are signed, all others are not."""
    return value if unit == wifi.QUAL_DBM else value % (1 << 32)


def directions(
    low: float, high: float, ranges: Sequence[float], elements: Sequence[common.Pose3d] = ()
) -> List[float]:
    """Of a range each: those of the elements if there is one per range, else spread from `low` to `high`."""
    count = len(ranges)
    if len(elements) == count and count > 1:
        return [element.pyaw for element in elements]
    step = (high - low) / (count - 1) if count > 1 else 0.0
    return [low + i * step for i in range(count)]
