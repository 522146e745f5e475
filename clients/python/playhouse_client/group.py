"""Data by multicast: numbered datagrams of a server to all clients that have asked for them."""

import selectors
import socket
import sys
import time
from collections import deque
from typing import Deque, Dict, Optional, Tuple

from .errors import WireError
from .wire import HEADER_BYTES, Header, Kind, Message, is_newer, loss_before

_CHUNK = 65536
_BUFFER_BYTES = 1 << 20  # of the system, for bursts
_DATAGRAMS_PER_LOOK = 64
_LONGEST_LOOK = 3600.0  # seconds, which the system takes
_ANY = "0.0.0.0"


class Group:
    """Those of one server, of the devices that this client has open; beside its connection, which has all else."""

    def __init__(self, place: str, port: int, connection: socket.socket) -> None:
        """`place`: as the server tells it, "239.255.0.1:6680 from 41234"; `port`: of its devices. Raises OSError, or
        WireError for another place."""
        self._connection = connection
        self._port = port
        self.lost_count = 0  # of data messages
        self.waiting: Deque[Message] = deque()
        self._newest: Dict[Tuple[int, int], Optional[int]] = {}  # number, by interface and index; None: nothing came yet
        try:
            where, _, sender = place.partition(" from ")
            group, _, group_port = where.rpartition(":")
            self._sender = int(sender)
            self._socket = _joined(group, int(group_port), _own_address(connection))
        except ValueError:
            raise WireError(f"the server tells a group that is none: {place!r}") from None
        self._selector = selectors.DefaultSelector()
        for each in (self._socket, connection):
            self._selector.register(each, selectors.EVENT_READ)

    def open_device(self, interface: int, index: int) -> None:
        """Takes the data of a device from now on. Its first message is the first that counts."""
        self._newest[interface, index] = None

    def close_device(self, interface: int, index: int) -> None:
        self._newest.pop((interface, index), None)

    def next(self, deadline: float) -> Optional[Message]:
        """The next message. None: the connection has something to read, or the deadline is over."""
        while not self.waiting:
            left = min(max(deadline - time.monotonic(), 0.0), _LONGEST_LOOK)
            ready = {key.fileobj for key, _ in self._selector.select(left)}
            if self._connection in ready or (not ready and time.monotonic() >= deadline):
                return None
            self._receive()
        return self.waiting.popleft()

    def forget(self) -> None:
        """Drops what has come."""
        while self._receive():
            pass
        self.waiting.clear()

    def close(self) -> None:
        self._selector.close()
        self._socket.close()

    def _receive(self) -> bool:
        """False: nothing more has come."""
        for _ in range(_DATAGRAMS_PER_LOOK):
            try:
                datagram, sender = self._socket.recvfrom(_CHUNK)
            except OSError:
                return False
            if sender[1] == self._sender and len(datagram) >= HEADER_BYTES:
                self._take(Header.decode(datagram[:HEADER_BYTES]), datagram[HEADER_BYTES:])
        return True

    def _take(self, header: Header, body: bytes) -> None:
        device = (header.interface, header.index)
        is_ours = header.kind == Kind.DATA and header.robot == self._port and header.size == len(body)
        if not is_ours or device not in self._newest:
            return
        newest = self._newest[device]
        if newest is not None:
            if not is_newer(header.sequence, newest):
                return
            self.lost_count += loss_before(header.sequence, newest)
        self._newest[device] = header.sequence
        self.waiting.append(Message(header, body))


def _own_address(connection: socket.socket) -> str:
    """That the connection comes from: data of the server come by the same interface, mostly."""
    name = connection.getsockname()
    return name[0] if connection.family == socket.AF_INET else "127.0.0.1"


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
