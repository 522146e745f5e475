"""Data by multicast: numbered datagrams of a server to all clients that have asked for them."""

import selectors
import socket
import sys
import time
from collections import deque
from ipaddress import IPv4Address
from typing import Any, Deque, Dict, List, NamedTuple, Optional, Tuple

from .errors import WireError
from .wire import HEADER_BYTES, Header, Kind, Message

_CHUNK = 65536
_BUFFER_BYTES = 1 << 20  # of the system, for bursts
_DATAGRAMS_PER_LOOK = 64
_MOST_ARRIVED = 4096  # datagrams, more than the system keeps: an end to what a busy sender never ends
_LONGEST_LOOK = 3600.0  # seconds, which the system takes
_FAR_BEHIND, _FAR_AHEAD = 1024, 1 << 20  # messages: what farther off counts only when another follows it
_ANY = "0.0.0.0"


class _Place(NamedTuple):
    """Where a server says that its group is."""

    group: str
    port: int
    sender: str  # empty: not told
    sender_port: int


class _Series:
    """The messages of one device, by their numbers, which go on where another device has its address."""

    def __init__(self) -> None:
        self.is_open = False
        self._newest: Optional[int] = None
        self._counts = False  # whether those missing since the newest are lost
        self._stray: Optional[int] = None  # the last one far off

    def open(self) -> None:
        self.is_open = True
        self._counts = False

    def take(self, number: int) -> Optional[int]:
        """How many were lost before this one. None: it does not count, as it was overtaken, or is alone far off."""
        ahead = 1 if self._newest is None else _steps(self._newest, number)
        if -_FAR_BEHIND <= ahead <= 0:
            return None
        is_far = ahead < 0 or (self._counts and ahead > _FAR_AHEAD)
        if is_far and not self._follows_stray(number):
            return None
        lost = ahead - 1 if ahead > 0 and self._counts else 0
        self._newest, self._counts, self._stray = number, True, None
        return lost

    def _follows_stray(self, number: int) -> bool:
        """Whether it goes on from another one far off: then it is the newest that misled, as of a forger."""
        stray, self._stray = self._stray, number
        return stray is not None and 0 < _steps(stray, number) <= _FAR_BEHIND


def _steps(start: int, end: int) -> int:
    """Between two numbers of messages, which wrap."""
    return ((end - start + (1 << 31)) & 0xFFFFFFFF) - (1 << 31)


class Group:
    """Those of one server, of the devices that this client has open; beside its connection, which has all else."""

    def __init__(self, place: str, port: int, connection: socket.socket) -> None:
        """`place`: as the server tells it, "239.255.0.1:6680 from 10.0.0.7:41234", without the address if the server has
        several; `port`: of its devices. Raises OSError, or WireError for another place."""
        self._connection = connection
        self._port = port
        self.lost_count = 0  # of data messages
        self.waiting: Deque[Message] = deque()
        self._series: Dict[Tuple[int, int], _Series] = {}  # by interface and index
        told = _parsed(place)
        self._sender_port = told.sender_port
        self._senders = {told.sender} if told.sender else set()  # its addresses, empty: not known yet
        self._peer = _address(connection.getpeername(), connection.family)
        self._socket = _joined(told.group, told.port, _address(connection.getsockname(), connection.family) or "127.0.0.1")
        self._selector = selectors.DefaultSelector()
        for each in (self._socket, connection):
            self._selector.register(each, selectors.EVENT_READ)

    def open_device(self, interface: int, index: int) -> None:
        """Takes the data of a device from now on, not those that have come. Its first message is the first that counts."""
        device = (interface, index)
        series = self._series.setdefault(device, _Series())
        if series.is_open:
            return
        self._receive_arrived()
        series.open()

    def close_device(self, interface: int, index: int) -> None:
        """Drops its data that wait as well. Those overtaken are known if it is opened again."""
        device = (interface, index)
        if device in self._series:
            self._series[device].is_open = False
        self.waiting = deque(each for each in self.waiting if (each.header.interface, each.header.index) != device)

    def next(self, deadline: float) -> Optional[Message]:
        """The next message. None: the connection has something to read, or the deadline is over."""
        while not self.waiting:
            left = min(max(deadline - time.monotonic(), 0.0), _LONGEST_LOOK)
            ready = {key.fileobj for key, _ in self._selector.select(left)}
            if self._connection in ready:
                return None
            self._receive()
            if not self.waiting and time.monotonic() >= deadline:
                return None
        return self.waiting.popleft()

    def arrived(self) -> List[Message]:
        """All that has come, without waiting."""
        self._receive_arrived()
        came = list(self.waiting)
        self.waiting.clear()
        return came

    def close(self) -> None:
        """What has come still waits."""
        self._receive_arrived()
        self._selector.close()
        self._socket.close()

    def _receive_arrived(self) -> None:
        for _ in range(_MOST_ARRIVED // _DATAGRAMS_PER_LOOK):
            if not self._receive():
                return

    def _receive(self) -> bool:
        """False: nothing more has come."""
        for _ in range(_DATAGRAMS_PER_LOOK):
            try:
                datagram, sender = self._socket.recvfrom(_CHUNK)
            except OSError:
                return False
            if sender[1] == self._sender_port and len(datagram) >= HEADER_BYTES:
                self._take(Header.decode(datagram[:HEADER_BYTES]), datagram[HEADER_BYTES:], sender[0])
        return True

    def _take(self, header: Header, body: bytes, sender: str) -> None:
        is_ours = header.kind == Kind.DATA and header.robot == self._port and header.size == len(body)
        series = self._series.get((header.interface, header.index))
        if not is_ours or series is None or not series.is_open or not self._is_of_server(sender):
            return
        lost = series.take(header.sequence)
        if lost is None:
            return
        self.lost_count += lost
        self.waiting.append(Message(header, body))

    def _is_of_server(self, sender: str) -> bool:
        """A server that does not tell its address has the one heard first, or that of the connection."""
        if not self._senders:
            self._senders = {sender, self._peer}
        return sender in self._senders


def _parsed(place: str) -> _Place:
    try:
        where, _, source = place.partition(" from ")
        group, _, port = where.rpartition(":")
        sender, _, sender_port = source.rpartition(":")
        if not IPv4Address(group).is_multicast:
            raise ValueError
        return _Place(group, _port(port), str(IPv4Address(sender)) if sender else "", _port(sender_port))
    except ValueError:
        raise WireError(f"the server tells a group that is none: {place!r}") from None


def _port(text: str) -> int:
    if not (text.isascii() and text.isdigit() and len(text) <= 5 and 0 < int(text) < 65536):
        raise ValueError
    return int(text)


def _address(name: Any, family: int) -> str:
    """That of one end of the connection. Data of the server come by the same interface, mostly. Empty: not one of IPv4."""
    return str(name[0]) if family == socket.AF_INET else ""


def _joined(group: str, port: int, own: str) -> socket.socket:
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # for all clients of this machine
        made.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, _BUFFER_BYTES)
        made.bind(("" if sys.platform == "win32" else group, port))
        made.setblocking(False)
        _join(made, group, own)
    except OSError:
        made.close()
        raise
    return made


def _join(made: socket.socket, group: str, own: str) -> None:
    """On the interface of the connection and on that of the system's choice: a server of all interfaces sends by the latter."""
    failed: Optional[OSError] = None
    joined = 0
    for interface in dict.fromkeys((own, _ANY)):
        try:
            made.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton(group) + socket.inet_aton(interface))
            joined += 1
        except OSError as error:
            failed = error
    if not joined and failed is not None:
        raise failed
