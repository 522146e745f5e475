"""Proxies of equipment: batteries, grippers, joints, lamps, blobfinders and radios. Units and reading are
those of proxies.py.
"""

import enum
from typing import Iterator, List, NamedTuple, Optional, Sequence, Tuple, cast

from .device import Device
from .generated import actarray, blinkenlight, blobfinder, common, gripper, power, wifi
from .proxies import Pose3d, Size, _answer, _pose3d
from .wire import text

Rgb = Tuple[int, int, int]  # red, green, blue, from 0 to 255

_STATES = (actarray.ACTSTATE_MOVING, actarray.ACTSTATE_BRAKED, actarray.ACTSTATE_STALLED)


class Charging(enum.IntEnum):
    """Whether a battery is being charged."""

    IMPOSSIBLE = -1
    NO = 0
    YES = 1


class PowerState(NamedTuple):
    """The data of a battery: voltage (V), charge in percent of a full one and in J, and power drawn (W,
    negative while charging). What the server does not report is None. `time` is the server's, in s."""

    volts: Optional[float]
    percent: Optional[float]
    joules: Optional[float]
    watts: Optional[float]
    charging: Optional[Charging]
    time: float


class GripperState(NamedTuple):
    """The data of a gripper: whether its fingers are open, closed (as far as possible, perhaps around an
    object) or moving; none of the three if they are faulty, or stopped in between. `beams` has a bit for each
    break beam, set if it is interrupted: for a simulated gripper 4 is the inner, 8 the outer one. `time` is
    the server's, in s."""

    open: bool
    closed: bool
    moving: bool
    beams: int
    time: float


class GripperGeometry(NamedTuple):
    """Pose of a gripper on its robot, its size, size of the gap between the open fingers, and number of break
    beams."""

    pose: Pose3d
    size: Size
    gap: Size
    beam_count: int


class Joint(NamedTuple):
    """The state of a joint: position, speed and acceleration, in m or rad and s; current of its motor in A,
    None if unknown. One that neither moves nor is braked or stalled is idle."""

    position: float
    speed: float
    acceleration: float
    current: Optional[float]
    moving: bool
    braked: bool
    stalled: bool


class ActArrayState(NamedTuple):
    """The data of a chain of joints: their states, and whether the motors are on. `time` is the server's, in
    s."""

    joints: List[Joint]
    motors_on: bool
    time: float


class JointGeometry(NamedTuple):
    """A joint: whether it turns (else it slides); length to the next one in m; orientation at rest relative
    to the previous one (roll, pitch, yaw); axis, a unit vector; lowest, centre, highest and home position in
    m or rad; speed in position control; whether it has brakes."""

    rotary: bool
    length: float
    orientation: Tuple[float, float, float]
    axis: Tuple[float, float, float]
    lowest: float
    centre: float
    highest: float
    home: float
    speed: float
    has_brakes: bool


class ActArrayGeometry(NamedTuple):
    """Pose of the base of a chain of joints on its robot, and the joints."""

    pose: Pose3d
    joints: List[JointGeometry]


class LightState(NamedTuple):
    """The data of a light: whether it is switched on, also between two flashes; period of its flashes in s, 0
    for steady light; fraction of the period in which it is lit; its color. `time` is the server's, in s."""

    on: bool
    period: float
    duty_cycle: float
    color: Rgb
    time: float


class Blob(NamedTuple):
    """A region of one color in an image: the channel that detected it, its color for display, its area in
    pixels; in pixels from the top left corner of the image its centre (x, y), first and last column, first
    and last row; its distance in m, 0 if unknown."""

    channel: int
    color: Rgb
    area: int
    x: int
    y: int
    left: int
    right: int
    top: int
    bottom: int
    range: float


class ImageSize(NamedTuple):
    """Of an image, in pixels."""

    width: int
    height: int


class Link(NamedTuple):
    """A link to another radio: its hardware and network address, the name of its network, its role (one of
    wifi.MODE_AUTO, wifi.MODE_ADHOC and so on), its frequency in MHz; quality of the link, up to
    WifiState.max_quality; level of signal and noise in the unit WifiState.unit, signed in dBm."""

    mac: str
    ip: str
    essid: str
    mode: int
    frequency: int
    encrypted: bool
    quality: int
    level: int
    noise: int


class WifiState(NamedTuple):
    """The data of a radio: its links, estimated throughput and configured bit rate in bit/s, role as for
    links; unit of levels (one of wifi.QUAL_DBM, QUAL_REL and QUAL_UNKNOWN) and the maximum of quality, level
    and noise; hardware address of the access point. `time` is the server's, in s."""

    links: List[Link]
    throughput: int
    bitrate: int
    mode: int
    unit: int
    max_quality: int
    max_level: int
    max_noise: int
    access_point: str
    time: float


