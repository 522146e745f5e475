"""A program's connection to a Player server, and what it can ask of the server itself."""

import enum
import time
from typing import Dict, List, NamedTuple, Optional, Tuple, Type, TypeVar

from .connection import Connection
from .device import Access, Device
from .errors import ConnectionLost, PlayerError, RequestRefused, RequestTimeout, WireError
from .generated import INTERFACES, common, find_message, player
from .proxies import Fiducial, Laser, Position2d, Ranger, Simulation, Sonar
from .session import Session
from .wire import Kind, text

DEFAULT_HOST = "127.0.0.1"  # not localhost, which a machine without /etc/hosts cannot resolve
DEFAULT_PORT = 6665
_GOODBYE_SECONDS = 1.0

P = TypeVar("P", bound=Device)


class Mode(enum.IntEnum):
    """When the server sends data: at once, or in rounds that the client asks for."""

    PUSH = player.DATAMODE_PUSH
    PULL = player.DATAMODE_PULL


class Rule(enum.IntEnum):
    """What happens to a message for this client when one like it is still waiting."""

    ACCEPT = player.MSG_REPLACE_RULE_ACCEPT
    REPLACE = player.MSG_REPLACE_RULE_REPLACE
    IGNORE = player.MSG_REPLACE_RULE_IGNORE


class DeviceEntry(NamedTuple):
    """One line of the server's device list. `interface` is a name, or a number where no name is known."""

    interface: str
    index: int
    driver: str

    @property
    def name(self) -> str:
        return f"{self.interface}:{self.index}"


