"""A connection to a Player server, and requests to the server itself."""

import enum
import math
import ssl
import time
from typing import Callable, Dict, List, NamedTuple, Optional, Tuple, Type, TypeVar

from .connection import UDP, Connection
from .device import Access, Device, code_of, did_you_mean
from .errors import ConnectionLost, InvalidValue, PlayerError, RequestRefused, RequestTimeout, WireError
from .generated import INTERFACES, common, find_message, player, simulation
from .generated.proxies import PROXIES, Openers
from .models import DeviceAddress, Model, ask_models, families
from .robot import Robot
from .session import Session
from .wire import Kind, c_string, text

DEFAULT_HOST = "127.0.0.1"  # not localhost: a machine without /etc/hosts cannot resolve it
DEFAULT_PORT = 6665
_TOKEN_BYTES = 32
_GROUP_PROPERTY = "multicast"  # of player:0: where the group is, and whether this client reads it
_CLOSING_SECONDS = 1.0

P = TypeVar("P", bound=Device)
_Place = Tuple[int, str, int]  # port, interface, index


class Mode(enum.IntEnum):
    """Delivery of data: immediately (push), or in rounds requested by the client (pull)."""

    PUSH = player.DATAMODE_PUSH
    PULL = player.DATAMODE_PULL


class Rule(enum.IntEnum):
    """Handling of a message for this client while an older one of the same type is queued."""

    ACCEPT = player.MSG_REPLACE_RULE_ACCEPT
    REPLACE = player.MSG_REPLACE_RULE_REPLACE
    IGNORE = player.MSG_REPLACE_RULE_IGNORE


class DeviceEntry(NamedTuple):
    """One entry of the server's device list. `interface` is a name, or a number if it has no known name; `model` is the
    full name of the model behind the device and `robot` that of its top-level model, both empty if the server does
    not report them."""

    interface: str
    index: int
    driver: str
    model: str = ""
    robot: str = ""

    @property
    def name(self) -> str:
        return f"{self.interface}:{self.index}"