class Power(Device):
    """A battery."""

    @property
    def state(self) -> PowerState:
        data, time = self._stamped(power.DATA_STATE)
        valid = data.valid
        return PowerState(
            data.volts if valid & power.MASK_VOLTS else None,
            data.percent if valid & power.MASK_PERCENT else None,
            data.joules if valid & power.MASK_JOULES else None,
            data.watts if valid & power.MASK_WATTS else None,
            Charging(max(-1, min(data.charging, 1))) if valid & power.MASK_CHARGING else None,
            time,
        )

    def updates(self, timeout: Optional[float] = None) -> Iterator[PowerState]:
        """Reads for ever: one PowerState per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.state

    def set_charging_policy(self, takes: bool, gives: bool) -> None:
        """Whether the battery may be charged, and whether it may supply others."""
        self.request(power.REQ_SET_CHARGING_POLICY, power.ChargepolicyConfig(int(takes), int(gives)))


class Gripper(Device):
    """A gripper with two fingers. A simulated one holds what is between them when they close, and moves while
    its device is open."""

    @property
    def state(self) -> GripperState:
        data, time = self._stamped(gripper.DATA_STATE)
        what = data.state
        return GripperState(what == gripper.STATE_OPEN, what == gripper.STATE_CLOSED,
                            what == gripper.STATE_MOVING, data.beams, time)

    def updates(self, timeout: Optional[float] = None) -> Iterator[GripperState]:
        """Reads for ever: one GripperState per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.state

    def open_fingers(self) -> None:
        self.command(gripper.CMD_OPEN)

    def close_fingers(self) -> None:
        """Grips; close() closes the device."""
        self.command(gripper.CMD_CLOSE)

    def stop(self) -> None:
        """Stops the fingers where they are."""
        self.command(gripper.CMD_STOP)

    def geometry(self) -> GripperGeometry:
        geom = cast(gripper.Geom, _answer(self.request(gripper.REQ_GET_GEOM)))
        size, gap = _size(geom.outer_size), _size(geom.inner_size)
        return GripperGeometry(_pose3d(geom.pose), size, gap, geom.num_beams)


class ActArray(Device):
    """A chain of joints that slide or turn, such as an arm; a simulated actuator is a chain of one joint,
    which moves while its device is open. Joints are numbered from 0."""

    ALL = -1  # all joints, for home() and set_speed()

    @property
    def state(self) -> ActArrayState:
        data, time = self._stamped(actarray.DATA_STATE)
        return ActArrayState([_joint(one) for one in data.actuators], bool(data.motor_state), time)

    @property
    def joints(self) -> List[Joint]:
        """ActArrayState.joints."""
        return self.state.joints

    def updates(self, timeout: Optional[float] = None) -> Iterator[ActArrayState]:
        """Reads for ever: one ActArrayState per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.state

    def move_to(self, joint: int, position: float) -> None:
        """Moves a joint to a position, in m or rad."""
        self._insist_on_joint(joint, 0)
        self._insist_on_finite(position=position)
        self.command(actarray.CMD_POS, actarray.PositionCmd(joint, position))

    def move_all_to(self, positions: Sequence[float]) -> None:
        """Moves all joints, to one position each."""
        for position in positions:
            self._insist_on_finite(position=position)
        self.command(actarray.CMD_MULTI_POS, actarray.MultiPositionCmd(list(positions)))

    def move_at(self, joint: int, speed: float) -> None:
        """Moves a joint at a speed, in m/s or rad/s, until the next command."""
        self._insist_on_joint(joint, 0)
        self._insist_on_finite(speed=speed)
        self.command(actarray.CMD_SPEED, actarray.SpeedCmd(joint, speed))

    def move_all_at(self, speeds: Sequence[float]) -> None:
        """Moves all joints, at one speed each."""
        for speed in speeds:
            self._insist_on_finite(speed=speed)
        self.command(actarray.CMD_MULTI_SPEED, actarray.MultiSpeedCmd(list(speeds)))

    def home(self, joint: int = ALL) -> None:
        """Moves a joint, or all, to the home position."""
        self._insist_on_joint(joint, self.ALL)
        self.command(actarray.CMD_HOME, actarray.HomeCmd(joint))

    def set_speed(self, joint: int, speed: float) -> None:
        """Sets the speed of a joint, or of ALL, in position control."""
        self._insist_on_joint(joint, self.ALL)
        self._insist_on_finite(speed=speed)
        self.request(actarray.REQ_SPEED, actarray.SpeedConfig(joint, speed))

    def set_motor_power(self, on: bool) -> None:
        self.request(actarray.REQ_POWER, actarray.PowerConfig(int(on)))

    def set_brakes(self, on: bool) -> None:
        self.request(actarray.REQ_BRAKES, actarray.BrakesConfig(int(on)))

    def geometry(self) -> ActArrayGeometry:
        geom = cast(actarray.Geom, _answer(self.request(actarray.REQ_GET_GEOM)))
        pose = Pose3d(*_xyz(geom.base_pos), *_turns(geom.base_orientation))
        return ActArrayGeometry(pose, [_joint_geometry(one) for one in geom.actuators])

    def _insist_on_joint(self, joint: int, least: int) -> None:
        self._insist_on_whole("joint", joint, least, (1 << 31) - 1)


class BlinkenLight(Device):
    """A lamp that can flash, or several; a simulated device has one, of number 0. Data are of one lamp."""

    @property
    def state(self) -> LightState:
        data, time = self._stamped(blinkenlight.DATA_STATE)
        color = (data.color.red, data.color.green, data.color.blue)
        return LightState(bool(data.enable), data.period, data.dutycycle, color, time)

    def updates(self, timeout: Optional[float] = None) -> Iterator[LightState]:
        """Reads for ever: one LightState per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.state

    def set(self, on: bool, period: float, duty_cycle: float, color: Rgb, light: int = 0) -> None:
        """Sets all of a lamp: set_power(), flash() and set_color() at once."""
        self._insist_on_finite(period=period, duty_cycle=duty_cycle)
        command = blinkenlight.Cmd(light, int(on), period, duty_cycle, _color(color))
        self.command(blinkenlight.CMD_STATE, command)

    def set_power(self, on: bool, light: int = 0) -> None:
        """Switches a lamp on or off."""
        self.command(blinkenlight.CMD_POWER, blinkenlight.CmdPower(light, int(on)))

    def set_color(self, color: Rgb, light: int = 0) -> None:
        """Colors a lamp: red, green, blue from 0 to 255."""
        self.command(blinkenlight.CMD_COLOR, blinkenlight.CmdColor(light, _color(color)))

    def flash(self, period: float, duty_cycle: float = 0.5, light: int = 0) -> None:
        """Lets a lamp that is on flash: a period in s, of which it is lit for this fraction, from 0 to 1; a
        period of 0 is steady light."""
        self._insist_on_finite(period=period, duty_cycle=duty_cycle)
        self.command(blinkenlight.CMD_FLASH, blinkenlight.CmdFlash(light, period, duty_cycle))