class Client:
    """One connection; one thread. Use it in a `with` block: leaving it closes the devices and says goodbye.

    `timeout` in seconds is the patience of every request and every read() unless told otherwise.
    """

    def __init__(
        self,
        host: str = DEFAULT_HOST,
        port: int = DEFAULT_PORT,
        *,
        mode: Mode = Mode.PULL,
        timeout: float = 5.0,
    ) -> None:
        self._session = Session(Connection(host, port, timeout), timeout)
        self._devices: Dict[Tuple[int, int], List[Device]] = {}
        self._reading = False
        self.mode = Mode.PUSH  # what a server starts with
        if mode != Mode.PUSH:
            self.set_mode(mode)

    @property
    def banner(self) -> str:
        """What the server said first, "Player v.3.1" for instance."""
        return self._session.connection.banner

    @property
    def connected(self) -> bool:
        return self._session.connection.alive

    @property
    def overflow_count(self) -> int:
        """Data messages that were lost because they were not read in time, here or in the server."""
        return self._session.overflow_count

    @property
    def skipped_count(self) -> int:
        """Messages that nobody waited for or that made no sense."""
        return self._session.skipped_count

    def devices(self) -> List[DeviceEntry]:
        """What the server offers, in its own order, with the driver behind each device."""
        answer = self._session.request(player.CODE, 0, player.REQ_DEVLIST)
        listed = player.DeviceDevlist.decode(answer.body).devices
        return [self._describe(addr) for addr in listed]

    def set_mode(self, mode: Mode) -> None:
        self._session.request(player.CODE, 0, player.REQ_DATAMODE, player.DeviceDatamodeReq(int(mode)))
        self.mode = Mode(mode)

    def set_replace_rule(
        self, rule: Rule, *, interface: int = -1, index: int = -1, kind: int = -1, subtype: int = -1
    ) -> None:
        """Tells the server what to do with messages that wait for this client; -1 stands for any."""
        body = player.AddReplaceRuleReq(interface, index, kind, subtype, int(rule))
        self._session.request(player.CODE, 0, player.REQ_ADD_REPLACE_RULE, body)

    def read(self, timeout: Optional[float] = None) -> int:
        """Waits for the next data and hands them to the devices; returns how many messages there were.

        In pull mode this is one round: everything the server holds for this client. In push mode it is what
        has arrived, at least one message. Raises RequestTimeout when no data come; the next read() goes on
        waiting.
        """
        if self._reading:
            raise PlayerError("read() was called from a callback that read() itself is running")
        self._reading = True
        try:
            deadline = self._session.deadline(timeout)
            return self._read_round(deadline) if self.mode == Mode.PULL else self._read_pushed(deadline)
        except RequestTimeout:
            raise RequestTimeout(f"{self._session.connection.peer}: no data in time") from None
        finally:
            self._reading = False

    def device(self, interface: str, index: int = 0, access: Access = Access.ALL) -> Device:
        """Opens a device of any interface."""
        return self._open(Device, interface, index, access)

    def position2d(self, index: int = 0, access: Access = Access.ALL) -> Position2d:
        return self._open(Position2d, "position2d", index, access)

    def ranger(self, index: int = 0, access: Access = Access.ALL) -> Ranger:
        return self._open(Ranger, "ranger", index, access)

    def laser(self, index: int = 0, access: Access = Access.ALL) -> Laser:
        return self._open(Laser, "laser", index, access)

    def sonar(self, index: int = 0, access: Access = Access.ALL) -> Sonar:
        return self._open(Sonar, "sonar", index, access)

    def fiducial(self, index: int = 0, access: Access = Access.ALL) -> Fiducial:
        return self._open(Fiducial, "fiducial", index, access)

    def simulation(self, index: int = 0, access: Access = Access.ALL) -> Simulation:
        return self._open(Simulation, "simulation", index, access)

    def forget(self, device: Device) -> None:
        """Takes a closed device off the list; Device.close() does this."""
        same = self._devices.get((device.code, device.index), [])
        if device in same:
            same.remove(device)

    def close(self) -> None:
        """Closes what is open, last opened first, and waits until the server has read everything."""
        opened = [device for devices in self._devices.values() for device in devices]
        for device in reversed(opened):
            try:
                device.close()
            except PlayerError:
                pass  # the goodbye below closes it as well
        self._session.connection.close(_GOODBYE_SECONDS)

    def __enter__(self) -> "Client":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _describe(self, addr: common.Devaddr) -> DeviceEntry:
        request = player.DeviceDriverinfo(common.Devaddr(0, 0, addr.interf, addr.index))
        try:
            answer = self._session.request(player.CODE, 0, player.REQ_DRIVERINFO, request)
            driver = text(player.DeviceDriverinfo.decode(answer.body).driver_name)
        except (RequestRefused, WireError):
            driver = ""
        return DeviceEntry(INTERFACES.get(addr.interf, str(addr.interf)), addr.index, driver)

    def _open(self, kind: Type[P], interface: str, index: int, access: Access) -> P:
        device = kind(self, self._session, interface, index, access)
        self._devices.setdefault((device.code, index), []).append(device)
        try:
            device.prepare()
        except RequestRefused:
            pass  # it works without what it wanted to know
        except PlayerError:
            device.close()
            raise
        return device

    def _read_round(self, deadline: float) -> int:
        delivered = self._deliver()
        if not self._session.round_open:
            self._session.round_open = True
            patience = max(deadline - time.monotonic(), 0.0)
            self._session.request(player.CODE, 0, player.REQ_DATA, timeout=patience)
        delivered += self._deliver()
        while self._session.round_open:
            self._session.sort_next(deadline)
            delivered += self._deliver()
        return delivered

    def _read_pushed(self, deadline: float) -> int:
        delivered = self._deliver()
        while not delivered or self._session.connection.buffered():
            self._session.sort_next(deadline)
            delivered += self._deliver()
        return delivered

    def _deliver(self) -> int:
        count = 0
        while self._session.waiting:
            header, body = self._session.waiting.popleft()
            row = find_message(header.interface, Kind.DATA, header.subtype)
            takers = self._devices.get((header.interface, header.index), [])
            if row is None or row.payload is None or not takers:
                self._session.skipped_count += 1
                continue
            try:
                value = row.payload.decode(body)
            except WireError:
                self._session.skipped_count += 1
                continue
            for device in list(takers):
                device.take(row, value, header.timestamp)
            count += 1
        return count


def _split(address: str) -> Tuple[str, str]:
    """Host and port of an address; an IPv6 host is in brackets."""
    if address.startswith("["):
        host, _, rest = address[1:].partition("]")
        return host, rest[1:] if rest else str(DEFAULT_PORT)
    host, colon, port = address.rpartition(":")
    return (host, port) if colon else (address, str(DEFAULT_PORT))


def connect(address: str = DEFAULT_HOST, *, mode: Mode = Mode.PULL, timeout: float = 5.0) -> Client:
    """Connects to "host", "host:port", ":port" or "[::1]:port"; what is missing is 127.0.0.1 and 6665."""
    host, port = _split(address)
    if not port.isdigit() or not 0 < int(port) < 65536:
        raise ConnectionLost(f'"{address}" is not HOST or HOST:PORT')
    return Client(host or DEFAULT_HOST, int(port), mode=mode, timeout=timeout)