class Client(Openers):
    """One connection, for one thread. In a `with` block, devices and connection are closed at its end.

    `timeout` (s) applies to connecting, to every request, and to every read() without a timeout of its own.
    `tls` says which certificates to trust, for a server with --tls-cert: for instance ssl.create_default_context(cafile=...).
    `multicast` has a server with --multicast send data to its group, once for all such clients; they come in push mode.
    """

    def __init__(
        self,
        host: str = DEFAULT_HOST,
        port: int = DEFAULT_PORT,
        *,
        mode: Mode = Mode.PULL,
        timeout: float = 5.0,
        token: str = "",
        tls: Optional[ssl.SSLContext] = None,
        multicast: bool = False,
    ) -> None:
        if multicast and tls is not None:
            raise InvalidValue("data by multicast are in the clear: multicast without tls is valid")
        self._devices: Dict[Tuple[int, int], List[Device]] = {}
        self._session = Session(Connection(host, port, timeout, tls), timeout, self._retire)
        self._families: Optional[List[List[Model]]] = None  # as of the last query
        self._robots: Dict[Tuple[str, Tuple[DeviceAddress, ...]], Robot] = {}  # by name and devices
        self._reading = False
        self.mode = Mode.PUSH  # initial mode of a server
        try:
            if token:
                self._authenticate(token)
            if multicast:
                self._hear_group()
            elif mode != Mode.PUSH:
                self.set_mode(mode)
        except BaseException:
            self.close()
            raise

    def _authenticate(self, token: str) -> None:
        key = token.encode()
        if len(key) > _TOKEN_BYTES:
            raise InvalidValue(f"a token has {_TOKEN_BYTES} letters at most, not {len(key)}")
        try:
            self._session.request(player.CODE, 0, player.REQ_AUTH, player.DeviceAuthReq(key))
        except RequestRefused:
            raise RequestRefused(f"{self._session.peer}: the token is refused; a run without --guests needs none") from None

    def _hear_group(self) -> None:
        peer = self._session.peer
        try:
            question = common.StrpropReq(c_string(_GROUP_PROPERTY))
            answer = self._session.request(player.CODE, 0, common.REQ_GET_STRPROP, question)
        except RequestRefused:
            raise RequestRefused(f"{peer}: the server sends nothing by multicast; its option --multicast GROUP does") from None
        place = text(common.StrpropReq.decode(answer.body).value)
        try:
            self._session.connection.hear(place, self._session.server_port)
        except OSError as error:
            raise PlayerError(f"{peer}: cannot listen to the group {place}: {error}") from error
        self._session.request(player.CODE, 0, common.REQ_SET_INTPROP, common.IntpropReq(c_string(_GROUP_PROPERTY), 1))

    @property
    def banner(self) -> str:
        """The server's greeting, for instance "Player v.3.1"."""
        return self._session.connection.banner

    @property
    def connected(self) -> bool:
        return self._session.connection.alive

    @property
    def overflow_count(self) -> int:
        """Data messages dropped because they were not read in time, here or in the server."""
        return self._session.overflow_count

    def lost_count(self) -> int:
        """Queries the number of data messages lost on the way to this client, in any mode: the server's count plus those
        not read here in time, and by UDP and by multicast those that went astray. Raises RequestRefused if the server does not report it."""
        question = common.IntpropReq(c_string("lost"))
        answer = self._session.request(player.CODE, 0, common.REQ_GET_INTPROP, question)
        connection = self._session.connection
        astray = connection.lost_count + (connection.group.lost_count if connection.group else 0)
        return common.IntpropReq.decode(answer.body).value + self._session.unread_count + astray

    @property
    def skipped_count(self) -> int:
        """Messages without a recipient, and invalid messages."""
        return self._session.skipped_count

    def devices(self) -> List[DeviceEntry]:
        """The devices of the server, in its own order, with the driver and the model behind each."""
        answer = self._session.request(player.CODE, 0, player.REQ_DEVLIST)
        listed = player.DeviceDevlist.decode(answer.body).devices
        owners = self._find_owners() if any(addr.interf == simulation.CODE for addr in listed) else {}
        return [self._describe(addr, owners) for addr in listed]

    def set_mode(self, mode: Mode) -> None:
        if mode != Mode.PUSH and self._session.connection.group:
            raise InvalidValue("data by multicast come when they come: Mode.PUSH is valid")
        self._session.request(player.CODE, 0, player.REQ_DATAMODE, player.DeviceDatamodeReq(int(mode)))
        self.mode = Mode(mode)

    def set_replace_rule(
        self, rule: Rule, *, interface: int = -1, index: int = -1, kind: int = -1, subtype: int = -1
    ) -> None:
        """Sets the server's rule for messages queued for this client; -1 matches any."""
        body = player.AddReplaceRuleReq(interface, index, kind, subtype, int(rule))
        self._session.request(player.CODE, 0, player.REQ_ADD_REPLACE_RULE, body)

    def read(self, timeout: Optional[float] = None) -> int:
        """Waits for data and delivers them to the devices; returns the number of messages.

        In pull mode this is one round: everything the server has queued for this client. In push mode it is what
        has arrived, at least one message, or none if a device was retired before (Device.gone). Raises
        RequestTimeout without data; the next read() continues to wait. If the server disconnects, data it had sent are delivered first; the next read() raises ConnectionLost.
        """
        if self._reading:
            raise PlayerError("read() was called from a callback that read() itself is running")
        deadline = time.monotonic() + self._session.timeout_or_own(timeout)
        self._reading, self._session.told = True, False
        try:
            return self._read_round(deadline) if self.mode == Mode.PULL else self._read_pushed(deadline)
        finally:
            self._reading = False

    def device(self, interface: str, index: int = 0, access: Access = Access.ALL) -> Device:
        """Opens a device of any interface, as the proxy of that interface if there is one."""
        return self._open(PROXIES.get(interface, Device), interface, index, access)

    def models(self) -> List[Model]:
        """All models in the simulated world now, with their devices, parents before children. Raises
        RequestRefused if the server does not report models (not every simulator does, and no real robot)."""
        return [family[0] for family in self._list_families()]

    def robot(self, name: str) -> Robot:
        """The robot, or any other model, of this name, with the devices of all its descendants. It is looked up in the last
        list of models() or robots(), and if it is not there, in a new list.

        The same name gives the same Robot object while its devices are the same; of several models with one name it is the last. Raises RequestRefused if
        there is none, and as models().
        """
        named = [family for family in self._families or () if family[0].name == name]
        if not named:
            named = [family for family in self._list_families() if family[0].name == name]
        if not named:
            near = did_you_mean(name, [family[0].name for family in self._families or ()])
            raise RequestRefused(f'there is no robot "{name}" at {self._session.peer}{near}')
        return self._robot_of(named[-1])

    def robots(self) -> List[Robot]:
        """The top-level models with devices on this connection, of their own or of descendants, in the order of the world
        file. Raises RequestRefused as models()."""
        tops = [self._robot_of(family) for family in self._list_families() if not family[0].parent]
        return [robot for robot in tops if any(at.port == self._session.server_port for at in robot.devices)]

    def deliver_pushed(self) -> None:
        """In push mode, delivers data that have arrived to the devices, without waiting for more."""
        self._session.sort_arrived()
        if self.mode == Mode.PUSH and not self._reading:
            self._reading = True
            try:
                self._deliver()
            finally:
                self._reading = False

    def forget_run(self) -> None:
        """Drops all data received so far: the run that they are of is over. Called by Simulation.reset()."""
        self._session.connection.arrived()
        self._session.waiting.clear()
        self._forget_later(-math.inf)

    def forget(self, device: Device) -> None:
        """Removes a closed device from the list; called by Device.close()."""
        same = self._devices.get((device.code, device.index), [])
        if device in same:
            same.remove(device)
        self._forget_unread(device.code, device.index)
        if not same:
            self._devices.pop((device.code, device.index), None)
            if device.gone:
                self._session.drop_waiting(device.code, device.index)

    def close(self) -> None:
        """Closes all devices in reverse order of opening, and waits until the server has read everything."""
        opened = [device for devices in self._devices.values() for device in devices]
        for device in reversed(opened):
            try:
                device.close()
            except PlayerError:
                pass  # closing the connection closes it as well
        self._session.connection.close(_CLOSING_SECONDS)

    def __enter__(self) -> "Client":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _describe(self, addr: common.Devaddr, owners: Dict[_Place, Tuple[str, str]]) -> DeviceEntry:
        request = player.DeviceDriverinfo(common.Devaddr(0, 0, addr.interf, addr.index))
        try:
            answer = self._session.request(player.CODE, 0, player.REQ_DRIVERINFO, request)
            driver = text(player.DeviceDriverinfo.decode(answer.body).driver_name)
        except (RequestRefused, WireError):
            driver = ""
        interface = INTERFACES.get(addr.interf, str(addr.interf))
        model, robot = owners.get((addr.robot, interface, addr.index), ("", ""))
        return DeviceEntry(interface, addr.index, driver, model, robot)

    def _find_owners(self) -> Dict[_Place, Tuple[str, str]]:
        """The model behind each device and its top-level model; empty if the server does not report models."""
        try:
            tops = [family for family in self._list_families() if not family[0].parent]
        except RequestRefused:
            return {}
        return {
            (port, interface, index): (model, family[0].name)
            for family in tops
            for each in family
            for port, interface, index, model in each.devices
        }

    def _list_families(self) -> List[List[Model]]:
        """All current models, each with its descendants."""
        try:
            with self.simulation(0) as simulator:
                self._families = families(ask_models(simulator))
        except RequestRefused:
            raise RequestRefused(
                f"{self._session.peer}: this server does not tell the names of models; open devices by number"
            ) from None
        return self._families

    def _robot_of(self, family: List[Model]) -> Robot:
        key = (family[0].name, tuple(device for model in family for device in model.devices))
        if key not in self._robots:
            self._robots[key] = Robot(self, family, self._session.server_port)
        return self._robots[key]

    def _forget_later(self, timestamp: float) -> None:
        """Drops the data of devices whose last are later than this time (s): of a run that is over when time goes back."""
        for device in [each for same in self._devices.values() for each in same]:
            if device.timestamp > timestamp:
                device.forget_data()

    def _retire(self, addr: common.Devaddr) -> None:
        for device in self._devices.get((addr.interf, addr.index), []):
            device.retire(addr.robot)
        self._forget_unread(addr.interf, addr.index)

    def _forget_unread(self, interface: int, index: int) -> None:
        """Leaves the data by multicast of an address where no device is open for reading."""
        same = self._devices.get((interface, index), [])
        if not any(each.access != Access.WRITE and not each.gone for each in same):
            self._session.connection.forget_device(interface, index)

    def _open(self, kind: Type[P], interface: str, index: int, access: Access) -> P:
        code, connection = code_of(interface), self._session.connection
        reads = access != Access.WRITE
        if not self._devices.get((code, index)):
            self._session.drop_waiting(code, index)  # of the time before
        if reads:
            connection.expect_device(code, index)
        try:
            device = kind(self, self._session, interface, index, access)
        except BaseException:
            self._forget_unread(code, index)
            raise
        same = self._devices.setdefault((device.code, index), [])
        if any(each.gone for each in same):
            self._session.drop_waiting(device.code, index)
        same.append(device)
        if reads:
            connection.expect_device(code, index)  # again, if another one was retired meanwhile
        try:
            device.prepare()
        except RequestRefused:
            pass  # works without the results of prepare()
        except PlayerError:
            device.close()
            raise
        return device

    def _read_round(self, deadline: float) -> int:
        self._session.begin_round()
        delivered = self._receive(deadline, lambda _: self._session.round_open)
        if self._session.round_refused and not delivered:
            raise RequestRefused(f"{self._session.peer}: the server refuses to send data")
        return delivered

    def _read_pushed(self, deadline: float) -> int:
        return self._receive(deadline, lambda delivered: not delivered or self._session.connection.buffered())

    def _receive(self, deadline: float, more: Callable[[int], bool]) -> int:
        """Delivers queued messages, and new ones while `more` holds for the count so far; returns the number of messages.
        A disconnection after data is left to the next call, so that the data are delivered first."""
        delivered = self._deliver()
        while more(delivered) and not (self._session.told and not delivered):
            try:
                self._session.sort_next(deadline)
            except (ConnectionLost, RequestTimeout) as error:
                if delivered:
                    break
                if isinstance(error, RequestTimeout):
                    raise RequestTimeout(f"{self._session.peer}: no data in time") from None
                raise
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
            if any(each.goes_back(row, header.timestamp) for each in takers):  # another client restarted or rewound the run
                self._forget_later(header.timestamp)
            # The last data of a retired device belong to it, unless a new device has its address.
            for device in [each for each in takers if not each.gone] or list(takers):
                device.take(row, value, header.timestamp)
            count += 1
        return count