class Blobfinder(Device):
    """A camera that finds regions of one color."""

    @property
    def blobs(self) -> List[Blob]:
        """Blobs in the newest image."""
        data, _ = self._stamped(blobfinder.DATA_BLOBS)
        return [_blob(one) for one in data.blobs]

    @property
    def image_size(self) -> ImageSize:
        """Of the newest image."""
        data, _ = self._stamped(blobfinder.DATA_BLOBS)
        return ImageSize(data.width, data.height)

    def updates(self, timeout: Optional[float] = None) -> Iterator[List[Blob]]:
        """Reads for ever: one list per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.blobs


class Wifi(Device):
    """A radio, as what it receives. Messages between simulated radios are those of Opaque."""

    @property
    def state(self) -> WifiState:
        data, time = self._stamped(wifi.DATA_STATE)
        unit = data.qual_type
        links = [_link(one, unit) for one in data.links]
        return WifiState(links, data.throughput, data.bitrate, data.mode, unit, data.maxqual,
                         _level(data.maxlevel, unit), _level(data.maxnoise, unit), text(data.ap), time)

    @property
    def links(self) -> List[Link]:
        """WifiState.links."""
        return self.state.links

    def updates(self, timeout: Optional[float] = None) -> Iterator[WifiState]:
        """Reads for ever: one WifiState per new data message. Raises RequestTimeout."""
        while True:
            self.next_data(timeout)
            yield self.state

    def mac(self) -> str:
        """The radio's own hardware address."""
        return text(cast(wifi.MacReq, _answer(self.request(wifi.REQ_MAC))).mac)


def _size(box: common.Bbox3d) -> Size:
    return Size(box.sl, box.sw, box.sh)


def _xyz(point: common.Point3d) -> Tuple[float, float, float]:
    return point.px, point.py, point.pz


def _turns(orientation: common.Orientation3d) -> Tuple[float, float, float]:
    return orientation.proll, orientation.ppitch, orientation.pyaw


def _color(color: Rgb) -> common.Color:
    red, green, blue = color
    return common.Color(255, red, green, blue)


def _joint(one: actarray.Actuator) -> Joint:
    current = None if one.current == -1.0 else one.current
    moving, braked, stalled = (bool(one.state & bit) for bit in _STATES)
    return Joint(one.position, one.speed, one.acceleration, current, moving, braked, stalled)


def _joint_geometry(one: actarray.Actuatorgeom) -> JointGeometry:
    rotary = one.type == actarray.TYPE_ROTARY
    return JointGeometry(rotary, one.length, _turns(one.orientation), _xyz(one.axis), one.min, one.centre,
                         one.max, one.home, one.config_speed, bool(one.hasbrakes))


def _blob(one: blobfinder.Blob) -> Blob:
    color = (one.color >> 16 & 255, one.color >> 8 & 255, one.color & 255)
    return Blob(one.id, color, one.area, one.x, one.y, one.left, one.right, one.top, one.bottom, one.range)


def _link(one: wifi.Link, unit: int) -> Link:
    return Link(text(one.mac), text(one.ip), text(one.essid), one.mode, one.freq, one.encrypt != 0, one.qual,
                _level(one.level, unit), _level(one.noise, unit))


def _level(value: int, unit: int) -> int:
    """Levels in dBm are signed, all others are not."""
    return value if unit == wifi.QUAL_DBM else value % (1 << 32)
