"""An open device of any interface. The proxies add to it what their interface is about."""

import enum
from typing import TYPE_CHECKING, Any, Callable, Dict, NamedTuple, Optional, Type, TypeVar, Union

from .errors import PlayerError, RequestRefused
from .generated import INTERFACES, common, player
from .session import Session
from .wire import MessageType, Struct, c_string, text

if TYPE_CHECKING:
    from .client import Client

Property = Union[bool, int, float, str]
D = TypeVar("D", bound="Device")


class Access(enum.IntEnum):
    """What a program wants to do with a device. The character codes are those of Player's first servers."""

    ALL = player.OPEN_MODE
    READ = ord("r")
    WRITE = ord("w")


class _PropertyKind(NamedTuple):
    """The messages that get and set properties of one Python type, and how a value goes in and comes out."""

    get: MessageType
    set: MessageType
    wrap: Callable[[Any], Any]
    unwrap: Callable[[Any], Any]


_PROPERTIES: Dict[type, _PropertyKind] = {
    bool: _PropertyKind(common.REQ_GET_BOOLPROP, common.REQ_SET_BOOLPROP, int, bool),
    int: _PropertyKind(common.REQ_GET_INTPROP, common.REQ_SET_INTPROP, int, int),
    float: _PropertyKind(common.REQ_GET_DBLPROP, common.REQ_SET_DBLPROP, float, float),
    str: _PropertyKind(common.REQ_GET_STRPROP, common.REQ_SET_STRPROP, c_string, text),
}

T = TypeVar("T", bool, int, float, str)
_CODES = {name: code for code, name in INTERFACES.items()}


class Device:
    """Opened by Client.device() or one of its sisters; closed by close() or by leaving a `with` block.

    `driver` is the name of the driver behind the device, `timestamp` the server's time in seconds at the last
    data (0 before the first), `fresh` says whether data have come that next_data() has not seen.
    """

    def __init__(
        self, client: "Client", session: Session, interface: str, index: int, access: Access
    ) -> None:
        if interface not in _CODES:
            raise PlayerError(f'there is no interface "{interface}"')
        self.interface = interface
        self.code = _CODES[interface]
        self.index = index
        self.access = access
        self.timestamp = 0.0
        self.fresh = False
        self._session = session
        self._client = client
        self._latest: Dict[int, Struct] = {}
        self._callback: Optional[Callable[[MessageType, Struct, float], None]] = None
        self._open = False
        self.driver = self._set_access(access)
        self._open = True

    @property
    def name(self) -> str:
        return f"{self.interface}:{self.index}"

    def request(
        self, message: MessageType, payload: Optional[Struct] = None, timeout: Optional[float] = None
    ) -> Optional[Struct]:
        """Asks and waits for the answer, None if it has no body. Raises RequestRefused or RequestTimeout."""
        answer = self._session.request(self.code, self.index, message, payload, timeout)
        return message.payload.decode(answer.body) if message.payload and answer.body else None

    def command(self, message: MessageType, payload: Optional[Struct] = None) -> None:
        """Sends a command; the server carries it out without an answer."""
        self._session.send(self.code, self.index, message, payload)

    def latest(self, message: MessageType) -> Optional[Struct]:
        """The last value of a kind of data, None before the first."""
        return self._latest.get(message.subtype)

    def on_data(self, callback: Optional[Callable[[MessageType, Struct, float], None]]) -> None:
        """Calls back from inside Client.read() with (kind, value, timestamp) of all data of this device."""
        self._callback = callback

    def next_data(self, timeout: Optional[float] = None) -> None:
        """Reads until this device has data newer than at the last call; `timeout` (s) is each read's."""
        while not self.fresh:
            self._client.read(timeout)
        self.fresh = False

    def get_property(self, key: str, kind: Type[T]) -> T:
        """A property by its key and type: bool, int, float or str. Raises RequestRefused if there is none."""
        row = _PROPERTIES[kind]
        answer = self.request(row.get, row.get.payload(key=c_string(key)))
        if answer is None:
            raise RequestRefused(f"{self.name}: the answer about property {key} is empty")
        return row.unwrap(answer.value)

    def set_property(self, key: str, value: Property) -> None:
        row = _PROPERTIES[type(value)]
        self.request(row.set, row.set.payload(key=c_string(key), value=row.wrap(value)))

    def has_capability(self, message: MessageType) -> bool:
        """Whether the driver says that it understands a kind of message. Many drivers never say so."""
        try:
            self.request(common.REQ_CAPABILITIES, common.CapabilitiesReq(int(message.kind), message.subtype))
        except RequestRefused:
            return False
        return True

    def prepare(self) -> None:
        """Asks what a proxy needs to know once. Called after opening."""

    def take(self, message: MessageType, value: Struct, timestamp: float) -> None:
        """Receives data from Client.read()."""
        self._latest[message.subtype] = value
        self.timestamp = timestamp
        self.fresh = True
        if self._callback:
            self._callback(message, value, timestamp)

    def close(self) -> None:
        """Closes the device; a second call does nothing."""
        if not self._open:
            return
        self._open = False
        self._client.forget(self)
        if self._session.connection.alive:
            self._set_access(player.CLOSE_MODE)

    def __enter__(self: D) -> D:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _set_access(self, access: int) -> str:
        body = player.DeviceReq(common.Devaddr(0, 0, self.code, self.index), int(access))
        verb = "close" if access == player.CLOSE_MODE else "open"
        try:
            answer = self._session.request(player.CODE, 0, player.REQ_DEV, body)
        except RequestRefused:
            peer = self._session.connection.peer
            raise RequestRefused(f"{peer}: there is no {self.name} to {verb}") from None
        granted = player.DeviceReq.decode(answer.body)
        if granted.access == player.ERROR_MODE:
            raise RequestRefused(f"{self._session.connection.peer}: cannot {verb} {self.name}")
        return text(granted.driver_name)