def _split(address: str) -> Tuple[str, str]:
    """Host and port of an address; an IPv6 host is in brackets."""
    if address.startswith(UDP):
        host, port = _split(address[len(UDP):])
        return UDP + (host or DEFAULT_HOST), port
    if address.startswith("["):
        host, _, rest = address[1:].partition("]")
        return host, rest[1:] if rest else str(DEFAULT_PORT)
    host, colon, port = address.rpartition(":")
    return (host, port) if colon else (address, str(DEFAULT_PORT))


def connect(
    address: str = DEFAULT_HOST,
    *,
    mode: Mode = Mode.PULL,
    timeout: float = 5.0,
    token: str = "",
    tls: Optional[ssl.SSLContext] = None,
    multicast: bool = False,
) -> Client:
    """Connects to "host", "host:port", ":port" or "[::1]:port"; the defaults are 127.0.0.1 and 6665. "udp:" in front
    of any of them is UDP; "/FOLDER" or "/FOLDER:port" is the Unix socket FOLDER/port. token: of a guest, for a
    run with --guests; tls and multicast: as of Client."""
    host, port = _split(address)
    if not port.isdigit() or not 0 < int(port) < 65536:
        raise ConnectionLost(f'"{address}" is not HOST or HOST:PORT')
    return Client(host or DEFAULT_HOST, int(port), mode=mode, timeout=timeout, token=token, tls=tls, multicast=multicast)
