"""A robot by its name in the world file, with its devices and those of its descendants."""

from typing import TYPE_CHECKING, Dict, List

from .device import Device, code_of
from .errors import RequestRefused
from .generated.proxies import Devices
from .models import DeviceAddress, Model

if TYPE_CHECKING:
    from .client import Client


class Robot(Devices):
    """A model and its descendants, returned by Client.robot() and Client.robots().

    `name` and `type` are those of the world file; `models` are the model itself and its descendants,
    `devices` the addresses of all their devices. `position2d`, `laser` and so on are the first of their
    interface, `position2ds`, `lasers` and so on all of them, opened on first use.
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
