"""A robot by its name in the world file, with its devices and those of its descendants."""

from typing import TYPE_CHECKING, Dict, List, cast

from .device import Device, code_of
from .equipment import ActArray, BlinkenLight, Blobfinder, Gripper, Power, Wifi
from .errors import RequestRefused
from .models import DeviceAddress, Model
from .proxies import Aio, Bumper, Camera, Fiducial, Gps, Imu, Laser, Localize, Map, Opaque, Planner, PointCloud3d, Position2d, Position3d, Ptz, Ranger, Sonar, Speech, SpeechRecognition

if TYPE_CHECKING:
    from .client import Client


class Robot:
    """A model and its descendants, returned by Client.robot() and Client.robots().

    `name` and `type` are those of the world file; `models` are the model itself and its descendants,
    `devices` the addresses of all their devices. `position2d`, `laser`, `ranger`, `sonar`, `fiducial`,
    `bumper`, `camera`, `ptz`, `opaque`, `aio`, `position3d`, `imu`, `gps`, `pointcloud3d`, `speech`,
    `speech_recognition`, `localize`, `planner`, `map`, `gripper`, `power`, `blobfinder`, `wifi`, `actarray`
    and `blinkenlight` are the first of their interface, `lasers` and so on all of them, opened on first use.
    The end of a `with` block, or close(), closes devices opened here; a moving robot is stopped first.
    """

    def __init__(self, client: "Client", models: List[Model], port: int) -> None:
        self.name = models[0].name
        self.type = models[0].type
        self.models = models
        self.devices = [address for model in models for address in model.devices]
        self._client = client
        self._port = port  # of the connected server, as reported by the server
        self._opened: Dict[DeviceAddress, Device] = {}

    def __repr__(self) -> str:
        return f"<Robot {self.name!r}: {_names(self.devices)}>"

    def device(self, interface: str, nth: int = 0) -> Device:
        """The robot's device of an interface at index `nth`, from 0."""
        code_of(interface)  # raises InvalidValue for an unknown one
        here = self._reachable(interface)
        if not 0 <= nth < len(here):
            number = f" number {nth}" if nth else ""
            raise RequestRefused(f'robot "{self.name}" has no {interface}{number} {self._elsewhere(interface)}')
        return self._open(here[nth])

    @property
    def position2d(self) -> Position2d:
        return cast(Position2d, self.device("position2d"))

    @property
    def laser(self) -> Laser:
        return cast(Laser, self.device("laser"))

    @property
    def ranger(self) -> Ranger:
        return cast(Ranger, self.device("ranger"))

    @property
    def sonar(self) -> Sonar:
        return cast(Sonar, self.device("sonar"))

    @property
    def fiducial(self) -> Fiducial:
        return cast(Fiducial, self.device("fiducial"))

    @property
    def bumper(self) -> Bumper:
        return cast(Bumper, self.device("bumper"))

    @property
    def camera(self) -> Camera:
        return cast(Camera, self.device("camera"))

    @property
    def ptz(self) -> Ptz:
        return cast(Ptz, self.device("ptz"))

    @property
    def opaque(self) -> Opaque:
        return cast(Opaque, self.device("opaque"))

    @property
    def aio(self) -> Aio:
        return cast(Aio, self.device("aio"))

    @property
    def position3d(self) -> Position3d:
        return cast(Position3d, self.device("position3d"))

    @property
    def imu(self) -> Imu:
        return cast(Imu, self.device("imu"))

    @property
    def gps(self) -> Gps:
        return cast(Gps, self.device("gps"))

    @property
    def pointcloud3d(self) -> PointCloud3d:
        return cast(PointCloud3d, self.device("pointcloud3d"))

    @property
    def speech(self) -> Speech:
        return cast(Speech, self.device("speech"))

    @property
    def speech_recognition(self) -> SpeechRecognition:
        return cast(SpeechRecognition, self.device("speech_recognition"))

    @property
    def localize(self) -> Localize:
        return cast(Localize, self.device("localize"))

    @property
    def planner(self) -> Planner:
        return cast(Planner, self.device("planner"))

    @property
    def map(self) -> Map:
        return cast(Map, self.device("map"))

    @property
    def gripper(self) -> Gripper:
        return cast(Gripper, self.device("gripper"))

    @property
    def power(self) -> Power:
        return cast(Power, self.device("power"))

    @property
    def blobfinder(self) -> Blobfinder:
        return cast(Blobfinder, self.device("blobfinder"))

    @property
    def wifi(self) -> Wifi:
        return cast(Wifi, self.device("wifi"))

    @property
    def actarray(self) -> ActArray:
        return cast(ActArray, self.device("actarray"))

    @property
    def blinkenlight(self) -> BlinkenLight:
        return cast(BlinkenLight, self.device("blinkenlight"))

    @property
    def position2ds(self) -> List[Position2d]:
        return cast(List[Position2d], self._all("position2d"))

    @property
    def lasers(self) -> List[Laser]:
        return cast(List[Laser], self._all("laser"))

    @property
    def rangers(self) -> List[Ranger]:
        return cast(List[Ranger], self._all("ranger"))

    @property
    def sonars(self) -> List[Sonar]:
        return cast(List[Sonar], self._all("sonar"))

    @property
    def fiducials(self) -> List[Fiducial]:
        return cast(List[Fiducial], self._all("fiducial"))

    @property
    def bumpers(self) -> List[Bumper]:
        return cast(List[Bumper], self._all("bumper"))

    @property
    def cameras(self) -> List[Camera]:
        return cast(List[Camera], self._all("camera"))

    @property
    def ptzs(self) -> List[Ptz]:
        return cast(List[Ptz], self._all("ptz"))

    @property
    def opaques(self) -> List[Opaque]:
        return cast(List[Opaque], self._all("opaque"))

    @property
    def aios(self) -> List[Aio]:
        return cast(List[Aio], self._all("aio"))

    @property
    def position3ds(self) -> List[Position3d]:
        return cast(List[Position3d], self._all("position3d"))

    @property
    def imus(self) -> List[Imu]:
        return cast(List[Imu], self._all("imu"))

    @property
    def gpses(self) -> List[Gps]:
        return cast(List[Gps], self._all("gps"))

    @property
    def pointcloud3ds(self) -> List[PointCloud3d]:
        return cast(List[PointCloud3d], self._all("pointcloud3d"))

    @property
    def speeches(self) -> List[Speech]:
        return cast(List[Speech], self._all("speech"))

    @property
    def speech_recognitions(self) -> List[SpeechRecognition]:
        return cast(List[SpeechRecognition], self._all("speech_recognition"))

    @property
    def localizes(self) -> List[Localize]:
        return cast(List[Localize], self._all("localize"))

    @property
    def planners(self) -> List[Planner]:
        return cast(List[Planner], self._all("planner"))

    @property
    def maps(self) -> List[Map]:
        return cast(List[Map], self._all("map"))

    @property
    def grippers(self) -> List[Gripper]:
        return cast(List[Gripper], self._all("gripper"))

    @property
    def powers(self) -> List[Power]:
        return cast(List[Power], self._all("power"))

    @property
    def blobfinders(self) -> List[Blobfinder]:
        return cast(List[Blobfinder], self._all("blobfinder"))

    @property
    def wifis(self) -> List[Wifi]:
        return cast(List[Wifi], self._all("wifi"))

    @property
    def actarrays(self) -> List[ActArray]:
        return cast(List[ActArray], self._all("actarray"))

    @property
    def blinkenlights(self) -> List[BlinkenLight]:
        return cast(List[BlinkenLight], self._all("blinkenlight"))

    def close(self) -> None:
        """Closes devices opened here, in reverse order of opening. They reopen on use."""
        while self._opened:
            self._opened.popitem()[1].close()

    def __enter__(self) -> "Robot":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _all(self, interface: str) -> List[Device]:
        return [self._open(address) for address in self._reachable(interface)]

    def _reachable(self, interface: str) -> List[DeviceAddress]:
        """A connection reaches the devices of its own port only."""
        return [at for at in self.devices if at.interface == interface and at.port == self._port]

    def _elsewhere(self, interface: str) -> str:
        """Text: other ports with devices of this interface, or else the existing devices."""
        others = [
            f"{at.name} at port {at.port}"
            for at in self.devices
            if at.interface == interface and at.port != self._port
        ]
        if others:
            return f"at port {self._port}, but {', '.join(others)}: connect there"
        return f"(it has {_names(self.devices) or 'no devices'})"

    def _open(self, address: DeviceAddress) -> Device:
        device = self._opened.get(address)
        if device is None or not device.is_open:
            device = self._opened[address] = self._client.device(address.interface, address.index)
        return device


def _names(devices: List[DeviceAddress]) -> str:
    return ", ".join(address.name for address in devices)
