"""An open device of any interface, base of the proxies for specific interfaces."""

import enum
import numbers
import sys
import time
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterable, Iterator, NamedTuple, Optional, Sequence, Tuple, Type, TypeVar, Union

from .errors import DeviceClosed, DeviceGone, InvalidValue, NoData, RequestRefused, RequestTimeout, WireError
from .generated import INTERFACES, common, find_message, player
from .session import Session, device_name
from .wire import Kind, MessageType, Struct, c_string, text

if TYPE_CHECKING:
    from .client import Client

Property = Union[bool, int, float, str]
D = TypeVar("D", bound="Device")
Value = TypeVar("Value")


class Access(enum.IntEnum):
    """Access to a device. The character codes are those of Player's first servers."""

    ALL = player.OPEN_MODE
    READ = ord("r")
    WRITE = ord("w")


class _PropertyKind(NamedTuple):
    """Messages that get and set properties of one Python type, and conversions of the value."""

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
_LARGEST = sys.float_info.max
_LONGEST_WORD = 64  # longer input is no typo, and the table would be large
_CODES = {name: code for code, name in INTERFACES.items()}


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """' (did you mean "laser"?)' for the nearest known word, empty if none is near: by the rule of the program and the C++
    library (playhouse/base/nearest_word.h)."""
    if len(word) > _LONGEST_WORD:
        return ""
    best, edits = "", min(max(2, len(word) // 3), len(word)) + 1
    for each in known:
        distance = _edit_distance(word.lower(), each.lower())
        if distance < edits:
            best, edits = each, distance
    return f' (did you mean "{best}"?)' if best else ""


def _edit_distance(a: str, b: str) -> int:
    """Levenshtein distance, one row of the table at a time."""
    row = list(range(len(b) + 1))
    for i, letter in enumerate(a):
        above, row[0] = row[0], i + 1
        for j, other in enumerate(b):
            changed = above + (letter != other)
            above = row[j + 1]
            row[j + 1] = min(changed, row[j] + 1, above + 1)
    return row[-1]


def code_of(interface: str) -> int:
    if interface not in _CODES:
        raise InvalidValue(f'there is no interface "{interface}"{did_you_mean(interface, _CODES)}')
    return _CODES[interface]


def _property_kind(kind: type) -> "_PropertyKind":
    if kind not in _PROPERTIES:
        raise InvalidValue(f"a property is a bool, an int, a float or a str, not {kind.__name__}")
    return _PROPERTIES[kind]


class Device:
    """Opened by a function of Client or Robot; closed by close() or by leaving a `with` block.

    `driver` is the name of the driver behind the device, `timestamp` the server's time in seconds at the last
    data (0 before the first), `fresh` is set if data have arrived since the last next_data().
    """

    def __init__(
        self, client: "Client", session: Session, interface: str, index: int, access: Access
    ) -> None:
        self.interface = interface
        self.code = code_of(interface)
        if not 0 <= index <= 65535:
            raise InvalidValue(f"there is no {interface}:{index}: indices are 0 to 65535")
        self.index = index
        self.access = access
        self.timestamp = 0.0
        self.fresh = False
        self._session = session
        self._client = client
        self._latest: Dict[int, Tuple[Struct, float]] = {}
        self._callback: Optional[Callable[[MessageType, Struct, float], None]] = None
        self._open = False
        self._gone = ""  # why requests are refused
        self.driver = self._set_access(access)
        self._open = True

    @property
    def name(self) -> str:
        return device_name(self.code, self.index)

    @property
    def is_open(self) -> bool:
        """False after close(), of the device or of its client."""
        return self._open

    @property
    def gone(self) -> bool:
        """Whether read() has received the notice that the server retired the device. From then on its use raises
        DeviceGone, its last data remain, and close() has no effect. Before, the server refuses requests and drops
        commands."""
        return bool(self._gone)

    @property
    def has_data(self) -> bool:
        """Whether any data have arrived since this device was opened, and since the run was restarted."""
        return bool(self._latest)

    def request(
        self, message: MessageType, payload: Optional[Struct] = None, timeout: Optional[float] = None
    ) -> Optional[Struct]:
        """Sends a request and waits for the answer, None if it has no body. Raises RequestRefused or RequestTimeout."""
        self._insist_on_open()
        answer = self._session.request(self.code, self.index, message, payload, timeout)
        return message.payload.decode(answer.body) if message.payload and answer.body else None

    def command(self, message: MessageType, payload: Optional[Struct] = None) -> None:
        """Sends a command; commands have no answer."""
        self._insist_on_open()
        self._session.send(self.code, self.index, message, payload)

    def latest(self, message: MessageType) -> Optional[Struct]:
        """The newest value of a data message, None before the first."""
        return self._latest[message.subtype][0] if message.subtype in self._latest else None

    def on_data(self, callback: Optional[Callable[[MessageType, Struct, float], None]]) -> None:
        """Sets a callback, called within Client.read() with (message, value, timestamp) of all data of this device."""
        self._callback = callback

    def next_data(self, timeout: Optional[float] = None) -> None:
        """Waits for data newer than those of the last call. Raises RequestTimeout after `timeout` (s)."""
        seconds = self._session.timeout_or_own(timeout)
        deadline = time.monotonic() + seconds
        late = f"{self._session.peer}: no data of {self.name} in {seconds:g} s"
        while not self.fresh:
            self._insist_on_open()
            try:
                self._client.read(max(deadline - time.monotonic(), 0.0))
            except RequestTimeout as error:
                raise RequestTimeout(late) from error
            if not self.fresh and time.monotonic() >= deadline:  # read() is busy with other devices
                raise RequestTimeout(late)
        self.fresh = False

    def get_property(self, key: str, kind: Type[T]) -> T:
        """A property by its key and type: bool, int, float or str. Raises RequestRefused if there is none."""
        row = _property_kind(kind)
        try:
            answer = self.request(row.get, row.get.payload(key=c_string(key)))
        except RequestRefused:
            answer = None
        if answer is None:
            raise RequestRefused(f'{self._session.peer}: {self.name} has no {kind.__name__} property "{key}"')
        return row.unwrap(answer.value)

    def set_property(self, key: str, value: Property) -> None:
        row = _property_kind(type(value))
        body = row.set.payload(key=c_string(key), value=row.wrap(value))
        try:
            self.request(row.set, body)
        except RequestRefused:
            raise RequestRefused(f'{self._session.peer}: {self.name} refuses {value!r} as "{key}"') from None

    def has_capability(self, message: MessageType) -> bool:
        """Whether the driver reports that it supports a message. Many drivers never do."""
        try:
            self.request(common.REQ_CAPABILITIES, common.CapabilitiesReq(int(message.kind), message.subtype))
        except RequestRefused:
            return False
        return True

    def _why_refused(self) -> str:
        """Why the driver does not drive to its last goal; empty if it does, or has no such property."""
        try:
            return self.get_property("refusal", str)
        except RequestRefused:
            return ""

    def prepare(self) -> None:
        """Requests constant data for a proxy. Called after opening."""

    def take(self, message: MessageType, value: Struct, timestamp: float) -> None:
        """Receives data from Client.read()."""
        self._latest[message.subtype] = (value, timestamp)
        self.timestamp = timestamp
        self.fresh = True
        if self._callback:
            self._callback(message, value, timestamp)

    def goes_back(self, message: MessageType, timestamp: float) -> bool:
        """Whether data of this time are earlier than the last of their kind: the simulated time went back."""
        return message.subtype in self._latest and timestamp < self._latest[message.subtype][1]

    def forget_data(self) -> None:
        """Drops all data, as before the first: the run that they are of is over."""
        self._latest.clear()
        self.timestamp = 0.0
        self.fresh = False

    def retire(self, port: int) -> None:
        """Marks the device as retired by the server, whose own port number is `port`."""
        self._gone = self._gone or f"{port}:{self.name} is gone: the server retired it"

    def close(self) -> None:
        """Closes the device; a second call has no effect."""
        if not self._open:
            return
        self._open = False
        self._client.forget(self)
        if self._session.connection.alive and not self._gone:
            self._set_access(player.CLOSE_MODE)

    def __enter__(self: D) -> D:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _insist_on_open(self) -> None:
        if not self._open:
            raise DeviceClosed(f"{self._session.peer}: {self.name} is closed")
        if self._gone:
            raise DeviceGone(self._gone)

    def _insist_on_finite(self, **values: float) -> None:
        for name, value in values.items():
            if not -_LARGEST <= value <= _LARGEST:  # also rejects nan
                raise InvalidValue(f"{self.name}: {name} is {value}, not a finite number")

    def _insist_on_whole(self, name: str, value: int, least: int, most: int) -> None:
        if not isinstance(value, numbers.Integral) or not least <= value <= most:
            raise InvalidValue(f"{self.name}: {name} is {value!r}, not a whole number from {least} to {most}")

    def _stamped(self, message: MessageType) -> Tuple[Any, float]:
        """The newest value of a data message and its server time (s). Raises NoData before the first."""
        if message.subtype not in self._latest:
            raise NoData(f"{self._session.peer}: {self.name} {self._lack_of(message)}")
        return self._latest[message.subtype]

    def _newest_of(self, *kinds: MessageType) -> Any:
        """The newest value of several data messages. Raises NoData if there is none."""
        known = [self._stamped(kind) for kind in kinds if self.latest(kind) is not None]
        return max(known, key=lambda each: each[1])[0] if known else self._stamped(kinds[0])[0]

    def _first_of(self, values: Sequence[Value], what: str) -> Value:
        """The first value of a list. Raises NoData without one."""
        if not values:
            raise NoData(f"{self._session.peer}: {self.name} has no {what}")
        return values[0]

    def _ask(self, message: MessageType, payload: Optional[Struct] = None) -> Any:
        """The answer to a request. Raises WireError if it has no contents."""
        answer = self.request(message, payload)
        if answer is None:
            raise WireError("an answer came without its contents")
        return answer

    def _follow(self, look: Callable[[], Value], timeout: Optional[float]) -> Iterator[Value]:
        """Reads for ever: what `look` sees after each new data message."""
        while True:
            self.next_data(timeout)
            yield look()

    def _lack_of(self, message: MessageType) -> str:
        """Why there is no value of a data message."""
        if not self._latest:
            return "has sent no data yet; next_data() waits for them"
        sent = [row.name for row in (find_message(self.code, Kind.DATA, subtype) for subtype in self._latest) if row]
        return f"sends {', '.join(sent)}, not {message.name}"

    def _set_access(self, access: int) -> str:
        body = player.DeviceReq(common.Devaddr(0, 0, self.code, self.index), int(access))
        verb = "close" if access == player.CLOSE_MODE else "open"
        peer = self._session.peer
        try:
            answer = self._session.request(player.CODE, 0, player.REQ_DEV, body)
        except RequestRefused:
            raise RequestRefused(f"{peer}: there is no {self.name} to {verb}") from None
        except RequestTimeout:
            raise RequestTimeout(f"{peer}: no answer in time: {verb} {self.name}") from None
        granted = player.DeviceReq.decode(answer.body)
        if granted.access == player.ERROR_MODE:
            raise RequestRefused(f"{peer}: cannot {verb} {self.name}")
        return text(granted.driver_name)
